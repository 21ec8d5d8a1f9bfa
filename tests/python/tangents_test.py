"""TangentBracket: tangents of any physics, against numpy's eigenvalues and against a body."""
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import ringwatch as rw
from support import bar, body_of, stretched


def dense_step(mass: Any, groups: Any, tangents: Any, dofs: Any, free: Any, limit: Any = 2.0) -> Any:
    """mass: (N d, N d)."""
    K = np.zeros_like(mass)
    for cells, matrices in zip(groups, tangents):
        for nodes, matrix in zip(cells, matrices):
            own = matrix.shape[0] // len(nodes)
            rows = (dofs * nodes[:, None] + np.arange(own)).ravel()
            K[np.ix_(rows, rows)] += matrix
    root = np.linalg.cholesky(mass[np.ix_(free, free)])
    inverse = np.linalg.inv(root)
    return limit / np.sqrt(np.linalg.eigvalsh(inverse @ K[np.ix_(free, free)] @ inverse.T)[-1])


@settings(max_examples=40, deadline=None, database=None, derandomize=True)
@given(st.integers(0, 2**32 - 1), st.integers(1, 6), st.integers(2, 5), st.sampled_from(["scalar", "diagonal", "block"]))
def test_random_tangents(seed: int, dofs: Any, nodes: Any, form: Any) -> None:
    random = np.random.default_rng(seed)
    count = nodes + 6
    cells = np.array([random.choice(count, nodes, replace=False) for _ in range(8)])
    roots = random.standard_normal((len(cells), nodes * dofs, nodes * dofs))
    K = roots @ roots.transpose(0, 2, 1)
    K = np.ascontiguousarray((K + K.transpose(0, 2, 1)) / 2)
    if form == "scalar":
        mass = random.uniform(0.5, 2, count)
        dense = np.diag(np.repeat(mass, dofs))
    elif form == "diagonal":
        mass = random.uniform(0.5, 2, (count, dofs))
        dense = np.diag(mass.ravel())
    else:
        mass = np.array([np.diag(random.uniform(1, 2, dofs)) + 0.1 for _ in range(count)])
        dense = np.zeros((count * dofs, count * dofs))
        for i, block in enumerate(mass):
            dense[i * dofs : (i + 1) * dofs, i * dofs : (i + 1) * dofs] = block
    held = random.random((count, dofs)) < 0.1
    bracket = rw.TangentBracket(mass, cells, held, degrees_of_freedom=dofs)
    for factor in (1.0, 3.0):
        exact = dense_step(dense, [cells], [factor * K], dofs, np.flatnonzero(~held.ravel()))
        step = bracket.evaluate(factor * K)
        assert step.safe <= exact * (1 + 1e-12) and exact <= step.optimistic * (1 + 1e-12)
        assert bracket.evaluate(factor * K, limit=1.0).safe == pytest.approx(step.safe / 2, rel=0.5)
        group, element = step.controlling
        assert group == 0 and 0 <= element < len(cells)


def test_tangents_of_a_body() -> None:
    mesh = bar(cells=[5, 2, 2])
    body = body_of(mesh)
    held = mesh.points[:, 0] < 1e-6
    body.fix(held)
    x = stretched(mesh.points, 700)
    flags = np.repeat(held[:, None], 3, axis=1)
    cells = mesh.cells["tet4"]
    step = rw.TangentBracket(body.lumped_mass, cells, flags).evaluate(body.element_tangents(x))
    exact = rw.inspect(body, x, exact=True).exact
    assert exact is not None
    assert step.safe <= exact <= step.optimistic
    half = len(cells) // 2
    tangents = body.element_tangents(x)
    groups = rw.TangentBracket(body.lumped_mass, [cells[:half], cells[half:]], flags)
    parted = groups.evaluate([tangents[:half], tangents[half:]])
    assert parted.safe <= exact <= parted.optimistic


def test_groups_of_different_degrees_of_freedom() -> None:
    random = np.random.default_rng(3)
    mass = random.uniform(0.5, 2, (6, 6))
    beams, solids = np.array([[0, 1], [1, 2]]), np.array([[2, 3, 4, 5]])
    def symmetric(n: Any, size: Any) -> Any:
        roots = random.standard_normal((n, size, size))
        K = roots @ roots.transpose(0, 2, 1)
        return np.ascontiguousarray((K + K.transpose(0, 2, 1)) / 2)
    K = [symmetric(2, 12), symmetric(1, 12)]
    held = np.zeros((6, 6), dtype=bool)
    held[3:, 3:] = True
    step = rw.TangentBracket(mass, [beams, solids], held, group_dofs=[6, 3]).evaluate(K)
    exact = dense_step(np.diag(mass.ravel()), [beams, solids], K, 6, np.flatnonzero(~held.ravel()))
    assert step.safe <= exact <= step.optimistic
