"""The installed module: found below the prefix, works where the prefix is moved to, with its program and its hints."""
import os
import shutil
import subprocess
import sys

from support import BUILD, SOURCE, call

CODE = """
import pathlib, sys
import ringwatch as rw
assert pathlib.Path(rw.__file__).is_relative_to(sys.argv[1]), rw.__file__
step = rw.inspect(rw.Body(rw.generate_mesh("bar"), rw.Material("stvk", young=30e3, poisson=0.3, density=1000)))
result = rw.run(sys.argv[2], out=sys.argv[3], overrides=["output.picture=false", "integrator.end=0.01"])
print(step.safe.hex(), step.optimistic.hex(), result.history["safe_s"][0].hex())
"""


def test_installed_and_moved(tmp_path):
    call("cmake", "--install", BUILD, "--prefix", tmp_path / "here")
    shutil.move(tmp_path / "here", tmp_path / "there")
    packages = list((tmp_path / "there").glob("lib/python3.*/*-packages"))
    assert len(packages) == 1 and (packages[0] / "ringwatch/py.typed").exists()
    scene = SOURCE / "examples/stretch_bar.toml"
    told = []
    for folder, prefix in ((packages[0], tmp_path / "there"), (BUILD / "python", BUILD)):
        ended = subprocess.run([sys.executable, "-c", CODE, str(prefix), str(scene), str(tmp_path / "out")], text=True,
                               capture_output=True, check=False, env={**os.environ, "PYTHONPATH": str(folder)})
        assert ended.returncode == 0, ended.stderr
        told.append(ended.stdout)
    assert told[0] == told[1]


def test_a_module_without_its_program_says_so(tmp_path):
    shutil.copytree(BUILD / "python/ringwatch", tmp_path / "lib/ringwatch")
    ended = subprocess.run([sys.executable, "-c", "import ringwatch as rw\nrw.run({})"], capture_output=True, text=True,
                           check=False, env={**os.environ, "PYTHONPATH": str(tmp_path / "lib")})
    assert ended.returncode == 1 and "InputError" in ended.stderr and "there is no program" in ended.stderr
