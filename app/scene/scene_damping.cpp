#include <ringwatch/app/scene/scene_damping.h>

#include <algorithm>

#include <fmt/format.h>

#include <ringwatch/app/command/integrator_catalog.h>
#include <ringwatch/app/scene/scene_sections.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/body/rigid_block.h>

namespace ringwatch {

void readDampingSection(const SceneTable& section, Scene& scene) {
  scene.damping = {section.get<double>("mass"), section.get<double>("stiffness")};
  const bool bulk = section.get<bool>("bulk_viscosity");
  for (const char* key : {"linear_bulk_viscosity", "quadratic_bulk_viscosity"})
    if (section.given(key) && !section.given("bulk_viscosity"))
      fail(section.at(key).origin, section.name + "." + key, "goes with bulk_viscosity = true; set that too");
  if (!bulk) return;
  scene.linearBulkViscosity = section.get<double>("linear_bulk_viscosity");
  scene.quadraticBulkViscosity = section.get<double>("quadratic_bulk_viscosity");
}

DampingConstants dampingOf(const SceneTable& material, const Options& lawParameters) {
  DampingConstants damping;
  damping.massProportional = material.get<double>("mass_damping");
  damping.shearViscosity = material.get<double>("shear_viscosity");
  damping.volumeViscosity = material.get<double>("volume_viscosity");
  damping.hourglassViscosity = material.get<double>("hourglass_viscosity");
  const auto beta = material.get<double>("stiffness_damping");
  if (beta == 0) return damping;
  if (!lawParameters.find("young") || !lawParameters.find("poisson"))
    fail(material.at("stiffness_damping").origin, "material.stiffness_damping",
         fmt::format("is a time by which Young's modulus and Poisson's ratio are multiplied, which the law {} does not "
                     "have; give shear_viscosity and volume_viscosity",
                     inQuotes(material.get<std::string>("model"))));
  const double young = lawParameters.number("young"), poisson = lawParameters.number("poisson");
  damping.shearViscosity += beta * young / (2 * (1 + poisson));
  damping.volumeViscosity += beta * young / (3 * (1 - 2 * poisson));
  return damping;
}

void addElementDamping(const Scene& scene, Body& body) {
  if (!scene.hasElementDamping()) return;
  const std::vector<int> materials = materialOfBlocks(body.mesh());
  std::vector<DampingConstants> constants;
  for (std::size_t b = 0; b < body.blocks().size(); ++b) {
    DampingConstants own = scene.materials[materials.empty() ? 0 : static_cast<std::size_t>(materials[b])].damping;
    if (dynamic_cast<const RigidBlock*>(body.blocks()[b].get())) {  // it has no strain rates
      constants.push_back({.massProportional = own.massProportional});
      continue;
    }
    own.linearBulk = scene.linearBulkViscosity;
    own.quadraticBulk = scene.quadraticBulkViscosity;
    if (!body.blocks()[b]->rule().uniformStrain) own.hourglassViscosity = 0;  // of meshes of several elements
    constants.push_back(own);
  }
  body.setElementDamping(constants);
}

}  // namespace ringwatch
