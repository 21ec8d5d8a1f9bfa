"""The wheel of scripts/wheel, installed without a network into an environment of its own, gives the numbers of the build tree."""
import importlib.util
import os
import pathlib
import subprocess
import sys

import pytest

from support import BUILD, SOURCE, call

CODE = """
import shutil, sys
import ringwatch as rw
assert rw.__file__.startswith(sys.argv[1]) and shutil.which("ringwatch").startswith(sys.argv[1]), rw.__file__
result = rw.run(sys.argv[2], out=sys.argv[3], overrides=["output.picture=false", "integrator.end=0.01"])
print(rw.__version__, rw.inspect(rw.Body(rw.generate_mesh("bar"), rw.Material("stvk", young=30e3, poisson=0.3, density=1000))).safe.hex(),
      result.history["safe_s"][0].hex(), rw.report(result.folder).stat().st_size > 1e5)
"""


def test_it_installs(tmp_path: pathlib.Path) -> None:
    for module in ("wheel", "ensurepip"):
        if importlib.util.find_spec(module) is None:
            pytest.skip("scripts/setup --package installs what a wheel is made and installed with")
    file = pathlib.Path(call(SOURCE / "scripts/wheel", "--build", BUILD).stdout.split()[-1])
    call(sys.executable, "-m", "venv", "--system-site-packages", tmp_path / "venv")
    plain = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    plain["PATH"] = f"{tmp_path}/venv/bin:{plain['PATH']}"
    told = []
    subprocess.run(["python", "-m", "pip", "install", "--no-index", "--quiet", file], check=True, env=plain, cwd=tmp_path)
    for prefix, environment in ((tmp_path / "venv", plain), (BUILD, {**plain, "PYTHONPATH": f"{BUILD}/python", "PATH": f"{BUILD}/bin:{plain['PATH']}"})):
        ended = subprocess.run(["python", "-c", CODE, prefix, SOURCE / "examples/stretch_bar.toml", tmp_path / "out"], text=True,
                               capture_output=True, check=False, env=environment, cwd=tmp_path)
        assert ended.returncode == 0, ended.stderr
        told.append(ended.stdout)
    assert told[0] == told[1] and told[0].endswith("True\n")
    found = subprocess.run(["python", "-m", "pytest", "--fixtures", "-q"], check=False, capture_output=True, text=True, env=plain, cwd=tmp_path)
    assert "ringwatch_audit" in found.stdout
