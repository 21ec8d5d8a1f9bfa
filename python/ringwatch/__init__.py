"""ringwatch: how large a step an explicit nonlinear finite element run can take, proven from both sides.

>>> import ringwatch as rw
>>> mesh = rw.generate_mesh("bar", cells=[8, 2, 2])
>>> body = rw.Body(mesh, rw.Material("stvk", young=30e3, poisson=0.3, density=1000))
>>> step = rw.inspect(body)
>>> 0 < step.safe <= step.optimistic
True

Arrays of nodes are (N, 3), float64, in C order, and are read where they lie. Any consistent units will do; those named here are
of the SI, and `use_units` chooses what texts and pictures name. docs/python.md tells more.
"""
from ._errors import InputError, NumericalError
from ._results import (
    Check,
    CriticalStep,
    DeviceReport,
    Element,
    ElementCause,
    Inspection,
    Metric,
    MonitorEvent,
    MonitorReport,
    Suggestion,
    Verification,
)
from ._ringwatch import (
    Body,
    Material,
    Mesh,
    Monitor,
    TangentBracket,
    __version__,
    generate_mesh,
    inspect,
    load_mesh,
    metric_names,
    use_units,
)
from ._convert import grid_of, mesh_from
from ._device_monitor import DeviceMonitor
from ._run import Audit, Comparison, RunResult, audit, compare, report, run
from ._study import load_study
from ._suggest import suggest
from ._verification import judge, verify

__all__ = [
    "Audit",
    "Body",
    "Check",
    "Comparison",
    "CriticalStep",
    "DeviceMonitor",
    "DeviceReport",
    "Element",
    "ElementCause",
    "InputError",
    "Inspection",
    "Material",
    "Mesh",
    "Metric",
    "Monitor",
    "MonitorEvent",
    "MonitorReport",
    "NumericalError",
    "RunResult",
    "Suggestion",
    "TangentBracket",
    "Verification",
    "__version__",
    "audit",
    "compare",
    "generate_mesh",
    "grid_of",
    "inspect",
    "judge",
    "load_mesh",
    "load_study",
    "mesh_from",
    "metric_names",
    "report",
    "run",
    "suggest",
    "use_units",
    "verify",
]
