// What an outside project adds to ringwatch.
#pragma once
#include <array>
#include <cmath>

#include <ringwatch/base/host_device.h>
#include <ringwatch/elements/cell_subdivision.h>
#include <ringwatch/elements/quadrature.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/integrators/integrator.h>
#include <ringwatch/monitor/metrics/metrics.h>

namespace outside {

class Euler final : public ringwatch::Integrator {
 public:
  static constexpr ringwatch::IntegratorInfo description{.name = "own-euler",
                                                         .help = "symplectic Euler again",
                                                         .order = 1,
                                                         .forceEvaluations = 1,
                                                         .imaginaryLimit = 2,
                                                         .symplectic = true};
  const ringwatch::IntegratorInfo& info() const override { return description; }
  ringwatch::StepStatus step(ringwatch::SecondOrderSystem& system, ringwatch::State& state, double h) override {
    system.acceleration(state.time, state.x, state.v, a_);
    state.v += h * a_;
    state.x += h * state.v;
    state.time += h;
    return {};
  }

 private:
  ringwatch::NodeVectors a_;
};

/// The trilinear hexahedron in the node order of VTK's voxel: corner i + 2j + 4k.
struct Voxel8 {
  static constexpr std::string_view name = "voxel8";
  static constexpr int nodes = 8;
  static constexpr int order = 1;
  static constexpr int vtkCellType = 11;
  static constexpr int gmshType = 0;
  static constexpr bool constantGradient = false;
  static constexpr bool positiveRowSums = true;
  static constexpr double referenceVolume = 8;
  static constexpr std::array<std::array<double, 3>, nodes> referenceNodes{
      {{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 1}}};
  static constexpr std::array<std::array<int, 4>, 6> faces{
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}}};
  static constexpr std::array<std::array<int, 2>, 12> edges{
      {{0, 1}, {1, 3}, {3, 2}, {2, 0}, {4, 5}, {5, 7}, {7, 6}, {6, 4}, {0, 4}, {1, 5}, {3, 7}, {2, 6}}};
  static constexpr std::array<std::uint8_t, 8> corners{0, 1, 2, 3, 4, 5, 6, 7};
  static constexpr std::array<ringwatch::CellSubdivision, 1> cellSplits{{{name, 1, false, corners, corners}}};

  template <class S>
  RINGWATCH_HOST_DEVICE static constexpr void shape(const S xi[3], S N[nodes]) {
    for (int a = 0; a < nodes; ++a) {
      N[a] = S(0.125);
      for (int j = 0; j < 3; ++j) N[a] = N[a] * (S(1) + S(referenceNodes[a][j]) * xi[j]);
    }
  }
  template <class S>
  RINGWATCH_HOST_DEVICE static constexpr void shapeGradient(const S xi[3], S dN[nodes][3]) {
    for (int a = 0; a < nodes; ++a)
      for (int j = 0; j < 3; ++j) {
        dN[a][j] = S(0.125 * referenceNodes[a][j]);
        for (int k = 0; k < 3; ++k)
          if (k != j) dN[a][j] = dN[a][j] * (S(1) + S(referenceNodes[a][k]) * xi[k]);
      }
  }
  static constexpr auto points = ringwatch::gaussCube(ringwatch::gauss::x2, ringwatch::gauss::w2);
  static constexpr std::array<ringwatch::QuadratureRule, 1> rules{{{"gauss-2x2x2", "eight points", points}}};
  static constexpr ringwatch::QuadratureRule massRule = rules[0];
};

/// A wave that crosses the shortest edge from an element's first node.
inline ringwatch::MetricValues byEdge(const ringwatch::Body& body, ringwatch::NodeVectorsView x,
                                      const ringwatch::MetricProgress&) {
  ringwatch::MetricValues values;
  for (const auto& block : body.blocks()) {
    auto& own = values.emplace_back();
    for (std::int32_t e = 0; e < block->elementCount(); ++e) {
      const auto nodes = block->nodesOf(e);
      double shortest = INFINITY;
      for (std::size_t a = 1; a < nodes.size(); ++a)
        shortest = std::min(shortest, (x.col(nodes[a]) - x.col(nodes[0])).norm());
      own.push_back(std::pow(2 * block->material().waveSpeed() / shortest, 2));
    }
  }
  return values;
}
inline constexpr ringwatch::MetricEntry shortestEdge{
    {"shortest-edge", "a pressure wave along the shortest edge", ringwatch::Direction::estimate}, byEdge};

/// Where elements are handled, the whole body takes smaller steps.
class Substeps final : public ringwatch::Handler {
 public:
  static constexpr std::array table{ringwatch::OptionInfo{.name = "substeps",
                                                          .type = ringwatch::OptionType::integer,
                                                          .range = {1, 100, true, true},
                                                          .fallback = "4",
                                                          .help = "that make a step"}};
  static constexpr ringwatch::HandlerInfo description{
      .name = "substeps", .help = "smaller steps of the whole body", .options = table};
  Substeps(ringwatch::Body& body, std::unique_ptr<ringwatch::Integrator> base, ringwatch::HandlerOptions options)
      : Handler(description, body, std::move(base), std::move(options)), count_(options_.own.integer("substeps")) {}

 protected:
  void take(const ringwatch::NodeVectors&, double, const ringwatch::ElementFlags&) override {}
  ringwatch::StepStatus handledStep(ringwatch::SecondOrderSystem& system, ringwatch::State& state, double h) override {
    ringwatch::StepStatus status;
    for (int i = 0; i < count_ && status.done; ++i) status = base_->step(system, state, h / count_);
    return status;
  }

 private:
  int count_;
};

}  // namespace outside
