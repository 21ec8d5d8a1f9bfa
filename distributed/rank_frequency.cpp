#include <ringwatch/distributed/rank_frequency.h>

#include <exception>

#include <ringwatch/distributed/rank_domain.h>

namespace ringwatch {
namespace {

/// Products with the tangent of the whole, which the first rank asks for.
class RankProducts {
 public:
  RankProducts(Ranks& ranks, const RankBody& part, NodeVectorsView x)
      : ranks_(ranks), part_(part), x_(ownOf(x)), v_(3, x.cols()) {}

  /// On the first rank.
  NodeVectors of(NodeVectorsView v) {
    tell(true);
    v_ = v;
    return computed();
  }
  void end() { tell(false); }
  /// On the others, until the first has ended.
  void serve() {
    while (told()) computed();
  }

 private:
  void tell(bool another) { ranks_.share(&another, sizeof another, 0); }
  bool told() {
    bool another = false;
    ranks_.share(&another, sizeof another, 0);
    return another;
  }
  NodeVectors computed() {
    ranks_.share(v_.data(), sizeof(double) * static_cast<std::size_t>(v_.size()), 0);
    part_.body().tangentProduct(x_, ownOf(v_), product_, workspace_);
    return gathered(ranks_, part_, product_);
  }
  NodeVectors ownOf(NodeVectorsView whole) const { return whole(Eigen::all, part_.globalNodes()); }

  Ranks& ranks_;
  const RankBody& part_;
  NodeVectors x_, v_, product_;
  Body::Workspace workspace_;
};

}  // namespace

GlobalFrequency globalFrequency(Ranks& ranks, const RankBody& part, const Body& whole, NodeVectorsView x) {
  RankProducts products(ranks, part, x);
  GlobalFrequency found;
  std::exception_ptr fault;
  if (ranks.rank() == 0) {
    try {
      found = globalFrequency(whole, x, GlobalFrequency::usualTolerance, GlobalFrequency::mostRestarts,
                              [&](NodeVectorsView v, NodeVectors& Kv) { Kv = products.of(v); });
    } catch (...) {  // memory for its vectors; the others wait for a word all the same
      fault = std::current_exception();
    }
    products.end();
  } else {
    products.serve();
  }
  struct Told {
    bool converged;
    int products;
    double lambda;
  } told{found.converged, found.products, found.lambda};
  ranks.share(&told, sizeof told, 0);
  if (fault) std::rethrow_exception(fault);
  found.converged = told.converged;
  found.products = told.products;
  found.lambda = told.lambda;
  return found;
}

}  // namespace ringwatch
