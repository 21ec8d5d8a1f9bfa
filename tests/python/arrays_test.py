"""Arrays are read where they lie, results own their memory, and what does not fit is refused with what would."""
import gc
import json
import os
import pathlib
import resource
import subprocess
import sys
import threading
import time
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import ringwatch as rw
from support import bar, body_of, stretched, two_elements


def address(array: Any) -> Any:
    return array.__array_interface__["data"][0]


def test_views_share_memory_and_cannot_be_written() -> None:
    mesh = bar()
    body = body_of(mesh)
    view: Any
    for view in (lambda: mesh.points, lambda: mesh.cells["tet4"], lambda: body.points, lambda: body.lumped_mass):
        first, second = view(), view()
        assert np.shares_memory(first, second) and address(first) == address(second)
        assert not first.flags.owndata and not first.flags.writeable and first.flags.c_contiguous
        with pytest.raises(ValueError):
            first[0] = 0
    assert mesh.points.dtype == np.float64 and mesh.cells["tet4"].dtype == np.int32


def test_views_outlive_their_owner() -> None:
    points = bar().points
    mass = body_of(bar()).lumped_mass
    gc.collect()
    again = bar()
    assert np.array_equal(points, again.points) and np.array_equal(mass, body_of(again).lumped_mass)


def test_results_own_their_memory() -> None:
    body = body_of(bar())
    x = stretched(body.points, 100)
    first = body.internal_force(x)
    kept = first.copy()
    second = body.internal_force(stretched(body.points, 200))
    assert not np.shares_memory(first, second) and first.flags.writeable
    assert np.array_equal(first, kept) and not np.array_equal(first, second)


def test_states_are_read_where_they_lie() -> None:
    """Counted by a library that stands in for malloc: see allocations.cpp."""
    told = subprocess.run([sys.executable, "-c", COUNTED], capture_output=True, text=True, check=False,
                          env={**os.environ, "LD_PRELOAD": os.environ["RINGWATCH_ALLOCATIONS"]})
    assert told.returncode == 0, told.stderr
    assert json.loads(told.stdout) == {"copy": 1, "nothing": 0, "observe": 0, "energy": 0, "force": 1, "product": 1}


COUNTED = """
import ctypes, json
import numpy as np
import ringwatch as rw
count = ctypes.CDLL(None).ringwatch_large_allocations
count.argtypes = [ctypes.c_size_t]
body = rw.Body(rw.generate_mesh("bar", cells=[12, 6, 6]), rw.Material("stvk", young=3e4, poisson=0.3, density=1e3), threads=1)
x, v = body.points * 1.001, np.zeros_like(body.points)
monitor = rw.Monitor(body)
calls = {
    "copy": lambda: x.copy(),
    "nothing": lambda: None,
    "observe": lambda: monitor.observe(0, 0.0, x, v, 1e-5),
    "energy": lambda: body.energy(x),
    "force": lambda: body.internal_force(x),
    "product": lambda: body.tangent_product(x, v),
}
counts = {}
for name, call in calls.items():
    kept = [call(), call()]  # what is kept from call to call is made
    count(x.nbytes)
    kept.append(call())
    counts[name] = count(x.nbytes)
print(json.dumps(counts))
"""


def resident() -> Any:
    """Bytes of this process that lie in memory."""
    return int(pathlib.Path("/proc/self/statm").read_text().split()[1]) * resource.getpagesize()


def test_nothing_is_left_behind() -> None:
    body = body_of(bar(cells=[12, 6, 6]), threads=1)
    x, v = stretched(body.points, 1), np.zeros_like(body.points)
    monitor = rw.Monitor(body, limit=2.0)
    sizes = []
    for _ in range(10):
        for k in range(100):
            monitor.observe(k, 0.0, x, v, 1e-5, force=True, energy=True)
            body.internal_force(x)
            body.tangent_product(x, x)
        rw.Monitor(body, limit=2.0).observe(0, 0.0, x, v, 1e-5)
        sizes.append(resident())
    # The allocator takes more and gives it back; the least of some rounds shows what is kept. If each call left one
    # array behind, 400 of a kind would be kept from one half to the other.
    early, late = sizes[2:6], sizes[6:]  # the first rounds fill the allocator
    assert min(late) - min(early) < 100 * x.nbytes, sizes


STATES: dict[str, Any] = {
    "x: an array of float32 of shape (20, 3) in C order": lambda x: x.astype(np.float32),
    "x: an array of float64 of shape (20, 3) not in C order": np.asfortranarray,
    "x: an array of float64 of shape (3, 20) not in C order": lambda x: x.T,
    "x: an array of float64 of shape (19, 3) in C order": lambda x: x[1:].copy(),
    "x: an array of float64 of shape (20, 2) in C order": lambda x: x[:, :2].copy(),
    "x: an array of float64 of shape (60,) in C order": lambda x: x.ravel(),
    "x: an array of float64 of shape (10, 3) not in C order": lambda x: x[::2],
    "x: an array of >f8 of shape (20, 3) in C order": lambda x: x.astype(">f8"),
    "x: an array of int64 of shape (20, 3) in C order": lambda x: x.astype(np.int64),
    "x: an object of type list": lambda x: x.tolist(),
    "x: an object of type NoneType": lambda x: None,
}


@pytest.mark.parametrize("what", STATES)
def test_other_arrays_are_refused_with_what_would_be_right(what: Any) -> None:
    body = body_of(bar())
    x = body.points.copy()
    assert len(x) == 20
    wrong = STATES[what](x)
    monitor = rw.Monitor(body)
    calls: list[Any] = [body.internal_force, body.energy, lambda a: body.tangent_product(a, x), body.element_tangents,
             lambda a: monitor.observe(0, 0.0, a, x)]
    if wrong is not None:
        calls.append(lambda a: rw.inspect(body, a))
    for call in calls:
        with pytest.raises(rw.InputError) as raised:
            call(wrong)
        assert str(raised.value).startswith(what + "; must be an array of float64 of shape (20, 3) in C order, as ")
        assert "\n" not in str(raised.value)
    assert isinstance(raised.value, ValueError)


def test_unaligned_numbers_are_refused() -> None:
    body = body_of(bar())
    memory = np.zeros(body.points.nbytes + 8, dtype=np.uint8)
    x = memory[1 : 1 + body.points.nbytes].view(np.float64).reshape(-1, 3)
    with pytest.raises(rw.InputError, match=r"^x: float64 numbers that are not aligned in memory; pass x\.copy\(\)$"):
        body.energy(x)
    # Aligned as a double and no further is fine, to the same bits.
    aligned = np.zeros(body.points.size + 1)[1:].reshape(-1, 3)
    aligned[:] = stretched(body.points, 300)
    assert np.array_equal(body.internal_force(aligned), body.internal_force(stretched(body.points, 300)))


@settings(max_examples=24, deadline=None, database=None, derandomize=True)
@given(st.integers(0, 7), st.integers(1, 5000))
def test_where_a_state_lies_does_not_matter(offset: Any, k: float) -> None:
    body = body_of(bar(element="hex8"), threads=1)
    here = stretched(body.points, k)
    memory = np.zeros(here.size + 8)
    there = memory[offset : offset + here.size].reshape(-1, 3)
    there[:] = here
    one, other = rw.inspect(body, here), rw.inspect(body, there)
    assert (one.safe, one.optimistic) == (other.safe, other.optimistic)
    v = np.zeros_like(here)
    first, second = (rw.Monitor(body).observe(0, 0.0, x, v, 1e-4, force=True, energy=True) for x in (here, there))
    assert (first.bracket, first.strain_energy) == (second.bracket, second.strain_energy)
    assert first.internal_force is not None and second.internal_force is not None
    assert np.array_equal(first.internal_force, second.internal_force)


def test_meshes_are_checked() -> None:
    points, cells = two_elements()
    mesh = rw.Mesh(points, {"tet4": cells}, node_sets={"base": np.array([0, 1, 2])})
    assert np.array_equal(mesh.points, points) and not np.shares_memory(mesh.points, points)
    assert np.array_equal(mesh.cells["tet4"], cells) and mesh.element_count == 2
    assert mesh.node_sets["base"].tolist() == [0, 1, 2]
    for wrong, line in [
        ({"tet5": cells}, r"^cells: unknown element \"tet5\"; did you mean \"tet4\"\? known are tet4"),
        ({"tet4": cells + 1}, r'^cells\["tet4"\]: 5 is out of range; must be 0 to 4$'),
        ({"tet4": cells - 1}, r'^cells\["tet4"\]: -1 is out of range; must be 0 to 4$'),
        ({"tet4": cells[:, :3]}, r'^cells\["tet4"\]: an array of int64 of shape \(2, 3\) .*; must be of shape \(any, 4\)'),
        ({"tet4": cells.astype(float)}, r'^cells\["tet4"\]: an array of float64 .*; must be an array or a list of whole numbers'),
        ({"tet4": [[0, 1, 2, 3], [1, 2, 3]]}, r'^cells\["tet4"\]: an object of type list; must be an array or a list of whole numbers'),
        ({"tet4": np.array([[0, 1, 2, 2]])}, r"^mesh: "),
    ]:
        with pytest.raises(rw.InputError, match=line):
            rw.Mesh(points, wrong)
    with pytest.raises(rw.InputError, match=r"^points: .*; must be an array of float64 of shape \(any, 3\) in C order"):
        rw.Mesh(points.astype(np.float32), {"tet4": cells})
    turned = rw.Mesh(points, {"tet4": np.array([[1, 0, 2, 3]])})
    assert turned.cells["tet4"].tolist() != [[1, 0, 2, 3]] and len(turned.points) == 4 and len(turned.notes) == 2


def test_lists_and_names_are_taken_as_arrays_are() -> None:
    """Indices are copied in any case; what is held is compared by the bracket that it gives."""
    points, cells = two_elements()
    blocks: list[Any] = [{"tet4": cells.tolist()}, {"tetra": cells}, [("tetra", cells.tolist())]]
    for given in blocks:
        mesh = rw.Mesh(points, given, node_sets={"base": [0, 1, 2]}, node_ids=range(10, 15), cell_ids=[(7, 8)])
        assert np.array_equal(mesh.cells["tet4"], cells) and mesh.node_sets["base"].tolist() == [0, 1, 2]
        assert rw.inspect(body_of(mesh)).controlling.id in (7, 8)
    steps = set()
    flags = np.arange(5) < 3
    selections: list[Any] = [np.array([0, 1, 2]), [0, 1, 2], (2, 1, 0), range(3), [np.int64(0), 1, 2], "base", flags, flags.tolist()]
    for nodes in selections:
        body = body_of(mesh)
        body.fix(nodes)
        steps.add(rw.inspect(body).safe)
    assert len(steps) == 1 and steps != {rw.inspect(body_of(mesh)).safe}
    slips: list[tuple[Any, str]] = [
        ("bass", r'^nodes: unknown set "bass"; did you mean "base"\? known are base$'),
        ([0.5], r"^nodes: an array of float64 of shape \(1,\)"),
        (["base"], r"^nodes: an array of <U4"),
        (3, r"^nodes: an object of type int; must be"),
    ]
    for wrong, line in slips:
        with pytest.raises(rw.InputError, match=line):
            body.fix(wrong)
    with pytest.raises(rw.InputError, match=r'^nodes: unknown set "base"; known are x-max, x-min, '):
        body_of(bar()).fix("base")


def test_two_blocks_of_one_element() -> None:
    points, cells = two_elements()
    mesh = rw.Mesh(points, [("tet4", cells[:1]), ("tet4", cells[1:])])
    assert [name for name, _ in mesh.blocks] == ["tet4", "tet4"]
    with pytest.raises(rw.InputError, match="several blocks of tet4; use blocks"):
        mesh.cells
    soft, hard = (rw.Material("stvk", young=e, poisson=0.3, density=1000) for e in (1e3, 1e6))
    steps = rw.inspect(rw.Body(mesh, [hard, soft]), metrics=["single-element"]).element_steps
    assert [s.shape for s in steps] == [(1,), (1,)] and steps[1][0] > 10 * steps[0][0]


def test_other_threads_go_on() -> None:
    """Python's lock is given up: another thread runs while a body is inspected."""
    body = body_of(bar(cells=[14, 6, 6]), threads=1)
    done = threading.Event()

    def inspect() -> None:
        rw.inspect(body)
        done.set()

    interval = 1e-3  # s, after which the lock is asked for
    sys.setswitchinterval(interval)
    worker = threading.Thread(target=inspect)
    worker.start()
    begin = time.thread_time()
    while not done.is_set():
        pass
    used = time.thread_time() - begin
    worker.join()
    # With the lock held this thread would run for an interval before the inspection and stand still until its end.
    # Processor time, since on a busy machine any thread may stand still.
    assert used > 10 * interval


def test_threads_share_a_body_and_a_monitor() -> None:
    body = body_of(bar(cells=[6, 2, 2]), threads=1)
    x = stretched(body.points, 500)
    expected = body.internal_force(x)
    monitor = rw.Monitor(body)
    faults: list[Any] = []

    def work(number: Any) -> None:
        try:
            for k in range(40):
                if not np.array_equal(body.internal_force(x), expected):
                    faults.append("force")
                monitor.observe(k, 0.0, stretched(body.points, 10 * (number + k)), np.zeros_like(x), 1e-5)
                if number == 0:
                    body.fix(np.array([k]))
        except Exception as fault:  # noqa: BLE001 - handed to the test's own thread
            faults.append(fault)

    threads = [threading.Thread(target=work, args=(n,)) for n in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not faults


@pytest.mark.parametrize("order", ["import numpy, ringwatch", "import ringwatch, numpy"])
def test_import_order_does_not_matter(order: int) -> None:
    code = (f"{order}\nimport numpy as np, ringwatch as rw\nnp.linalg.svd(np.random.rand(100, 100))\n"
            "b = rw.Body(rw.generate_mesh('bar', cells=[8, 2, 2]), rw.Material('stvk', young=3e4, poisson=.3, density=1e3))\n"
            "s = rw.inspect(b)\nnp.linalg.svd(np.random.rand(100, 100))\nprint(s.safe.hex())")
    told = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert float.fromhex(told.stdout) == rw.inspect(body_of(rw.generate_mesh("bar", cells=[8, 2, 2]))).safe


def test_results_are_frozen() -> None:
    import dataclasses

    body = body_of(bar())
    step = rw.inspect(body)
    report = rw.Monitor(body).observe(0, 0.0, body.points, body.points, 1.0)
    for result in (step, step.controlling, step.cause, step.metrics["reduced-1-ring"], report, report.bracket,
                   report.new_events[0]):
        assert dataclasses.is_dataclass(result)
        name = dataclasses.fields(result)[0].name
        with pytest.raises(dataclasses.FrozenInstanceError):
            setattr(result, name, None)
        assert dataclasses.replace(result) == result or isinstance(result, (rw.Metric, rw.Inspection))
