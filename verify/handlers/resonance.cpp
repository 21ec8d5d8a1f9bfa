#include <ringwatch/verify/handlers/resonance.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/error.h>
#include <ringwatch/handlers/local_time_stepping/local_time_stepping.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/verify/integrators/oscillator.h>
#include <ringwatch/verify/matrix_eigenvalues.h>
#include <ringwatch/verify/study_bodies.h>

namespace ringwatch {
namespace {

using detail::young, detail::poisson, detail::density, detail::verletLimit;

/// A bar of 24 tetrahedra, clamped at one end. Block 0 is soft; of two neighbours in its middle one is `stiff` times as
/// stiff, and the other one the square root of that where `graded` says so.
Body bar(double stiff, bool graded) {
  BarOptions options;
  options.size = {0.04, 0.01, 0.01};
  options.cells = {4, 1, 1};
  Mesh mesh = generateBar(options);
  const MeshBlock all = mesh.blocks[0];
  const std::size_t n = all.nodesPerElement();
  constexpr std::size_t first = 9, second = 10;
  std::vector<MeshBlock> blocks(graded ? 3 : 2, MeshBlock{all.type, {}, {}});
  for (std::size_t e = 0; e < all.elementCount(); ++e) {
    MeshBlock& to = blocks[e == first ? 1 : graded && e == second ? 2 : 0];
    to.connectivity.insert(to.connectivity.end(), all.element(e), all.element(e) + n);
    to.ids.push_back(all.id(e));
  }
  mesh.blocks = std::move(blocks);
  mesh.elementSets.clear();
  const std::vector<std::int32_t> clamped = mesh.nodeSets.at("x-min");
  std::vector<Material> materials{makeMaterial("linear", young, poisson, density),
                                  makeMaterial("linear", young * stiff, poisson, density)};
  if (graded) materials.push_back(makeMaterial("linear", young * std::sqrt(stiff), poisson, density));
  Body body(std::move(mesh), materials, {{}, Lumping::rowSum, 1});
  for (const std::int32_t node : clamped) body.constraints().fix(node);
  return body;
}

std::vector<Eigen::Index> freeComponents(const Body& body) {
  std::vector<Eigen::Index> free;
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    for (int c = 0; c < 3; ++c)
      if (!body.constraints().isConstrained(i, c)) free.push_back(3 * i + c);
  return free;
}

/// rad²/s², by a dense solver.
double highestDenseEigenvalue(const Body& body) {
  const std::vector<Eigen::Index> free = freeComponents(body);
  const Eigen::MatrixXd K(body.assembleTangent(body.mesh().X));
  Eigen::MatrixXd A(free.size(), free.size());
  for (std::size_t i = 0; i < free.size(); ++i)
    for (std::size_t j = 0; j < free.size(); ++j)
      A(i, j) = K(free[i], free[j]) / std::sqrt(body.lumpedMass()[free[i] / 3] * body.lumpedMass()[free[j] / 3]);
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A, Eigen::EigenvaluesOnly).eigenvalues().tail<1>()[0];
}

double spectralRadius(const Body& body, Integrator& integrator, double h) {
  const std::vector<Eigen::Index> free = freeComponents(body);
  const Eigen::Index n = free.size();
  Eigen::MatrixXd G(2 * n, 2 * n);
  BodySystem system(body);
  for (Eigen::Index k = 0; k < 2 * n; ++k) {
    // The law is linear: a unit is as good as any, and loses least to rounding.
    State state{0, body.mesh().X, NodeVectors::Zero(3, body.nodeCount())};
    (k < n ? state.x : state.v).data()[free[k % n]] += k < n ? 1 : 1 / h;
    if (const StepStatus status = integrator.step(system, state, h); !status.done)
      throw NumericalError(joinText("resonance: ", status.reason));
    for (Eigen::Index i = 0; i < n; ++i) {
      const Eigen::Index d = free[i];
      G(i, k) = state.x.data()[d] - body.mesh().X.data()[d];
      G(n + i, k) = state.v.data()[d] * h;
    }
  }
  return eigenvaluesOf(G).cwiseAbs().maxCoeff();
}

struct LevelVariant {
  const char* name;
  bool stabilised;
  double dissipation;
};

}  // namespace

void addResonance(StudyEffort effort, StudyReport& report) {
  const bool full = effort == StudyEffort::full;
  StudyTable table{"resonance",
                   "Local time stepping of linear bars: spectral radius of a step, the highest frequency scanned",
                   {"stiff elements", "variant", "step/verletLimit of the soft part", "highest h omega/pi", "states",
                    "largest spectral radius - 1", "at h omega/pi", "unstable states", "finest step"},
                   {}};
  StudyFigure figure{"handlers_resonance",
                     "One stiff element, step 0.85 of the soft part's verletLimit: growth per step",
                     "h omega / pi",
                     "spectral radius - 1, at least 1e-12",
                     false,
                     true,
                     {}};
  figure.lines = false;  // bands are narrow: a line would claim what lies between two samples
  // A spectral radius of 1 comes out with the rounding of its eigenvalues: the largest of 12 is 7e-15 off, of some 800
  // 5.5e-14.
  const double rounding = full ? 1.6e-13 : 2e-14;
  constexpr double unstableFrom = 1e-9, floor = 1e-12;
  const double spacing = full ? 0.05 : 1.7, farthest = full ? 40 : 20;  // in h omega / pi
  for (const bool graded : {false, true})
    for (const double share : {0.4, 0.85}) {
      if (!full && share < 0.5) continue;
      const double softest = std::sqrt(highestDenseEigenvalue(bar(1, graded))), h = share * verletLimit / softest;
      // omega² grows in proportion to the stiffness from where the stiff element rules.
      constexpr double large = 1e4;
      const double slope = highestDenseEigenvalue(bar(large, graded)) / large;
      for (const LevelVariant& variant :
           {LevelVariant{"plain", false, 0}, {"stabilised", true, 0}, {"default", true, 0.1}}) {
        double worst = -1, worstAt = 0, last = 0;
        std::int64_t states = 0, unstable = 0;
        int finest = 1;
        StudyFigure::Curve curve{variant.name, {}, {}};
        for (double x = 0.7; x <= farthest; x += spacing) {
          const double wanted = x * std::numbers::pi / h;
          Body body = bar(std::max(1.0, wanted * wanted / slope), graded);
          HandlerOptions options;
          options.own = {{"variant", variant.stabilised ? "stabilised" : "plain"},
                         {"energy_limit", 0},
                         {"dissipation", variant.dissipation}};
          const auto handler = makeHandler("local-time-stepping", body, makeIntegrator("symplectic-euler"), options);
          handler->prepare(body.mesh().X, h);
          if (handler->elements().empty()) continue;
          last = h * std::sqrt(highestDenseEigenvalue(body)) / std::numbers::pi;
          const double growth = spectralRadius(body, *handler, h) - 1;
          finest = std::max(finest, dynamic_cast<const LocalTimeStepping&>(*handler).levels().back().substeps);
          ++states;
          unstable += growth > unstableFrom;
          if (growth > worst) {
            worst = growth;
            worstAt = last;
          }
          curve.x.push_back(last);
          curve.y.push_back(std::max(floor, growth));
        }
        table.rows.push_back({std::string(graded ? "two, one more" : "one"), std::string(variant.name), share, last,
                              states, worst, worstAt, unstable, joinText("h/", finest)});
        const std::string what = joinText(graded ? "two stiff elements, " : "one stiff element, ", variant.name, ", ",
                                          share, " of the soft verletLimit: largest spectral radius");
        const double largest = states > 0 ? 1 + worst : std::nan("");
        if (variant.stabilised)
          checkAtMost(report, what, largest, 1, rounding);
        else if (full)
          checkAtLeast(report, what + ", which must show bands", largest, 1.001, 0);
        if (!graded && share > 0.5) figure.curves.push_back(std::move(curve));
      }
    }
  report.tables.push_back(std::move(table));
  report.figures.push_back(std::move(figure));
}

}  // namespace ringwatch
