#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace ringwatch {

/// What of a deck is wanted.
enum class DeckUse {
  run,   ///< all of it: one *DYNAMIC step with what loads and moves the body
  model  ///< the body: mesh, materials, sections and what is held; procedures and loads do not matter to it
};

/// The sections of a scene that a deck of Abaqus, CalculiX or LS-DYNA, or a MuJoCo model, stands for.
struct DeckScene {
  nlohmann::ordered_json sections;             // as in Scene::echo, but only what the deck says
  std::map<std::string, std::string> origins;  // "force.0" -> "deck.inp:31", of sections
  std::vector<std::string> notes;              // what is left out and what is taken otherwise, with file and line
  /// Why a step above the optimistic side may be stable all the same: something that damps is left out; "" else.
  std::string mayBeStable = {};
  std::optional<double> ownStep = {};  // s, that the deck's program takes at rest by its own rule, where that is known
};

/// Whether a file is a deck, by its content or its extension .inp. False for one that cannot be read.
bool isDeckFile(const std::filesystem::path& file);

/// The materials, sections, supports, loads, initial velocities and the *DYNAMIC step of a deck, as CalculiX reads them
/// (CalculiX CrunchiX user's manual, "Input deck format"), or as readDynaScene has them. Output requests are left out
/// with a note. Throws InputError "FILE:LINE: …" with every keyword that changes the motion and that ringwatch has not.
DeckScene readDeckScene(const std::filesystem::path& file, DeckUse use);

}  // namespace ringwatch
