#pragma once
#include <filesystem>

#include <ringwatch/app/scene/deck_scene.h>

namespace ringwatch {

/// The same as readDeckScene for an LS-DYNA deck (LS-DYNA Keyword User's Manual, volumes I and II). Notes tell
/// LS-DYNA's own step, by its elements, and the mass that *CONTROL_TIMESTEP adds for DT2MS.
DeckScene readDynaScene(const std::filesystem::path& file, DeckUse use);

}  // namespace ringwatch
