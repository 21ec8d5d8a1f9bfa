"""An error is one line, the same that the program prints; the exception is rw.InputError, a ValueError."""
import pathlib
import subprocess
from typing import Any

import numpy as np
import pytest

import ringwatch as rw
from support import MATERIAL, PROGRAM, bar, body_of, two_elements


def line_of(*arguments: Any) -> Any:
    """What the program complains of, without its name."""
    ended = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, check=False)
    assert ended.returncode == 2, ended.stderr
    return ended.stderr.strip().removeprefix("ringwatch: ")


def message(call: Any, *arguments: Any, error: Any = rw.InputError, **options: Any) -> Any:
    with pytest.raises(error) as raised:
        call(*arguments, **options)
    assert "\n" not in str(raised.value)
    return str(raised.value)


BROKEN = {
    "missing.msh": None,
    "empty.msh": "",
    "words.msh": "$MeshFormat\nnot a number\n",
    "mesh.xyz": "1 2 3\n",
    "flat.inp": "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 1, 1, 0\n"
                "*ELEMENT, TYPE=C3D4\n1, 1, 2, 3, 4\n",
}


@pytest.mark.parametrize("name", BROKEN)
def test_a_broken_file_is_named_as_the_program_names_it(tmp_path: pathlib.Path, name: str) -> None:
    path = tmp_path / name
    content = BROKEN[name]
    if content is not None:
        path.write_text(content)
    expected = line_of("inspect", path, "--young", "1", "--poisson", "0.3", "--density", "1")
    assert str(path) in expected
    assert message(rw.load_mesh, path) == expected == message(rw.load_mesh, str(path))


def test_materials() -> None:
    with pytest.raises(ValueError):
        rw.Material("stvk", young=-1, poisson=0.3, density=1000)
    assert "young" in message(rw.Material, "stvk", young=-1, poisson=0.3, density=1000)
    assert "poisson" in message(rw.Material, "stvk", young=1, poisson=0.5, density=1000)
    assert "density" in message(rw.Material, "stvk", young=1, poisson=0.3, density=0)
    assert "neo-hookean" in message(rw.Material, "neo-hokean", young=1, poisson=0.3, density=1)
    assert "youngs" in message(rw.Material, "stvk", youngs=1, poisson=0.3, density=1)
    assert message(rw.Material, "stvk", young="soft", poisson=0.3, density=1).startswith("young: an object of type str")
    with pytest.raises(TypeError):
        rw.Material("stvk", young=1, poisson=0.3)  # type: ignore[call-arg]


def test_bodies() -> None:
    mesh = bar()
    material = rw.Material("stvk", **MATERIAL)
    assert "lumping" in message(rw.Body, mesh, material, lumping="rows")
    assert "rule" in message(rw.Body, mesh, material, rules={"tet4": "none"})
    assert message(rw.Body, mesh, material, threads=-1) == "threads = -1: must be 0, for all, or more"
    assert message(rw.Body, mesh, "stvk").startswith("material: an object of type str; must be a Material")
    message(rw.Body, mesh, [material, material])
    body = rw.Body(mesh, material)
    assert "components" in message(body.fix, np.array([0]), "xx")
    assert message(body.fix, np.array([20])) == "nodes: 20 is out of range; must be 0 to 19"
    assert message(body.fix, np.zeros(3, dtype=bool)).startswith("nodes: an array of bool of shape (3,)")
    assert message(body.fix, np.array([0]), velocity=(0, np.nan, 0)).startswith("velocity: nan m/s")
    assert message(body.element_tangents, body.points, 1) == "block = 1: must be 0 to 0"


def test_limits_and_names() -> None:
    body = body_of(bar())
    for limit in (0, -1, np.inf, np.nan):
        assert message(rw.inspect, body, limit=limit).startswith(f"limit = {limit}: must be > 0")
    message(rw.Monitor, body, limit=0.0)
    assert "metric" in message(rw.inspect, body, metrics=["single-elemnt"])
    assert "mode" in message(rw.Monitor, body, mode="brackets")
    assert "margin" in message(rw.Monitor, body, margin=1.0)
    assert "no metric was asked for" in message(lambda: rw.inspect(body, metrics=[]).element_steps)
    x = np.zeros_like(body.points)
    assert "h = 0 s" in message(rw.Monitor(body).observe, 0, 0.0, body.points, x, 0.0)
    assert "radius" in message(rw.generate_mesh, "ball", radius=-1.0)
    assert "bar" in message(rw.generate_mesh, "baar")
    assert "cells" in message(rw.generate_mesh, "bar", cells={"x": 1})


def test_mathematics_refuses() -> None:
    body = body_of(bar())
    x = body.points.copy()
    x[0, 0] = np.inf
    message(rw.inspect, body, x, error=rw.NumericalError)
    assert issubclass(rw.NumericalError, ArithmeticError) and issubclass(rw.InputError, ValueError)
    assert rw.InputError.__module__ == "ringwatch"


def test_tangent_brackets() -> None:
    nodes = np.array([[0, 1], [1, 2]])
    mass = np.ones(3)
    K = np.tile(np.kron(np.array([[1.0, -1], [-1, 1]]), np.diag([1.0, 0, 0])), (2, 1, 1))
    bracket = rw.TangentBracket(mass, nodes)
    assert message(bracket.evaluate, K[:1]).startswith(
        "tangents: an array of float64 of shape (1, 6, 6) in C order; must be an array of float64 of shape (2, 6, 6)")
    assert message(bracket.evaluate, K.astype(np.float32)).startswith("tangents: an array of float32")
    assert message(bracket.evaluate, K.transpose(0, 2, 1)).startswith("tangents: ") and K.flags.c_contiguous
    assert message(bracket.evaluate, [K, K]) == "tangents: 2 arrays for 1 groups of elements; must be one for each"
    K[1, 0, 3] = 5
    assert "group 0, element 1" in message(bracket.evaluate, K)
    K[1, 0, 3] = np.nan
    assert "group 0, element 1" in message(bracket.evaluate, K)
    assert "mass" in message(rw.TangentBracket, -mass, nodes)
    assert message(rw.TangentBracket, mass, nodes + 1) == "elements: 3 is out of range; must be 0 to 2"
    assert message(rw.TangentBracket, mass.astype(int), nodes).startswith("mass: an array of int64 of shape (3,)")
    assert message(rw.TangentBracket, mass.tolist(), nodes).startswith("mass: an object of type list")
    assert message(rw.TangentBracket, np.ones((3, 2, 3)), nodes).startswith("mass: an array of float64 of shape (3, 2, 3)")
    assert message(rw.TangentBracket, mass, nodes, np.zeros((3, 2), dtype=bool)).startswith(
        "constrained: an array of bool of shape (3, 2) in C order; must be an array of bool of shape (3, 3)")


def test_other_objects_are_no_meshes() -> None:
    points, cells = two_elements()

    class Cells:
        type, data = "tetra11", cells

    class Other:
        points: Any
        cells: Any

    other = Other()
    assert message(rw.mesh_from, other).startswith("mesh_from: an object of type Other")
    other.points, other.cells = points, [Cells()]
    assert message(rw.mesh_from, other).startswith("mesh_from: unknown cells 'tetra11'; known are tetra, ")
