"""Scenes: the results are those of the command line, file by file."""
import json
import os
import pathlib
import signal
import subprocess
import sys
import time
from typing import Any

import numpy as np
import pytest

import ringwatch as rw
from support import PROGRAM, SOURCE, bar

SCENE = """
[mesh]
generate = "bar"
cells = [4, 1, 1]
[material]
model = "stvk"
young = 30e3
poisson = 0.3
density = 1000
[integrator]
method = "symplectic-euler"
step = 1e-3
end = 0.05
[[fix]]
where = "x < 1e-6"
[[move]]
where = "x > 0.2 - 1e-6"
velocity = [0.4, 0, 0]
[output]
picture = false
"""
SECTIONS: dict[str, Any] = {
    "mesh": {"generate": "bar", "cells": [4, 1, 1]},
    "material": {"model": "stvk", "young": 30e3, "poisson": 0.3, "density": 1000},
    "integrator": {"method": "symplectic-euler", "step": 1e-3, "end": 0.05},
    "fix": [{"where": "x < 1e-6"}],
    "move": [{"where": "x > 0.2 - 1e-6", "velocity": np.array([0.4, 0, 0])}],
    "output": {"picture": False},
}


def test_a_file_and_a_dict_give_the_command_lines_results(tmp_path: pathlib.Path) -> None:
    path = tmp_path / "scene.toml"
    path.write_text(SCENE)
    subprocess.run([PROGRAM, "run", path, "--quiet", "--out", tmp_path / "program"], check=True)
    expected = (tmp_path / "program/history.csv").read_text()
    assert len(expected.splitlines()) > 40
    scene: Any
    for number, scene in enumerate((path, str(path), SECTIONS)):
        result = rw.run(scene, out=tmp_path / str(number))
        assert result.exit_status == 0 and result.stable and result.verdict == "certified"
        assert result.folder == tmp_path / str(number)
        assert (result.folder / "history.csv").read_text() == expected
        assert result.summary == json.loads((result.folder / "summary.json").read_text())
        assert result.summary["scene"] == json.loads((tmp_path / "program/summary.json").read_text())["scene"]
        rows = [line.split(",") for line in expected.splitlines()]
        for i, name in enumerate(rows[0]):
            column = result.history[name]
            assert len(column) == len(rows) - 1
            for row, value in zip(rows[1:], column):
                assert str(value) == row[i] or float(row[i] or "nan") == value or (row[i] == "" and np.isnan(value))


def test_an_unstable_run_is_a_result(tmp_path: pathlib.Path) -> None:
    result = rw.run(SOURCE / "examples/stretch_bar.toml", out=tmp_path,
                    overrides=["output.picture=false", "mesh.cells=[6,2,2]", "integrator.step=3e-3"])
    assert result.exit_status == 1 and not result.stable
    assert result.summary["scene"]["integrator"]["step"] == 3e-3
    assert "violated" in result.history["verdict"]


def test_bad_scenes_are_told_as_the_program_tells(tmp_path: pathlib.Path) -> None:
    path = tmp_path / "scene.toml"
    path.write_text(SCENE.replace("poisson = 0.3", "poisson = 0.7"))
    told = subprocess.run([PROGRAM, "run", path, "--out", tmp_path / "o"], capture_output=True, text=True, check=False)
    with pytest.raises(rw.InputError) as raised:
        rw.run(path, out=tmp_path / "o")
    assert told.returncode == 2 and f"ringwatch: {raised.value}\n" == told.stderr and f"{path}:" in str(raised.value)
    with pytest.raises(rw.InputError, match=r"^scene:\d+: material\.poisson"):
        rw.run({**SECTIONS, "material": {**SECTIONS["material"], "poisson": 0.7}}, out=tmp_path / "o")
    with pytest.raises(rw.InputError, match=r"^scene: mesh: 5; must be a dict"):
        rw.run({"mesh": 5}, out=tmp_path / "o")
    with pytest.raises(rw.InputError, match=r"^scene: mesh\.cells: None; must be"):
        rw.run({"mesh": {"cells": None}}, out=tmp_path / "o")
    with pytest.raises(rw.InputError, match="there is no such|cannot read"):
        rw.run(tmp_path / "none.toml", out=tmp_path / "o")
    assert not (tmp_path / "o").exists()


def test_a_mesh_file_of_a_dict_is_relative_to_here(tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch) -> None:
    bar().save(tmp_path / "bar ü.msh")
    monkeypatch.chdir(tmp_path)
    result = rw.run({**SECTIONS, "mesh": {"file": "bar ü.msh"}})
    assert result.exit_status == 0 and str(result.folder) == "out/scene" and (tmp_path / "out/scene/history.csv").exists()


def test_ctrl_c_ends_a_run_with_its_results(tmp_path: pathlib.Path) -> None:
    code = f"import ringwatch as rw; rw.run({{**{SECTIONS!r}, 'integrator': {{'method': 'symplectic-euler', 'step': 1e-4," \
           f" 'end': 1000.0}}, 'move': []}}, out={str(tmp_path / 'o')!r})"
    code = "from numpy import array\n" + code
    with subprocess.Popen([sys.executable, "-c", code], stderr=subprocess.PIPE, text=True) as process:
        for _ in range(600):
            if (tmp_path / "o/history.csv").exists():
                break
            time.sleep(0.05)
        os.kill(process.pid, signal.SIGINT)
        complaint = process.communicate(timeout=60)[1]
    assert "KeyboardInterrupt" in complaint
    assert json.loads((tmp_path / "o/summary.json").read_text())["exit_reason"] == "interrupted"
