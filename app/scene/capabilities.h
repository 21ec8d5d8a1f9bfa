#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <ringwatch/app/scene/feature.h>
#include <ringwatch/app/scene/scene.h>
#include <ringwatch/body/body.h>
#include <ringwatch/handlers/handler.h>

namespace ringwatch {

// What goes with what is one table, in capabilities.cpp, of the features that keys and sections declare. Checks, notes,
// advice, help, schema, reference and tests read it.

/// Ways to run a scene that are not one process on the CPU, and commands that take a scene and do not run it as
/// `ringwatch run` does.
enum class SceneUse { gpu, ranks, compare, advise, suggest, stretch, scaleMass, audit };

using SceneUses = SetOf<SceneUse>;

struct FeatureInfo {
  Feature feature, whole;  // what refuses the whole refuses its parts; itself for what is no part
  std::string_view name;   // for messages, a plural: "elements that damp"
  bool (*in)(const Scene& scene);
  /// Integrators that it goes with, and why it does not go with the others; nullptr and "": it goes with all.
  bool (*takes)(const IntegratorInfo& info) = nullptr;
  std::string_view why = {};
};
std::span<const FeatureInfo> sceneFeatures();
/// The sections and keys of a scene that declare it.
std::vector<std::string> keysOf(Feature feature);

struct SceneUseInfo {
  SceneUse use;
  std::string_view name;  // for messages: "a GPU"
  std::string_view mend;  // what a user does about a refusal
  /// Integrators and handlers that it takes, and why not the others; nullptr and "": all.
  bool (*takes)(const IntegratorInfo& info) = nullptr;
  std::string_view why = {};
  bool (*takesHandler)(const HandlerInfo& info) = nullptr;
  std::string_view whyHandler = {};
};
std::span<const SceneUseInfo> sceneUses();

enum class Fate { works, refused, meansNothing };
/// Features each of which does not go with each of some others.
struct Conflict {
  Features these, those;
  std::string_view why;
};
std::span<const Conflict> featureConflicts();
/// What some uses do not take of a scene, or leave out.
struct Limit {
  SceneUses by;
  Features of;
  std::string_view why;
  Fate fate = Fate::refused;
  bool told = false;  // a user may miss it
};
std::span<const Limit> useLimits();
const FeatureInfo& infoOf(Feature feature);
const SceneUseInfo& infoOf(SceneUse use);

/// An entry of the table. reason: why it does not work.
struct Capability {
  Fate fate = Fate::works;
  std::string_view reason = {};
};
Capability capability(Feature one, Feature other);
Capability capability(Feature feature, SceneUse use);
/// The table as text: what each feature does not go with, and why. And as data, for tests and other programs.
std::string capabilitiesText();
nlohmann::ordered_json capabilitiesJson();

/// Why a scene is refused: "origin: what: reason; mend".
struct Refusal {
  std::string origin, what, reason, mend;
  std::string text() const;
};
/// The first thing in a scene that does not go with another one; empty where all go together on the CPU.
std::optional<Refusal> refusalOf(const Scene& scene);
/// The first thing in a scene that a use does not take.
std::optional<Refusal> refusalOf(const Scene& scene, SceneUse use);
/// Throws InputError, one line that names the key, for a scene whose parts do not go together or not with its device.
void requireTogether(const Scene& scene);
/// Throws InputError, one line that names the key, for what a use does not take.
void requireTaken(const Scene& scene, SceneUse use);
/// The same in a few words, of a feature that the scene may not have: "checkpoints do not go with cuts"; "" where it
/// could have it.
std::string whyNot(const Scene& scene, Feature wanted);

/// Notes on what a use leaves out of a scene and its user may miss, one line each.
std::vector<std::string> notesOfOmissions(const Scene& scene, SceneUse use);

/// Why no handler goes with what a body has, or with all of a scene and a handler's own choice of what to do on a
/// violation; "" where one does.
std::string whyNoHandlers(const Body& body, const IntegratorInfo& integrator);
std::string whyNoHandlers(Scene scene);
/// Whether a use takes what a body has.
bool takesBody(SceneUse use, const Body& body);
/// The key of [damping] that a handler does not work with, and why; both "" where it works with this damping.
std::pair<std::string_view, std::string> dampingRefusedBy(const HandlerInfo& handler, const RayleighDamping& damping);

}  // namespace ringwatch
