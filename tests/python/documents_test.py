"""What docs/python.md and the README show of Python is run as it stands."""
import doctest
import importlib.util
import os
import pathlib
import re
import subprocess
import sys
from typing import Any

import pytest

import ringwatch as rw
from support import PROGRAM, SOURCE, bar, call

PAGE = SOURCE / "docs/python.md"
# A snippet that imports one of these is left out where it is not installed.
OPTIONAL = ("gmsh", "matplotlib", "vtkmodules")


def blocks(path: pathlib.Path) -> Any:
    return re.findall(r"^```python\n(.*?)^```", path.read_text(encoding="utf-8"), re.M | re.S)


def test_the_readmes_lines_run_as_pasted(tmp_path: pathlib.Path) -> None:
    call(PROGRAM, "mesh", "generate", "bar", "--size", "0.2", "0.04", "0.04", "--cells", "8", "2", "2", "-o",
         tmp_path / "bar.msh")
    (code,) = blocks(SOURCE / "README.md")
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False, cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    step = rw.inspect(rw.Body(rw.load_mesh(tmp_path / "bar.msh"),
                              rw.Material("stvk", young=30e3, poisson=0.3, density=1000)))
    assert str(step.safe) in ended.stdout and str(step.optimistic) in ended.stdout
    assert "violated" in ended.stdout


def test_the_pages_snippets(tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """One session from the first snippet to the last."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MPLBACKEND", "Agg")
    bar().save("bar.msh")
    missing = [name for name in OPTIONAL if importlib.util.find_spec(name) is None]
    snippets = [text for text in blocks(PAGE)
                if not re.search(rf"^>>> (?:import|from) (?:{'|'.join(missing or ['-'])})\b", text, re.M)]
    assert len(snippets) >= 5 and all(">>> " in snippet for snippet in snippets)
    test = doctest.DocTestParser().get_doctest("\n".join(snippets), {}, "docs/python.md", str(PAGE), 0)
    told: list[str] = []
    result = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE).run(test, out=told.append)
    assert result.attempted > 20 and result.failed == 0, "".join(told)


@pytest.mark.parametrize("name", ["", "_convert", "_plot", "_run", "_results", "_errors", "_suggest", "_verification"])
def test_the_packages_own_snippets(name: str) -> None:
    module = rw if not name else sys.modules[f"ringwatch.{name}"]
    result = doctest.testmod(module, optionflags=doctest.ELLIPSIS)
    assert result.failed == 0 and (name or result.attempted > 3)


def test_the_page_names_all_that_is_public() -> None:
    text = PAGE.read_text(encoding="utf-8")
    assert {name for name in rw.__all__ if not name.startswith("__")} <= set(re.findall(r"rw\.(\w+)", text))
    assert os.path.exists(SOURCE / "docs/reference/exit_status.md")
