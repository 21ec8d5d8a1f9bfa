"""Comparisons and report pages: those of the command line."""
import json
import pathlib

import numpy as np
import pytest

import ringwatch as rw
from run_test import SECTIONS
from support import PROGRAM, SOURCE, call

def test_a_comparison_is_the_command_lines(tmp_path: pathlib.Path) -> None:
    scene = SOURCE / "examples/swinging_bar.toml"
    words = ["--set", "mesh.cells=[4,1,1]", "--set", "integrator.end=0.05"]
    call(PROGRAM, "compare", scene, "--integrators", "verlet,rk4", "--step", "1e-3,2e-3", "--json", tmp_path / "c.json", *words)
    told = json.loads((tmp_path / "c.json").read_text())
    found = rw.compare(scene, integrators=["verlet", "rk4"], steps=[1e-3, 2e-3], overrides=words[1::2], out=tmp_path / "out")
    assert (found.title, found.end, found.reference_error) == (told["title"], told["end"], told["reference_error"])
    assert len(told["runs"]) == 4
    for name in ("integrator", "h", "error", "forces", "products", "matrices", "lost"):
        assert found.runs[name].tolist() == [row[name] for row in told["runs"]]
    assert found.runs["seconds"].dtype == np.float64 and found.runs["seconds"].min() > 0
    assert list(found.cheapest) == ["1 %", "0.1 %", "1e-6"]
    assert found.cheapest["1 %"]["by_forces"] == told["cheapest"]["1 %"]["by_forces"]
    assert {path.suffix for path in (tmp_path / "out").iterdir()} >= {".dat"}


def test_lost_runs_and_handlers() -> None:
    found = rw.compare(SOURCE / "examples/swinging_bar.toml", integrators=["verlet"], handlers=["imex"], steps=[2e-3, 5e-3],
                       overrides=["mesh.cells=[4,1,1]", "integrator.end=0.5"])
    assert found.runs["integrator"].tolist() == ["verlet", "verlet", "imex", "imex"]
    assert np.isnan(found.runs["error"][1]) and "not finite" in found.runs["lost"][1]
    assert np.isfinite(found.runs["error"][0]) and found.runs["lost"][0] == ""


def test_bad_comparisons_are_told_as_the_program_tells(tmp_path: pathlib.Path) -> None:
    with pytest.raises(rw.InputError, match="--integrators: unknown \"verlt\"; did you mean"):
        rw.compare(SOURCE / "examples/swinging_bar.toml", integrators=["verlt"])
    with pytest.raises(rw.InputError, match="integrators: 'verlet'; must be a list of names"):
        rw.compare(SOURCE / "examples/swinging_bar.toml", integrators="verlet")
    with pytest.raises(rw.InputError, match=r"^scene: nothing moves"):
        rw.compare({**SECTIONS, "move": []}, integrators=["verlet"])


def test_a_report_is_the_command_lines(tmp_path: pathlib.Path) -> None:
    result = rw.run(SECTIONS, out=tmp_path / "run", overrides=["output.every=0.01"])
    page = rw.report(result.folder)
    assert page == tmp_path / "run/report.html" and "<html" in page.read_text(encoding="utf-8")
    other = rw.report(str(result.folder), out=tmp_path / "page.html", frames=2)
    assert other == tmp_path / "page.html"
    call(PROGRAM, "report", result.folder, "--out", tmp_path / "theirs.html", "--frames", "2")
    assert abs(len(other.read_text()) - len((tmp_path / "theirs.html").read_text())) < 2000  # the gains are measured
    assert len(page.read_text()) > len(other.read_text())
    with pytest.raises(rw.InputError, match="none"):
        rw.report(tmp_path / "none")
    with pytest.raises(rw.InputError, match="frames"):
        rw.report(result.folder, frames=0)
