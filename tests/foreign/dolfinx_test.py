"""A bar of St. Venant-Kirchhoff tetrahedra in dolfinx: its tangents in our bracket, held to its own matrices."""

import json
import pathlib
import subprocess
import sys
import tempfile
import time

import numpy as np
import support

support.need("dolfinx")
import dolfinx  # noqa: E402
import ufl  # noqa: E402
from dolfinx import fem, io  # noqa: E402
from dolfinx.fem import petsc  # noqa: E402
from dolfinx_adapter import ElementTangents, body_of  # noqa: E402
from mpi4py import MPI  # noqa: E402

import ringwatch as rw  # noqa: E402


def energy(u):
    F = ufl.Identity(3) + ufl.grad(u)
    E = (F.T * F - ufl.Identity(3)) / 2
    return support.MU * ufl.inner(E, E) + support.LAMBDA / 2 * ufl.tr(E) ** 2


class Bar:
    """A bar of cells of 2 x 2 x 2 cm, six tetrahedra each, with what dolfinx assembles of it."""

    def __init__(self, cells):
        self.mesh = dolfinx.mesh.create_box(MPI.COMM_WORLD, [[0, 0, 0], [0.02 * n for n in cells]], cells)
        self.V = fem.VectorFunctionSpace(self.mesh, ("CG", 1))
        self.moved = fem.Function(self.V)
        residual = ufl.derivative(energy(self.moved) * ufl.dx, self.moved)
        self.residual, self.matrix = fem.form(residual), fem.form(ufl.derivative(residual, self.moved))
        test = ufl.TestFunction(fem.FunctionSpace(self.mesh, ("CG", 1)))
        self.mass = petsc.assemble_vector(fem.form(support.DENSITY * test * ufl.dx)).array.copy()
        self.points = self.V.tabulate_dof_coordinates()
        self.vector = petsc.create_vector(self.residual)

    def force(self, u):
        self.moved.x.array[:] = u.ravel()
        with self.vector.localForm() as local:
            local.set(0)
        petsc.assemble_vector(self.vector, self.residual)
        return self.vector.array.reshape(-1, 3)

    def assembled(self, u):
        self.moved.x.array[:] = u.ravel()
        K = petsc.assemble_matrix(self.matrix)
        K.assemble()
        return K[:, :]


def tangents_handed_over():
    bar = Bar([8, 1, 1])
    tangents = ElementTangents(bar.V, energy)

    def at(u):
        bar.moved.x.array[:] = u.ravel()
        return tangents(bar.moved)

    corners = bar.points[tangents.nodes]
    diameters = np.linalg.norm(corners[:, :, None] - corners[:, None, :], axis=3).max(axis=(1, 2))  # ufl.CellDiameter
    support.pulled(
        "dolfinx",
        bar.points,
        tangents.nodes.astype(np.int32),
        at,
        diameters.min() / support.WAVE,
        bar.force,
        bar.assembled,
        bar.mass,
        speed=1.0,
        steps=400,
    )


def positions_handed_over():
    """A law that ringwatch has too: its tangents are dolfinx's, and a step is watched for a few percent of its time."""
    law = {"young": support.YOUNG, "poisson": support.POISSON, "density": support.DENSITY}
    small = Bar([4, 2, 2])
    body = body_of(small.V, "stvk", **law)
    assert np.abs(body.lumped_mass / small.mass - 1).max() < 1e-13
    u = 1e-3 * np.random.default_rng(1).standard_normal(small.points.shape)
    nodes = ElementTangents(small.V, energy).nodes
    ours = support.assemble(nodes, body.element_tangents(small.points + u), len(small.points))
    theirs = small.assembled(u)
    assert np.abs(ours - theirs).max() < 1e-12 * np.abs(theirs).max(), np.abs(ours - theirs).max()

    bar = Bar([32, 6, 6])
    body = body_of(bar.V, "stvk", threads=1, **law)
    left, right = bar.points[:, 0] < 1e-9, bar.points[:, 0] > bar.points[:, 0].max() - 1e-9
    h = 0.5 * rw.inspect(body).safe
    body.fix(left | right)
    for mode in ("threshold", "bracket"):
        monitor = rw.Monitor(body, limit=2.0, mode=mode)
        u, v = np.zeros_like(bar.points), np.zeros_like(bar.points)
        v[right, 0] = 0.3
        watched = stepped = 0.0
        for n in range(200):
            before = time.process_time()
            report = monitor.observe(n, n * h, bar.points + u, v, h)
            between = time.process_time()
            a = -bar.force(u) / bar.mass[:, None]
            a[left | right] = 0
            v += h * a
            u += h * v
            if n > 0:
                watched += between - before
                stepped += time.process_time() - between
            assert report.verdict == "certified", (mode, n)
        print(f"dolfinx: {mode} mode on positions takes {watched / stepped:.3f} of dolfinx's step")


def results_audited():
    """The files that dolfinx writes of a run whose step becomes too large."""
    bar = Bar([8, 1, 1])
    left, right = bar.points[:, 0] < 1e-9, bar.points[:, 0] > 0.16 - 1e-9
    u, v = np.zeros_like(bar.points), np.zeros_like(bar.points)
    v[right, 0] = 1.0
    h = 3.53e-4
    shown = fem.Function(bar.V)
    shown.name = "displacement"
    exact = []
    with tempfile.TemporaryDirectory(prefix="ringwatch-dolfinx-") as folder:
        folder = pathlib.Path(folder)
        with io.VTKFile(MPI.COMM_WORLD, folder / "run.pvd", "w") as file:
            for n in range(72):
                if n % 4 == 0:
                    shown.x.array[:] = u.ravel()
                    file.write_function(shown, n * h)
                    free = np.repeat(~(left | right), 3)
                    exact.append(support.exact_step(bar.assembled(u), np.repeat(bar.mass, 3), np.flatnonzero(free)))
                a = -bar.force(u) / bar.mass[:, None]
                a[left | right] = 0
                v += h * a
                u += h * v
        command = ["audit", "run.pvd", "--young", "1e6", "--poisson", "0.3", "--density", "1000", "--step", str(h)]
        command += ["--fix", "x < 1e-9", "--fix", "x > 0.1599", "--json", "-"]
        audited = subprocess.run([sys.argv[1], *command], cwd=folder, capture_output=True, text=True)
    assert audited.returncode == 1, audited.stderr
    found = json.loads(audited.stdout)
    history = found["history"]
    assert len(history) == len(exact), (len(history), len(exact))
    for state, step in zip(history, exact):
        assert state["safe"] <= step * (1 + 1e-6) and step * (1 - 1e-6) <= state["optimistic"], (state, step)
    first = found["first"]["violated"]["state"]
    print(f"dolfinx: audited {len(history)} states: proven unstable from state {first}")
    assert next(k + 1 for k, step in enumerate(exact) if step < h) <= first


tangents_handed_over()
positions_handed_over()
results_audited()
