"""A run of which one allocation fails ends by a line, whichever it is: no signal ends it, and nothing is written twice.

  end_of_memory_test.py PROGRAM ALLOCATOR
"""
import os
import pathlib
import subprocess
import sys
import tempfile

SCENE = """
[mesh]
generate = "bar"
cells = [12, 3, 3]
[material]
model = "stvk"
young = 30e3
poisson = 0.3
density = 1000
[integrator]
method = "symplectic-euler"
step = "auto"
end = 0.03
[[fix]]
set = "x-min"
[[move]]
set = "x-max"
velocity = [1, 0, 0]
"""
# Smaller ones are too many, and those of the C++ library at its start.
LEAST = 2000
RUNS = 120


def main():
    program, allocator = sys.argv[1:]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "scene.toml").write_text(SCENE)

        def run(**settings):
            environment = {**os.environ, "LD_PRELOAD": allocator, "OMP_NUM_THREADS": "2", "FAIL_LEAST": str(LEAST), **settings}
            return subprocess.run([program, "run", "scene.toml", "--quiet"], cwd=folder, env=environment, capture_output=True,
                                  text=True, timeout=300, check=False)

        whole = run(FAIL_COUNT="1")
        assert whole.returncode == 0, whole.stderr
        count = int(whole.stderr.split()[-1])
        assert count > RUNS, f"only {count} allocations: is the allocator loaded?"
        failed = 0
        for k in range(RUNS):
            at = count * k // RUNS
            ended = run(FAIL_AT=str(at))
            assert ended.returncode in (0, 1, 2), f"allocation {at}: status {ended.returncode}, {ended.stderr}"
            failed += ended.returncode != 0
        assert failed > RUNS // 2, f"only {failed} of {RUNS} runs were told of their end of memory"


main()
