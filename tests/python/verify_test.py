"""An integrator that is written in Python is measured as its twin in C++ is, and one with a fault is caught."""
import json
import math
from typing import Any

import numpy as np
import pytest

import ringwatch as rw
from support import PROGRAM, call

KIND: dict[str, Any] = {"limit": 2, "order": 2, "forces": 1, "symplectic": True, "reversible": True}


class Verlet:
    """Velocity Verlet that keeps its last acceleration."""

    def __init__(self) -> None:
        self.a: Any = None

    def __call__(self, acceleration: Any, t: Any, x: Any, v: Any, h: Any) -> Any:
        if self.a is None:
            self.a = acceleration(t, x, v)
        v += h / 2 * self.a
        x += h * v
        self.a = acceleration(t + h, x, v)
        return t + h, x, v + h / 2 * self.a


def symplectic_euler(acceleration: Any, t: Any, x: Any, v: Any, h: Any) -> Any:
    v = v + h * acceleration(t, x, v)
    return t + h, x + h * v, v


def rk4(acceleration: Any, t: Any, x: Any, v: Any, h: Any) -> Any:
    def slope(dt: Any, dx: Any, dv: Any) -> Any:
        return v + dt * dv, acceleration(t + dt, x + dt * dx, v + dt * dv)

    none = np.zeros_like(x)
    a = slope(0, none, none)
    b = slope(h / 2, *a)
    c = slope(h / 2, *b)
    d = slope(h, *c)
    return (t + h, *(y + h / 6 * (p + 2 * q + 2 * r + s) for y, p, q, r, s in zip((x, v), a, b, c, d)))


@pytest.fixture(scope="module")
def of_program(tmp_path_factory: pytest.TempPathFactory) -> Any:
    """What `ringwatch verify integrators` measures of the integrators of the library."""
    path = tmp_path_factory.mktemp("verify") / "verify.json"
    call(PROGRAM, "verify", "integrators", "--quick", "--json", path)
    return json.loads(path.read_text())["studies"]["integrators"]["tables"]


def rows_of(tables: Any, table: Any, name: str) -> Any:
    return [row for row in tables[table] if row["integrator"] == name]


@pytest.mark.parametrize("twin, integrator, declared", [
    ("symplectic-euler", symplectic_euler, {"limit": 2, "order": 1, "forces": 1, "symplectic": True}),
    ("verlet", Verlet, {"limit": 2, "order": 2, "symplectic": True, "reversible": True}),
    ("rk4", rk4, {"limit": math.sqrt(8), "order": 4, "damped_order": 4, "forces": 4}),
])
def test_twins_in_both_languages(of_program: Any, twin: Any, integrator: Any, declared: Any) -> None:
    found = rw.verify(integrator, **declared)
    assert found.passed and all(check.passed for check in found.checks), str(found)
    assert found.name == integrator.__name__ and len(found.checks) >= 9
    (limits,), (theirs,) = rows_of(found.tables, "limits", found.name), rows_of(of_program, "limits", twin)
    assert limits["measured"] == pytest.approx(theirs["measured"], rel=1e-10)
    ours, theirs = rows_of(found.tables, "damped_limits", found.name), rows_of(of_program, "damped_limits", twin)
    assert len(ours) == len(theirs) == 8
    if twin != "verlet":  # it evaluates the damping once a step, with a velocity that the library's takes otherwise
        for one, other in zip(ours, theirs):
            assert one["damping ratio"] == other["damping ratio"]
            assert one["measured"] == pytest.approx(other["measured"], rel=1e-9)
    (orders,), (theirs,) = rows_of(found.tables, "orders", found.name), rows_of(of_program, "orders", twin)
    assert orders["order"] == pytest.approx(theirs["order"], rel=1e-6)
    if twin != "verlet":
        assert orders["order, damped"] == pytest.approx(theirs["order, damped"], rel=9e-6)  # measured: 2.9e-6
    assert orders["forces a step"] == theirs["forces a step"]
    for one, other in zip(rows_of(found.tables, "drift", found.name), rows_of(of_program, "drift", twin)):
        assert one["oscillation"] == pytest.approx(other["oscillation"], rel=1e-9)
    for one, other in zip(rows_of(found.tables, "observed", found.name), rows_of(of_program, "observed", twin)):
        if "damped" not in one["system"] and one["system"] == other["system"]:
            assert one["observed (s)"] == pytest.approx(other["observed (s)"], rel=1e-4)


def drifting(acceleration: Any, t: Any, x: Any, v: Any, h: Any) -> Any:
    t, x, v = symplectic_euler(acceleration, t, x, v, h)
    return t, x, v * (1 + 1e-9 * h)


def failed(integrator: Any, **declared: Any) -> Any:
    return [check.name.split(": ", 1)[1] for check in rw.verify(integrator, **declared).checks if not check.passed]


def test_faults_are_caught() -> None:
    kind: dict[str, Any] = {"limit": 2, "order": 1, "forces": 1, "symplectic": True}
    assert failed(symplectic_euler, **kind) == []
    assert failed(symplectic_euler, **{**kind, "limit": 2.001})[0] == "limit on the imaginary axis"
    assert failed(symplectic_euler, **{**kind, "order": 2}) == ["order", "order with forces of time that are not linear"]
    assert failed(symplectic_euler, **{**kind, "forces": 2}) == ["forces a step"]
    assert failed(symplectic_euler, **kind, reversible=True) == ["reversible: 100 steps and back"]
    assert failed(lambda a, t, x, v, h: (t, *symplectic_euler(a, t, x, v, h)[1:]), **kind)[:2] == [
        "time advances by h in every step: relative error", "time advances by 100 h in 100 steps: relative error"]
    late = failed(lambda a, t, x, v, h: symplectic_euler(lambda s, y, w: a(s + h, y, w), t, x, v, h), **kind)
    assert late == ["forces at the times of their positions: difference in a frame that moves"]
    assert "energy drift over 1e6 periods, by powers" in failed(drifting, **kind)
    explicit = failed(lambda a, t, x, v, h: (t + h, x + h * v, v + h * a(t, x, v)), **kind)
    assert "limit on the imaginary axis" in explicit and "symplectic: |det - 1|" in explicit
    assert failed(lambda a, t, x, v, h: (t + h, x + h * v, v + h * np.sin(a(t, x, v))), **kind) == [
        "steps a linear oscillator by a linear recursion"]


def test_what_is_no_integrator_is_refused() -> None:
    def wrong(made: Any) -> Any:
        return lambda acceleration, t, x, v, h: made(acceleration, t, x, v, h)

    integrator: Any
    declared: Any
    for integrator, said in (
            (wrong(lambda a, t, x, v, h: x), "integrator: returned an array of float64 .*; must return a tuple"),
            (wrong(lambda a, t, x, v, h: ("now", x, v)), "an object of type str as the time; must be a number"),
            (wrong(lambda a, t, x, v, h: (t, x.T, v)), r"integrator: x: an array of float64 of shape \(3, 1\)"),
            (wrong(lambda a, t, x, v, h: (t, x, v.astype(np.float32))), "integrator: v: an array of float32"),
            (wrong(lambda a, t, x, v, h: a(t, x[0], v)), r"acceleration: x: an array of float64 of shape \(3,\)"),
            (5, "integrator: an object of type int; must be a function")):
        with pytest.raises(rw.InputError, match=said):
            rw.verify(integrator, **KIND)
    for declared, said in (({"limit": -1}, "limit = -1: must be >= 0"), ({"limit": math.nan}, "limit = nan"),
                           ({"order": 0}, "order = 0: must be at least 1"), ({"forces": -1}, "forces = -1"),
                           ({"damped_order": 0}, "damped_order = 0"), ({"effort": "some"}, "unknown 'some'; known are quick, full")):
        with pytest.raises(rw.InputError, match=said):
            rw.verify(symplectic_euler, **{**KIND, **declared})


def test_what_the_integrator_raises_comes_through() -> None:
    def careless(acceleration: Any, t: Any, x: Any, v: Any, h: Any) -> Any:
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        rw.verify(careless, **KIND)


def test_an_acceleration_ends_with_its_step() -> None:
    kept: list[Any] = []

    def keeping(acceleration: Any, t: Any, x: Any, v: Any, h: Any) -> Any:
        if kept:
            kept[0](t, x, v)
        kept.append(acceleration)
        return symplectic_euler(acceleration, t, x, v, h)

    with pytest.raises(rw.InputError, match="acceleration: called after the step"):
        rw.verify(keeping, **KIND)


def test_judges_a_rule_of_python() -> None:
    def shortest_edge(points: Any, cells: Any, young: float, poisson: float, density: float) -> float:
        speed = math.sqrt(young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson)) / density)
        pairs = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)]
        return min(float(np.linalg.norm(points[nodes[:, a]] - points[nodes[:, b]], axis=1).min())
                   for element, nodes in cells if element == "tet4" for a, b in pairs) / speed

    found = rw.judge(shortest_edge, elements=["tet4"], shapes=3)
    assert not found.passed and found.name == "shortest_edge"
    same = json.loads(call(PROGRAM, "judge", "--metric", "pressure-wave:shortest-edge", "--elements", "tet4", "--shapes", "3",
                           "--json", "-", status=1).stdout)["studies"]["judge"]["tables"]["judge"]
    for mine, theirs in zip(found.tables["judge"], same, strict=True):
        assert mine["on"] == theirs["on"] and mine["unsafe"] == theirs["unsafe"]
        assert mine["largest step over exact"] == pytest.approx(theirs["largest step over exact"], rel=1e-9)
    assert rw.judge(lambda *_: 1e-9, shapes=1, elements=["hex8"], histories=True).passed
    bad: Any
    for bad, said in ((5, "rule: an object of type int"), (lambda *_: "now", "rule: returned an object of type str"),
                      (lambda *_: -1.0, "the rule gives -1 s; must be above 0 and finite")):
        with pytest.raises(rw.InputError, match=said):
            rw.judge(bad)
    with pytest.raises(rw.InputError, match="shapes = -1"):
        rw.judge(shortest_edge, shapes=-1)
    with pytest.raises(rw.InputError, match="nothing to judge"):
        rw.judge(shortest_edge, shapes=0)
    assert [row["on"] for row in rw.judge(lambda *_: 1e-9, shapes=1, elements="wedge6").tables["judge"]] == ["wedges"]
