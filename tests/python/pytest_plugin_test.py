"""The fixture of pytest for other solvers' tests, and the audit that it makes."""
import os
import pathlib
import subprocess
import sys

import pytest

import ringwatch as rw

SCENE = """
[mesh]
generate = "bar"
cells = [4, 1, 1]
[material]
model = "stvk"
young = 30e3
poisson = 0.3
density = 1000
[integrator]
method = "verlet"
step = 1e-3
end = 0.01
[[fix]]
where = "x < 1e-6"
[output]
every = 1e-3
picture = false
"""
TESTS = """
def test_{name}(ringwatch_audit):
    ringwatch_audit("out/run.pvd", young=30e3, poisson=0.3, density=1000, fix=["x < 1e-6"]{step})
"""


@pytest.fixture
def results(tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch) -> pathlib.Path:
    """Frames of a bar at rest, as another solver could have left them."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "bar.toml").write_text(SCENE, encoding="utf-8")
    assert rw.run("bar.toml", out="out").stable
    for frame in (tmp_path / "out/frames").iterdir():  # which would not tell its steps by this name
        frame.write_bytes(frame.read_bytes().replace(b'Name="step (s)"', b'Name="dt"'))
    return tmp_path


def test_a_test_passes_or_fails_by_the_audit(results: pathlib.Path) -> None:
    # The proven step is that of inspect, of the mesh at rest with the same supports.
    body = rw.Body(rw.generate_mesh("bar", cells=[4, 1, 1]), rw.Material("stvk", young=30e3, poisson=0.3, density=1000))
    body.fix([node for node, point in enumerate(rw.generate_mesh("bar", cells=[4, 1, 1]).points) if point[0] < 1e-6])
    safe = rw.inspect(body).safe
    (results / "test_solver.py").write_text(
        TESTS.format(name="good", step=f", step={0.5 * safe!r}") + TESTS.format(name="bad", step=f", step={2 * safe!r}")
        + TESTS.format(name="unknown", step=""), encoding="utf-8")
    plain = {name: value for name, value in os.environ.items() if name != "PYTEST_DISABLE_PLUGIN_AUTOLOAD"}
    ended = subprocess.run([sys.executable, "-m", "pytest", "-rA", "-p", "no:cacheprovider", "test_solver.py"],
                           capture_output=True, text=True, check=False, cwd=results, env=plain)
    assert ended.returncode == 1, ended.stdout + ended.stderr
    assert "PASSED test_solver.py::test_good" in ended.stdout
    assert "FAILED test_solver.py::test_bad" in ended.stdout and "FAILED test_solver.py::test_unknown" in ended.stdout
    assert "the step came to 2 times the proven one, in state 1" in ended.stdout
    assert "the results do not tell which step was taken" in ended.stdout
    assert "2 failed, 1 passed" in ended.stdout


def test_the_audit_is_that_of_the_command_line(results: pathlib.Path) -> None:
    found = rw.audit(["out/run.pvd"], scene="bar.toml", step=1e-3, every=5)
    assert found.exit_status == 0 and 0 < found.largest_share < 1 and len(found.found["history"]) == 3
    assert found.largest_share == pytest.approx(1e-3 / found.found["steps"]["proven_in_all"])
    with pytest.raises(rw.InputError, match="--young, --poisson and --density are required"):
        rw.audit("out/run.pvd")
