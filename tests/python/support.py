"""What the tests share."""
import json
import os
import pathlib
import subprocess

import numpy as np

import ringwatch as rw

SOURCE = pathlib.Path(os.environ["RINGWATCH_SOURCE"])
BUILD = pathlib.Path(os.environ["RINGWATCH_BUILD"])
PROGRAM = os.environ["RINGWATCH_PROGRAM"]
REFERENCE = os.environ["RINGWATCH_REFERENCE"]
MATERIAL = {"young": 30e3, "poisson": 0.3, "density": 1000}
LAWS = ("stvk", "linear", "corotational", "neo-hookean")


def bar(**parameters):
    return rw.generate_mesh("bar", **{"cells": [4, 1, 1], "jitter": 0.2, **parameters})


def body_of(mesh, law="stvk", **options):
    return rw.Body(mesh, rw.Material(law, **MATERIAL), **options)


def stretched(points, k):
    """The states of reference.cpp."""
    x = points.copy()
    x[:, 0] *= 1 + k / 4096
    return x


def call(*command, status=0):
    ended = subprocess.run([str(c) for c in command], capture_output=True, text=True, check=False)
    assert ended.returncode == status, ended.stderr
    return ended


def inspect_json(path, *options):
    words = ["--young", "30e3", "--poisson", "0.3", "--density", "1000", "--json", "-"]
    return json.loads(call(PROGRAM, "inspect", path, *words, *options).stdout)


def two_elements():
    """Points and cells of two tetrahedra."""
    points = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]])
    return points, np.array([[0, 1, 2, 3], [1, 2, 3, 4]])
