import os
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._results import CriticalStep, Inspection, MonitorEvent, MonitorReport

__version__: str

Reals = NDArray[np.float64]
Integers = NDArray[np.integer[Any]]
Indices = Integers | Sequence[int]
Connectivity = Integers | Sequence[Sequence[int]]

class Mesh:
    def __init__(
        self,
        points: Reals,
        cells: Mapping[str, Connectivity] | Sequence[tuple[str, Connectivity]],
        *,
        node_sets: Mapping[str, Indices] = {},
        node_ids: Indices | None = None,
        cell_ids: Sequence[Indices] | None = None,
        cell_sets: Mapping[str, Sequence[Indices]] = {},
    ) -> None: ...
    @property
    def points(self) -> Reals: ...
    @property
    def blocks(self) -> tuple[tuple[str, NDArray[np.int32]], ...]: ...
    @property
    def cells(self) -> dict[str, NDArray[np.int32]]: ...
    @property
    def node_sets(self) -> dict[str, NDArray[np.int32]]: ...
    @property
    def cell_sets(self) -> dict[str, list[NDArray[np.int32]]]: ...
    @property
    def notes(self) -> tuple[str, ...]: ...
    @property
    def element_count(self) -> int: ...
    def save(self, path: str | os.PathLike[str]) -> None: ...

class Material:
    def __init__(self, model: str, /, *, density: float, **parameters: float) -> None: ...
    @property
    def model(self) -> str: ...
    @property
    def density(self) -> float: ...
    @property
    def wave_speed(self) -> float: ...

class Body:
    def __init__(
        self,
        mesh: Mesh,
        material: Material | Sequence[Material],
        *,
        lumping: str = "row-sum",
        rules: Mapping[str, str] = {},
        threads: int = 0,
    ) -> None: ...
    @property
    def node_count(self) -> int: ...
    @property
    def element_count(self) -> int: ...
    @property
    def points(self) -> Reals: ...
    @property
    def lumped_mass(self) -> Reals: ...
    @property
    def total_mass(self) -> float: ...
    @property
    def volume(self) -> float: ...
    @property
    def external_force(self) -> Reals: ...
    def add_body_force(self, acceleration: Sequence[float] | Reals) -> None: ...
    def fix(
        self,
        nodes: str | Indices | NDArray[np.bool_] | Sequence[bool],
        components: str = "xyz",
        *,
        velocity: Sequence[float] | Reals = [0.0, 0.0, 0.0],
    ) -> None: ...
    def internal_force(self, x: Reals) -> Reals: ...
    def tangent_product(self, x: Reals, v: Reals) -> Reals: ...
    def energy(self, x: Reals) -> float: ...
    def element_tangents(self, x: Reals, block: int = 0) -> Reals: ...

class Monitor:
    def __init__(
        self,
        body: Body,
        limit: float = 2.0,
        *,
        mode: str = "bracket",
        metric: str = "",
        margin: float = 0.1,
        every: int = 1,
        width: float = 0.05,
        budget: float | None = None,
        steps: int = 0,
        first_observation_elements: int = 10000,
    ) -> None: ...
    def observe(
        self,
        step: int,
        time: float,
        x: Reals,
        v: Reals,
        h: float | None = None,
        *,
        force: bool = False,
        energy: bool = False,
    ) -> MonitorReport: ...
    @property
    def events(self) -> tuple[MonitorEvent, ...]: ...

class TangentBracket:
    def __init__(
        self,
        mass: Reals,
        elements: Integers | Sequence[Integers],
        constrained: NDArray[np.bool_] | None = None,
        *,
        degrees_of_freedom: int = 3,
        group_dofs: Sequence[int] = [],
        threads: int = 0,
    ) -> None: ...
    def evaluate(
        self, tangents: Reals | Sequence[Reals], limit: float = 2.0, *, search_negative: bool = False
    ) -> CriticalStep: ...

def use_units(system: str) -> None: ...
def _used_units() -> str: ...
def _labelled(text: str) -> str: ...
def _elements() -> tuple[tuple[str, int, int, int, tuple[int, ...], tuple[int, ...]], ...]: ...
def load_mesh(path: str | os.PathLike[str], *, repair: bool = False) -> Mesh: ...
def generate_mesh(kind: str, /, **parameters: float | Sequence[float] | str) -> Mesh: ...
def inspect(
    body: Body,
    x: Reals | None = None,
    *,
    limit: float = 2.0,
    metrics: Sequence[str] = ["reduced-1-ring"],
    exact: bool = False,
    width: float = 0.01,
) -> Inspection: ...
def metric_names() -> tuple[str, ...]: ...
