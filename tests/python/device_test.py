"""The certificate on a GPU at positions of cupy and torch: proven steps are below the critical one, nothing of a state
comes to the host. Without a GPU the tests are skipped, but that which says what is missing."""
import importlib.util
import json
import pathlib
from typing import Any

import numpy as np
import pytest

import ringwatch as rw
from support import bar, body_of

CUDA = importlib.util.find_spec("ringwatch._device") is not None
needs_cuda = pytest.mark.skipif(not CUDA, reason="ringwatch was built without CUDA")


@pytest.mark.skipif(CUDA, reason="ringwatch was built with CUDA")
def test_a_build_without_cuda_says_so() -> None:
    with pytest.raises(rw.InputError, match="DeviceMonitor: this ringwatch was built without CUDA; docs/gpu.md"):
        rw.DeviceMonitor(body_of(bar()))


class Interface:
    """Nothing but __cuda_array_interface__, as numba's arrays have it."""

    def __init__(self, array: Any, **other: Any) -> None:
        self.held = array
        self.__cuda_array_interface__ = {**array.__cuda_array_interface__, **other}


def makers() -> Any:
    """Ways to have a numpy array on the GPU, by name."""
    cupy = pytest.importorskip("cupy")
    if not cupy.cuda.is_available():
        pytest.skip("there is no GPU")
    torch = pytest.importorskip("torch")
    return {
        "cupy": cupy.asarray,
        "torch": lambda x: torch.from_numpy(np.array(x)).cuda(),
        "interface": lambda x: Interface(cupy.asarray(x)),
        "interface, default stream": lambda x: Interface(cupy.asarray(x), version=2, stream=1),
    }


def pulled(body: Any, k: float) -> Any:
    x = body.points.copy()
    x[:, 0] *= 1 + k / 100
    return x


@needs_cuda
@pytest.mark.parametrize("element", ["tet4", "hex8"])
def test_certified_steps_are_stable(element: str) -> None:
    """Against the exact critical step, of the CPU; and every package's arrays say the same, bit by bit."""
    told = {}
    for name, on_gpu in makers().items():
        body = body_of(bar(element=element))
        body.fix(body.points[:, 0] < 1e-6)
        monitor = rw.DeviceMonitor(body, limit=2.0)
        first = monitor.observe(on_gpu(body.points))
        exact = rw.inspect(body, exact=True).exact
        assert exact is not None and first.h is None and first.renewed and first.safe <= exact <= 1.3 * first.safe
        h = 0.9 * first.safe
        told[name] = [first, monitor.observe(on_gpu(body.points), h)]
        assert told[name][1].renewed and told[name][1].certified
        for k in range(1, 41):
            x = pulled(body, k)
            report = monitor.observe(on_gpu(x), h)
            told[name].append(report)
            if report.certified:
                exact = rw.inspect(body, x, exact=True).exact
                assert exact is not None and report.safe >= h and h <= exact
        certified = [report.certified for report in told[name]]
        assert certified[2] and not certified[-1]  # stretched by 0.4 the step is too large
        assert any(not report.renewed for report in told[name])
        assert all(certified[i] for i, report in enumerate(told[name]) if not report.renewed)
    all_told = list(told.values())
    assert len(all_told) == 4 and all(other == all_told[0] for other in all_told[1:])


@needs_cuda
def test_what_is_not_finite() -> None:
    on_gpu = makers()["cupy"]
    body = body_of(bar())
    monitor = rw.DeviceMonitor(body)
    h = 0.9 * monitor.observe(on_gpu(body.points)).safe
    x = body.points.copy()
    x[3, 1] = np.nan
    for _ in range(2):
        assert monitor.observe(on_gpu(body.points), h).certified
        report = monitor.observe(on_gpu(x), h)
        assert not report.certified and report.safe == 0


@needs_cuda
def test_work_under_way_comes_first() -> None:
    """A state that is still being computed, in a stream that waits for no other."""
    makers()
    cupy, torch = pytest.importorskip("cupy"), pytest.importorskip("torch")
    body = body_of(bar())
    monitor = rw.DeviceMonitor(body)
    h = 0.9 * monitor.observe(cupy.asarray(body.points)).safe
    good = cupy.asarray(body.points)
    matrix = cupy.ones((6000, 6000))
    wrap: Any
    for wrap in (lambda x: x, Interface):
        stream = cupy.cuda.Stream(non_blocking=True)
        x = cupy.full_like(good, np.nan)
        cupy.cuda.Device().synchronize()
        with stream:
            busy = matrix @ matrix  # some hundred milliseconds, or ten
            x[...] = good + 0 * busy[0, 0]
            assert monitor.observe(wrap(x), h).certified
    good, matrix = torch.from_numpy(body.points.copy()).cuda(), torch.ones(6000, 6000, dtype=torch.float64, device="cuda")
    x = torch.full_like(good, torch.nan)
    torch.cuda.synchronize()
    with torch.cuda.stream(torch.cuda.Stream()):
        busy = matrix @ matrix
        x.copy_(good + 0 * busy[0, 0])
        assert monitor.observe(x, h).certified


@needs_cuda
def test_no_state_comes_to_the_host(tmp_path: pathlib.Path) -> None:
    """All copies between GPU and host that CUDA's own profiler sees."""
    makers()
    torch = pytest.importorskip("torch")
    body = body_of(bar(cells=[40, 10, 10]))
    monitor = rw.DeviceMonitor(body)
    x = torch.from_numpy(body.points.copy()).cuda()
    h = 0.9 * monitor.observe(x).safe
    monitor.observe(x, h)
    with torch.profiler.profile(activities=[torch.profiler.ProfilerActivity.CUDA]) as profiler:
        on_host = x.cpu()  # what the profiler must see
        torch.cuda.synchronize()
        for k in range(20):
            assert monitor.observe(x * (1 + 1e-6 * k), h).certified
    profiler.export_chrome_trace(str(tmp_path / "trace.json"))
    trace = json.loads((tmp_path / "trace.json").read_text())["traceEvents"]
    copied = [event["args"]["bytes"] for event in trace if event.get("cat") == "gpu_memcpy"
              and ("DtoH" in event["name"] or "HtoD" in event["name"])]
    state = on_host.numel() * 8
    assert copied.count(state) == 1 and max(copied) == state  # our own
    assert len(copied) > 20 and sum(copied) - state < 20 * 1000


@needs_cuda
def test_what_is_refused() -> None:
    on_gpu = makers()
    cupy, torch = pytest.importorskip("cupy"), pytest.importorskip("torch")
    body = body_of(bar())
    count = len(body.points)
    monitor = rw.DeviceMonitor(body)
    x = on_gpu["cupy"](body.points)
    for wrong, said in ((body.points.copy(), "lies on the host"),
                        (body.points.tolist(), "an object of type list; must have __dlpack__"),
                        (torch.from_numpy(body.points.copy()), "lies on the host"),
                        (x.astype(cupy.float32), "numbers of 32 bits"),
                        (x[:-1], rf"of shape \({count - 1}, 3\); must be .* of shape \({count}, 3\)"),
                        (x.T.copy().T, "not in C order"),
                        (Interface(x.astype(cupy.float32)), "an array of <f4"),
                        (Interface(x.T.copy().T), "not in C order"),
                        (Interface(x, data=(body.points.ctypes.data, True)), "not in the memory of GPU 0")):
        with pytest.raises(rw.InputError, match=said):
            monitor.observe(wrong, 1e-4)
    for h in (0, -1, np.inf, np.nan):
        with pytest.raises(rw.InputError, match="h = .* must be > 0 and finite"):
            monitor.observe(x, h)
    with pytest.raises(rw.InputError, match="limit = 0: must be > 0"):
        rw.DeviceMonitor(body, limit=0)
    assert monitor.observe(x, 1e-9).certified  # it still works
