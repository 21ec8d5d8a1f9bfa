#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <ringwatch/body/obstacle.h>
#include <ringwatch/body/surface_contact.h>
#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// A linear spring with a dashpot, from a node to the ground or to another node.
///
/// To the ground: force -k (x - anchor) on the node, or -k n nᵀ(x - anchor) where a direction n is given. Between two
/// nodes: k (l - length) along their line, l its length now; with length 0, k times the line itself. The dashpot acts
/// along the same directions, on the velocity.
struct Spring {
  std::int32_t node = 0;
  std::int32_t other = -1;                           ///< -1: the ground
  Eigen::Vector3d anchor = Eigen::Vector3d::Zero();  ///< m; of a spring to the ground
  std::optional<Eigen::Vector3d> direction = {};     ///< a unit vector; of a spring to the ground
  double length = 0;                                 ///< at rest, m; between two nodes
  double stiffness = 0;                              ///< k, N/m
  double damping = 0;                                ///< c, N s/m
};

/// Nodes that an obstacle pushes away: with g < 0 the distance from its surface and n the outward normal, the force
/// -k g n; -c n nᵀ(v - v_o) by viscous damping, v_o the velocity of the obstacle; and by friction -μ k |g| u/max(|u|,
/// slip(|g|)), u the part of v - v_o along the surface (Coulomb's law, regularised).
struct PenaltyContact {
  std::size_t obstacle = 0;
  std::vector<std::int32_t> nodes;
  std::vector<double> penalty;  ///< k of each node, N/m
  std::vector<double> damping;  ///< c of each node, N s/m
  double friction = 0;          ///< μ
  SlipSpeed slip = {};          ///< below it the surfaces stick
};

/// Forces at nodes that are of no solid element: springs, dashpots and penalty contact, with rigid obstacles and of
/// surfaces with one another. Part of a TangentSource, whose forces, energies and tangents then hold them; one that has
/// none pays nothing for them. With contact of surfaces, one thread at a time may ask it.
///
/// K is the exact tangent of the elastic forces, C the symmetric damping matrix of dashpots and viscous contact. Bounds
/// take K + f C with the factor f of setDampingFactor (Theorem 47, docs/theory/discrete_forces.md). Friction is in
/// neither: while surfaces slide its tangent is not symmetric, and nothing is proven of it. From above, majorants()
/// counts its damping as if all nodes stuck.
class DiscreteForces {
 public:
  explicit DiscreteForces(std::int32_t nodeCount) : nodeCount_(nodeCount), shared_(std::make_shared<Shared>()) {}

  std::int32_t nodeCount() const { return nodeCount_; }
  /// Throws InputError for nodes that do not exist and constants that are negative or not finite.
  void add(const std::vector<Spring>& springs);
  /// An obstacle, and how to address it in a PenaltyContact.
  std::size_t add(std::unique_ptr<Obstacle> obstacle);
  void add(PenaltyContact contact);
  void add(SurfaceContact contact);
  /// Threads that look for contact of surfaces; 0: all.
  void setThreads(int threads) { threads_ = threads; }

  /// Moves an obstacle: its displacement since time zero, m, and its velocity, m/s.
  void place(std::size_t obstacle, const Eigen::Vector3d& displacement, const Eigen::Vector3d& velocity);
  /// Nodes as near to an obstacle or a surface as that, m, count in majorants() as if they touched it: what can touch
  /// before the next look.
  void setReach(double reach) {
    shared_->reach = reach;
    looked_ = nullptr;
  }
  /// f, 1/s, of K + f C.
  void setDampingFactor(double factor) { shared_->dampingFactor = factor; }
  double dampingFactor() const { return shared_->dampingFactor; }

  /// The forces of some nodes alone, which get the numbers of their places: principal submatrices of K and C. A spring
  /// whose other node is not among them is left out; partners() tells which nodes that would be. Obstacles and settings
  /// stay those of this object, wherever they are changed.
  /// Which surfaces touch is that of the whole at the positions where it was last asked, of which those of the part
  /// must be a part: locate() asks it. Else calls throw NumericalError.
  DiscreteForces restrictedTo(std::span<const std::int32_t> nodes) const;
  /// Looks which surfaces touch at x, 3×N; the others do so themselves.
  void locate(NodeVectorsView x) const;
  /// Keeps the contact of one state: while it lives, calls at the very array x search once for the nodes near
  /// obstacles. The numbers of x may not change meanwhile, and one thread alone makes and ends it. discrete: nullptr
  /// for none.
  class ContactAt {
   public:
    ContactAt(const DiscreteForces* discrete, NodeVectorsView x) : discrete_(discrete) {
      if (discrete_) discrete_->remember(x);
    }
    ~ContactAt() {
      if (discrete_) discrete_->looked_ = nullptr;
    }
    ContactAt(const ContactAt&) = delete;
    ContactAt& operator=(const ContactAt&) = delete;

   private:
    const DiscreteForces* discrete_;
  };
  /// The other ends of the springs at these nodes, which are ascending, as are the results.
  std::vector<std::int32_t> partners(std::span<const std::int32_t> nodes) const;

  /// Pairs i < j of nodes that a force couples at x, ascending.
  std::vector<std::array<std::int32_t, 2>> coupledNodes(NodeVectorsView x) const;

  /// The nodes at which a force can act, ascending.
  const std::vector<std::int32_t>& nodes() const { return nodes_; }
  /// The position of a node in nodes(), -1: none.
  std::int32_t placeOf(std::int32_t node) const { return place_.empty() ? -1 : place_[node]; }
  const std::vector<Spring>& springs() const { return springs_; }
  const std::vector<PenaltyContact>& contacts() const { return contacts_; }
  /// Contact of surfaces, and what is near.
  const std::vector<SurfaceSearch>& surfaces() const { return shared_->surfaces; }
  bool hasContact() const { return !contacts_.empty() || !shared_->surfaces.empty(); }
  /// Whether a force depends on velocities.
  bool damped() const { return damped_; }
  /// Whether there is friction, of which nothing is proven while surfaces slide.
  bool friction() const { return friction_; }

  /// Adds ∂(energy)/∂x to f, 3×N, N.
  void addInternalForce(NodeVectorsView x, NodeVectors& f) const;
  /// Elastic energy, J.
  double energy(NodeVectorsView x) const;
  /// Adds the forces that damping and friction resist with to f, 3×N, N: C (v - v_o), and those of friction.
  void addDampingForce(NodeVectorsView x, NodeVectorsView v, NodeVectors& f) const;
  /// Power of moving obstacles on the nodes, W: force on the nodes times velocity of the obstacle, of elastic and of
  /// damping forces.
  struct ObstaclePower {
    double elastic = 0, damping = 0;
  };
  ObstaclePower obstaclePower(NodeVectorsView x, NodeVectorsView v) const;

  /// Adds (K + f C) u to a vector, 3×N. f: of setDampingFactor unless given.
  void addTangentProduct(NodeVectorsView x, NodeVectorsView u, NodeVectors& Ku, std::optional<double> f = {}) const;
  /// vᵀ (K + f C) v.
  double form(NodeVectorsView x, NodeVectorsView v) const;
  /// vᵀ f C v alone, and what rounding of directions and sums can make of it at most.
  struct DampingForm {
    double value = 0, rounding = 0;
  };
  DampingForm dampingForm(NodeVectorsView x, NodeVectorsView v) const;
  /// Calls visit(i, j, block) for the 3×3 blocks of K + f C, both triangles, of the forces at least one of whose nodes
  /// is wanted(node); a block may come in several parts.
  template <class Visit, class Wanted>
  void forEachBlock(NodeVectorsView x, const Visit& visit, const Wanted& wanted) const;
  template <class Visit>
  void forEachBlock(NodeVectorsView x, const Visit& visit) const {
    forEachBlock(x, visit, [](std::int32_t) { return true; });
  }

  /// A symmetric positive semidefinite matrix for each of nodes(), N/m, with K + f C ≼ their block diagonal: at x, and
  /// for any set of the nodes within reach that touch. room: a little more of what changes as nodes move, so that they
  /// hold for longer. Theorem 45, docs/theory/discrete_forces.md.
  void majorants(NodeVectorsView x, bool room, std::vector<Eigen::Matrix3d>& matrices) const;
  /// The same into matrices that are zero but at `places`, which become those that are not zero now, in any order: most
  /// nodes of a surface are far from any other.
  void majorants(NodeVectorsView x, bool room, std::vector<Eigen::Matrix3d>& matrices,
                 std::vector<std::int32_t>& places) const;

  /// With room, and of nodes that are farther from obstacles than the reach by at most `further`, m, one for each of
  /// nodes(): what may come to touch.
  void majorantsToCome(NodeVectorsView x, std::span<const double> further,
                       std::vector<Eigen::Matrix3d>& matrices) const;

  /// The largest speed of a node of a contact against its obstacle, m/s, and at most that of nodes of surfaces against
  /// one another.
  double largestSpeed(NodeVectorsView v) const;

  /// What contact is like at x.
  struct ContactState {
    std::int64_t touching = 0;  ///< pairs of node and obstacle or surface, and of edges
    double deepest = 0;         ///< m
    std::int32_t deepestNode = -1;
    std::size_t deepestObstacle = 0;  ///< ofSurface: a surface
  };
  static constexpr std::size_t ofSurface = static_cast<std::size_t>(-1);
  ContactState contactState(NodeVectorsView x) const;

 private:
  struct MovingObstacle {
    std::unique_ptr<Obstacle> shape;
    Eigen::Vector3d displacement = Eigen::Vector3d::Zero(), velocity = Eigen::Vector3d::Zero();
  };
  struct Shared {
    std::vector<MovingObstacle> obstacles;
    std::vector<SurfaceSearch> surfaces;
    double reach = 0, dampingFactor = 0;
  };
  /// What touches at x, whose four nodes are numbered as this object's are, -1: not of this part.
  template <class Visit>
  void forEachTouch(NodeVectorsView x, const Visit& visit) const;
  void requireLocated(NodeVectorsView x) const;
  /// Calls add(node, part) for the parts of the majorants: matrices, or numbers that stand for multiples of 1. further:
  /// of majorantsToCome, or empty.
  template <class Add>
  void forMajorants(NodeVectorsView x, bool room, std::span<const double> further, const Add& add) const;
  void fillMajorants(NodeVectorsView x, bool room, std::span<const double> further,
                     std::vector<Eigen::Matrix3d>& matrices, std::vector<std::int32_t>& places) const;
  template <class Add>
  void forSurfaceMajorants(NodeVectorsView x, bool room, const Add& add) const;
  /// The number of a node of the whole, -1: none.
  std::int32_t numberOf(std::int32_t node) const { return isPart_ ? numberOf_[node] : node; }
  /// Stiffness and damping of a spring between two nodes: the matrix of [1 -1; -1 1] ⊗, exact or without its negative
  /// part.
  static Eigen::Matrix3d axial(const Spring& spring, NodeVectorsView x, double f, bool positivePart);
  static Eigen::Matrix3d toGround(const Spring& spring, double k);
  Obstacle::Surface surface(std::size_t obstacle, const Eigen::Vector3d& x) const;
  void remember(NodeVectorsView x) const;
  /// Calls visit(k) for the nodes of a contact that are no farther than `gap` from its obstacle, m, and for a few more.
  template <class Visit>
  void forEachNear(std::size_t contact, double gap, NodeVectorsView x, const Visit& visit) const;
  /// Calls visit(contact, k, node, surface) for all nodes that obstacles push away.
  template <class Visit>
  void forEachPushed(NodeVectorsView x, const Visit& visit) const;
  void note(const std::vector<std::int32_t>& nodes);

  std::int32_t nodeCount_;
  bool damped_ = false, friction_ = false;
  std::shared_ptr<Shared> shared_;
  std::vector<Spring> springs_;
  std::vector<PenaltyContact> contacts_;
  std::vector<std::int32_t> nodes_, place_;
  // Of a ContactAt: the array, nullptr for none, and by contact the nodes within the reach.
  mutable const double* looked_ = nullptr;
  mutable std::vector<std::vector<std::int32_t>> near_;
  int threads_ = 1;
  // Of a part: the numbers that nodes of the whole have in it, -1 for none, and by surface the nodes that it has, with
  // their positions in SurfaceSearch::nodes.
  bool isPart_ = false;
  std::vector<std::int32_t> numberOf_;
  std::vector<std::vector<std::array<std::int32_t, 2>>> surfaceNodes_;
};

template <class Visit>
void DiscreteForces::forEachTouch(NodeVectorsView x, const Visit& visit) const {
  if (shared_->surfaces.empty()) return;
  if (isPart_)
    requireLocated(x);
  else
    locate(x);
  for (const SurfaceSearch& surface : shared_->surfaces)
    for (const SurfaceSearch::Touch& touch : surface.touching()) {
      std::array<std::int32_t, 4> nodes = touch.nodes;
      if (isPart_) {
        for (std::int32_t& node : nodes) node = numberOf_[node];
        if (nodes == std::array<std::int32_t, 4>{-1, -1, -1, -1}) continue;
      }
      visit(surface.contact(), touch, nodes);
    }
}

template <class Visit>
void DiscreteForces::forEachNear(std::size_t contact, double gap, NodeVectorsView x, const Visit& visit) const {
  if (looked_ == x.data() && gap <= shared_->reach) {
    for (const std::int32_t k : near_[contact]) visit(static_cast<std::size_t>(k));
    return;
  }
  const PenaltyContact& own = contacts_[contact];
  const MovingObstacle& obstacle = shared_->obstacles[own.obstacle];
  constexpr std::size_t chunk = 512;
  std::int32_t near[chunk];
  for (std::size_t begin = 0; begin < own.nodes.size(); begin += chunk) {
    const std::span some = std::span(own.nodes).subspan(begin, std::min(chunk, own.nodes.size() - begin));
    const std::size_t count = obstacle.shape->within(gap, x, some, obstacle.displacement, near);
    for (std::size_t i = 0; i < count; ++i) visit(begin + static_cast<std::size_t>(near[i]));
  }
}

template <class Visit>
void DiscreteForces::forEachPushed(NodeVectorsView x, const Visit& visit) const {
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    const PenaltyContact& contact = contacts_[c];
    forEachNear(c, 0, x, [&](std::size_t k) {
      const Obstacle::Surface at = surface(contact.obstacle, x.col(contact.nodes[k]));
      if (at.gap < 0) visit(contact, k, contact.nodes[k], at);
    });
  }
}

template <class Visit, class Wanted>
void DiscreteForces::forEachBlock(NodeVectorsView x, const Visit& visit, const Wanted& wanted) const {
  const double f = dampingFactor();
  for (const Spring& spring : springs_) {
    if (!wanted(spring.node) && !(spring.other >= 0 && wanted(spring.other))) continue;
    if (spring.other < 0) {
      visit(spring.node, spring.node, toGround(spring, spring.stiffness + f * spring.damping));
      continue;
    }
    const Eigen::Matrix3d block = axial(spring, x, f, false), opposite = -block;
    visit(spring.node, spring.node, block);
    visit(spring.other, spring.other, block);
    visit(spring.node, spring.other, opposite);
    visit(spring.other, spring.node, opposite);
  }
  forEachPushed(x, [&](const PenaltyContact& contact, std::size_t k, std::int32_t node, const Obstacle::Surface& at) {
    if (!wanted(node)) return;
    const Eigen::Matrix3d block = (contact.penalty[k] + f * contact.damping[k]) * at.normal * at.normal.transpose() +
                                  contact.penalty[k] * at.gap * at.curvature;
    visit(node, node, block);
  });
  forEachTouch(x,
               [&](const SurfaceContact&, const SurfaceSearch::Touch& touch, const std::array<std::int32_t, 4>& nodes) {
                 bool any = false;
                 for (const std::int32_t node : nodes) any = any || (node >= 0 && wanted(node));
                 if (!any) return;
                 const double k = touch.penalty, fc = f * touch.damping;
                 for (int a = 0; a < 4; ++a)
                   for (int c = 0; c < 4; ++c)
                     if (nodes[a] >= 0 && nodes[c] >= 0) visit(nodes[a], nodes[c], touch.block(a, c, k, fc));
               });
}

}  // namespace ringwatch
