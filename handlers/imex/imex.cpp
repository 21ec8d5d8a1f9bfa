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
    auto& clusters = owner_.clusters_;
    owner_.failed_.assign(clusters.size(), 0);
    parallelFor(0, clusters.size(), owner_.body_.threads(), [&](std::int64_t k) {
      ImplicitCluster& cluster = clusters[k];
      if (!cluster.follow(x))
        owner_.failed_[k] = 1;
      else if (!cluster.solve(a, v, c_))
        owner_.failed_[k] = 2;
    });
    const auto worst = std::max_element(owner_.failed_.begin(), owner_.failed_.end());
    if (*worst != 0 && fault.empty()) {
      const ImplicitCluster& cluster = clusters[worst - owner_.failed_.begin()];
      const ElementRef first = cluster.elements().front();
      fault = joinText(*worst == 1 ? "the implicit matrix is not positive definite or not finite"
                                   : "conjugate gradients did not converge",
                       " in the cluster of ", cluster.elements().size(), " elements at element ", first.block, ":",
                       first.element);
    }
  }
  int threads() const override { return owner_.body_.threads(); }
  bool velocityDependent() const override { return c_ != 0 || inner_.velocityDependent(); }

  std::string fault;

 private:
  Imex& owner_;
  SecondOrderSystem& inner_;
  double c_;
  NodeVectors& first_;
};

Imex::Imex(Body& body, std::unique_ptr<Integrator> base, HandlerOptions options)
    : Handler(description, body, std::move(base), std::move(options)),
      dissipation_(options_.own.number("dissipation")),
      cluster_(clusterOptionsOf(options_.own)) {}

void Imex::take(const NodeVectors& x, double h, const ElementFlags& chosen) {
  const double beta = newmarkBeta(dissipation_);
  clusters_.clear();
  for (auto& elements : clustersOf(body_, chosenElements(chosen)))
    clusters_.emplace_back(body_, std::move(elements), beta * h * h, x, cluster_);
  detach(chosen);
}

StepStatus Imex::handledStep(SecondOrderSystem& system, State& state, double h) {
  const double alpha = dissipation_, beta = newmarkBeta(alpha);
  // With u = a + c v, c = α/(beta h), the damping force needs no product of its own: (M + beta h² K̂) u = M (a₀ + c v).
  NodeVectors first(3, 0);
  if (handledBeginsWithAcceleration()) first.swap(state.a);
  Corrected corrected(*this, system, alpha / (beta * h), first);
  return baseStep(corrected, state, h, corrected.fault);
}

std::vector<HandlerFigure> Imex::figures() const {
  std::size_t largest = 0;
  std::int64_t factorisations = 0, iterations = 0;
  for (const ImplicitCluster& cluster : clusters_) {
    largest = std::max(largest, cluster.nodes().size());
    factorisations += cluster.factorisations();
    iterations += cluster.iterations();
  }
  return {{"clusters", static_cast<double>(clusters_.size())},
          {"largest_cluster_nodes", static_cast<double>(largest)},
          {"factorisations", static_cast<double>(factorisations), true},
          {"iterations", static_cast<double>(iterations), true}};
}

}  // namespace ringwatch
