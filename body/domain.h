#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include <Eigen/Core>

#include <ringwatch/base/exact_sum.h>
#include <ringwatch/body/body.h>

namespace ringwatch {

/// How a process that has a part of a body talks with those that have the rest: each node belongs to one of them, and
/// the part's own nodes come first; behind them are its ghosts, nodes of others that its elements touch. This one is of
/// a process that has the whole body: there is nobody to talk with. Functions that are not const are collective.
class Domain {
 public:
  virtual ~Domain() = default;

  /// Whether the process has the whole body.
  virtual bool whole() const { return true; }
  /// Whether the process is the first one, which writes what there is once.
  virtual bool first() const { return true; }
  /// The number of own nodes among `nodes`, all that the part has.
  virtual Eigen::Index owned(Eigen::Index nodes) const { return nodes; }
  /// Whether this process counts an element of the part where each is to count once.
  virtual bool counts(ElementRef) const { return true; }
  /// The number in the whole of an element of the part, and of a node.
  virtual ElementRef inWhole(ElementRef e) const { return e; }
  virtual std::int32_t nodeInWhole(std::int32_t node) const { return node; }
  /// The element of the part that has that number in the whole; nothing where it is of other parts.
  virtual std::optional<ElementRef> here(ElementRef inWhole) const { return inWhole; }

  /// Replaces each number by the largest of all processes; NaN where one is. meanwhile: called, unless empty, while the
  /// others are waited for; work that is no collective.
  virtual void largest(std::span<double>, const std::function<void()>& meanwhile = {}) {
    if (meanwhile) meanwhile();
  }
  /// Replaces each sum by that of all processes.
  virtual void sum(std::span<ExactSum>) {}
  /// The first of the elements that processes have found, by block and number in the whole, and as named there; nothing
  /// where none has found one. found: of the part. text: that of the process whose element it is.
  virtual std::optional<ElementRef> firstFound(std::optional<ElementRef> found, std::string& /*text*/) { return found; }

  /// Gives all processes the bytes of the first that has them; where none has, they stay.
  virtual void share(void* /*data*/, std::size_t /*bytes*/, bool /*has*/) {}

  /// Gives ghosts the values of their owners: 3×N, and six numbers a node.
  virtual void exchange(NodeVectors&) {}
  virtual void exchange(Eigen::Matrix<double, 6, Eigen::Dynamic>&) {}
  /// Begins that of 3×N and comes back: the vectors stay where they are until finish().
  virtual void begin(NodeVectors&) {}
  virtual void finish() {}
  /// For StepEvaluation::arrival: a pass at positions whose exchange is under way finishes it behind the elements that
  /// need no ghost. nullptr where nothing is under way.
  virtual NodeArrival* arrival() { return nullptr; }
  /// x with the values of its owners at ghosts, until the next call.
  virtual const NodeVectors& withGhosts(const NodeVectors& x) { return x; }

  /// Vectors of all nodes of the whole, on the first process, of those of the part's; nothing on the others.
  virtual NodeVectors gathered(const NodeVectors& ofPart) { return ofPart; }
  /// Those of the part's nodes, of those of the whole.
  virtual NodeVectors taken(NodeVectors ofWhole) const { return ofWhole; }

  /// Does work that is no collective. Where it fails on one process it throws on all.
  virtual void together(const std::function<void()>& work) { work(); }
};

/// What the elements of all processes come to together.
struct SizeOfWhole {
  double volume;  // at rest, m³
  double elements;
};
/// Collective, as all of Domain.
SizeOfWhole sizeOfWhole(const Body& body);

/// Whether values, 3×N, are finite at the nodes of the part that are its own.
bool ownFinite(const Body& body, NodeVectorsView values);

/// a·b at a node, rounded alike wherever its column lies: a compiler may fuse an expression in some places only.
inline double dotAt(const NodeVectors& a, const NodeVectors& b, Eigen::Index node) {
  return std::fma(a(0, node), b(0, node), std::fma(a(1, node), b(1, node), a(2, node) * b(2, node)));
}

}  // namespace ringwatch
