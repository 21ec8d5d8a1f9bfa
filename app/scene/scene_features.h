#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <ringwatch/app/scene/scene.h>
#include <ringwatch/body/body.h>
#include <ringwatch/handlers/handler.h>

namespace ringwatch {

/// Commands that take a scene and do not run it as `ringwatch run` does.
enum class SceneUse { compare, advise, suggest, scaleMass, audit };

/// Throws InputError, one line that names the key, for the first thing in a scene that changes the motion or the
/// bracket and that a command does not take. What only watches or writes (probes, frames, checkpoints, the monitor) is
/// left out by all of them.
void requireTaken(const Scene& scene, SceneUse use);

/// What a scene has that changes its body or its step later than at the start, one line each.
std::vector<std::string> notesOfLaterChanges(const Scene& scene);
/// What of a body of the scene is not in its bracket, one line each.
std::vector<std::string> notesOfBracket(const Scene& scene, const Body& body);

/// The key of [damping] that a handler does not work with, and why; both "" where it works with this damping.
std::pair<std::string_view, std::string> dampingRefusedBy(const HandlerInfo& handler, const RayleighDamping& damping);
/// Whether `ringwatch run` takes a scene (Scene::echo) with a handler of its own choice in place of what it has.
bool takesSomeHandler(const nlohmann::ordered_json& echo);

}  // namespace ringwatch
