#!/usr/bin/env python3
"""The peak memory of each rank of `ringwatch inspect`, of a bar of tetrahedra that is read in parts (MSH 4.1 binary) and of one that every rank reads whole (MSH 4.1 text).

usage: rank_memory.py [PROGRAM] [--cells N] [--ranks 1,2,4] [--element TYPE]
"""
import argparse
import os
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

MEGABYTE = 1024  # of ru_maxrss, kB


def watch(report, command):
    """Runs a rank, and writes its peak memory, kB, behind it."""
    status = subprocess.run(command, check=False).returncode
    peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
    pathlib.Path(f"{report}.{os.environ['OMPI_COMM_WORLD_RANK']}").write_text(str(peak), encoding="utf-8")
    return status


def measure(program, folder, mesh, ranks):
    """Peak memory of each rank, MB, and the time, s."""
    report = folder / "peak"
    began = time.monotonic()
    subprocess.run(["mpirun", "--oversubscribe", "-n", str(ranks), sys.executable, __file__, "--watch", str(report),
                    program, "inspect", str(mesh), "--young", "1e6", "--poisson", "0.3", "--density", "1000",
                    "--threads", "1", "--ranks", "yes"],
                   check=True, stdout=subprocess.DEVNULL,
                   env={**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"})
    took = time.monotonic() - began
    return [int(pathlib.Path(f"{report}.{rank}").read_text(encoding="utf-8")) / MEGABYTE for rank in range(ranks)], took


def main():
    if sys.argv[1:2] == ["--watch"]:
        return watch(sys.argv[2], sys.argv[3:])
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program", nargs="?", default="build/release/bin/ringwatch")
    parser.add_argument("--cells", type=int, default=55, help="along each axis; six tetrahedra each")
    parser.add_argument("--ranks", default="1,2,4")
    parser.add_argument("--element", default="tet4")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        cells = [str(options.cells)] * 3
        for file, more in (("text.msh", []), ("binary.msh", ["--binary"])):
            made = subprocess.run([options.program, "mesh", "generate", "bar", "--cells", *cells, "--jitter", "0.2",
                                   "--element", options.element, "-o", str(folder / file), *more],
                                  check=True, capture_output=True, text=True).stdout
        print(made.split(": ", 1)[1].strip())
        print("| ranks | in parts: MB a rank, most | all ranks | time, s | whole mesh on each: MB a rank, most | all ranks | time, s |")
        print("|---|---|---|---|---|---|---|")
        for ranks in map(int, options.ranks.split(",")):
            row = [str(ranks)]
            for file in ("binary.msh", "text.msh"):
                peaks, took = measure(options.program, folder, folder / file, ranks)
                row += [f"{max(peaks):.0f}", f"{sum(peaks):.0f}", f"{took:.0f}"]
            print("| " + " | ".join(row) + " |", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
