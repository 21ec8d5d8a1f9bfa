#pragma once
#include <vector>

#include <ringwatch/app/scene/scene.h>
#include <ringwatch/app/scene/scene_tables.h>

namespace ringwatch {

/// Reads the [[probe]] of a scene and how often they are wanted, after its other sections. Throws InputError.
void readProbes(const std::vector<SceneTable>& sections, const SceneTable& output, Scene& scene);

}  // namespace ringwatch
