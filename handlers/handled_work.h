#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <ringwatch/body/body.h>

namespace ringwatch {

/// What the time integration of some elements takes from their energy. With a_n the acceleration of the step that leads
/// from v_(n-½) to v_(n+½), ã_n that by all other forces and x_(n+½) half way between x_n and x_(n+1), the elements
/// take
///   M (ã_n - a_n) · (x_(n+½) - x_(n-½))
/// from the kinetic energy, and what was dissipated is the sum of these - W at the last x_(n+½) + W at the first, W
/// their strain energy by their law. Exact for the two-step form of any scheme, whatever the forces were: Theorem 67,
/// docs/theory/handlers.md. Constrained components count with the elements' forces at the ends of steps, as
/// EnergyBalance has what supports do.
class HandledWork {
 public:
  /// h: the step, s. The body must outlive this.
  HandledWork(const Body& body, std::span<const ElementRef> elements, double h, int threads);

  /// The elements as a body of their own, and their nodes in the whole, ascending.
  const Body& part() const { return part_; }
  const std::vector<std::int32_t>& nodes() const { return nodes_; }

  /// A step from positions x (3×N of the whole, m) begins: a is the acceleration (m/s²) by all forces but the elements'
  /// own.
  void begin(NodeVectorsView x, const NodeVectors& a);
  /// The same, and adds the elements' own forces to a.
  void beginAndAdd(NodeVectorsView x, NodeVectors& a);
  /// The same where a has the elements' own forces already.
  void beginWithAll(NodeVectorsView x, const NodeVectors& a);
  /// The step takes the acceleration a from velocities v (m/s).
  void end(const NodeVectors& v, const NodeVectors& a);
  /// What has ended from here on can be taken back: by revert().
  void mark() { marked_ = true; }
  void revert();

  /// J.
  double dissipated() const;

 private:
  /// Calls visit(i, node) for all of nodes_, which must treat each alone.
  template <class Visit>
  void forEachNode(const Visit& visit) const;
  void take(NodeVectorsView x, const NodeVectors& a);
  void countSupports();
  double energyAt(const NodeVectors& x) const;

  std::vector<std::int32_t> nodes_;
  Body part_;
  double h_;
  Body::Workspace workspace_;
  // Of nodes_, 3×n.
  NodeVectors x_, others_, force_;
  NodeVectors lastX_ = NodeVectors(3, 0), lastForce_;  // of the step before, where supports move
  NodeVectors halfway_ = NodeVectors(3, 0);            // x_(n+½) of the last step
  double work_ = 0;                                    // against the elements, J
  double firstEnergy_ = 0;                             // W at the first half step, J
  bool marked_ = false;
  NodeVectors halfwayBefore_ = NodeVectors(3, 0);  // as they were at the mark
  double workBefore_ = 0;
};

}  // namespace ringwatch
