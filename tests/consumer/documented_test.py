#!/usr/bin/env python3
"""Builds the README's program against the installed package with the CMake that README.md and docs/embedding.md show, and runs it; what
they show for a subfolder is configured.

usage: documented_test.py SOURCE_DIR BUILD_DIR WORK_DIR CMAKE GENERATOR COMPILER BUILD_TYPE
"""
import pathlib
import re
import shutil
import subprocess
import sys

source, build, work = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
cmake, generator, compiler, build_type = sys.argv[4:8]


def run(*command, **options):
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, check=False, **options)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout


def main():
    shutil.rmtree(work, ignore_errors=True)
    prefix = work / "prefix"
    run(cmake, "--install", build, "--prefix", prefix)
    found, built = 0, set()
    for page in ("README.md", "docs/embedding.md"):
        for number, text in enumerate(re.findall(r"^```cmake\n(.*?)^```", (source / page).read_text(encoding="utf-8"), re.M | re.S)):
            found += 1
            project = work / f"{pathlib.Path(page).stem}_{number}"
            project.mkdir(parents=True)
            shutil.copy(source / "examples/embed_minimal.cpp", project / "main.cpp")
            (project / "ringwatch").symlink_to(source)
            (project / "CMakeLists.txt").write_text(
                "cmake_minimum_required(VERSION 3.25)\nproject(documented LANGUAGES CXX)\nadd_executable(your_solver main.cpp)\n" + text,
                encoding="utf-8")
            run(cmake, "-S", project, "-B", project / "build", "-G", generator, f"-DCMAKE_CXX_COMPILER={compiler}",
                f"-DCMAKE_BUILD_TYPE={build_type}", f"-DCMAKE_PREFIX_PATH={prefix}")
            bare = re.sub(r"\s*#.*", "", text)
            if "add_subdirectory" in bare or bare in built:
                continue  # consumer.add_subdirectory builds the one, and the other is built
            built.add(bare)
            run(cmake, "--build", project / "build")
            run(prefix / "bin/ringwatch", "mesh", "generate", "bar", "--cells", "8", "2", "2", "-o", "bar.msh", cwd=project)
            if "is proven unstable" not in (said := run(project / "build/your_solver", cwd=project)):
                sys.exit(f"{page}: the program says {said}")
    if found < 3:
        sys.exit(f"only {found} blocks of CMake in the documents")
    print(f"{found} blocks of CMake")


main()
