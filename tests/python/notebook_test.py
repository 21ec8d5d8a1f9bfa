"""The notebooks run as Jupyter runs them, show what they say, and hold no results, numbers of runs or names of a machine."""
import json
import os
import pathlib
import re
import sys
from typing import Any

import pytest

from support import SOURCE

# Of each: how many pictures it shows, and what it prints.
SHOWS = {
    "bad_mesh": (2, [r"^\S+ s <= critical step <= \S+ s, for h omega <= 2$", r"^the step grows ([2-9]|\d\d)\.\d times$"]),
    "error_against_cost": (2, [r"^error +1 %: (verlet|symplectic-euler) with \d+ forces$", r"^error +1e-6: (rkn4|pefrl|rk4) with \d+ forces$"]),
    "bar_run": (3, [r"^\d.* s <= critical step <= \d.* s\ntet4 element 0:\d+", r"^step \d+, t = \S+ s: violated: h = ",
                    r"^(?:violated|unstable) since "]),
    "which_handler": (2, [r"^24 of 1280 elements forbid three times that step$", r"^imex +\S+ of the time, error +0\.\d\d %, certified$",
                          r"^local-time-stepping +\S+ of the time, error +0\.\d\d %, certified$"]),
    "audit_foreign_run": (1, [r"^exit status 1; the steps came to \S+ times the proven one$",
                              r"^first state whose step is proven unstable: [1-9]\d of \d+$"]),
}


def test_all_are_known() -> None:
    assert {path.stem for path in SOURCE.glob("examples/*.ipynb")} == set(SHOWS)


@pytest.mark.parametrize("name", SHOWS)
def test_it_holds_sources_only(name: str) -> None:
    path = SOURCE / f"examples/{name}.ipynb"
    notebook = json.loads(path.read_text(encoding="utf-8"))
    assert notebook["nbformat"] == 4 and set(notebook["metadata"]) == {"kernelspec", "language_info"}
    assert notebook["metadata"]["kernelspec"]["name"] == "python3"
    codes = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    assert len(codes) >= 4 and all(cell["outputs"] == [] and cell["execution_count"] is None for cell in codes)
    assert all(cell["metadata"] == {} for cell in notebook["cells"])
    assert not re.search(r"/(?:home|root|work|tmp|usr)/", path.read_text(encoding="utf-8"))


@pytest.mark.parametrize("name", SHOWS)
def test_it_runs(name: str, tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch) -> None:
    nbformat, nbclient = pytest.importorskip("nbformat"), pytest.importorskip("nbclient")
    pytest.importorskip("ipykernel")
    pytest.importorskip("matplotlib")
    monkeypatch.setenv("IPYTHONDIR", str(tmp_path / "ipython"))
    monkeypatch.setenv("MPLCONFIGDIR", str(tmp_path / "matplotlib"))
    monkeypatch.delenv("MPLBACKEND", raising=False)  # the kernel has its own
    notebook = nbformat.read(SOURCE / f"examples/{name}.ipynb", as_version=4)
    nbformat.validate(notebook)
    kernel = this_interpreter(tmp_path)
    monkeypatch.setenv("JUPYTER_PATH", str(kernel))
    nbclient.NotebookClient(notebook, timeout=300, kernel_name="this", resources={"metadata": {"path": str(tmp_path)}}).execute()
    codes = [cell for cell in notebook.cells if cell.cell_type == "code"]
    printed = "".join(output.text for cell in codes for output in cell.outputs if output.output_type == "stream")
    pictures, texts = SHOWS[name]
    assert sum("image/png" in output.get("data", {}) for cell in codes for output in cell.outputs) == pictures
    for text in texts:
        assert re.search(text, printed, re.M), printed
    assert {path.name for path in tmp_path.iterdir()} <= {"ipython", "jupyter", "matplotlib"}  # nothing is left behind


def this_interpreter(folder: Any) -> Any:
    """A kernel of the interpreter that runs the tests, whichever others the machine has."""
    place = folder / "jupyter/kernels/this"
    os.makedirs(place)
    (place / "kernel.json").write_text(json.dumps({
        "argv": [sys.executable, "-m", "ipykernel_launcher", "-f", "{connection_file}"], "display_name": "this",
        "language": "python"}))
    return folder / "jupyter"
