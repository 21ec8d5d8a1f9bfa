#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <ringwatch/base/name_table.h>

namespace ringwatch {

/// How one number is made of those of several nodes or elements.
enum class ProbeReduction { mean, sum, least, largest };
inline constexpr auto probeReductionNames = nameTable<ProbeReduction>({
    {ProbeReduction::mean, "mean", "of nodes their mean, of elements the mean by their volumes at rest"},
    {ProbeReduction::sum, "sum", "the sum"},
    {ProbeReduction::least, "min", "the least, of each component by itself"},
    {ProbeReduction::largest, "max", "the largest, of each component by itself"},
});

/// What a [[probe]] can tell of nodes, elements or a rigid body.
struct ProbeQuantity {
  enum class Kind {
    displacement,
    velocity,
    momentum,
    angularMomentum,
    load,
    reaction,
    energy,
    step,
    stress,
    centre,
    rotation,
    centreVelocity,
    angularVelocity,
    force,
    torque,
    supportForce,
    supportTorque
  };

  Kind kind;
  std::string name;                // in scenes; of a stress that of its StressMeasure
  std::string unit;                // "" for none
  std::vector<std::string> parts;  // of the names of its columns; one "" for a single number of this name
  std::vector<ProbeReduction> as;  // what it takes, the first where none is asked for
  std::string help;

  bool ofNodes() const { return kind < Kind::energy; }
  bool ofRigidBodies() const { return kind >= Kind::centre; }
  /// Whether it takes the internal force of the state.
  bool needsForce() const { return kind == Kind::reaction || kind >= Kind::force; }
  /// Whether it is of what holds or moves a rigid body.
  bool ofSupports() const { return kind >= Kind::supportForce; }
};
/// Every quantity: those of nodes, energies and steps of elements, all stress measures, and those of rigid bodies.
const std::vector<ProbeQuantity>& allProbeQuantities();

}  // namespace ringwatch
