"""Texts, messages and pictures name the units that a program chooses; numbers stay what they are."""
import re
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

import ringwatch as rw
from run_test import SCENE
from support import bar, body_of


@pytest.fixture(autouse=True)
def leave_si() -> Iterator[None]:
    yield
    rw.use_units("SI")


def told() -> list[str]:
    body = body_of(bar())
    step = rw.inspect(body, exact=True)
    monitor = rw.Monitor(body, limit=2.0)
    report = monitor.observe(0, 0.5, body.points, np.zeros_like(body.points), 2 * step.optimistic)
    net = bar()
    suggested = rw.suggest(net.points, net.cells["tet4"], young=1e5, poisson=0.3, density=1000, dt=1 / 60)
    return [str(step), str(report), str(report.bracket), str(report.new_events[0]), str(suggested)]


def test_bodies_and_materials_name_them() -> None:
    material, body = rw.Material("stvk", young=210e3, poisson=0.3, density=7.85e-9), body_of(bar())
    assert repr(body).endswith(" kg>") and repr(material).endswith(" m/s>")
    rw.use_units("mm-t-s")
    assert repr(body).endswith(" t>") and repr(material).endswith(" mm/s>") and " t/mm3," in repr(material)


def refusal() -> str:
    with pytest.raises(rw.InputError) as fault:
        rw.Material("stvk", young=-1.0, poisson=0.3, density=1000.0)
    return str(fault.value)


@pytest.mark.parametrize("system, time, pressure", [("mm-t-s", "s", " MPa"), ("mm-kg-ms", "ms", " GPa"), ("cm-g-us", "us", " Mbar"), ("none", "", "")])
def test_texts(system: str, time: str, pressure: str) -> None:
    si = told()
    assert all(re.search(r"[0-9] s\b", text) for text in si)
    rw.use_units(system)
    assert told() == [re.sub(r"(?<=[0-9]) s\b", f" {time}" if time else "", text) for text in si]
    assert refusal() == f"young = -1{pressure}: must be > 0"


def test_pictures(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("MPLBACKEND", "Agg")
    pytest.importorskip("matplotlib.pyplot")
    step: Any = rw.inspect(body_of(bar()), metrics=["single-element"])
    for system, unit in (("SI", " (s)"), ("cm-g-us", " (us)"), ("none", "")):
        rw.use_units(system)
        assert step.plot().get_xlabel() == f"step of an element by single-element{unit}"


def test_audits_name_them(tmp_path: Any) -> None:
    scene = tmp_path / "scene.toml"
    scene.write_text(SCENE)
    folder = rw.run(scene, out=tmp_path / "run", overrides=["output.every=0.01"]).folder
    rw.use_units("mm-kg-ms")
    found = rw.audit(folder / "run.pvd", step=1e-4, density=1000, young=30e3, poisson=0.3)
    assert re.search(r"at t = \S+ ms; \S+ ms is proven", found.message)
    # A scene names its own.
    assert re.search(r"at t = \S+ s; \S+ s is proven", rw.audit(folder / "run.pvd", step=1e-4, scene=scene).message)


def test_what_is_known_is_told() -> None:
    with pytest.raises(rw.InputError, match='system: unknown "metric".*mm-t-s'):
        rw.use_units("metric")
