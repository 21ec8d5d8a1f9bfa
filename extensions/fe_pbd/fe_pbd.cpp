#include <ringwatch/extensions/fe_pbd/fe_pbd.h>

#include <algorithm>

namespace ringwatch {

FePbd::FePbd(Body& body, std::unique_ptr<Integrator> base, HandlerOptions options)
    : RelaxingHandler(description, body, std::move(base), std::move(options), variants[0]),
      goal_(options_.own.text("variant") == variants[0] ? GoalShape::linear : GoalShape::rigid),
      passes_(std::max(1, options_.own.integer("passes"))) {}

void FePbd::takeRelaxed(double h, const ElementFlags& chosen) {
  const auto elements = chosenElements(chosen);
  relaxed_ = std::make_unique<RelaxedTetrahedra>(body_, elements, h, goal_, passes_);
}

std::string FePbd::relax(const NodeVectors& x, const NodeVectors& v, double, NodeVectors& a) {
  return relaxed_->relax(x, v, a) ? "" : "the handled elements' nodes are not at finite positions";
}

std::vector<HandlerFigure> FePbd::figuresOfPasses() const {
  if (!relaxed_) return {};
  const auto [least, most] = std::minmax_element(relaxed_->alpha().begin(), relaxed_->alpha().end());
  return {{"handled_nodes", static_cast<double>(relaxed_->nodeCount())},
          {"largest_overlap", static_cast<double>(relaxed_->largestOverlap())},
          {"passes", static_cast<double>(relaxed_->passes())},
          {"least_alpha", *least},
          {"largest_alpha", *most}};
}

}  // namespace ringwatch
