"""Type hints: mypy --strict finds nothing in the package and in a program that uses all of it, and finds a seeded fault;
the hints of the extension are those of the extension itself."""
import ast
import dataclasses
import importlib
import inspect
import os
import pathlib
import pydoc
import subprocess
import sys
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

import ringwatch as rw
from support import BUILD

PACKAGE = pathlib.Path(rw.__file__).parent

PROGRAM = """
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

import ringwatch as rw

Reals = NDArray[np.float64]

mesh: rw.Mesh = rw.generate_mesh("bar", cells=[4, 1, 1], element="tet4")
body = rw.Body(mesh, rw.Material("stvk", young=30e3, poisson=0.3, density=1000))
body.fix(mesh.points[:, 0] < 1e-6, "xy", velocity=(0, 0, 1))
safe: float = rw.inspect(body, limit=2.0).safe
x, v = body.points.copy(), np.zeros_like(body.points)
monitor = rw.Monitor(body, limit=2.0)
report: rw.MonitorReport = monitor.observe(0, 0.0, x, v, safe, force=True)
if report.bracket is not None:
    both: float = report.bracket.safe + report.bracket.optimistic
energy: float = body.energy(x) + float(np.sum(body.internal_force(x) * v))
bracket = rw.TangentBracket(body.lumped_mass, mesh.cells["tet4"])
step: rw.CriticalStep = bracket.evaluate(body.element_tangents(x), limit=2.0)
spent: float = sum(rw.Monitor(body, budget=0.1).observe(0, 0.0, x, v).spent.values())


def euler(
    acceleration: Callable[[float, Reals, Reals], Reals], t: float, x: Reals, v: Reals, h: float
) -> tuple[float, Reals, Reals]:
    v = v + h * acceleration(t, x, v)
    return t + h, x + h * v, v


class Euler:
    def __call__(
        self, acceleration: Callable[[float, Reals, Reals], Reals], t: float, x: Reals, v: Reals, h: float
    ) -> tuple[float, Reals, Reals]:
        return euler(acceleration, t, x, v, h)


for found in (rw.verify(euler, limit=2, order=1), rw.verify(Euler, limit=2, order=1)):
    passed: bool = found.passed
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> pathlib.Path:
    """Where all calls of mypy run and keep what they know of numpy, which takes most of their time."""
    return tmp_path_factory.mktemp("types")


def mypy(folder: pathlib.Path, *arguments: Any) -> Any:
    return subprocess.run([sys.executable, "-m", "mypy", "--strict", "--cache-dir", str(folder / "cache"), *arguments],
                          capture_output=True, text=True, check=False, cwd=folder,
                          env={**os.environ, "MYPYPATH": f"{BUILD / 'python'}:{pathlib.Path(__file__).parent}"})


def test_package_and_users_are_strictly_typed(folder: pathlib.Path) -> None:
    (folder / "program.py").write_text(PROGRAM)
    told = mypy(folder, "-p", "ringwatch")
    assert told.returncode == 0, told.stdout
    told = mypy(folder, "program.py")
    assert told.returncode == 0, told.stdout
    (folder / "wrong.py").write_text(PROGRAM.replace("limit=2.0)\nreport", "limt=2.0)\nreport"))
    told = mypy(folder, "wrong.py")
    assert told.returncode == 1 and "limt" in told.stdout


def test_the_tests_are_strictly_typed(folder: pathlib.Path) -> None:
    """They use all of the interface, so its hints are held to what it does."""
    told = mypy(folder, *sorted(str(path) for path in pathlib.Path(__file__).parent.glob("*.py")))
    assert told.returncode == 0, told.stdout


def test_the_program_runs() -> None:
    subprocess.run([sys.executable, "-c", PROGRAM], check=True)


@pytest.mark.parametrize("name", ["_ringwatch", "_verify"])
def test_hints_are_those_of_the_extensions(name: str) -> None:
    """Names of an extension against its hints, and the other way round."""
    hints = {}
    for node in ast.parse((PACKAGE / f"{name}.pyi").read_text()).body:
        if isinstance(node, ast.ClassDef):
            hints[node.name] = {member.name for member in node.body if isinstance(member, ast.FunctionDef)}
        elif isinstance(node, ast.FunctionDef):
            hints[node.name] = set()
    there = {}
    for name, value in vars(importlib.import_module(f"ringwatch.{name}")).items():
        if isinstance(value, type):
            there[name] = {member for member in vars(value) if not member.startswith("_") or member == "__init__"}
        elif callable(value):
            there[name] = set()
    assert hints == there


def signature_of_hint(function: ast.FunctionDef) -> inspect.Signature:
    """Names, kinds and defaults of a function in the hints."""
    made: dict[str, Any] = {}
    bare = ast.parse(f"def made({ast.unparse(function.args)}): ...").body[0]
    assert isinstance(bare, ast.FunctionDef)
    for argument in [*bare.args.posonlyargs, *bare.args.args, *bare.args.kwonlyargs, bare.args.kwarg]:
        if argument is not None:
            argument.annotation = None
    exec(ast.unparse(bare), made)
    parameters = list(inspect.signature(made["made"]).parameters.values())
    return inspect.Signature([p for p in parameters if p.name != "self"])


def test_help_shows_the_signatures_of_the_hints() -> None:
    """What `help`, `inspect` and editors read of functions, classes and methods against the hints, with every default."""
    compared = 0
    for node in ast.parse((PACKAGE / "_ringwatch.pyi").read_text()).body:
        thing = getattr(rw, node.name, None) if isinstance(node, (ast.ClassDef, ast.FunctionDef)) else None
        members = node.body if isinstance(node, ast.ClassDef) else [node]
        for member in members:
            if thing is None or not isinstance(member, ast.FunctionDef) or member.decorator_list:
                continue
            called = thing if member.name in ("__init__", thing.__name__) else getattr(thing, member.name)
            shown = inspect.signature(called)
            bound = [p for p in shown.parameters.values() if p.name != "self"]
            assert inspect.Signature(bound) == signature_of_hint(member), member.name
            assert str(shown) in pydoc.render_doc(thing, renderer=pydoc.plaintext)  # type: ignore[attr-defined]
            compared += 1
    assert compared >= 17


def test_what_is_shown_is_a_few_words() -> None:
    """Of everything that the module returns: no address, no long array, at most two lines."""
    body = rw.Body(mesh := rw.generate_mesh("bar", cells=[4, 1, 1]), rw.Material("stvk", young=30e3, poisson=0.3, density=1000))
    step = rw.inspect(body, metrics=list(rw.metric_names())[:3], exact=True)
    monitor = rw.Monitor(body)
    report = monitor.observe(0, 0.0, body.points * 1.5, np.zeros_like(body.points), step.safe, force=True)
    tangents = rw.TangentBracket(body.lumped_mass, mesh.cells["tet4"])
    things = [mesh, body, rw.Material("stvk", young=30e3, poisson=0.3, density=1000), step, step.controlling, step.cause, *step.metrics.values(),
              monitor, report, report.bracket, *report.new_events, tangents, tangents.evaluate(body.element_tangents(body.points))]
    for thing in things:
        for text in (str(thing), repr(thing)):
            assert text.count("\n") <= 1 and len(text) <= 600 and " at 0x" not in text and "array([" not in text, text
    assert f"{step.safe:.6g}" in str(step) and str(step.controlling) in str(step)
    assert f"{mesh.points.shape[0]} nodes" in repr(mesh) and "tet4" in repr(mesh)
    assert report.bracket is not None
    for result in (step, report, report.bracket):  # what a notebook shows
        shown = ElementTree.fromstring(f"<div>{result._repr_html_()}</div>")
        assert shown.findtext("p") == str(result)
        assert [row.findtext("th") for row in shown.iter("tr")] == [field.name for field in dataclasses.fields(result)]


@pytest.mark.parametrize("name", rw.__all__)
def test_everything_public_is_documented(name: str) -> None:
    thing = getattr(rw, name)
    assert name == "__version__" or thing.__doc__ and not thing.__doc__.startswith(f"{name}(")
    if isinstance(thing, type) and thing.__module__ == "ringwatch._ringwatch":
        for member, value in vars(thing).items():
            if not member.startswith("_") and member not in ("node_count", "element_count", "model"):
                assert value.__doc__, f"{name}.{member}"


@pytest.mark.parametrize("name", [name for name in rw.__all__ if dataclasses.is_dataclass(getattr(rw, name))])
def test_help_tells_what_every_field_is(name: str) -> None:
    """The text that stands below the field in the source, which the next quotes of the file begin."""
    thing = getattr(rw, name)
    source = inspect.getsource(thing)
    shown = " ".join(pydoc.render_doc(thing, renderer=pydoc.plaintext).replace("|", " ").split())  # type: ignore[attr-defined]
    for field in dataclasses.fields(thing):
        _, _, below = source.partition(f"\n    {field.name}: ")
        text = below.split('"""')[1]
        assert below.index('"""') == below.index("\n") + 5, field.name
        assert " ".join(text.split()) in shown, field.name
