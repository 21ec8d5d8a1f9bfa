"""The step that arrays of a soft body can take."""
from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._errors import InputError
from ._results import Suggestion
from ._ringwatch import Body, Material, Mesh, TangentBracket


def suggest(
    points: ArrayLike,
    cells: ArrayLike,
    young: float,
    poisson: float,
    masses: ArrayLike | None = None,
    dt: float | np.floating[Any] | None = None,
    *,
    density: float | None = None,
    held: ArrayLike | None = None,
    x: ArrayLike | None = None,
    model: str = "stvk",
    limit: float = 2.0,
) -> Suggestion:
    """Says whether a step is proven stable for a soft body of linear tetrahedra, and how large one can be.

    points: at rest, (N, 3), m. cells: the tetrahedra, (M, 4), in either order; points that are in none do not count.
    young, Pa, poisson: of the law `model`. masses: of each point, (N,), kg, 0 for one that is held; or density, kg/m³.
    held: points that are held, a flag for each. x: the state, (N, 3), or a batch of states, (B, N, 3), of which the
    least step counts; without, rest. dt: the step that is asked about, s. limit: the integrator's largest stable
    h·omega, 2 for symplectic Euler. Arrays are of any type of numbers, float32 too. Damping and contact are not in it.
    Raises InputError; NumericalError where the tangent is not finite.
    """
    rest = _reals("points", points, ("N", 3))
    tetrahedra = np.asarray(cells)
    if tetrahedra.ndim != 2 or tetrahedra.shape[1:] != (4,) or tetrahedra.dtype.kind not in "iu" or not tetrahedra.size:
        raise InputError(f"cells: an array of {tetrahedra.dtype} of shape {tetrahedra.shape}; must be integers of shape (M, 4)")
    if tetrahedra.min() < 0 or tetrahedra.max() >= len(rest):
        raise InputError(f"cells: points {tetrahedra.min()} to {tetrahedra.max()}; there are {len(rest)}, counted from 0")
    if (masses is None) == (density is None):
        raise InputError("masses, density: one of them is needed, and not both")
    if dt is not None and not (dt > 0 and math.isfinite(dt)):
        raise InputError(f"dt = {dt}: must be > 0, s")

    used, inverse = np.unique(tetrahedra, return_inverse=True)
    corners = inverse.reshape(tetrahedra.shape)
    turned = np.linalg.det(rest[used][corners[:, 1:]] - rest[used][corners[:, :1]]) < 0
    corners[turned] = corners[turned][:, [0, 1, 3, 2]]
    body = Body(
        Mesh(rest[used], {"tet4": corners}),
        Material(model, young=float(young), poisson=float(poisson), density=1.0 if density is None else float(density)),
    )
    mass = body.lumped_mass if masses is None else _reals("masses", masses, (len(rest),))[used]
    if mass.min() < 0:
        raise InputError(f"masses: {mass.min()} kg; must be >= 0, and 0 for points that are held")
    fixed = mass == 0
    if held is not None:
        flags = np.asarray(held)
        if flags.dtype != np.bool_ or flags.shape != (len(rest),):
            raise InputError(f"held: an array of {flags.dtype} of shape {flags.shape}; must be flags of shape ({len(rest)},)")
        fixed = fixed | flags[used]
    if fixed.all():
        raise InputError("held, masses: every point is held; no step is too large")

    batch = np.asarray(rest if x is None else x)
    states = _reals("x", batch if batch.ndim == 3 else batch[None], ("B", len(rest), 3))[:, used]
    weights, constrained = np.where(fixed, 1.0, mass), np.repeat(fixed[:, None], 3, axis=1)
    found = [  # each from scratch, whatever came before
        TangentBracket(weights, corners.astype(np.int32), constrained).evaluate(
            body.element_tangents(np.ascontiguousarray(state)), limit, search_negative=True
        )
        for state in states
    ]
    if not found:
        raise InputError("x: a batch without states; at least one is needed")
    safe = [one.safe for one in found]
    least = int(np.argmin(safe))
    optimistic = min(one.optimistic for one in found)
    step = None if dt is None else float(dt)
    negative = [one.lowest_eigenvalue for one in found if one.lowest_eigenvalue is not None]
    substeps = None if step is None or negative or not safe[least] > 0 else _parts(step, safe[least])
    return Suggestion(
        safe[least],
        optimistic,
        step,
        None
        if step is None
        else "violated"
        if step > optimistic
        else "certified"
        if step <= safe[least] and not negative
        else "not-certified",
        substeps,
        None if step is None or substeps is None else step / substeps,
        found[least].controlling[1],
        least,
        min(negative, default=None),
    )


def _parts(dt: float, longest: float) -> int:
    """Equal parts of dt of which none is longer."""
    count = max(1, math.ceil(dt / longest))
    return count if dt / count <= longest else count + 1  # a quotient that was rounded down


def _reals(name: str, given: Any, shape: tuple[int | str, ...]) -> NDArray[np.float64]:
    """Finite numbers of a shape, in which letters stand for any size."""
    array = np.asarray(given)
    fits = len(shape) == array.ndim and all(isinstance(n, str) or n == own for n, own in zip(shape, array.shape))
    if array.dtype.kind not in "fiu" or not fits:
        wanted = ", ".join(str(n) for n in shape) + ("," if len(shape) == 1 else "")
        raise InputError(f"{name}: an array of {array.dtype} of shape {array.shape}; must be numbers of shape ({wanted})")
    if not np.isfinite(array).all():
        raise InputError(f"{name}: has numbers that are not finite")
    return np.ascontiguousarray(array, dtype=np.float64)
