"""What the tests share."""
import json
import os
import pathlib
import subprocess
from typing import Any

import numpy as np
from numpy.typing import NDArray

import ringwatch as rw

Reals = NDArray[np.float64]
SOURCE = pathlib.Path(os.environ["RINGWATCH_SOURCE"])
BUILD = pathlib.Path(os.environ["RINGWATCH_BUILD"])
PROGRAM = os.environ["RINGWATCH_PROGRAM"]
REFERENCE = os.environ["RINGWATCH_REFERENCE"]
MATERIAL = {"young": 30e3, "poisson": 0.3, "density": 1000}
LAWS = ("stvk", "linear", "corotational", "neo-hookean")


def bar(**parameters: Any) -> rw.Mesh:
    every: dict[str, Any] = {"cells": [4, 1, 1], "jitter": 0.2, **parameters}
    return rw.generate_mesh("bar", **every)


def body_of(mesh: rw.Mesh, law: str = "stvk", **options: Any) -> rw.Body:
    return rw.Body(mesh, rw.Material(law, **MATERIAL), **options)


def stretched(points: Reals, k: float) -> Reals:
    """The states of reference.cpp."""
    x = points.copy()
    x[:, 0] *= 1 + k / 4096
    return x


def call(*command: Any, status: Any = 0) -> Any:
    ended = subprocess.run([str(c) for c in command], capture_output=True, text=True, check=False)
    assert ended.returncode == status, ended.stderr
    return ended


def inspect_json(path: pathlib.Path, *options: Any) -> Any:
    words = ["--young", "30e3", "--poisson", "0.3", "--density", "1000", "--json", "-"]
    return json.loads(call(PROGRAM, "inspect", path, *words, *options).stdout)


def two_elements() -> Any:
    """Points and cells of two tetrahedra."""
    points = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]])
    return points, np.array([[0, 1, 2, 3], [1, 2, 3, 4]])
