"""The notebook runs as Jupyter runs it, shows what it says, and holds no results, numbers of runs or names of a machine."""
import json
import os
import pathlib
import re
import sys
from typing import Any

import pytest

from support import SOURCE

NOTEBOOK = SOURCE / "examples/bar_run.ipynb"


def test_it_holds_sources_only() -> None:
    notebook = json.loads(NOTEBOOK.read_text(encoding="utf-8"))
    assert notebook["nbformat"] == 4 and set(notebook["metadata"]) == {"kernelspec", "language_info"}
    assert notebook["metadata"]["kernelspec"]["name"] == "python3"
    codes = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    assert len(codes) >= 4 and all(cell["outputs"] == [] and cell["execution_count"] is None for cell in codes)
    assert all(cell["metadata"] == {} for cell in notebook["cells"])
    assert not re.search(r"/(?:home|root|work|tmp|usr)/", NOTEBOOK.read_text(encoding="utf-8"))


def test_it_runs(tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch) -> None:
    nbformat, nbclient = pytest.importorskip("nbformat"), pytest.importorskip("nbclient")
    pytest.importorskip("ipykernel")
    pytest.importorskip("matplotlib")
    monkeypatch.setenv("IPYTHONDIR", str(tmp_path / "ipython"))
    monkeypatch.setenv("MPLCONFIGDIR", str(tmp_path / "matplotlib"))
    monkeypatch.delenv("MPLBACKEND", raising=False)  # the kernel has its own
    notebook = nbformat.read(NOTEBOOK, as_version=4)
    nbformat.validate(notebook)
    kernel = this_interpreter(tmp_path)
    monkeypatch.setenv("JUPYTER_PATH", str(kernel))
    nbclient.NotebookClient(notebook, timeout=300, kernel_name="this", resources={"metadata": {"path": str(tmp_path)}}).execute()
    codes = [cell for cell in notebook.cells if cell.cell_type == "code"]
    printed = "".join(output.text for cell in codes for output in cell.outputs if output.output_type == "stream")
    pictures = [output.data for cell in codes for output in cell.outputs if "image/png" in output.get("data", {})]
    assert len(pictures) == 3
    assert re.search(r"^\d.* s <= critical step <= \d.* s\ntet4 element 0:\d+", printed)
    assert re.search(r"^step \d+, t = \S+ s: violated: h = ", printed, re.M)
    assert re.search(r"^(?:violated|unstable) since ", printed, re.M)
    assert {path.name for path in tmp_path.iterdir()} <= {"ipython", "jupyter", "matplotlib"}  # nothing is left behind


def this_interpreter(folder: Any) -> Any:
    """A kernel of the interpreter that runs the tests, whichever others the machine has."""
    place = folder / "jupyter/kernels/this"
    os.makedirs(place)
    (place / "kernel.json").write_text(json.dumps({
        "argv": [sys.executable, "-m", "ipykernel_launcher", "-f", "{connection_file}"], "display_name": "this",
        "language": "python"}))
    return folder / "jupyter"
