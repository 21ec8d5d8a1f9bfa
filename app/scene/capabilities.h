#pragma once
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <ringwatch/app/scene/scene.h>
#include <ringwatch/body/body.h>
#include <ringwatch/handlers/handler.h>

namespace ringwatch {

// What goes with what is one table, in capabilities.cpp. Checks, notes, advice, help, schema, reference and tests read
// it.

/// Parts of a scene that something else does not go with.
enum class Feature {
  handler,
  timed,
  pressure,
  discrete,
  surfaces,
  movingObstacles,
  dashpots,
  friction,
  elementDamping,
  rayleigh,
  stiffnessDamping,
  provenDamping,
  rigid,
  cuts,
  erosion,
  uniformStrain,
  otherLaws,
  nodalMass,
  certificates,
  mustCertify,
  gaps,
  savedStates,
  repeat,
  reduceStep,
  hold,
  checkpoints,
  exactTimes,
  probes,
  reactions,
  metric,
  noBracket,
  budget,
  fields,
  handlerAuto,
  handlerSolver,
  handlerDamping,
  handlerHandle,
  handlerHalves,
  handlerDevices
};

/// Ways to run a scene that are not one process on the CPU, and commands that take a scene and do not run it as
/// `ringwatch run` does.
enum class SceneUse { gpu, ranks, compare, advise, suggest, stretch, scaleMass, audit };

/// Some entries of an enumeration of at most 64.
template <class Entry>
class SetOf {
 public:
  constexpr SetOf(std::initializer_list<Entry> entries) {
    for (const Entry entry : entries) add(entry);
  }
  constexpr bool has(Entry entry) const { return (bits_ & bit(entry)) != 0; }
  constexpr void add(Entry entry) { bits_ |= bit(entry); }
  friend constexpr SetOf operator|(SetOf set, Entry entry) {
    set.add(entry);
    return set;
  }

 private:
  static constexpr std::uint64_t bit(Entry entry) { return std::uint64_t{1} << static_cast<unsigned>(entry); }
  std::uint64_t bits_ = 0;
};
using Features = SetOf<Feature>;
using SceneUses = SetOf<SceneUse>;

struct FeatureInfo {
  Feature feature, whole;  // what refuses the whole refuses its parts; itself for what is no part
  std::string_view name;   // for messages, a plural: "elements that damp"
  std::string_view keys;   // its sections and keys, apart by spaces
  bool (*in)(const Scene& scene);
  /// Integrators that it goes with, and why it does not go with the others; nullptr and "": it goes with all.
  bool (*takes)(const IntegratorInfo& info) = nullptr;
  std::string_view why = {};
};
std::span<const FeatureInfo> sceneFeatures();

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
