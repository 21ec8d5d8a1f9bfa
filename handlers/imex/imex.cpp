#include <ringwatch/handlers/imex/imex.h>

#include <algorithm>

#include <ringwatch/base/error.h>
#include <ringwatch/base/parallel.h>

namespace ringwatch {
namespace {

/// β of the scheme of a dissipation alpha. Theorem 34, docs/theory/handlers.md.
double newmarkBeta(double alpha) { return 0.25 * (1 + alpha) * (1 + alpha); }

}  // namespace

std::string imexForGpu(Options& own) {
  const OptionValue* solver = own.find("solver");
  if (solver && *solver == OptionValue(clusterSolverNames.nameOf(ClusterSolver::cholesky)))
    return "a GPU solves implicit clusters by conjugate gradients, not by \"cholesky\"";
  if (solver && *solver == OptionValue(Imex::newton))
    return "a GPU solves implicit clusters by conjugate gradients, not by \"newton\"";
  if (!own.find("tolerance") || own.automatic("tolerance")) own.set("tolerance", 1e-8);
  return {};
}

class Imex::Corrected final : public SecondOrderSystem {
 public:
  /// first: the acceleration by the inner system that is asked for first; empty when it is not known.
  Corrected(Imex& owner, SecondOrderSystem& inner, double c, NodeVectors& first)
      : owner_(owner), inner_(inner), c_(c), first_(first) {}
  void acceleration(double time, const NodeVectors& x, const NodeVectors& v, NodeVectors& a) override {
    if (first_.cols() > 0) {
      a.swap(first_);
      first_.resize(3, 0);
    } else {
      inner_.acceleration(time, x, v, a);
    }
    if (owner_.nonlinear_)
      forEachCluster(owner_.newtonClusters_, [&](NewtonCluster& cluster) -> std::string_view {
        switch (cluster.solve(x, a, v, c_)) {
          case NewtonCluster::Outcome::solved:
            return {};
          case NewtonCluster::Outcome::noEnergy:
            return "the implicit elements have no finite energy";
          case NewtonCluster::Outcome::notConverged:
            break;
        }
        return "Newton's method did not converge";
      });
    else
      forEachCluster(owner_.clusters_, [&](ImplicitCluster& cluster) -> std::string_view {
        if (!cluster.follow(x)) return "the implicit matrix is not positive definite or not finite";
        return cluster.solve(a, v, c_) ? "" : "conjugate gradients did not converge";
      });
  }
  int threads() const override { return owner_.body_.threads(); }
  bool velocityDependent() const override { return c_ != 0 || inner_.velocityDependent(); }

  std::string fault;

 private:
  /// Has all clusters solved, side by side; solve tells what went wrong, "" for nothing.
  template <class Cluster, class Solve>
  void forEachCluster(std::vector<Cluster>& clusters, const Solve& solve) {
    auto& failed = owner_.failed_;
    failed.assign(clusters.size(), {});
    parallelFor(0, clusters.size(), owner_.body_.threads(), [&](std::int64_t k) { failed[k] = solve(clusters[k]); });
    for (std::size_t k = 0; k < clusters.size() && fault.empty(); ++k)
      if (!failed[k].empty()) {
        const ElementRef first = clusters[k].elements().front();
        fault = joinText(failed[k], " in the cluster of ", clusters[k].elements().size(), " elements at element ",
                         first.block, ":", first.element);
      }
  }

  Imex& owner_;
  SecondOrderSystem& inner_;
  double c_;
  NodeVectors& first_;
};

Imex::Imex(Body& body, std::unique_ptr<Integrator> base, HandlerOptions options)
    : Handler(description, body, std::move(base), std::move(options)),
      dissipation_(options_.own.number("dissipation")),
      nonlinear_(options_.own.text("solver") == newton),
      cluster_(clusterOptionsOf(nonlinear_ ? Options(options_.own).set("solver", "auto") : options_.own)) {
  if (nonlinear_ && options_.damping.any())
    throw InputError("imex: the solver \"newton\" works without damping; take another");
}

void Imex::take(const NodeVectors& x, double h, const ElementFlags& chosen) {
  const double beta = newmarkBeta(dissipation_);
  dissipatedBefore_ = dissipated();
  clusters_.clear();
  newtonClusters_.clear();
  for (auto& elements : clustersOf(body_, chosenElements(chosen)))
    if (nonlinear_)
      newtonClusters_.emplace_back(body_, std::move(elements), h, beta * h * h, cluster_.tolerance,
                                   cluster_.iterations);
    else
      clusters_.emplace_back(body_, std::move(elements), weightOfTangent(h), x, cluster_);
  detach(chosen);
}

StepStatus Imex::handledStep(SecondOrderSystem& system, State& state, double h) {
  // With u = a + c v, c = α h/w, the damping force needs no product of its own: (M + w K̂) u = M (a₀ + c v).
  NodeVectors first(3, 0);
  if (handledBeginsWithAcceleration()) first.swap(state.a);
  Corrected corrected(*this, system, dissipation_ * h / weightOfTangent(h), first);
  return baseStep(corrected, state, h, corrected.fault);
}

double Imex::weightOfTangent(double h) const {
  return newmarkBeta(dissipation_) * h * h + 0.5 * h * options_.damping.beta;
}

double Imex::dissipated() const {
  double sum = dissipatedBefore_;
  for (const NewtonCluster& cluster : newtonClusters_) sum += cluster.dissipated();
  return sum;
}

std::vector<HandlerFigure> Imex::figures() const {
  const auto largestOf = [](const auto& clusters) {
    std::size_t largest = 0;
    for (const auto& cluster : clusters) largest = std::max(largest, cluster.nodes().size());
    return static_cast<double>(largest);
  };
  std::int64_t rounds = 0, iterations = 0;
  for (const ImplicitCluster& cluster : clusters_) {
    rounds += cluster.factorisations();
    iterations += cluster.iterations();
  }
  for (const NewtonCluster& cluster : newtonClusters_) {
    rounds += cluster.iterations();
    iterations += cluster.products();
  }
  return {{"clusters", static_cast<double>(clusters_.size() + newtonClusters_.size())},
          {"largest_cluster_nodes", std::max(largestOf(clusters_), largestOf(newtonClusters_))},
          {nonlinear_ ? "newton_iterations" : "factorisations", static_cast<double>(rounds), true},
          {"iterations", static_cast<double>(iterations), true}};
}

}  // namespace ringwatch
