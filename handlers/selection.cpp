#include <ringwatch/handlers/selection.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <ringwatch/base/error.h>
#include <ringwatch/monitor/nodal_bound.h>
#include <ringwatch/monitor/reduced_ring.h>
#include <ringwatch/monitor/scaled_tangent.h>

namespace ringwatch {
namespace {

constexpr double slack = 1e-9;  // kept free for the rounding of sums and small eigenvalues

class Greedy {
 public:
  Greedy(const Body& body, const NodeVectors& x, double lambda, const ElementFlags& keep)
      : body_(body), x_(x), lambda_(lambda), keep_(keep.empty() ? noElements(body.mesh()) : keep), chosen_(keep_) {}

  CertifiedSelection run() {
    // The worst elements bend the shapes of their whole neighbourhood, so they leave first, and the shapes are swept
    // without them before the next ones are judged.
    for (const double hot : {16.0, 4.0, 1.0, 1.0}) {
      takeOut(hot * lambda_);
      if (hot == 1) bringBack();
    }
    CertifiedSelection result;
    result.chosen = std::move(chosen_);
    double rest = 0;
    for (std::int32_t i = 0; i < body_.nodeCount(); ++i) rest = std::max(rest, nodal(i).first);
    result.rest = {rest};
    result.nodalSums = std::move(sums_);
    return result;
  }

 private:
  /// lambda_max of a node's sum over its mass and the direction that has it.
  std::pair<double, Eigen::Vector3d> nodal(std::int32_t i) const {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(sums_[static_cast<std::size_t>(i)] /
                                                               body_.lumpedMass()[i]);
    return {eigen.eigenvalues()[2], eigen.eigenvectors().col(2)};
  }
  /// Hands over elements until no node of the rest is above `allowed`.
  void takeOut(double allowed) {
    const ElementFlags left = complement(chosen_);
    const Body rest(body_, left);
    NodalBound bound(rest);
    if (std::isnan(bound.evaluate(x_, sweeps).value))
      throw NumericalError("no elements can be selected: the tangent at these positions is not finite");
    const auto numbers = elementNumbers(left);
    sums_.assign(static_cast<std::size_t>(body_.nodeCount()), Eigen::Matrix3d::Zero());
    std::priority_queue<std::pair<double, std::int32_t>> queue;
    for (std::int32_t i = 0; i < body_.nodeCount(); ++i) {
      Eigen::Matrix3d& sum = sums_[static_cast<std::size_t>(i)];
      for (const auto at : bound.incidences(i)) sum += bound.value(bound.elementAt(at)) * bound.shape(at);
      sum = freePart(body_, i, sum);
      queue.push({nodal(i).first, i});
    }
    while (!queue.empty()) {
      const auto [value, i] = queue.top();
      queue.pop();
      const auto [now, direction] = nodal(i);
      if (now < value * (1 - slack)) {  // a neighbour has left since
        queue.push({now, i});
        continue;
      }
      if (now <= allowed * (1 - slack)) return;
      double most = -1;
      ElementRef worst;
      for (const auto at : bound.incidences(i)) {
        const ElementRef e = bound.elementAt(at);
        if (chosen_[static_cast<std::size_t>(e.block)][number(numbers, e)]) continue;
        const double share = bound.value(e) * direction.dot(freePart(body_, i, bound.shape(at)) * direction);
        if (share > most) {
          most = share;
          worst = e;
        }
      }
      if (most < 0) {  // nothing is left here but rounding
        sums_[static_cast<std::size_t>(i)].setZero();
        continue;
      }
      chosen_[static_cast<std::size_t>(worst.block)][number(numbers, worst)] = true;
      const auto nodes = rest.blocks()[static_cast<std::size_t>(worst.block)]->nodesOf(worst.element);
      for (const std::int32_t node : nodes) {
        // Summed anew: differences would keep the rounding of what has left.
        Eigen::Matrix3d& sum = sums_[static_cast<std::size_t>(node)];
        sum.setZero();
        for (const auto at : bound.incidences(node)) {
          const ElementRef e = bound.elementAt(at);
          if (!chosen_[static_cast<std::size_t>(e.block)][number(numbers, e)])
            sum += bound.value(e) * freePart(body_, node, bound.shape(at));
        }
      }
      queue.push({nodal(i).first, i});
    }
  }
  static std::size_t number(const std::vector<std::vector<std::int32_t>>& numbers, ElementRef e) {
    return static_cast<std::size_t>(numbers[static_cast<std::size_t>(e.block)][static_cast<std::size_t>(e.element)]);
  }

  /// Takes back, softest first, every element that the slack of its nodes holds.
  void bringBack() {
    std::vector<std::pair<double, ElementRef>> candidates;
    for (const ElementRef e : chosenElements(chosen_))
      if (!keep_[static_cast<std::size_t>(e.block)][static_cast<std::size_t>(e.element)])
        candidates.push_back({use(e), e});
    std::sort(candidates.begin(), candidates.end());
    for (const auto& [before, e] : candidates) {
      const double l = use(e);
      if (!(l <= 1 - slack)) continue;
      for (const std::int32_t node : body_.blocks()[static_cast<std::size_t>(e.block)]->nodesOf(e.element))
        sums_[static_cast<std::size_t>(node)] += l * slackOf(node);
      chosen_[static_cast<std::size_t>(e.block)][static_cast<std::size_t>(e.element)] = false;
    }
  }
  Eigen::Matrix3d slackOf(std::int32_t node) const {
    return freePart(body_, node,
                    lambda_ * (1 - slack) * body_.lumpedMass()[node] * Eigen::Matrix3d::Identity() -
                        sums_[static_cast<std::size_t>(node)]);
  }
  /// l_e with the slack of its nodes as shapes: the share of it that an element would use up; infinite without slack.
  double use(ElementRef e) const {
    Eigen::MatrixXd K = body_.elementTangent(e, x_);
    const auto nodes = body_.blocks()[static_cast<std::size_t>(e.block)]->nodesOf(e.element);
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      Eigen::Matrix3d T = slackOf(nodes[a]);
      const auto at = static_cast<Eigen::Index>(3 * a);
      for (int c = 0; c < 3; ++c)
        if (body_.constraints().isConstrained(nodes[a], c)) {
          K.row(at + c).setZero();
          K.col(at + c).setZero();
          T(c, c) = 1;
        }
      const Eigen::LLT<Eigen::Matrix3d> factor(T);
      if (factor.info() != Eigen::Success) return std::numeric_limits<double>::infinity();
      K.middleRows<3>(at) = factor.matrixL().solve(K.middleRows<3>(at).eval()).eval();
      K.middleCols<3>(at) = factor.matrixL().solve(K.middleCols<3>(at).transpose().eval()).transpose().eval();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(K, Eigen::EigenvaluesOnly);
    const double largest = eigen.eigenvalues().tail<1>()[0];
    return largest >= 0 ? largest : largest < 0 ? 0 : std::numeric_limits<double>::infinity();
  }

  static constexpr int sweeps = 8;
  const Body& body_;
  const NodeVectors& x_;
  double lambda_;
  ElementFlags keep_, chosen_;
  std::vector<Eigen::Matrix3d> sums_;
};

}  // namespace

ElementFlags noElements(const Mesh& mesh) {
  ElementFlags flags;
  for (const MeshBlock& block : mesh.blocks) flags.emplace_back(block.elementCount(), false);
  return flags;
}

std::vector<ElementRef> chosenElements(const ElementFlags& flags) {
  std::vector<ElementRef> elements;
  for (std::size_t b = 0; b < flags.size(); ++b)
    for (std::size_t e = 0; e < flags[b].size(); ++e)
      if (flags[b][e]) elements.push_back({static_cast<std::int32_t>(b), static_cast<std::int32_t>(e)});
  return elements;
}

ElementFlags complement(ElementFlags flags) {
  for (std::vector<bool>& block : flags) block.flip();
  return flags;
}

std::vector<std::vector<std::int32_t>> elementNumbers(const ElementFlags& flags) {
  std::vector<std::vector<std::int32_t>> numbers(flags.size());
  for (const ElementRef e : chosenElements(flags)) numbers[static_cast<std::size_t>(e.block)].push_back(e.element);
  return numbers;
}

Body bodyOf(const Body& body, const ElementFlags& flags, std::span<const std::int32_t> nodes,
            const Eigen::VectorXd& mass) {
  const Mesh& all = body.mesh();
  Mesh mesh;
  mesh.X.resize(3, static_cast<Eigen::Index>(nodes.size()));
  std::vector<std::int32_t> numberOf(all.nodeCount(), -1);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    mesh.X.col(static_cast<Eigen::Index>(i)) = all.X.col(nodes[i]);
    mesh.nodeIds.push_back(all.nodeIds[static_cast<std::size_t>(nodes[i])]);
    numberOf[static_cast<std::size_t>(nodes[i])] = static_cast<std::int32_t>(i);
  }
  for (std::size_t b = 0; b < all.blocks.size(); ++b) {
    const MeshBlock& from = all.blocks[b];
    MeshBlock block{from.type, {}, {}};
    for (std::size_t e = 0; e < from.elementCount(); ++e) {
      if (!flags[b][e]) continue;
      block.ids.push_back(from.ids[e]);
      for (int a = 0; a < from.nodesPerElement(); ++a)
        block.connectivity.push_back(numberOf[static_cast<std::size_t>(from.element(e)[a])]);
    }
    mesh.blocks.push_back(std::move(block));
  }
  std::vector<std::unique_ptr<ElementBlock>> blocks;
  for (std::size_t b = 0; b < all.blocks.size(); ++b) {
    const ElementBlock& face = *body.blocks()[b];
    blocks.push_back(makeElementBlock(mesh, mesh.blocks[b], face.material(), face.rule().name));
  }
  return Body(std::move(mesh), std::move(blocks), mass, body.threads());
}

ElementFlags selectByReducedRing(const Body& body, const NodeVectors& x, double lambda, const ElementFlags& lookAt) {
  if (!(lambda > 0)) throw InputError(joinText("selection: lambda = ", lambda, " rad2/s2 must be > 0"));
  ElementFlags flags = noElements(body.mesh());
  const auto judge = [&](const Body& part, const auto& numberOf) {
    ReducedRing rings(part);
    const auto& largest = rings.evaluate(x).largest;
    for (std::size_t b = 0; b < largest.size(); ++b)
      for (std::size_t e = 0; e < largest[b].size(); ++e) {
        const std::size_t whole = numberOf(b, e);
        flags[b][whole] = !(largest[b][e] <= lambda) && (lookAt.empty() || lookAt[b][whole]);
      }
  };
  if (lookAt.empty()) {
    judge(body, [](std::size_t, std::size_t e) { return e; });
    return flags;
  }
  // A ring is made of all elements at the nodes of its own: with these, a part of the body has the same rings.
  std::vector<bool> near(static_cast<std::size_t>(body.nodeCount()), false);
  const std::vector<MeshBlock>& blocks = body.mesh().blocks;
  const auto nodesOf = [&](std::size_t b, std::size_t e) {
    return std::span(blocks[b].element(e), static_cast<std::size_t>(blocks[b].nodesPerElement()));
  };
  for (std::size_t b = 0; b < blocks.size(); ++b)
    for (std::size_t e = 0; e < lookAt[b].size(); ++e)
      if (lookAt[b][e])
        for (const std::int32_t n : nodesOf(b, e)) near[static_cast<std::size_t>(n)] = true;
  ElementFlags around = noElements(body.mesh());
  for (std::size_t b = 0; b < blocks.size(); ++b)
    for (std::size_t e = 0; e < around[b].size(); ++e) {
      const auto nodes = nodesOf(b, e);
      around[b][e] =
          std::any_of(nodes.begin(), nodes.end(), [&](std::int32_t n) { return near[static_cast<std::size_t>(n)]; });
    }
  if (chosenElements(around).empty()) return flags;
  const auto numbers = elementNumbers(around);
  judge(Body(body, around), [&](std::size_t b, std::size_t e) { return static_cast<std::size_t>(numbers[b][e]); });
  return flags;
}

ElementFlags carriedOver(const CutMesh& cut, const ElementFlags& before) {
  ElementFlags after = cut.changed;
  for (std::size_t b = 0; b < after.size(); ++b)
    for (std::size_t e = 0; e < after[b].size(); ++e)
      after[b][e] = !cut.changed[b][e] && before[b][static_cast<std::size_t>(cut.parent[b][e])];
  return after;
}

ElementFlags selectBySingleElement(const Body& body, const NodeVectors& x, double lambda) {
  if (!(lambda > 0)) throw InputError(joinText("lambda ", lambda, ": must be > 0"));
  ElementFlags flags = noElements(body.mesh());
  for (std::size_t b = 0; b < flags.size(); ++b) {
    std::vector<double> mass(static_cast<std::size_t>(body.blocks()[b]->element().nodes));
    for (std::size_t e = 0; e < flags[b].size(); ++e) {
      const ElementRef ref{static_cast<std::int32_t>(b), static_cast<std::int32_t>(e)};
      Eigen::MatrixXd K = body.elementTangent(ref, x);
      body.elementLumpedMass(ref, mass.data());
      for (Eigen::Index i = 0; i < K.rows(); ++i) {
        const double root = std::sqrt(mass[static_cast<std::size_t>(i / 3)]);
        K.row(i) /= root;
        K.col(i) /= root;
      }
      const double highest =
          Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K, Eigen::EigenvaluesOnly).eigenvalues().tail<1>()[0];
      flags[b][e] = !(highest <= lambda * (1 - slack));
    }
  }
  return flags;
}

CertifiedSelection selectCertified(const Body& body, const NodeVectors& x, double lambda, const ElementFlags& keep) {
  if (!(lambda > 0)) throw InputError(joinText("selection: lambda = ", lambda, " rad2/s2 must be > 0"));
  return Greedy(body, x, lambda, keep).run();
}

}  // namespace ringwatch
