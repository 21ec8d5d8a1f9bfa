"""Pictures, by matplotlib, which is imported when one is drawn."""
from __future__ import annotations

import importlib
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._errors import InputError
from ._ringwatch import _labelled

_SAFE, _OPTIMISTIC, _TAKEN = "tab:green", "tab:red", "black"


def _axes(ax: Any) -> Any:
    if ax is not None:
        return ax
    try:
        pyplot = importlib.import_module("matplotlib.pyplot")
    except ImportError as fault:
        raise ImportError(f"plot: needs matplotlib (Debian: python3-matplotlib): {fault}") from None
    return pyplot.subplots()[1]


def run(history: Mapping[str, NDArray[Any]], events: Sequence[Mapping[str, Any]], verdict: str, ax: Any) -> Any:
    def column(stem: str) -> str:
        """The name of a column, which ends with its unit unless the scene names none."""
        return next(name for name in history if stem in (name, name.rpartition("_")[0]))

    unit = f" ({column('time')[5:]})" if column("time") != "time" else ""
    curves = [curve for curve in (("optimistic", "optimistic: unstable above", {"color": _OPTIMISTIC}),
                                  ("safe", "safe: stable up to here", {"color": _SAFE}),
                                  ("metric_step", "by the metric: an estimate", {"color": "tab:blue"}))
              if np.isfinite(history[column(curve[0])]).any()]
    if not curves:
        raise InputError("plot: the run was not monitored: it has neither bracket nor metric")
    ax = _axes(ax)
    time = history[column("time")]
    for stem, label, style in [*curves, ("h", "step taken", {"color": _TAKEN, "linestyle": "--"})]:
        ax.plot(time, history[column(stem)], label=label, **style)
    begun: dict[str, list[float]] = {}
    for event in events:
        begun.setdefault(str(event["kind"]), []).append(float(event["time"]))
    for number, (kind, times) in enumerate(begun.items()):
        for time_of in times:
            ax.axvline(time_of, color=f"C{4 + number}", linewidth=1, label=kind if time_of == times[0] else None)
    ax.set(xlabel=f"time{unit}", ylabel=f"step{unit}", title=verdict)
    ax.legend()
    return ax


def inspection(steps: Sequence[NDArray[np.float64]], safe: float, optimistic: float, metric: str, ax: Any) -> Any:
    ax = _axes(ax)
    values = np.concatenate(steps)
    values = values[np.isfinite(values)]  # an element without stiffness allows every step
    if values.size == 0:
        raise InputError(f"plot: {metric} gives no element a finite step")
    least, most = float(values.min()), float(values.max())
    bins = np.geomspace(least, most, 41) if most > least else np.array([0.99 * least, 1.01 * least])
    bins[0], bins[-1] = min(bins[0], least), max(bins[-1], most)  # rounding must not leave the ends out
    ax.hist(values, bins=bins, color="tab:blue")
    ax.axvline(safe, color=_SAFE, label="safe: stable up to here")
    ax.axvline(optimistic, color=_OPTIMISTIC, linestyle="--", label="optimistic: unstable above")
    ax.set(xscale="log", xlabel=_labelled(f"step of an element by {metric} (s)"), ylabel="elements")
    ax.legend()
    return ax


def comparison(runs: Mapping[str, NDArray[Any]], title: str, against: str, ax: Any) -> Any:
    if against not in ("seconds", "forces"):
        raise InputError(f"plot: against: unknown {against!r}; known are seconds, forces")
    ax = _axes(ax)
    cost = runs["seconds"] if against == "seconds" else runs["forces"] + runs["products"]
    for name in dict.fromkeys(runs["integrator"].tolist()):
        own = runs["integrator"] == name
        ax.plot(cost[own], runs["error"][own], marker="o", label=name)
    label = "computing time (seconds)" if against == "seconds" else "force evaluations and tangent products"
    ax.set(xscale="log", yscale="log", xlabel=label, ylabel="error over displacement", title=title)
    ax.legend()
    return ax
