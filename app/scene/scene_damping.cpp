#include <ringwatch/app/scene/scene_damping.h>

#include <algorithm>

#include <fmt/format.h>

#include <ringwatch/app/scene/integrator_catalog.h>
#include <ringwatch/app/scene/scene_sections.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/body/rigid_block.h>

namespace ringwatch {

void addElementDamping(const Scene& scene, Body& body) {
  if (!scene.hasElementDamping()) return;
  const auto materials = blockMaterials(scene.materials, body.mesh());
  std::vector<DampingConstants> constants;
  for (std::size_t b = 0; b < body.blocks().size(); ++b) {
    DampingConstants own = materials[b]->damping;
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
