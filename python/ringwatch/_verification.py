"""Integrators and step rules that are written in Python, held to what is exact."""
from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from typing import cast

import numpy as np
from numpy.typing import NDArray

from ._errors import InputError
from ._results import Verification

# acceleration(time, x, v), and a step of (acceleration, time, x, v, h) -> (time, x, v)
Acceleration = Callable[[float, NDArray[np.float64], NDArray[np.float64]], NDArray[np.float64]]
Step = Callable[
    [Acceleration, float, NDArray[np.float64], NDArray[np.float64], float],
    tuple[float, NDArray[np.float64], NDArray[np.float64]],
]

# rule(points, cells, young, poisson, density) -> step
Rule = Callable[[NDArray[np.float64], list[tuple[str, NDArray[np.int32]]], float, float, float], float]


def judge(
    rule: Rule,
    *,
    meshes: str | os.PathLike[str] | Sequence[str | os.PathLike[str]] = (),
    elements: str | Sequence[str] = (),
    shapes: int | None = None,
    histories: bool = False,
    young: float = 1e6,
    poisson: float = 0.3,
    density: float = 1000.0,
) -> Verification:
    """Holds a rule for the step to the exact one of central differences, as `ringwatch judge` does.

    rule: a function (points, cells, young, poisson, density) -> step, s, of a free elastic body: points (N, 3), m; cells,
    a list of (element, (M, n) node numbers), the elements as "tet4", nodes in VTK's order. meshes: files. elements: whose
    shapes count; all linear ones by default. shapes: of each family, 20 by default, 0 where meshes and no elements are
    given. histories: also states of bars and a ball that move. young (Pa), poisson, density (kg/m³): of the shapes and
    meshes. The table `judge` says on how many cases the rule is unsafe, `passed` that it is on none. Raises InputError,
    and what the rule raises.
    """
    if not callable(rule):
        raise InputError(f"rule: an object of type {type(rule).__name__}; must be a function "
                         "(points, cells, young, poisson, density) -> step")
    files = [meshes] if isinstance(meshes, (str, os.PathLike)) else list(meshes)
    chosen = [elements] if isinstance(elements, str) else list(elements)
    count = shapes if shapes is not None else 0 if files and not chosen else 20
    if count < 0:
        raise InputError(f"shapes = {count}: must be at least 0")
    from . import _verify  # the studies, which nothing else needs

    called = getattr(rule, "__name__", type(rule).__name__)
    return _verify.judge(rule, called, [os.fspath(file) for file in files], chosen, count, histories,
                         young, poisson, density)


def verify(
    integrator: Step | Callable[[], Step],
    *,
    limit: float,
    order: int,
    damped_order: int = 1,
    forces: int = 0,
    symplectic: bool = False,
    reversible: bool = False,
    name: str = "",
    effort: str = "quick",
) -> Verification:
    """Holds an integrator written in Python to what it declares, by the study of `ringwatch verify integrators`.

    integrator: a function (acceleration, time, x, v, h) -> (time, x, v) that takes one step of h, s; or a class whose
    instances are such, for a scheme that remembers: every motion gets an instance of its own. x and v, (N, 3), m and
    m/s, are its own to write into; acceleration(time, x, v) gives (N, 3), m/s². limit: the largest stable h·omega
    without damping, counted from zero upwards; 0 for none, infinity for every step. order: of the error at a fixed time;
    damped_order: of the same where the acceleration depends on v. forces: accelerations a step; 0 where that varies.
    symplectic, reversible: whether it is. effort: "quick", seconds, or "full". Measured are these, that time advances by
    h, the drift of the energy, limits with damping, and the critical step of real runs. Raises InputError, and what the
    integrator raises; NumericalError where its step is not linear in x and v.
    """
    if not callable(integrator):
        raise InputError(f"integrator: an object of type {type(integrator).__name__}; must be a function "
                         "(acceleration, time, x, v, h) -> (time, x, v), or a class of such")
    if not limit >= 0:
        raise InputError(f"limit = {limit}: must be >= 0, the largest stable h omega")
    for what, value, least in (("order", order, 1), ("damped_order", damped_order, 1), ("forces", forces, 0)):
        if value < least:
            raise InputError(f"{what} = {value}: must be at least {least}")
    if effort not in ("quick", "full"):
        raise InputError(f"effort: unknown {effort!r}; known are quick, full")
    from . import _verify  # the studies, which nothing else needs

    make = cast(Callable[[], Step], integrator if isinstance(integrator, type) else lambda: integrator)
    called = name or getattr(integrator, "__name__", type(integrator).__name__)
    with np.errstate(over="ignore", invalid="ignore"):  # unstable motions are part of it
        return _verify.verify(make, called, limit, order, damped_order, forces, symplectic, reversible, effort == "full")
