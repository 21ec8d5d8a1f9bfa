"""The step of arrays against the program's answer for the same body, and against eigenvalues of numpy."""
import json
import pathlib
from typing import Any

import numpy as np
import pytest

import ringwatch as rw
from support import PROGRAM, Reals, bar, call

YOUNG, POISSON = 3e4, 0.3


def arrays(**parameters: Any) -> Any:
    mesh = bar(cells=[4, 2, 1], **parameters)
    return mesh.points.copy(), mesh.cells["tet4"].copy()


def critical_step(points: Reals, cells: Any, mass: Reals, held: Any, x: Any = None) -> float:
    """2 / omega of the assembled tangent."""
    body = rw.Body(rw.Mesh(points, {"tet4": cells}), rw.Material("stvk", young=YOUNG, poisson=POISSON, density=1.0))
    count = 3 * len(points)
    K = np.zeros((count, count))
    for nodes, own in zip(cells, body.element_tangents(points if x is None else x)):
        rows = (3 * nodes[:, None] + np.arange(3)).ravel()
        K[np.ix_(rows, rows)] += own
    free = np.repeat(~held, 3)
    scale = np.sqrt(np.repeat(mass, 3)[free])
    return float(2 / np.sqrt(np.linalg.eigvalsh(K[np.ix_(free, free)] / np.outer(scale, scale)).max()))


def test_it_is_the_step_of_numpys_matrices() -> None:
    points, cells = arrays()
    mass = 1e-3 * (1 + np.arange(len(points)) % 4)
    held = points[:, 0] < 1e-6
    for own in (mass, np.where(held, 0, mass)):
        exact = critical_step(points, cells, mass, held)
        found = rw.suggest(points, cells, YOUNG, POISSON, own, 3 * exact, held=None if (own == 0).any() else held)
        assert found.safe <= exact <= found.optimistic <= 1.05 * found.safe
        assert (found.verdict, found.dt) == ("violated", 3 * exact)
        assert found.substeps is not None and found.substep is not None
        assert found.substeps in (3, 4) and found.substep == 3 * exact / found.substeps <= found.safe
    assert rw.suggest(points, cells, YOUNG, POISSON, mass, 0.5 * found.safe).verdict == "certified"
    middle = rw.suggest(points, cells, YOUNG, POISSON, mass, 0.5 * (found.safe + found.optimistic), held=held)
    assert middle.verdict == "not-certified" and "neither proven" in str(middle)
    assert rw.suggest(points, cells, YOUNG, POISSON, mass).substeps is None


def test_a_scene_of_the_same_body_has_the_same_answer(tmp_path: pathlib.Path) -> None:
    points, cells = arrays()
    rw.Mesh(points, {"tet4": cells}).save(tmp_path / "bar.msh")
    dt = 2e-3
    (tmp_path / "scene.toml").write_text(
        f'[mesh]\nfile = "bar.msh"\n[material]\nmodel = "stvk"\nyoung = {YOUNG}\npoisson = {POISSON}\ndensity = 1000\n'
        f'[integrator]\nstep = {dt}\nend = 1\n', encoding="utf-8")
    told = json.loads(call(PROGRAM, "suggest", tmp_path / "scene.toml", "--json", "-").stdout)
    found = rw.suggest(points, cells, young=YOUNG, poisson=POISSON, density=1000, dt=dt)
    assert found.optimistic == pytest.approx(told["start"]["optimistic"], rel=1e-2)
    assert found.safe == pytest.approx(told["start"]["safe"], rel=1e-2)
    assert (found.verdict, found.substeps) == (told["timestep"]["verdict"], told["timestep"]["steps"])


def test_cells_of_either_order_float32_and_points_of_no_cell_are_taken() -> None:
    points, cells = arrays()
    mass = np.full(len(points), 2e-3)
    usual = rw.suggest(points, cells, YOUNG, POISSON, mass, 1e-3)
    turned = cells.copy()
    turned[::2] = turned[::2][:, [1, 0, 2, 3]]
    more = np.concatenate([points, [[9.0, 9, 9]]])
    found = rw.suggest(more.astype(np.float32), turned.astype(np.int64), YOUNG, POISSON,
                       np.append(mass, 1).astype(np.float32), np.float32(1e-3))
    assert found.safe == pytest.approx(usual.safe, rel=1e-5)
    assert found.verdict == usual.verdict


def test_the_least_step_of_a_batch_counts() -> None:
    points, cells = arrays()
    mass, held = np.full(len(points), 2e-3), np.zeros(len(points), dtype=bool)
    batch = np.stack([points, points * (1.2, 1, 1), points])
    found = rw.suggest(points, cells, YOUNG, POISSON, mass, 1e-3, x=batch)
    exact = critical_step(points, cells, mass, held, batch[1].copy())
    assert found.state == 1
    assert found.safe <= exact <= found.optimistic
    assert found.safe == rw.suggest(points, cells, YOUNG, POISSON, mass, 1e-3, x=batch[1]).safe


def test_no_step_of_an_indefinite_tangent_is_certified() -> None:
    points, cells = arrays()
    mass = np.full(len(points), 2e-3)
    batch = np.stack([points, points * (0.5, 1, 1)])
    found = rw.suggest(points, cells, YOUNG, POISSON, mass, 1e-6, x=batch)
    assert (found.verdict, found.substeps) == ("not-certified", None)
    assert found.lowest_eigenvalue is not None and found.lowest_eigenvalue < 0
    assert str(found) == (f"dt = 1e-06 s is not proven stable: the tangent is indefinite, eigenvalue "
                          f"{found.lowest_eigenvalue:.6g} rad2/s2: no step cures that")
    assert rw.suggest(points, cells, YOUNG, POISSON, mass, 1, x=batch).verdict == "violated"
    assert rw.suggest(points, cells, YOUNG, POISSON, mass, 1e-6).lowest_eigenvalue is None


def test_what_does_not_fit_is_named() -> None:
    points, cells = arrays()
    mass = np.full(len(points), 2e-3)

    def refuse(what: str, *arguments: Any, **named: Any) -> None:
        with pytest.raises(rw.InputError, match=what):
            rw.suggest(*arguments, **named)

    refuse(r"points: an array of float64 of shape \(30, 2\); must be numbers of shape \(N, 3\)", points[:, :2], cells, YOUNG, POISSON, mass)
    refuse(r"cells: an array of float64", points, cells.astype(float), YOUNG, POISSON, mass)
    refuse(r"cells: points 0 to 99; there are 30, counted from 0", points, np.where(cells == 29, 99, cells), YOUNG, POISSON, mass)
    refuse("masses, density: one of them is needed", points, cells, YOUNG, POISSON)
    refuse("masses, density: one of them is needed", points, cells, YOUNG, POISSON, mass, density=1)
    refuse(r"masses: an array of float64 of shape \(29,\); must be numbers of shape \(30,\)", points, cells, YOUNG, POISSON, mass[1:])
    refuse("masses: -0.002 kg; must be >= 0", points, cells, YOUNG, POISSON, -mass)
    refuse("masses: has numbers that are not finite", points, cells, YOUNG, POISSON, mass * np.nan)
    refuse("every point is held", points, cells, YOUNG, POISSON, 0 * mass)
    refuse("dt = 0: must be > 0, s", points, cells, YOUNG, POISSON, mass, 0)
    refuse(r"held: an array of int64 of shape \(1,\); must be flags of shape \(30,\)", points, cells, YOUNG, POISSON, mass, held=[3])
    refuse(r"x: an array of float64 of shape \(1, 29, 3\); must be numbers of shape \(B, 30, 3\)", points, cells, YOUNG, POISSON, mass, x=points[1:])
    refuse("poisson", points, cells, YOUNG, 0.5, mass)
    flat = points * (1, 1, 0)
    with pytest.raises((rw.InputError, rw.NumericalError)):
        rw.suggest(flat, cells, YOUNG, POISSON, mass)
