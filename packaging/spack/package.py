# UNTESTED: a start for a recipe of Spack. No CI builds it; the Debian package (scripts/package) is the one that is tested.
from spack.package import *


class Ringwatch(CMakePackage):
    """Stability monitor for explicit nonlinear finite element runs."""

    license("BSD-3-Clause")
    version("main", branch="main")  # set `git` to the address of the repository

    variant("mpi", default=True, description="runs that several processes share")
    variant("python", default=False, description="the Python module")
    variant("cuda", default=False, description="the CUDA blocks")

    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    for library in ("eigen@3.4", "spectra", "sundials", "vtk", "tomlplusplus", "cli11", "nlohmann-json", "fmt", "pugixml", "zlib-api", "arb"):
        depends_on(library)
    depends_on("mpi", when="+mpi")
    depends_on("scotch+mpi", when="+mpi")
    depends_on("py-pybind11", when="+python", type="build")
    depends_on("py-numpy", when="+python")
    depends_on("cuda", when="+cuda")

    def cmake_args(self):
        return [
            self.define("RINGWATCH_NATIVE", False),
            self.define("RINGWATCH_BUILD_TESTS", False),
            self.define("RINGWATCH_BUILD_BENCH", False),
            self.define("RINGWATCH_BUILD_EXAMPLES", False),
            self.define_from_variant("RINGWATCH_WITH_MPI", "mpi"),
            self.define_from_variant("RINGWATCH_PYTHON", "python"),
            self.define_from_variant("RINGWATCH_WITH_CUDA", "cuda"),
        ]
