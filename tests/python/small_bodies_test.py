"""Bodies of one and two elements, and steps above 2^31, through the module: brackets hold the step of a stiffness that is built here."""
import numpy as np
import pytest
from numpy.typing import NDArray

import ringwatch as rw

POINTS = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)], dtype=float)
CELLS = np.array([(0, 1, 2, 3), (1, 2, 3, 4)])
YOUNG, POISSON, DENSITY = 3e4, 0.3, 1e3
LARGE = 2**31 + 3


def critical_step(points: NDArray[np.float64], cells: NDArray[np.int64]) -> float:
    """Of Hooke's law at one point of each tetrahedron, with a quarter of its mass at each node, s."""
    shear, first = YOUNG / (2 * (1 + POISSON)), YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON))
    stiffness, mass = np.zeros((3 * len(points), 3 * len(points))), np.zeros(3 * len(points))
    for cell in cells:
        edges = points[cell[1:]] - points[cell[0]]
        volume = abs(np.linalg.det(edges)) / 6
        gradients = np.linalg.inv(edges).T
        gradients = np.vstack([-gradients.sum(axis=0), gradients])
        for a, b in np.ndindex(4, 4):
            ga, gb = gradients[a], gradients[b]
            block = first * np.outer(ga, gb) + shear * (np.outer(gb, ga) + ga @ gb * np.eye(3))
            stiffness[3 * cell[a] : 3 * cell[a] + 3, 3 * cell[b] : 3 * cell[b] + 3] += volume * block
        for node in cell:
            mass[3 * node : 3 * node + 3] += DENSITY * volume / 4
    return float(2 / np.sqrt(np.linalg.eigvalsh(stiffness / np.sqrt(np.outer(mass, mass)))[-1]))


@pytest.mark.parametrize("elements", [1, 2])
def test_brackets_of_few_elements_hold_the_step(elements: int) -> None:
    points, cells = POINTS[: 3 + elements], CELLS[:elements]
    body = rw.Body(rw.Mesh(points, {"tet4": cells}), rw.Material("linear", young=YOUNG, poisson=POISSON, density=DENSITY))
    exact, rest = critical_step(points, cells), np.zeros_like(points)
    for mode in ("bracket", "threshold"):
        monitor = rw.Monitor(body, mode=mode)
        for step in (0, 1, LARGE, LARGE + 1):
            report = monitor.observe(step, 1e-3 * step, points, rest, 0.5 * exact)
            assert report.step == step and report.verdict == "certified"
            if report.bracket is not None:
                assert report.bracket.safe <= exact * (1 + 1e-9) and exact <= report.bracket.optimistic * (1 + 1e-9)
        assert monitor.observe(LARGE + 2, 1e-3 * LARGE, points, rest, 1.5 * exact).verdict != "certified"
        assert all(event.step == LARGE + 2 for event in monitor.events)


def test_a_mesh_of_no_elements_is_refused() -> None:
    with pytest.raises(rw.InputError, match="there are no elements"):
        rw.Mesh(POINTS[:4], {"tet4": CELLS[:0]})
