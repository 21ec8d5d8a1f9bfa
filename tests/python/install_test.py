"""The installed module: found below the prefix, works where the prefix is moved to, with its program and its hints."""
import os
import pathlib
import shutil
import subprocess
import sys
import sysconfig

import pytest

from support import BUILD, SOURCE, call

CODE = """
import pathlib, sys
import ringwatch as rw
assert pathlib.Path(rw.__file__).is_relative_to(sys.argv[1]), rw.__file__
step = rw.inspect(rw.Body(rw.generate_mesh("bar"), rw.Material("stvk", young=30e3, poisson=0.3, density=1000)))
result = rw.run(sys.argv[2], out=sys.argv[3], overrides=["output.picture=false", "integrator.end=0.01"])
print(step.safe.hex(), step.optimistic.hex(), result.history["safe_s"][0].hex())
"""


def test_installed_and_moved(tmp_path: pathlib.Path) -> None:
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


def test_debians_python_looks_where_it_is_installed(tmp_path: pathlib.Path) -> None:
    """Below /usr/local, the usual prefix: `python3 -c "import ringwatch"` works as pasted. Staged, so that no root is needed."""
    if "deb_system" not in sysconfig.get_scheme_names():
        pytest.skip("the module is for an interpreter that is not Debian's")
    subprocess.run(["cmake", "--install", BUILD, "--prefix", "/usr/local"], check=True, capture_output=True,
                   env={**os.environ, "DESTDIR": str(tmp_path)})
    plain = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    told = subprocess.run([sys.executable, "-c", "import site; print(*site.getsitepackages(), sep='\\n')"], text=True,
                          capture_output=True, check=True, env=plain, cwd="/").stdout.split("\n")
    found = [folder for folder in told if folder and (tmp_path / folder.lstrip("/") / "ringwatch/__init__.py").exists()]
    assert found == [f"/usr/local/lib/python3.{sys.version_info.minor}/dist-packages"]
    staged = str(tmp_path / found[0].lstrip("/"))
    ended = subprocess.run([sys.executable, "-c", "import ringwatch; print(ringwatch.__file__)"], text=True, capture_output=True,
                           check=True, env={**plain, "PYTHONPATH": staged}, cwd="/")
    assert ended.stdout.startswith(staged)


def test_a_module_without_its_program_says_so(tmp_path: pathlib.Path) -> None:
    shutil.copytree(BUILD / "python/ringwatch", tmp_path / "lib/ringwatch")
    ended = subprocess.run([sys.executable, "-c", "import ringwatch as rw\nrw.run({})"], capture_output=True, text=True,
                           check=False, env={**os.environ, "PYTHONPATH": str(tmp_path / "lib")})
    assert ended.returncode == 1 and "InputError" in ended.stderr and "there is no program" in ended.stderr
