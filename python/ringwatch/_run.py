"""Scenes and reports, by the program `ringwatch` of this installation: its results are those of the command line."""
from __future__ import annotations

import contextlib
import csv
import importlib
import json
import math
import os
import pathlib
import subprocess
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from html import escape
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _plot
from ._errors import InputError, NumericalError
from ._locations import PROGRAM
from ._results import Result, document_fields
from ._ringwatch import _used_units

_FAILED, _BAD_INPUT = 1, 2  # exit statuses, docs/reference/exit_status.md
_TEXTS = ("controlling_element", "verdict")  # columns of history.csv that are no numbers


@dataclass(frozen=True, slots=True, repr=False)
class RunResult(Result):
    """What came of a run."""

    exit_status: int
    """0 done and stable, 1 instability found, 3 never certified, 4 interrupted."""
    stable: bool
    """Whether no instability was seen."""
    verdict: str
    """certified, not-certified, violated, unstable or unmonitored."""
    folder: pathlib.Path
    """Where the results lie: history.csv, summary.json, frames, picture."""
    summary: dict[str, Any]
    """All of summary.json."""
    history: dict[str, NDArray[Any]]
    """The columns of history.csv by name: float64, NaN where a field is empty; controlling_element and verdict are
    texts."""

    def __str__(self) -> str:
        return f"{self.verdict}: {self.summary['conclusion']}"

    def plot(self, ax: Any = None) -> Any:
        """Draws both sides of the bracket, the step by the monitor's metric, where there is one, and the step that was
        taken, s, over time, s, with the beginnings of events.

        ax: matplotlib's Axes to draw into; None makes some. Returns the Axes. Raises InputError for a run that was not
        monitored, ImportError without matplotlib.
        """
        return _plot.run(self.history, self.summary.get("events", []), self.verdict, ax)

    def show(self) -> Any:
        """Shows the page about the run, with its body in 3-D, in a frame of a notebook. Raises ImportError without IPython."""
        html = importlib.import_module("IPython.display").HTML
        page = escape(report(self.folder).read_text(encoding="utf-8"))
        return html(f'<div><iframe title="Report" srcdoc="{page}" style="width: 100%; height: 48rem; border: 0"></iframe></div>')


@dataclass(frozen=True, slots=True, repr=False)
class Comparison(Result):
    """Error against cost of integrators on the motion of a scene: see `compare`."""

    title: str
    """Of the scene."""
    end: float
    """s, where the positions are compared."""
    reference_error: float
    """By how much the reference still changed as it was refined, relative to the displacement."""
    runs: dict[str, NDArray[Any]]
    """Columns with a row a run: integrator (or handler), h (s), error (of the positions over the displacement; NaN for a
    run that was lost), seconds, forces, products (tangent products), matrices, lost (why)."""
    cheapest: dict[str, dict[str, Any]]
    """By error, "1 %", "0.1 %" and "1e-6": by_time, seconds, h, by_forces, forces; empty where none reaches it."""

    def plot(self, ax: Any = None, *, against: str = "seconds") -> Any:
        """Draws the error over "seconds", or over "forces", which counts tangent products too; a curve an integrator.

        ax: matplotlib's Axes to draw into; None makes some. Returns the Axes. Raises InputError for another cost,
        ImportError without matplotlib.
        """
        return _plot.comparison(self.runs, self.title, against, ax)


@dataclass(frozen=True, slots=True, repr=False)
class Audit(Result):
    """What the results of another program prove of its run: see `audit`."""

    exit_status: int
    """0 every step that is known is proven, 1 a step is proven unstable, an element inverted or a state lost, 3 some step
    is not proven."""
    largest_share: float
    """The largest step used over the proven step of its state; NaN where the results tell no step."""
    found: dict[str, Any]
    """All that `ringwatch audit --json` writes."""

    def __str__(self) -> str:
        return self.message

    @property
    def message(self) -> str:
        """The audit in a line: its conclusion, and the first states in which something happened."""
        told = [f"first {what} in state {first['state']}" for what, first in self.found["first"].items() if first]
        return "; ".join([f"{self.found['results']}: {self.found['conclusion']}", *told])


document_fields(__name__)


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
    with _file_of(scene) as path:
        results = pathlib.Path(out) if out is not None else pathlib.Path("out") / path.stem
        status, _, complaint = _call(["run", str(path), "--quiet", "--out", str(results), "--threads", str(threads),
                                      *_settings(overrides)])
        if complaint and status in (_BAD_INPUT, _FAILED):
            _refuse(status, complaint, scene, path)
    summary = json.loads((results / "summary.json").read_text(encoding="utf-8"))
    return RunResult(status, bool(summary["stable"]), str(summary["verdict"]), results, summary,
                     _history(results / "history.csv"))


def compare(
    scene: str | os.PathLike[str] | Mapping[str, Any],
    *,
    integrators: Sequence[str] = ("all",),
    handlers: Sequence[str] = (),
    steps: Sequence[float] = (),
    out: str | os.PathLike[str] | None = None,
    overrides: Sequence[str] = (),
    threads: int = 1,
) -> Comparison:
    """Runs the motion of a scene with several integrators: error against cost, as `ringwatch compare` does.

    scene, overrides: as in `run`. integrators: names, or "all". handlers: also with these, on verlet. steps: s; else a
    range for each integrator, from its largest. out: folder for pictures; None for none. Raises InputError with the line
    that the program prints, NumericalError where there is no reference: the motion is chaotic or unstable.
    """
    for name, given in (("integrators", integrators), ("handlers", handlers)):
        if isinstance(given, str):
            raise InputError(f"{name}: {given!r}; must be a list of names")
    with _file_of(scene) as path:
        command = ["compare", str(path), "--json", "-", "--threads", str(threads), "--integrators", ",".join(integrators)]
        command += ["--handlers", ",".join(handlers)] if handlers else []
        command += ["--step", ",".join(repr(float(step)) for step in steps)] if len(steps) else []
        command += ["--out", str(out)] if out is not None else []
        status, told, complaint = _call([*command, *_settings(overrides)])
        if status:
            _refuse(status, complaint, scene, path)
    found = json.loads(told)
    runs = {}
    for name in ("integrator", "h", "error", "seconds", "forces", "products", "matrices", "lost"):
        values = [row[name] for row in found["runs"]]
        runs[name] = np.array([math.nan if value is None else value for value in values])
    return Comparison(found["title"], float(found["end"]), float(found["reference_error"]), runs,
                      {error: best or {} for error, best in found["cheapest"].items()})


def audit(
    results: str | os.PathLike[str] | Sequence[str | os.PathLike[str]],
    *,
    scene: str | os.PathLike[str] | None = None,
    step: float | None = None,
    density: float | None = None,
    model: str | None = None,
    integrator: str | None = None,
    limit: float | None = None,
    displacement: str | None = None,
    fix: Sequence[str] = (),
    every: int = 1,
    threads: int = 0,
    **parameters: float,
) -> Audit:
    """Holds the steps of another program against what is proven of its states, as `ringwatch audit` does.

    results: an .frd of CalculiX, a .pvd, or .vtu or .vtk files in their order. scene: a scene or a deck with materials and
    supports; else density (kg/m³) and the parameters of the law `model`, such as young (Pa) and poisson. step: s, that was
    taken; else by the results. integrator, limit: whose largest stable h omega counts. displacement: the field. fix: nodes
    that are held. every: every so many states. Raises InputError with the line that the program prints.
    """
    files = [results] if isinstance(results, (str, os.PathLike)) else list(results)
    command = ["audit", *map(str, files), "--json", "-", "--every", str(every), "--threads", str(threads)]
    numbers = {"step": step, "density": density, "limit": limit, **parameters}
    texts = {"scene": scene, "model": model, "integrator": integrator, "displacement": displacement}
    for name, value in numbers.items():
        command += [] if value is None else [f"--{name}", repr(float(value))]
    for name, text in texts.items():
        command += [] if text is None else [f"--{name}", str(text)]
    command += [word for nodes in fix for word in ("--fix", nodes)]
    command += [] if scene is not None else ["--units", _used_units()]
    status, told, complaint = _call(command)
    if not told:
        _refuse(status, complaint)
    found = json.loads(told)
    return Audit(status, float(found["steps"]["largest_share"]) if found["steps"] else math.nan, found)


def report(folder: str | os.PathLike[str], *, out: str | os.PathLike[str] | None = None, frames: int | None = None) -> pathlib.Path:
    """Writes the page about a run from what it left in its folder, as `ringwatch report` does. Returns its path.

    out: the file; else report.html in the folder. frames: the most frames in it. Raises InputError.
    """
    command = ["report", str(folder)]
    command += ["--out", str(out)] if out is not None else []
    command += ["--frames", str(frames)] if frames is not None else []
    status, _, complaint = _call(command)
    if status:
        _refuse(status, complaint)
    return pathlib.Path(out) if out is not None else pathlib.Path(folder) / "report.html"


@contextlib.contextmanager
def _file_of(scene: str | os.PathLike[str] | Mapping[str, Any]) -> Iterator[pathlib.Path]:
    """The scene's file; one that is removed again for a dict."""
    if not isinstance(scene, Mapping):
        yield pathlib.Path(scene)
        return
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "scene.toml"
        path.write_text(_toml(_with_absolute_mesh(scene)), encoding="utf-8")
        yield path


def _settings(overrides: Sequence[str]) -> list[str]:
    return [word for setting in overrides for word in ("--set", setting)]


def _refuse(status: int, complaint: str, scene: object = None, path: pathlib.Path | None = None) -> None:
    """Raises what the program printed last; a dict's file has no name that its writer would know."""
    line = complaint.split("\n")[-1].removeprefix("ringwatch: ")
    if isinstance(scene, Mapping):
        line = line.replace(str(path), "scene")
    raise InputError(line) if status == _BAD_INPUT else NumericalError(line)


def _call(arguments: list[str]) -> tuple[int, str, str]:
    """Exit status, standard output and standard error of the program. Ctrl-C ends a run after its step, with its results
    written."""
    program = pathlib.Path(__file__).parent / PROGRAM
    if not program.is_file():
        raise InputError(f"{program.resolve()}: there is no program; scenes and reports need it: build and install ringwatch_app")
    with subprocess.Popen([str(program), *arguments], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True, encoding="utf-8") as process:
        try:
            told, complaint = process.communicate()
        except KeyboardInterrupt:
            process.terminate()  # the second signal of one kind would end it at once, and Ctrl-C has reached it too
            process.wait()
            raise
    if process.returncode < 0:
        raise RuntimeError(f"ringwatch {arguments[0]} was ended by signal {-process.returncode}")
    return process.returncode, told, complaint.strip()


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
