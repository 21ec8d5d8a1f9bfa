"""What pytest has where ringwatch is installed: the fixture `ringwatch_audit`, for the tests of other solvers."""
from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    import ringwatch


@pytest.fixture
def ringwatch_audit() -> Callable[..., ringwatch.Audit]:
    """Fails a test whose run took a step that is not proven, or left an inverted element or a state that is lost.

    Takes what `ringwatch.audit` takes, and returns what it returns: ringwatch_audit("run.pvd", young=1e6, poisson=0.3,
    density=1000, step=2e-4).
    """

    def check(results: Any, **options: Any) -> ringwatch.Audit:
        import ringwatch as rw  # tests that do not audit do not load it

        found = rw.audit(results, **options)
        if found.exit_status or not found.found["steps"]:
            pytest.fail(found.message, pytrace=False)
        return found

    return check
