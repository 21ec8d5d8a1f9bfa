#include <ringwatch/app/scene/probe_quantity.h>

#include <ringwatch/body/element_stress.h>

namespace ringwatch {
namespace {

using Quantity = ProbeQuantity::Kind;
using As = ProbeReduction;

std::vector<ProbeQuantity> makeQuantities() {
  const std::vector<std::string> vector{"x", "y", "z"};
  const std::vector<As> average{As::mean, As::least, As::largest}, total{As::sum};
  std::vector<ProbeQuantity> all{
      {Quantity::displacement, "displacement", "m", vector, average, "of nodes, from where they are at rest"},
      {Quantity::velocity, "velocity", "m/s", vector, average, "of nodes"},
      {Quantity::momentum, "momentum", "kg m/s", vector, total, "of nodes, lumped mass times velocity"},
      {Quantity::angularMomentum, "angular_momentum", "kg m2/s", vector, total,
       "of nodes about the origin, position times lumped mass times velocity"},
      {Quantity::load, "load", "N", vector, total, "dead loads, pressures and tables of time at nodes, at that moment"},
      {Quantity::reaction, "reaction", "N", vector, total,
       "what [[fix]] and [[move]] put on nodes, at the components that they hold: internal and damping force less "
       "loads, and mass times the acceleration of a prescribed motion"},
      {Quantity::energy,
       "energy",
       "J",
       {"kinetic", "strain"},
       total,
       "of elements; kinetic with the mass that they give to their nodes"},
      {Quantity::step,
       "step",
       "s",
       {""},
       {As::least},
       "the least step of the elements by a metric; the column's name says whether it is safe, optimistic or an "
       "estimate for the whole body"},
  };
  for (const StressMeasure& measure : allStressMeasures()) {
    const std::string title(measure.title);
    const std::size_t unit = title.find(" (");
    all.push_back({Quantity::stress, std::string(measure.name),
                   unit == std::string::npos ? "" : title.substr(unit + 2, title.size() - unit - 3),
                   measure.components == 6   ? std::vector<std::string>{"xx", "yy", "zz", "xy", "yz", "xz"}
                   : measure.components == 3 ? std::vector<std::string>{"1", "2", "3"}
                                             : std::vector<std::string>{""},
                   average, "of elements: " + std::string(measure.help)});
  }
  const auto addRigid = [&](Quantity kind, const char* name, const char* unit, const char* help) {
    all.push_back({kind, name, unit, vector, {As::mean}, std::string("of a rigid body: ") + help});
  };
  addRigid(Quantity::centre, "centre", "m", "where its centre of mass is");
  addRigid(Quantity::rotation, "rotation", "rad", "from rest, its axis times its angle, at most pi");
  addRigid(Quantity::centreVelocity, "centre_velocity", "m/s", "of its centre of mass");
  addRigid(Quantity::angularVelocity, "angular_velocity", "rad/s", "in fixed axes");
  addRigid(Quantity::force, "force", "N",
           "of elements, springs, contact, damping and loads at its nodes, which accelerates it");
  addRigid(Quantity::torque, "torque", "N m", "of these forces about its centre of mass");
  addRigid(Quantity::supportForce, "support_force", "N",
           "what the [[fix]] or [[move]] that names it puts on it, at the components that it holds");
  addRigid(Quantity::supportTorque, "support_torque", "N m",
           "the same about the point that is held or moved, its centre of mass where none is named");
  return all;
}

}  // namespace

const std::vector<ProbeQuantity>& allProbeQuantities() {
  static const std::vector<ProbeQuantity> all = makeQuantities();
  return all;
}

}  // namespace ringwatch
