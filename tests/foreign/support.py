"""What the tests with foreign solvers share. A test whose solver is not installed is skipped by name (exit status 77)."""

import importlib
import sys

import numpy as np


def need(module):
    """A module, or the end of the test."""
    try:
        return importlib.import_module(module)
    except ImportError as fault:
        print(f"skipped: {module} is not installed (scripts/setup --foreign): {fault}")
        sys.exit(77)


YOUNG, POISSON, DENSITY = 1e6, 0.3, 1000.0  # Pa, 1, kg/m3
MU = YOUNG / (2 * (1 + POISSON))
LAMBDA = YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON))
WAVE = np.sqrt((LAMBDA + 2 * MU) / DENSITY)  # m/s, of pressure


def exact_step(K, mass, free):
    """2/omega of the assembled stiffness (N/m) and the lumped masses (kg, one a degree of freedom), on free degrees."""
    scale = 1 / np.sqrt(mass[free])
    return 2 / np.sqrt(np.linalg.eigvalsh(K[np.ix_(free, free)] * scale[:, None] * scale[None, :])[-1])


def assemble(nodes, tangents, count):
    """Element tangents (elements, 3 n, 3 n) summed into the matrix of all degrees of freedom."""
    K = np.zeros((3 * count, 3 * count))
    for element, tangent in zip(nodes, tangents):
        rows = (3 * element[:, None] + np.arange(3)).ravel()
        K[np.ix_(rows, rows)] += tangent
    return K


def shortest_edge(points, nodes):
    """m, of the pairs of corners of simplices."""
    corners = points[nodes[:, :4]]
    return min(
        np.linalg.norm(corners[:, a] - corners[:, b], axis=1).min() for a in range(4) for b in range(a + 1, 4)
    )


def pulled(program, points, nodes, tangents, theirs, force, matrix, mass, speed, steps):
    """An explicit run of a foreign solver's bar, pulled along x with the speed (m/s) at a step fixed at the start, with
    the bracket at every step. tangents(u), force(u) and matrix(u) are the solver's; theirs: its own step rule, s."""
    import ringwatch as rw

    length = points[:, 0].max()
    left, right = points[:, 0] < 1e-9, points[:, 0] > length - 1e-9
    held = np.zeros(points.shape, bool)
    held[left | right] = True
    bracket = rw.TangentBracket(mass, nodes, held)
    free, masses = np.flatnonzero(~held.ravel()), np.repeat(mass, 3)
    u, v = np.zeros_like(points), np.zeros_like(points)
    v[right, 0] = speed

    def checked(u):
        step = bracket.evaluate(tangents(u), limit=2.0)
        exact = exact_step(matrix(u), masses, free)
        assert step.safe <= exact * (1 + 1e-9) and exact * (1 - 1e-9) <= step.optimistic, (step, exact)
        return step, exact

    rest, exact = checked(u)
    edge = shortest_edge(points, nodes) / WAVE
    print(f"{program}: at rest safe {rest.safe:.6e} s, exact {exact:.6e} s, optimistic {rest.optimistic:.6e} s")
    print(f"{program}: bracket {100 * (rest.optimistic / rest.safe - 1):.3f} % wide")
    for name, rule in [("its own rule", theirs), ("shortest edge / c", edge)]:
        share = rule / exact
        print(f"{program}: {name}: {rule:.6e} s, {share:.3f} of the true step{', unsafe' if share > 1 else ''}")
    assert rest.optimistic <= 1.0005 * exact and rest.safe >= 0.99 * exact, "as tight as measured at rest"

    h, first, widest = 0.98 * rest.safe, None, 0.0
    for n in range(steps):
        step = bracket.evaluate(tangents(u), limit=2.0)
        if n % 10 == 0:
            narrow, exact = checked(u)
            widest = max(widest, narrow.optimistic / narrow.safe - 1)
        if first is None and h > step.optimistic:
            first = n
            break
        a = -force(u) / mass[:, None]
        a[held] = 0
        v += h * a
        u += h * v
    assert first is not None, "the bar stiffens until the step of the start is too large"
    step, exact = checked(u)
    print(f"{program}: left the bracket at step {first}: h = {h:.6e} s, optimistic {step.optimistic:.6e} s")
    print(f"{program}: bracket at most {100 * widest:.3f} % wide until then")
    assert widest <= 0.04
    assert h > exact
