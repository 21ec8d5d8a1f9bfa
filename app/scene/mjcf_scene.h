#pragma once
#include <filesystem>

#include <ringwatch/app/scene/deck_scene.h>

namespace ringwatch {

/// The sections of a scene that the 3-D flexes of a MuJoCo model stand for: its timestep and integrator, elasticity,
/// masses, pins, damping and gravity. Notes name all else. Throws InputError as readFlexModel, and for an integrator
/// whose limit is not known here.
DeckScene readMjcfScene(const std::filesystem::path& file);

}  // namespace ringwatch
