"""The certificate on a GPU, at positions that cupy, torch, jax and others hold there."""
from __future__ import annotations

import importlib
from typing import Any

from ._errors import InputError
from ._results import DeviceReport
from ._ringwatch import Body

_CUDA, _CUDA_MANAGED = 2, 13  # devices of DLPack
_ALL_WORK = 1  # CUDA's default stream


class DeviceMonitor:
    """Whether steps are certified at states that lie on an NVIDIA GPU: DeviceMonitor(body, limit=2.0).

    limit: the integrator's largest stable h·omega. Mass, supports and rules are those that the body has now. Nothing of a
    state comes to the host: an observation is one pass over the elements on the GPU while all of them are in their
    validity balls. Raises InputError in a build without CUDA, without a GPU, and for bodies that a GPU does not take
    (docs/gpu.md).
    """

    def __init__(self, body: Body, limit: float = 2.0) -> None:
        try:
            device = importlib.import_module("ringwatch._device")
        except ModuleNotFoundError:
            raise InputError("DeviceMonitor: this ringwatch was built without CUDA; docs/gpu.md says how to build it") from None
        self._monitor = device.Monitor(body, limit)

    def observe(self, x: Any, h: float | None = None) -> DeviceReport:
        """Observes positions x, (N, 3) float64 in C order on the GPU, m, before a step of h, s.

        x: an object with `__dlpack__`, as of cupy, torch and jax, or `__cuda_array_interface__`. It is read where it lies,
        after the work that its package has under way, and before this returns. h: None for the largest step that can be
        proven, which takes a bound from scratch. Raises InputError.
        """
        if hasattr(x, "__dlpack__") and hasattr(x, "__dlpack_device__"):
            if x.__dlpack_device__()[0] not in (_CUDA, _CUDA_MANAGED):
                raise InputError("x: lies on the host; must be on the GPU of the body, or be observed by Monitor")
            report: DeviceReport = self._monitor.observe_tensor(x.__dlpack__(stream=self._monitor.stream), h)
            return report
        given = getattr(x, "__cuda_array_interface__", None)
        if given is None:
            raise InputError(f"x: an object of type {type(x).__name__}; must have __dlpack__ or __cuda_array_interface__")
        wanted = (self._monitor.node_count, 3)
        shape, strides = tuple(given["shape"]), given.get("strides")
        if given["typestr"] != "<f8" or shape != wanted or strides not in (None, (24, 8)):
            order = " not in C order" if shape == wanted and strides not in (None, (24, 8)) else ""
            raise InputError(f"x: an array of {given['typestr']} of shape {shape}{order}; must be of <f8, float64, of shape "
                             f"{wanted} in C order")
        stream = given.get("stream", _ALL_WORK)  # None: nothing is under way
        report = self._monitor.observe_pointer(given["data"][0], h, stream)
        return report
