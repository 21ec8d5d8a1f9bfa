"""Scenes, run by the program `ringwatch` of this installation: its results are those of the command line."""
from __future__ import annotations

import csv
import json
import math
import os
import pathlib
import subprocess
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._errors import InputError, NumericalError
from ._locations import PROGRAM

_FAILED, _BAD_INPUT = 1, 2  # exit statuses, docs/reference/exit_status.md
_TEXTS = ("controlling_element", "verdict")  # columns of history.csv that are no numbers


@dataclass(frozen=True, slots=True)
class RunResult:
    """What came of a run."""

    exit_status: int
    """0 done and stable, 1 instability found, 3 never certified, 4 interrupted."""
    stable: bool
    verdict: str
    """certified, not-certified, violated, unstable or unmonitored."""
    folder: pathlib.Path
    """Where the results lie: history.csv, summary.json, frames, picture."""
    summary: dict[str, Any]
    """All of summary.json."""
    history: dict[str, NDArray[Any]]
    """The columns of history.csv by name: float64, NaN where a field is empty; controlling_element and verdict are
    texts."""


def run(
    scene: str | os.PathLike[str] | Mapping[str, Any],
    *,
    out: str | os.PathLike[str] | None = None,
    overrides: Sequence[str] = (),
    threads: int = 0,
) -> RunResult:
    """Runs a scene, as `ringwatch run` does.

    scene: a scene file (TOML), or the same as a dict of sections; file names in a dict are relative to the current
    folder. out: folder for the results; else out/ and the scene's name, which for a dict is "scene". overrides:
    "section.key=value" each. Raises InputError with the line that the program prints; a run that becomes unstable is a
    result, not an error.
    """
    program = pathlib.Path(__file__).parent / PROGRAM
    if not program.is_file():
        raise InputError(f"{program.resolve()}: there is no program; scenes need it: build and install ringwatch_app")
    with tempfile.TemporaryDirectory() as folder:
        if isinstance(scene, Mapping):
            path = pathlib.Path(folder) / "scene.toml"
            path.write_text(_toml(_with_absolute_mesh(scene)), encoding="utf-8")
        else:
            path = pathlib.Path(scene)
        results = pathlib.Path(out) if out is not None else pathlib.Path("out") / path.stem
        command = [str(program), "run", str(path), "--quiet", "--out", str(results), "--threads", str(threads)]
        for setting in overrides:
            command += ["--set", setting]
        status, complaint = _call(command)
    if status < 0:
        raise RuntimeError(f"ringwatch run was ended by signal {-status}")
    if complaint and status in (_BAD_INPUT, _FAILED):
        line = complaint.split("\n")[-1].removeprefix("ringwatch: ").replace(f"{folder}{os.sep}scene.toml", "scene")
        raise InputError(line) if status == _BAD_INPUT else NumericalError(line)
    summary = json.loads((results / "summary.json").read_text(encoding="utf-8"))
    return RunResult(status, bool(summary["stable"]), str(summary["verdict"]), results, summary,
                     _history(results / "history.csv"))


def _call(command: list[str]) -> tuple[int, str]:
    """Exit status and standard error. Ctrl-C ends the run after its step, with its results written."""
    with subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                          text=True) as process:
        try:
            complaint = process.communicate()[1]
        except KeyboardInterrupt:
            process.terminate()  # the second signal of one kind would end it at once, and Ctrl-C has reached it too
            process.wait()
            raise
    return process.returncode, complaint.strip()


def _history(path: pathlib.Path) -> dict[str, NDArray[Any]]:
    with path.open(newline="", encoding="utf-8") as stream:
        names, *rows = csv.reader(stream)
    columns = {}
    for i, name in enumerate(names):
        texts = [row[i] for row in rows]
        columns[name] = np.array(texts) if name in _TEXTS else np.array([float(t) if t else math.nan for t in texts])
    return columns


def _with_absolute_mesh(scene: Mapping[str, Any]) -> dict[str, Any]:
    """The scene lies in a folder of its own while it runs, so that a name relative to here would lead nowhere."""
    sections = dict(scene)
    mesh = sections.get("mesh")
    if isinstance(mesh, Mapping) and isinstance(mesh.get("file"), (str, os.PathLike)):
        sections["mesh"] = {**mesh, "file": os.path.abspath(mesh["file"])}
    return sections


def _toml(scene: Mapping[str, Any]) -> str:
    lines = []
    for section, content in scene.items():
        tables = [content] if isinstance(content, Mapping) else content
        head = f"[{_name(section)}]" if isinstance(content, Mapping) else f"[[{_name(section)}]]"
        if isinstance(tables, str) or not isinstance(tables, Sequence) or not all(isinstance(t, Mapping) for t in tables):
            raise InputError(f"scene: {section}: {content!r}; must be a dict, or a list of them")
        for table in tables:
            lines.append(head)
            lines += [f"{_name(key)} = {_value(f'{section}.{key}', value)}" for key, value in table.items()]
    return "\n".join(lines) + "\n"


def _name(key: Any) -> str:
    return json.dumps(str(key), ensure_ascii=False)


def _value(name: str, value: Any) -> str:
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, (int, np.integer)):
        return str(int(value))
    if isinstance(value, (float, np.floating)):
        return repr(float(value))  # TOML writes inf and nan as Python does
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, np.ndarray):
        return _value(name, value.tolist())
    if isinstance(value, Sequence):
        return "[" + ", ".join(_value(name, part) for part in value) + "]"
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{_name(k)} = {_value(f'{name}.{k}', v)}" for k, v in value.items()) + "}"
    raise InputError(f"scene: {name}: {value!r}; must be a number, a text, a list of them or a dict")
