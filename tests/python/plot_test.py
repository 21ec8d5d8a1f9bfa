"""What the pictures show is in the results; without matplotlib one line says what is missing."""
import html
import pathlib
import re
import subprocess
import sys
from typing import Any

import numpy as np
import pytest

import ringwatch as rw
from run_test import SECTIONS
from support import SOURCE, bar, body_of

WITHOUT = """
import sys
sys.modules["matplotlib"] = sys.modules["matplotlib.pyplot"] = None
import ringwatch as rw
step = rw.inspect(rw.Body(rw.generate_mesh("bar"), rw.Material("stvk", young=30e3, poisson=0.3, density=1000)))
try:
    step.plot()
except ImportError as fault:
    print(fault)
"""


def test_without_matplotlib_one_line_says_so() -> None:
    told = subprocess.run([sys.executable, "-c", WITHOUT], capture_output=True, text=True, check=True).stdout
    assert told.startswith("plot: needs matplotlib (Debian: python3-matplotlib): ") and told.count("\n") == 1


def test_matplotlib_is_imported_late() -> None:
    code = "import sys, ringwatch; assert 'matplotlib' not in sys.modules and 'meshio' not in sys.modules"
    subprocess.run([sys.executable, "-c", code], check=True)


@pytest.fixture
def pyplot(monkeypatch: pytest.MonkeyPatch) -> Any:
    monkeypatch.setenv("MPLBACKEND", "Agg")
    module = pytest.importorskip("matplotlib.pyplot")
    yield module
    module.close("all")


def texts(ax: Any) -> Any:
    return [text.get_text() for text in ax.get_legend().get_texts()]


def test_a_run(pyplot: Any, tmp_path: pathlib.Path) -> None:
    result = rw.run(SOURCE / "examples/stretch_bar.toml", out=tmp_path / "run",
                    overrides=["output.picture=false", "mesh.cells=[6,2,2]", "integrator.step=3e-3", "monitor.metric=none"])
    ax = result.plot()
    optimistic, safe, taken = ax.get_lines()[:3]
    for line, column in ((optimistic, "optimistic_s"), (safe, "safe_s"), (taken, "h_s")):
        assert np.array_equal(line.get_xdata(), result.history["time_s"])
        assert np.array_equal(line.get_ydata(), result.history[column], equal_nan=True)
    kinds = {event["kind"] for event in result.summary["events"]}
    assert "violated" in kinds and kinds <= set(texts(ax)) and ax.get_title() == result.verdict
    begun = [line.get_xdata()[0] for line in ax.get_lines()[3:]]
    assert sorted(begun) == sorted(event["time"] for event in result.summary["events"])
    ax.figure.savefig(tmp_path / "run.png")
    assert (tmp_path / "run.png").stat().st_size > 5000


def test_the_page_in_a_notebook(tmp_path: pathlib.Path) -> None:
    pytest.importorskip("IPython")
    result = rw.run(SECTIONS, out=tmp_path / "run")
    [page] = re.findall('srcdoc="([^"]*)"', result.show().data)
    assert html.unescape(page) == (tmp_path / "run/report.html").read_text(encoding="utf-8")


def test_runs_without_bracket(pyplot: Any, tmp_path: pathlib.Path) -> None:
    result = rw.run({**SECTIONS, "monitor": {"bracket": False, "metric": "reduced-1-ring"}}, out=tmp_path / "metric")
    ax = result.plot()
    assert texts(ax) == ["by the metric: an estimate", "step taken"]
    assert np.array_equal(ax.get_lines()[0].get_ydata(), result.history["metric_step_s"])
    result = rw.run({**SECTIONS, "monitor": {"bracket": False}}, out=tmp_path / "run")
    with pytest.raises(rw.InputError, match="the run was not monitored"):
        result.plot()


@pytest.mark.parametrize("jitter", [0, 0.2])
def test_an_inspection(pyplot: Any, jitter: float) -> None:
    step = rw.inspect(body_of(bar(cells=[8, 2, 2], jitter=jitter)), metrics=["single-element", "reduced-1-ring"])
    _, mine = pyplot.subplots()
    for ax, metric in ((step.plot(), "single-element"), (step.plot(mine, metric="reduced-1-ring"), "reduced-1-ring")):
        steps = step.metrics[metric].element_steps[0]
        assert sum(bar.get_height() for bar in ax.patches) == len(steps)  # none is left out
        assert ax.patches[0].get_x() == pytest.approx(steps.min(), rel=0.02) and metric in ax.get_xlabel()
        assert [line.get_xdata()[0] for line in ax.get_lines()] == [step.safe, step.optimistic]
    assert step.plot(mine) is mine
    with pytest.raises(rw.InputError, match="'fried' was not asked for"):
        step.plot(metric="fried")


def test_a_comparison(pyplot: Any) -> None:
    found = rw.compare(SOURCE / "examples/swinging_bar.toml", integrators=["verlet", "rk4"], steps=[1e-3, 2e-3],
                       overrides=["mesh.cells=[4,1,1]", "integrator.end=0.05"])
    for against in ("seconds", "forces"):
        ax = found.plot(against=against)
        assert texts(ax) == ["verlet", "rk4"]
        first = ax.get_lines()[0]
        assert np.array_equal(first.get_ydata(), found.runs["error"][:2])
    assert np.array_equal(first.get_xdata(), found.runs["forces"][:2] + found.runs["products"][:2])
    with pytest.raises(rw.InputError, match="unknown 'money'; known are seconds, forces"):
        found.plot(against="money")
