#pragma once
#include <ringwatch/app/scene/scene.h>

namespace ringwatch {

/// Lets the elements of a body of the scene damp, whose blocks are as assignMaterials made them.
void addElementDamping(const Scene& scene, Body& body);

}  // namespace ringwatch
