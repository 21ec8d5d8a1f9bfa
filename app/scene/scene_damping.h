#pragma once
#include <ringwatch/app/scene/scene.h>
#include <ringwatch/app/scene/scene_tables.h>

namespace ringwatch {

/// [damping]: Rayleigh damping and bulk viscosity.
void readDampingSection(const SceneTable& section, Scene& scene);
/// What the keys of a [material] say of damping, without bulk viscosity; its law has these parameters.
DampingConstants dampingOf(const SceneTable& material, const Options& lawParameters);
/// Lets the elements of a body of the scene damp, whose blocks are as assignMaterials made them.
void addElementDamping(const Scene& scene, Body& body);

}  // namespace ringwatch
