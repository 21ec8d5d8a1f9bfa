#include "handled_program.h"

#include <cmath>
#include <sstream>

#include <ringwatch/meshes/mesh_io.h>

#include <tests/handlers/handler_cases.h>

namespace ringwatch::test {

void HandledProgram::SetUp() {
  writeMesh(sliverBar(0.98), folder_.path() / "slivers.msh");
  const Body body = sliverBody("stvk", 0.98);
  critical_ = 2 / std::sqrt(denseHighest(body, body.mesh().X));
  step_ = 0.1 / std::ceil(0.1 / (3 * critical_));  // halves and quarters of the end are hit exactly
  for (int parts = 4; std::abs(std::remainder(0.1 / step_, parts)) > 1e-6;) step_ = 0.1 / (std::round(0.1 / step_) + 1);
  write("");
}

void HandledProgram::write(const std::string& handler, const std::string& rest, const std::string& monitor) {
  folder_.write("slivers.toml",
                "[mesh]\nfile = \"slivers.msh\"\n[material]\nmodel = \"stvk\"\nyoung = 30e3\npoisson = 0.3\n"
                "density = 1000\n[integrator]\nmethod = \"verlet\"\nstep = " +
                    number(step_) + "\nend = 0.1\n[[fix]]\nwhere = \"x < 1e-6\"\n" +
                    (rest.empty() ? "[[force]]\nwhere = \"all\"\nacceleration = [0, 0, -1]\n" : rest) + "[monitor]\n" +
                    monitor + "\n" + handler);
}

std::string HandledProgram::number(double value) {
  std::ostringstream text;
  text.precision(17);
  text << value;
  return text.str();
}

}  // namespace ringwatch::test
