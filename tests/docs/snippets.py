#!/usr/bin/env python3
"""Writes the C++ snippets of README.md and docs/ into one source file, which is compiled with the tests.

Every snippet needs a context here: what its text takes for granted, and whether its lines stand in a function. A snippet
without a context, and a context without a snippet, is an error.

usage: snippets.py SOURCE_DIR OUTPUT
"""
import pathlib
import re
import sys

# (document, number of the snippet in it): (includes, code before), in a loop that `break` may leave. None as code before for a
# snippet that stands outside of functions; a third text is what stands before that one. A file for a snippet that is that file,
# which is built with the examples.
STATE = "  std::int64_t step = 0; double time = 0; ringwatch::NodeVectors x, v;\n"
STEP = STATE + "  double h = 1e-4;\n"
CONTEXTS = {
    ("README.md", 0): "examples/embed_minimal.cpp",
    ("docs/embedding.md", 0): (
        ["ringwatch/monitor/stability_monitor.h"],
        "  struct { std::vector<double> X; std::vector<std::int32_t> tets; } solver; std::int32_t nodes = 0;\n",
    ),
    ("docs/embedding.md", 1): (
        ["ringwatch/monitor/stability_monitor.h"],
        "  ringwatch::Body& body = any<ringwatch::Body>(); ringwatch::StabilityMonitor monitor(body, {.limit = 2.0});\n" + STATE,
    ),
    ("docs/embedding.md", 2): (
        ["ringwatch/integrators/body_system.h", "ringwatch/integrators/symplectic_euler.h",
         "ringwatch/monitor/stability_monitor.h"],
        "  ringwatch::Body& body = any<ringwatch::Body>(); ringwatch::StabilityMonitor monitor(body, {.limit = 2.0});\n"
        "  ringwatch::BodySystem system(body); ringwatch::SymplecticEuler integrator;\n"
        "  ringwatch::State state = system.initialState(); std::int64_t step = 0; double h = 1e-4;\n",
    ),
    ("docs/embedding.md", 3): (
        ["ringwatch/monitor/tangent_bracket.h"],
        "  std::vector<double> mass, tangents; std::vector<std::int32_t> bars; std::vector<std::uint8_t> held;\n",
    ),
    ("docs/embedding.md", 4): (
        ["ringwatch/monitor/tangent_bracket.h"],
        "  std::vector<double> blocks; std::vector<std::int32_t> beams, solids; std::vector<std::uint8_t> held;\n",
    ),
    ("docs/elements.md", 0): (["ringwatch/body/register_element.h"], "  using MyElement = ringwatch::Tet4;\n"),
    ("docs/verify_your_own.md", 0): (["memory"], None),
    ("docs/verify_your_own.md", 1): (["tests/added/wedge15.h"], None, "using MyElement = ringwatch::test::Wedge15;\n"),
    ("docs/verify_your_own.md", 2): (["tests/added/log_mooney_rivlin.h"], None, "using MyLaw = ringwatch::test::LogMooneyRivlin;\n"),
    ("docs/gpu.md", 0): ([], "  ringwatch::Body& body = any<ringwatch::Body>(); double h = 1e-4;\n"),
    ("docs/gpu.md", 1): (
        ["ringwatch/gpu/body/device_body.h", "ringwatch/gpu/imex/device_imex.h",
         "ringwatch/handlers/imex/implicit_cluster.h"],
        "  ringwatch::Body& body = any<ringwatch::Body>(); ringwatch::DeviceBody<double> device(body); double h = 1e-4;\n"
        "  std::vector<ringwatch::ElementRef> stiff;\n",
    ),
}


def snippets(source):
    """(document, number, line, text) of every ```cpp block."""
    for path in [source / "README.md", *sorted((source / "docs").rglob("*.md"))]:
        lines = path.read_text(encoding="utf-8").split("\n")
        number, begin = 0, None
        for i, line in enumerate(lines):
            if begin is None and re.match(r"```(cpp|c\+\+|cxx)\b", line):
                begin = i + 1
            elif begin is not None and line.startswith("```"):
                yield path.relative_to(source).as_posix(), number, begin + 1, lines[begin:i]
                number, begin = number + 1, None


def main():
    source, output = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    includes, bodies, unused, faults = ["cstdint", "vector"], [], set(CONTEXTS), []
    for document, number, line, text in snippets(source):
        if (document, number) not in CONTEXTS:
            faults.append(f"{document}:{line}: snippet {number} has no context in {pathlib.Path(__file__).name}")
            continue
        unused.discard((document, number))
        if isinstance(CONTEXTS[document, number], str):
            if (source / CONTEXTS[document, number]).read_text(encoding="utf-8") != "\n".join(text) + "\n":
                faults.append(f"{document}:{line}: snippet {number} is not {CONTEXTS[document, number]}")
            continue
        own, before, *outside = CONTEXTS[document, number]
        includes += own + [m[1] for m in (re.match(r"#include <(.*)>", t) for t in text) if m]
        code = "\n".join("" if t.startswith("#include") else t for t in text)
        code = f'#line {line} "{source / document}"\n{code}\n'
        name = re.sub(r"\W", "_", document) + f"_{number}"
        bodies.append(f"namespace {name} {{\n{''.join(outside)}{code}}}\n" if before is None else f"void {name}() {{\n{before}  do {{\n{code}  }} while (false);\n}}\n")
    faults += [f"{document}: there is no snippet {number} any more" for document, number in sorted(unused)]
    if faults:
        sys.exit("\n".join(faults))
    head = "".join(f"#include <{i}>\n" for i in dict.fromkeys(includes))
    pragma = "".join(f'#pragma GCC diagnostic ignored "-W{w}"\n' for w in ("unused-variable", "unused-but-set-variable", "missing-field-initializers"))
    text = f"{head}{pragma}namespace {{\ntemplate <class T>\nT& any() {{\n  throw 0;\n}}\n}}  // namespace\n" + "".join(bodies)
    output.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
