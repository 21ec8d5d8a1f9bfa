"""What the functions return. The extension fills the fields by their order here."""
from __future__ import annotations

import ast
import contextlib
import inspect
import pathlib
import sys
from dataclasses import dataclass, fields
from html import escape
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _plot
from ._errors import InputError
from ._ringwatch import _labelled


_LONGEST = 80  # characters of a field; what is longer is told by its type and size


def _brief(value: Any) -> str:
    if isinstance(value, np.ndarray):
        return f"array of shape {value.shape}"
    if isinstance(value, Result):
        return f"<{value}>"
    text = repr(value)
    return text if len(text) <= _LONGEST or not hasattr(value, "__len__") or isinstance(value, str) else f"{type(value).__name__} of {len(value)}"


class Result:
    """Shows itself in a line, however much it holds."""

    __slots__ = ()

    def __repr__(self) -> str:
        shown = (f"{field.name}={_brief(getattr(self, field.name))}" for field in fields(self))
        return f"{type(self).__name__}({', '.join(shown)})"

    def _repr_html_(self) -> str:
        """Shows itself in a notebook: what `print` says, and a row for each field."""
        said = str(self) if type(self).__str__ is not object.__str__ else type(self).__name__
        rows = "".join(f"<tr><th>{field.name}</th><td>{escape(_brief(getattr(self, field.name)))}</td></tr>" for field in fields(self))
        return f"<p>{escape(said)}</p><table>{rows}</table>"


@dataclass(frozen=True, slots=True, repr=False)
class Element(Result):
    """An element of a mesh."""

    block: int
    """Its block, from 0."""
    index: int
    """Its place in the block, from 0."""
    type: str
    """tet4, hex8 and so on."""
    nodes: tuple[int, ...]
    """Its nodes, rows of the points."""
    id: int
    """Its number in the file."""
    node_ids: tuple[int, ...]
    """The numbers of its nodes in the file."""
    text: str
    """All of that in a few words."""

    def __str__(self) -> str:
        return self.text


@dataclass(frozen=True, slots=True, repr=False)
class ElementCause(Result):
    """Why an element allows only a small step: its departure from rest, and its shape at rest."""

    text: str
    """In a few words."""
    finite: bool
    """Whether its deformation gradients are numbers; where not, the next three say nothing."""
    least_determinant: float
    """det F, least over the quadrature points."""
    largest_stretch: float
    """Largest principal stretch, over the quadrature points."""
    least_stretch: float
    """Least principal stretch, over the quadrature points."""
    shape: str
    """round, small, needle, wedge, spindle, sliver, cap; other for what is no tetrahedron."""
    least_dihedral: float
    """Degrees."""
    largest_dihedral: float
    """Degrees."""
    aspect: float
    """Longest over shortest edge."""
    badly_shaped: bool
    """The shape alone makes the step small."""

    def __str__(self) -> str:
        return self.text


@dataclass(frozen=True, slots=True, repr=False)
class CriticalStep(Result):
    """The bracket safe <= critical step <= optimistic, s, proven for the tangent at one state."""

    safe: float
    """s, proven stable up to here."""
    optimistic: float
    """s, proven unstable above."""
    controlling: tuple[int, int]
    """Block (or group) and index of the element that holds most of the top mode, as far as it is known."""
    safe_by: str
    """How the side was obtained."""
    optimistic_by: str
    """How the side was obtained."""
    lowest_eigenvalue: float | None
    """rad²/s², negative: it proves the tangent indefinite, which no step cures. None where none was found."""

    def __str__(self) -> str:
        return _labelled(f"{self.safe:.6g} s <= critical step <= {self.optimistic:.6g} s")


@dataclass(frozen=True, slots=True, repr=False)
class Suggestion(Result):
    """What is proven of a step: see `suggest`."""

    safe: float
    """s, proven stable up to here."""
    optimistic: float
    """s, proven unstable above."""
    dt: float | None
    """s, the step that was asked about."""
    verdict: str | None
    """certified: proven stable; violated: proven unstable; not-certified: neither, or the tangent is indefinite. None without
    dt."""
    substeps: int | None
    """Equal parts of dt, each proven stable; None where no number is, and without dt."""
    substep: float | None
    """s, the length of each."""
    controlling: int
    """The cell that holds most of the top mode, as far as it is known."""
    state: int
    """The state of the batch whose safe step is the least."""
    lowest_eigenvalue: float | None
    """rad²/s², negative: it proves the tangent of a state indefinite, which no step cures. None where none was found."""

    def __str__(self) -> str:
        return _labelled(self._text())

    def _text(self) -> str:
        text = f"proven stable up to {self.safe:.6g} s, proven unstable above {self.optimistic:.6g} s"
        if self.dt is None:
            return text
        verdict = {"certified": "proven stable", "violated": "proven unstable"}.get(
            str(self.verdict), "neither proven stable nor unstable"
        )
        if self.lowest_eigenvalue is not None:
            indefinite = f"the tangent is indefinite, eigenvalue {self.lowest_eigenvalue:.6g} rad2/s2: no step cures that"
            return f"dt = {self.dt:.6g} s is {'proven unstable' if self.verdict == 'violated' else 'not proven stable'}: {indefinite}"
        parts = f"{self.substeps} substep{'s' * (self.substeps != 1)} of {self.substep:.6g} s" if self.substeps else "no substeps"
        return f"dt = {self.dt:.6g} s is {verdict}; {text}: {parts}"


@dataclass(frozen=True, slots=True, repr=False)
class Metric(Result):
    """The steps of all elements by a metric."""

    name: str
    """One of `metric_names()`."""
    side: str
    """Where `step` lies of the critical step: "safe" or "optimistic" where that is proven, else "estimate"."""
    step: float
    """s, the least of all elements."""
    controlling: tuple[int, int]
    """Block and index of the element that has it."""
    element_steps: tuple[NDArray[np.float64], ...]
    """s, an array for each block of the mesh with a number for each element."""


@dataclass(frozen=True, slots=True, repr=False)
class Inspection(Result):
    """What a body can take at one state: see `inspect`."""

    safe: float
    """s, proven stable up to here for the tangent at this state."""
    optimistic: float
    """s, proven unstable above."""
    exact: float | None
    """s, by a global eigenvalue, when asked for."""
    controlling: Element
    """The element in the way."""
    cause: ElementCause
    """Why it is."""
    safe_by: str
    """How the side was obtained."""
    optimistic_by: str
    """How the side was obtained."""
    lowest_eigenvalue: float | None
    """rad²/s², negative: it proves the tangent indefinite, which no step cures. None where none was found."""
    limit: float
    """The largest stable h·omega that the steps are for."""
    metrics: dict[str, Metric]
    """Those that were asked for, in that order."""

    def __str__(self) -> str:
        between = f"critical step = {self.exact:.6g} s" if self.exact is not None else "critical step"
        return _labelled(f"{self.safe:.6g} s <= {between} <= {self.optimistic:.6g} s, for h omega <= {self.limit:g}\n"
                         f"in the way: {self.controlling}: {self.cause}")

    @property
    def element_steps(self) -> tuple[NDArray[np.float64], ...]:
        """Those of the first metric: s, an array for each block of the mesh."""
        if not self.metrics:
            raise InputError("element_steps: no metric was asked for; name one in inspect(metrics=...)")
        return next(iter(self.metrics.values())).element_steps

    def plot(self, ax: Any = None, *, metric: str = "") -> Any:
        """Draws how the steps of the elements spread, s, by a metric that was asked for, the first one unless named, with
        both sides of the bracket.

        ax: matplotlib's Axes to draw into; None makes some. Returns the Axes. Raises InputError for a metric that was
        not asked for, ImportError without matplotlib.
        """
        if metric and metric not in self.metrics:
            raise InputError(f"plot: metric: {metric!r} was not asked for; name it in inspect(metrics=...)")
        steps = self.metrics[metric].element_steps if metric else self.element_steps
        return _plot.inspection(steps, self.safe, self.optimistic, metric or next(iter(self.metrics)), ax)


@dataclass(frozen=True, slots=True, repr=False)
class MonitorEvent(Result):
    """Something that happened in a run."""

    kind: str
    """violated, energy-balance, inverted, non-finite or indefinite."""
    step: int
    """Where it begins."""
    time: float
    """s"""
    value: float
    """violated: the step over the optimistic one; inverted: det F; indefinite: an eigenvalue, rad²/s²."""
    element: Element | None
    """Where, when it is an element's doing."""
    cause: ElementCause | None
    """Why that element is in the way."""
    end: int | None
    """First step without it; None while it goes on."""
    text: str
    """All of that in one line."""

    def __str__(self) -> str:
        return self.text


@dataclass(frozen=True, slots=True, repr=False)
class MonitorReport(Result):
    """What a monitor knows of a state."""

    step: int
    """The number of the step, as it was handed over."""
    time: float
    """s"""
    h: float | None
    """s, the step that was asked about."""
    verdict: str
    """certified: h is proven stable at this state; violated: proven unstable, or the state is not finite and no step
    helps; not-certified: neither."""
    bracket: CriticalStep | None
    """None in mode "threshold" while the step is certified, and for a state that is not finite."""
    certified: float
    """s, the largest step proven at this state; 0 for none."""
    metric_step: float | None
    """s, by the monitor's metric, less its margin: an estimate."""
    fresh: bool
    """Evaluated at this very state; else fewer steps than `every` have passed."""
    evaluated_at: int
    """The step whose state the bracket is of."""
    elements_refreshed: int
    """Element evaluations spent."""
    spent: dict[str, float]
    """Work of this observation over that of a step's own force, counted, by what it went to: tests (of validity balls),
    evaluations, repairs, sweeps, mode (the optimistic side), searches (for negative stiffness)."""
    new_events: tuple[MonitorEvent, ...]
    """Begun at this step."""
    internal_force: NDArray[np.float64] | None
    """N, (N, 3), when asked for."""
    strain_energy: float | None
    """J, when asked for."""

    def __str__(self) -> str:
        asked = "" if self.h is None else f", h = {self.h:.6g} s"
        known = f"{self.bracket}" if self.bracket else f"{self.certified:.6g} s is proven"
        return _labelled(f"step {self.step}, t = {self.time:.6g} s{asked}: {self.verdict}; {known}")

    @property
    def safe(self) -> float:
        """s, of the bracket; the certified step where there is none."""
        return self.bracket.safe if self.bracket else self.certified

    @property
    def optimistic(self) -> float | None:
        """s, of the bracket; None where there is none."""
        return self.bracket.optimistic if self.bracket else None


@dataclass(frozen=True, slots=True, repr=False)
class DeviceReport(Result):
    """What a DeviceMonitor knows of a state."""

    h: float | None
    """s, the step that was asked about."""
    certified: bool
    """h is proven stable for the tangent at this state."""
    safe: float
    """s, the largest step proven there; 0 for none, also of a state that is not finite."""
    renewed: bool
    """The certificate was made again, or it was tried: at the first observation, where it was lost, for a larger step."""
    elements_refreshed: int
    """Elements that had left their validity balls and were evaluated one by one."""


@dataclass(frozen=True, slots=True, repr=False)
class Check(Result):
    """A measured number and the limit that it is held to."""

    name: str
    """What was measured, with its unit where it has one."""
    measured: float
    """In the unit that `name` tells."""
    expected: float
    """In the same unit."""
    tolerance: float
    """How far measured may be from expected: on both sides, above or below."""
    sense: str
    """near, at-most or at-least."""
    passed: bool
    """Whether measured is as far from expected as it may be."""

    def __str__(self) -> str:
        return (f"{'passed' if self.passed else 'FAILED'} {self.name}: measured {self.measured:.9g}, "
                f"expected {self.expected:.9g}, tolerance {self.tolerance:.3g}")


@dataclass(frozen=True, slots=True, repr=False)
class Verification(Result):
    """What a study of an integrator or of a step rule found: see `verify` and `judge`."""

    name: str
    """Of the integrator or the rule."""
    passed: bool
    """Whether all checks did."""
    checks: tuple[Check, ...]
    """All that were made."""
    tables: dict[str, tuple[dict[str, Any], ...]]
    """What was measured: limits, damped_limits, orders, periods, drift, observed, stiff; each a tuple of rows, a dict by
    column. A table that says nothing of this integrator is left out."""

    def __str__(self) -> str:
        failed = [str(check) for check in self.checks if not check.passed]
        return "\n".join([f"{self.name}: {len(self.checks)} checks, {len(failed)} failed", *failed])


def document_fields(module: str) -> None:
    """Hands `help` the texts below the fields of a module's classes, which Python does not keep."""
    with contextlib.suppress(OSError):  # where there is no source
        for node in ast.parse(pathlib.Path(str(sys.modules[module].__file__)).read_text(encoding="utf-8")).body:
            if isinstance(node, ast.ClassDef):
                texts = {field.target.id: inspect.cleandoc(text.value.value) for field, text in zip(node.body, node.body[1:])
                         if isinstance(field, ast.AnnAssign) and isinstance(field.target, ast.Name)
                         and isinstance(text, ast.Expr) and isinstance(text.value, ast.Constant)}
                made = getattr(sys.modules[module], node.name)
                made.__slots__ = {name: texts.get(name) for name in made.__slots__}


document_fields(__name__)
