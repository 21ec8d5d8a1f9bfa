#include <ringwatch/app/scene/body_notes.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <Eigen/Eigenvalues>

#include <ringwatch/base/infinity.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/body/element_damping.h>

namespace ringwatch {
namespace {

using Json = nlohmann::ordered_json;

constexpr int rigidModes = 6;

/// Eigenvalues of an element's tangent at rest that are rounding, beyond those of rigid motions.
int modesWithoutStiffness(const Body& body, ElementRef element) {
  const Eigen::MatrixXd K = body.elementTangent(element, body.mesh().X);
  const Eigen::VectorXd lambda =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K, Eigen::EigenvaluesOnly).eigenvalues();
  // Rounding leaves some 1e-15 of the largest, a needle 10⁴ times as long as thick has 1e-8.
  constexpr double rounding = 1e-12;
  const double largest = lambda.cwiseAbs().maxCoeff();
  if (!(largest > 0)) return 0;  // within a rigid body
  return std::max(0, static_cast<int>((lambda.cwiseAbs().array() < rounding * largest).count()) - rigidModes);
}

/// Whether viscous hourglass control damps the modes that have no stiffness.
bool resistsByViscosity(const Body& body, std::size_t block) {
  const ElementDamping* damping = body.elementDamping();
  return damping && damping->blocks()[block] && damping->blocks()[block]->constants().hourglassViscosity > 0;
}

void addModes(const Body& body, std::vector<std::string>& notes) {
  std::set<std::pair<std::string_view, std::string_view>> seen;
  for (std::size_t b = 0; b < body.blocks().size(); ++b) {
    if (body.mesh().blocks[b].elementCount() == 0) continue;
    const ElementBlock& block = *body.blocks()[b];
    if (resistsByViscosity(body, b) || !seen.emplace(block.element().name, block.rule().name).second) continue;
    const int modes = modesWithoutStiffness(body, {static_cast<std::int32_t>(b), 0});
    if (modes == 0) continue;
    notes.push_back(fmt::format(
        "{} with the rule {}: an element alone has {} mode{} without stiffness beside its rigid motions, and nothing "
        "resists {}; choose another rule{}",
        block.element().name, block.rule().name, modes, modes == 1 ? "" : "s", modes == 1 ? "it" : "them",
        block.rule().uniformStrain ? ", or hourglass_stiffness > 0" : ""));
  }
}

/// Speeds of pressure waves, m/s, that solids have: rubber is not below, diamond, which no structure is of, above.
constexpr double slowestOfSolids = 10, fastestOfSolids = 12'000;
/// Gels and foams are slower, and lighter than this, kg/m³; metals and stone are denser, and faster than lead, m/s.
constexpr double densestOfSlow = 2000, slowestOfDense = 1000;
/// The densest metals, kg/m³.
constexpr double densest = 25'000;
/// What is larger, m, is rarely meshed in metres.
constexpr double largestOfBodies = 100;

/// Units that do not belong together: what density and wave speed are times as large in m, kg and s.
struct MixedUnits {
  double density, speed;
  std::string_view hint;  // with the speed, m/s
};
constexpr MixedUnits mixedUnits[] = {
    {1e12, 1e-3,
     "in mm, t and s it is one of {:.4g} m/s: name them, units.system = \"mm-t-s\" or --units mm-t-s, and give all of "
     "the scene in these"},
    {1, 1e3, "with a modulus in MPa beside m, kg and s it would be one of {:.4g} m/s; give the modulus in Pa"},
    {1, 31622.8, "with a modulus in GPa beside m, kg and s it would be one of {:.4g} m/s; give the modulus in Pa"},
    {1e3, 0.0316228, "with a density in g/cm3 it would be one of {:.4g} m/s; give it in kg/m3"},
    {1e12, 1e-6, "with a density in t/mm3 beside Pa it would be one of {:.4g} m/s; give it in kg/m3"},
};

bool isOfSolids(double speed, double density) {
  return speed >= (density > densestOfSlow ? slowestOfDense : slowestOfSolids) && speed <= fastestOfSolids &&
         density <= densest;
}

void addUnits(const Body& body, std::vector<std::string>& notes) {
  if (usedUnits() == Units::none) return;
  const UnitSizes unit = sizesOf(usedUnits());
  for (const auto& block : body.blocks()) {
    const double named = block->material().waveSpeed(), speed = named * unit.length / unit.time,
                 density = block->material().density * unit.mass / std::pow(unit.length, 3);
    if (isOfSolids(speed, 0) || (speed < slowestOfSolids && density < densestOfSlow)) continue;
    const auto* mixed = std::ranges::find_if(mixedUnits, [&](const MixedUnits& units) {
      return usedUnits() == Units::si && isOfSolids(speed * units.speed, density * units.density);
    });
    notes.push_back(fmt::format("a wave speed of {:.4g} m/s is none of a solid; {}", named,
                                mixed == std::end(mixedUnits)
                                    ? fmt::format("are modulus and density in consistent units, {}?",
                                                  unitSystems.find(unitSystems.nameOf(usedUnits()))->help)
                                    : fmt::format(fmt::runtime(mixed->hint), speed * mixed->speed)));
    return;
  }
}

}  // namespace

BodyFigures bodyFigures(const Body& body) {
  const NodeVectors& X = body.mesh().X;
  BodyFigures figures{X.rowwise().maxCoeff() - X.rowwise().minCoeff(), infinity, 0};
  for (const auto& block : body.blocks()) {
    const double speed = block->material().waveSpeed();
    figures.slowest = std::min(figures.slowest, speed);
    figures.fastest = std::max(figures.fastest, speed);
  }
  return figures;
}

std::string BodyFigures::text() const {
  return fmt::format("{:.4g} x {:.4g} x {:.4g} m, pressure waves at {}{:.4g} m/s, {:.4g} s along the longest side",
                     size[0], size[1], size[2], slowest < fastest ? fmt::format("{:.4g} to ", slowest) : "", fastest,
                     crossing());
}

Json BodyFigures::json() const {
  return Json{{"size", {size[0], size[1], size[2]}},
              {"wave_speed", {{"slowest", slowest}, {"fastest", fastest}}},
              {"crossing_time", crossing()}};
}

bool isHeld(const Body& body) {
  return body.constraints().any() || !body.constraints().rigidBodies().empty() || body.discreteForces();
}

std::vector<std::string> bodyNotes(const Body& body) {
  std::vector<std::string> notes = bodyNotes(body, isHeld(body));
  if (const double size = bodyFigures(body).size.maxCoeff(); size > largestOfBodies && usedUnits() == Units::si)
    notes.push_back(fmt::format("the body is {:.4g} m long; of a mesh in mm the critical step is a thousandth", size));
  return notes;
}

std::vector<std::string> bodyNotes(const Body& body, bool held) {
  std::vector<std::string> notes;
  addModes(body, notes);
  if (!held) notes.emplace_back("nothing is held: the body can fly and turn as a whole");
  addUnits(body, notes);
  return notes;
}

std::vector<std::string> notesOfBracket(const Scene& scene, const Body& body) {
  std::vector<std::string> notes;
  if (body.discreteForces() && body.discreteForces()->friction())
    notes.emplace_back(
        "friction: while surfaces slide its tangent is not symmetric, and what is called certified is that of the "
        "run without it, with the damping that it has while they stick");
  if (body.elementDamping() && body.elementDamping()->dependsOnRates())
    notes.emplace_back(
        "quadratic bulk viscosity: it counts with its derivative at the velocities of each observed state");
  if (std::ranges::any_of(body.constraints().rigidBodies(), [](const RigidBody& rigid) {
        return rigid.guide().turning != RigidGuide::Turning::prescribed;
      }))
    notes.emplace_back(
        "rigid bodies: their nodes' forces turn with them, which adds a stiffness that is not in the bracket");
  if (!scene.pressures.empty())
    notes.emplace_back(
        "pressure: its load stiffness is not symmetric and not in the bracket, which is that of the body under dead "
        "loads");
  return notes;
}

}  // namespace ringwatch
