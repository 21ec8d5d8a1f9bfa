"""Brackets of ranks against the highest eigenvalue that SLEPc finds, which takes nothing of the bounds.

slepc_test.py MPIEXEC PROGRAM: PROGRAM is ringwatch_rank_states.
"""
import os
import pathlib
import subprocess
import sys
import tempfile

try:
    from petsc4py import PETSc
    from slepc4py import SLEPc
except ImportError as fault:
    print(f"skipped: {fault}")
    sys.exit(77)


def read(path):
    with open(path) as lines:
        safe, optimistic, size = next(lines).split()
        entries = [line.split() for line in lines]
    return float(safe), float(optimistic), int(size), entries


def highest(size, entries):
    matrix = PETSc.Mat().createAIJ([size, size], nnz=90)
    matrix.setOption(PETSc.Mat.Option.NEW_NONZERO_ALLOCATION_ERR, False)
    for row, column, value in entries:
        matrix.setValue(int(row), int(column), float(value))
    matrix.assemble()
    solver = SLEPc.EPS().create()
    solver.setOperators(matrix)
    solver.setProblemType(SLEPc.EPS.ProblemType.HEP)
    solver.setWhichEigenpairs(SLEPc.EPS.Which.LARGEST_REAL)
    solver.setTolerances(1e-12, 10000)
    solver.solve()
    assert solver.getConverged() > 0, "SLEPc did not converge"
    return solver.getEigenvalue(0).real


def main():
    mpiexec, program = sys.argv[1:]
    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", OMP_NUM_THREADS="1")
    texts = []
    for ranks in (1, 3):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([mpiexec, "-n", str(ranks), "--oversubscribe", program, folder], check=True, env=environment)
            files = sorted(pathlib.Path(folder).glob("state_*.txt"))
            assert len(files) == 12, files
            texts.append([file.read_text() for file in files])
            if ranks == 1:
                continue
            for file in files:
                safe, optimistic, size, entries = read(file)
                exact = 2 / highest(size, entries) ** 0.5
                print(f"{file.name}: {safe / exact:.4f} <= 1 <= {optimistic / exact:.4f}")
                assert safe <= exact * (1 + 1e-11) and exact * (1 - 1e-11) <= optimistic, (safe, exact, optimistic)
    assert texts[0] == texts[1], "the states differ between 1 and 3 ranks"


main()
