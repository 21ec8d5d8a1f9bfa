#include <ringwatch/extensions/modal_filter/modal_filter.h>

#include <algorithm>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/error.h>
#include <ringwatch/monitor/bounds/scaled_tangent.h>

namespace ringwatch {

ModalFilter::ModalFilter(Body& body, std::unique_ptr<Integrator> base, HandlerOptions options)
    : RelaxingHandler(description, body, std::move(base), std::move(options), variants[0]),
      projects_(options_.own.text("variant") == variants[1]),
      passes_(std::max(1, options_.own.integer("passes"))) {}

void ModalFilter::takeRelaxed(double h, const ElementFlags& chosen) {
  const auto elements = chosenElements(chosen);
  const double lambda = allowedLambda(h);
  Eigen::VectorXd share = Eigen::VectorXd::Zero(body_.nodeCount());  // certified: of each handled element, N/m
  if (certificate()) {
    for (const ElementRef e : elements)
      for (const std::int32_t n : nodesOf(e)) ++share[n];
    for (std::int32_t i = 0; i < body_.nodeCount(); ++i) {
      if (share[i] == 0) continue;
      const Eigen::Matrix3d rest = freePart(body_, i, certificate()->nodalSums[i]);
      const double used = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(rest, Eigen::EigenvaluesOnly).eigenvalues()[2];
      const double whole = lambda * body_.lumpedMass()[i];
      share[i] = std::max(whole - used, 1e-9 * whole) / share[i];  // no allowance may vanish
    }
  }
  std::vector<Eigen::Vector4d> allowances;
  for (const ElementRef e : elements) {
    const auto nodes = nodesOf(e);
    Eigen::Vector4d& allowance = allowances.emplace_back();
    body_.elementLumpedMass(e, allowance.data());
    allowance *= lambda;
    if (certificate())
      for (int a = 0; a < 4; ++a) allowance[a] = share[nodes[a]];
  }
  tetrahedra_ = std::make_unique<FilteredTetrahedra>(body_, elements, allowances, h);
  if (projects_)
    projection_.emplace(body_, shapeConstraints(body_.mesh(), elements),
                        options_.own.automatic("tolerance") ? 1e-8 : options_.own.number("tolerance"),
                        options_.own.integer("iterations"));
}

std::string ModalFilter::relax(const NodeVectors& x, const NodeVectors& v, double h, NodeVectors& a) {
  if (!tetrahedra_->act(x, v, a, projects_ ? 0 : passes_))
    return "the handled elements' nodes are not at finite positions";
  if (!projection_) return {};
  predicted_ = x + h * (v + h * a);
  projected_ = predicted_;
  if (std::string reason = projection_->project(projected_); !reason.empty()) return reason;
  a += (projected_ - predicted_) / (h * h);
  return a.allFinite() ? "" : "the projected positions are not finite";
}

std::vector<HandlerFigure> ModalFilter::figuresOfPasses() const {
  if (!tetrahedra_) return {};
  std::vector<HandlerFigure> result{{"filtered_modes", static_cast<double>(tetrahedra_->modes())}};
  if (projection_) {
    result.push_back({"constraints", static_cast<double>(projection_->constraints().size())});
    result.push_back({"iterations", static_cast<double>(projection_->iterations())});
  } else {
    result.push_back({"passes", static_cast<double>(passes_)});
  }
  return result;
}

}  // namespace ringwatch
