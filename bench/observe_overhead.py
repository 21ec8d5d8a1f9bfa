#!/usr/bin/env python3
"""What an observation costs more from Python than from C++: the same body and states, in turns, one thread.

usage: PYTHONPATH=build/release/python python3 bench/observe_overhead.py build/release/bin/ringwatch_python_reference [ROUNDS]

Prints, for bodies of a few sizes, µs of processor time an observation in C++ and from Python: the least of the rounds,
since other programs only ever add to it, and as the error the distance to the next quartile.
"""
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np
import ringwatch as rw

OBSERVATIONS = 200  # a round, as in the C++ program
CELLS = ([1, 1, 1], [4, 1, 1], [8, 2, 2])


def rounds_of_python(path, rounds):
    body = rw.Body(rw.load_mesh(path), rw.Material("stvk", young=30e3, poisson=0.3, density=1000), threads=1)
    states = [body.points.copy(), body.points.copy()]
    states[1][:, 0] *= 1 + 1 / 4096
    v = np.zeros_like(states[0])
    observe = rw.Monitor(body, limit=2.0).observe
    for _ in range(rounds):
        begin = time.thread_time()
        for k in range(OBSERVATIONS):
            observe(k, 1e-3 * k, states[k % 2], v, 1e-4)
        yield (time.thread_time() - begin) / OBSERVATIONS * 1e6


def least(values):
    return min(values), statistics.quantiles(values, n=4)[0] - min(values)


def main():
    program, rounds = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 200
    print("elements  C++ (us)        Python (us)     difference (us)")
    with tempfile.TemporaryDirectory() as folder:
        for cells in CELLS:
            path = pathlib.Path(folder) / "bar.msh"
            mesh = rw.generate_mesh("bar", cells=cells)
            mesh.save(path)
            cpp, python = [], []
            for _ in range(4):  # in turns, so that both see the same machine
                told = subprocess.run([program, "time", path, "stvk", str(rounds)], capture_output=True, text=True, check=True)
                cpp += map(float, told.stdout.split())
                python += rounds_of_python(path, rounds)
            (a, da), (b, db) = least(cpp), least(python)
            print(f"{mesh.element_count:8d}  {a:7.3f} ± {da:.3f}  {b:7.3f} ± {db:.3f}  {b - a:7.3f}")


if __name__ == "__main__":
    main()
