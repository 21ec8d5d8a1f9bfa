#pragma once
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <ringwatch/base/name_table.h>
#include <ringwatch/body/element_block.h>
#include <ringwatch/body/element_damping.h>
#include <ringwatch/body/tangent_source.h>

namespace ringwatch {

class Domain;
/// The domain of a process that has all of its body.
Domain& wholeDomain();

/// How an element's mass goes to its nodes.
enum class Lumping {
  rowSum,  ///< m_a = ρ ∫ N_a dV, row sums of the consistent mass; diagonal scaling for elements without positive ones
  equal,   ///< mass over node count, as Fierz 2013 has it
  diagonalScaling,  ///< diagonal of the consistent mass, scaled to the element's mass (Hinton, Rock & Zienkiewicz 1976)
};
inline constexpr auto lumpingNames = nameTable<Lumping>({
    {Lumping::rowSum, "row-sum", "row sums of the consistent mass, or diagonal-scaling where one is not positive"},
    {Lumping::equal, "equal", "the same at each node"},
    {Lumping::diagonalScaling, "diagonal-scaling", "diagonal of the consistent mass, scaled"},
});

/// Element name -> quadrature rule name; the default rule where absent.
using ElementRules = std::map<std::string, std::string, std::less<>>;

struct BodyOptions {
  ElementRules rules;
  Lumping lumping = Lumping::rowSum;
  int threads = 0;                              // 0: all that OpenMP offers
  HourglassControl hourglassControl = {};       // of rules of uniform strain
  std::vector<ElementRules> rulesOfBlock = {};  // instead of `rules`: empty, or one a block
};

/// Lumped mass that an element gives to its nodes, kg: mass[n].
void elementLumpedMass(const Mesh& mesh, const ElementBlock& block, Lumping lumping, std::int32_t element,
                       double* mass);
/// The lumped mass of each node, kg, and the volume at rest, m³, of elements.
struct LumpedMass {
  Eigen::VectorXd ofNode;
  double volume = 0;
};
/// Of all blocks of a mesh; each node's is summed by block and number of its elements. Throws NumericalError where one
/// is not positive or they do not add up to density × volume.
LumpedMass lumpedMass(const Mesh& mesh, const std::vector<std::unique_ptr<ElementBlock>>& blocks, Lumping lumping);

/// Values at some nodes that come from elsewhere while a pass over the elements runs: other processes own these nodes.
/// The pass goes over the patches without such nodes first. Sums at nodes keep their order, and so their bits.
class NodeArrival {
 public:
  /// Patches without such a node and those with one, each ascending, counted over all blocks.
  virtual std::span<const std::int64_t> patchesWithout() const = 0;
  virtual std::span<const std::int64_t> patchesWith() const = 0;
  /// Lets what is under way make progress; called now and then, by the thread that has called the pass.
  virtual void progress() = 0;
  /// Waits until the values are there.
  virtual void complete() = 0;

 protected:
  ~NodeArrival() = default;
};

/// What one pass over the elements of a body is asked for, and what it found. What is not asked for is not computed.
struct StepEvaluation {
  bool wantsForce = true;
  bool wantsEnergy = false;
  PatchVisitor* visitor = nullptr;  ///< sees the deformation gradients that it wants
  /// 3×N, m/s, or nullptr. Where elements damp and the force is wanted, their damping force at these is part of
  /// internalForce.
  const NodeVectors* velocities = nullptr;
  NodeArrival* arrival = nullptr;  ///< completes the positions while the pass runs
  NodeVectors internalForce;       ///< ∂(strain energy)/∂x, 3×N, N
  double strainEnergy = 0;         ///< J, of elements and discrete forces
  double wallTime = 0;             ///< s, of the pass
};

/// Mesh + material + density made computable: a source of tangents at any positions, and their forces and energies.
/// Knows no time. All passes are const and keep their scratch memory in a Workspace that the caller owns, so that
/// threads can share a body.
class Body : public TangentSource {
 public:
  struct Workspace : TangentSource::Workspace {
    std::vector<double> energies;  // of the patches, J
    NodeVectors damping;           // N
  };

  /// Throws InputError for an unknown rule, NumericalError for an element whose volume or nodal mass is not positive or
  /// when the lumped mass does not add up to density × volume.
  Body(Mesh mesh, const Material& material, const BodyOptions& options = {});
  Body(Mesh mesh, const std::vector<Material>& materialOfBlock, const BodyOptions& options = {});
  /// Makes a body of blocks made elsewhere, one for each of the mesh, with the lumped mass of each node, kg.
  Body(Mesh mesh, std::vector<std::unique_ptr<ElementBlock>> blocks, Eigen::VectorXd lumpedMass, int threads = 0);
  /// Some elements of another body, chosen[block][element], on all of its nodes and with its lumped mass, constraints
  /// and loads; they damp as they do there. Blocks keep their numbers and chosen elements their order; a block may end
  /// up empty. For bodies made of a mesh and materials. Throws InputError when `chosen` does not fit the mesh, and for
  /// bodies with discrete forces.
  Body(const Body& whole, const std::vector<std::vector<bool>>& chosen);

  const Mesh& mesh() const { return mesh_; }
  const std::vector<std::unique_ptr<ElementBlock>>& blocks() const { return blocks_; }
  /// What the body is a part of, if it is one (body/domain.h); by reference.
  Domain& domain() const { return *domain_; }
  void setDomain(Domain& domain) { domain_ = &domain; }
  double totalMass() const { return lumpedMass().sum(); }
  /// Volume at rest, m³.
  double volume() const { return volume_; }

  /// Ties nodes, ascending, to a rigid body of their lumped masses, from now on. Blocks all of whose elements lie
  /// within rigid bodies have neither forces nor stiffness then (RigidBlock). Before elements damp; throws InputError
  /// after, and as RigidBody and Constraints::tie do.
  void tie(std::string name, std::vector<std::int32_t> nodes, RigidGuide guide = {});

  /// Lets elements damp, by constants for each block; tangents are those of K + f C from now on, f of
  /// ElementDamping::setFactor, 0 at first. Once, before anything keeps a reference to the blocks. Throws InputError
  /// where the blocks are not as many, for constants that are negative or not finite, and for a body that damps
  /// already.
  void setElementDamping(const std::vector<DampingConstants>& ofBlocks);
  /// The same for a part of another body, whose factor and coefficients count: elements[block], numbered there.
  void setElementDamping(const Body& whole, const std::vector<std::vector<std::int32_t>>& elements);
  /// nullptr where no element damps.
  ElementDamping* elementDamping() { return damping_.get(); }
  const ElementDamping* elementDamping() const { return damping_.get(); }
  /// Adds the elements' damping forces at x and v (3×N, m and m/s) to f, 3×N, N: what resists the motion. In parallel,
  /// with the same bits for any number of threads.
  void addElementDampingForce(NodeVectorsView x, NodeVectorsView v, NodeVectors& f, Workspace& workspace) const;
  /// Lets the coefficients of damping that depends on velocities count what x and v need (DampedBlock::follow).
  void followDampingRates(NodeVectorsView x, NodeVectorsView v);

  /// Dead nodal forces, 3×N, N.
  NodeVectors& externalForce() { return externalForce_; }
  const NodeVectors& externalForce() const { return externalForce_; }
  /// Adds mass × acceleration to the nodal forces; acceleration in m/s².
  void addBodyForce(const Eigen::Vector3d& acceleration);

  /// Internal force, strain energy and deformation gradients at positions x (3×N, m), whatever of them is asked for, in
  /// one pass over the elements. In parallel, with the same bits for any number of threads. The equation of motion is
  /// m a = externalForce - internalForce.
  void evaluate(NodeVectorsView x, StepEvaluation& evaluation, Workspace& workspace) const;
  /// The internal force alone, 3×N, N. visit(begin, end) is called for ranges of nodes that are all of them, side by
  /// side, as soon as the force there is final: while it is in the thread's cache.
  void internalForce(NodeVectorsView x, NodeVectors& f, Workspace& workspace,
                     const NodeRangeVisitor& visit = nullptr) const;
  /// The same and the damping force of elements at v, 3×N, m/s, in one pass.
  void resistingForce(NodeVectorsView x, const NodeVectors& v, NodeVectors& f, Workspace& workspace,
                      const NodeRangeVisitor& visit = nullptr) const;
  /// The strain energy alone, J.
  double energy(NodeVectorsView x, Workspace& workspace) const;
  /// Lumped mass that an element gives to its nodes, kg: mass[n].
  void elementLumpedMass(ElementRef element, double* mass) const {
    ringwatch::elementLumpedMass(mesh_, *blocks_[element.block], options_.lumping, element.element, mass);
  }
  /// Least det F over all elements and quadrature points, with its element.
  struct LeastDeterminant {
    double value;
    ElementRef element;
  };
  enum class Among { allElements, whereInversionIsAnError };  ///< the second leaves out laws that allow it
  LeastDeterminant leastDeterminant(NodeVectorsView x, Among among = Among::allElements) const;

 private:
  std::vector<const ElementTangents*> tangentsOfBlocks() const;
  /// Blocks all of whose elements lie each within one rigid body become a RigidBlock.
  void wrapRigidBlocks();
  Eigen::VectorXd lumpMass();
  /// What a pass writes where it is not nullptr; velocities: of the damping that is part of the force.
  struct Wanted {
    NodeVectors* force = nullptr;
    double* energy = nullptr;
    const NodeVectors* velocities = nullptr;
    NodeArrival* arrival = nullptr;
  };
  /// Calls passPatch for all patches, in parallel.
  template <class PassPatch>
  void passAll(NodeArrival* arrival, const PassPatch& passPatch) const;
  void pass(NodeVectorsView x, PatchVisitor* visitor, Wanted wanted, Workspace& workspace,
            const NodeRangeVisitor& visit) const;
  Mesh mesh_;
  BodyOptions options_;
  std::vector<std::unique_ptr<ElementBlock>> blocks_;
  std::vector<Material> materials_;
  double volume_ = 0;
  NodeVectors externalForce_;
  std::unique_ptr<ElementDamping> damping_;
  Domain* domain_ = &wholeDomain();
};

}  // namespace ringwatch
