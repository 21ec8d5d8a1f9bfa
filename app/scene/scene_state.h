#pragma once
#include <ringwatch/app/scene/scene.h>
#include <ringwatch/integrators/body_system.h>

namespace ringwatch {

/// The state in which a scene begins: at rest or with the velocities of its [[initial]], which add up; prescribed
/// components move as prescribed. system: of the scene's body. Throws InputError for selections without nodes.
State sceneInitialState(const Scene& scene, const BodySystem& system);

}  // namespace ringwatch
