from collections.abc import Callable

from ._results import Verification
from ._verification import Step

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
