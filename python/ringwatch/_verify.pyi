from collections.abc import Callable

from ._results import Verification
from ._verification import Rule, Step

class Acceleration:
    def __init__(self) -> None: ...

def verify(
    make: Callable[[], Step],
    name: str,
    limit: float,
    order: int,
    damped_order: int,
    forces: int,
    symplectic: bool,
    reversible: bool,
    full: bool,
    /,
) -> Verification: ...

def judge(
    rule: Rule,
    name: str,
    meshes: list[str],
    elements: list[str],
    shapes: int,
    histories: bool,
    young: float,
    poisson: float,
    density: float,
    /,
) -> Verification: ...
