#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>

#include <nlohmann/json.hpp>

#include <ringwatch/app/scene/scene.h>
#include <ringwatch/integrators/integrator.h>

namespace ringwatch {

/// What a run goes on from as if it had not been stopped: its state and what its parts have saved. There are two kinds.
/// At those that the scene wants a run begins its monitor and its energy balance again, whether it goes on or is
/// resumed: so both have the same bits, and the file is small. Those of a signal must change nothing of the run: they
/// hold the monitor itself.
struct Checkpoint {
  std::filesystem::path sceneFile;  // as the run was given it
  std::filesystem::path meshFile;   // empty when generated
  nlohmann::ordered_json scene;     // Scene::echo
  std::uint64_t mesh = 0;           // hashOf
  State state;                      // positions and velocities of one time; no acceleration
  nlohmann::ordered_json parts;     // what the parts of a run have saved
  std::string memory;               // by SavingArchive, what else they know; "" where the run has begun them again
};

/// Name of the file in the folder of a run.
inline constexpr const char* checkpointFile = "checkpoint.bin";

/// Vectors at nodes, 3×N, as bytes in JSON.
nlohmann::ordered_json binaryOf(const NodeVectors& vectors);
/// Throws InputError where the bytes are not those of three numbers a node.
NodeVectors vectorsOf(const nlohmann::ordered_json& json);

/// A number for nodes and elements of a mesh; another mesh has another one.
std::uint64_t hashOf(const Mesh& mesh);

/// Replaces the checkpoint in a folder: the old one or the whole new one is there, however the program or the machine
/// ends. Returns its bytes. Throws InputError when it cannot be written.
std::size_t writeCheckpoint(const std::filesystem::path& folder, const Checkpoint& checkpoint);
/// Throws InputError where there is none, it is damaged, or another version has written it.
Checkpoint readCheckpoint(const std::filesystem::path& folder);

/// The scene of a checkpoint.
Scene sceneOf(const Checkpoint& checkpoint);
/// Throws InputError that names the first key in which a scene differs from that of the checkpoint in the folder.
void requireSameScene(const Checkpoint& checkpoint, const Scene& scene, const std::filesystem::path& folder);

/// Throws InputError where the checkpoint in the folder was not written by a run on ranks, or by one of one process.
void requireWrittenBy(const Checkpoint& checkpoint, bool ranks, const std::filesystem::path& folder);
/// Throws InputError where the mesh of the body is not that of the checkpoint.
void requireSameMesh(const Checkpoint& checkpoint, const Scene& scene, const Body& body);
/// The prescribed velocities of the step that led to the state, m/s, by Constraints::components(): the work there is
/// summed with them. Empty where nothing has moved.
std::vector<double> prescribedVelocities(const Constraints& constraints);
void resumeMotion(Constraints& constraints, const std::vector<double>& velocities);

/// Numbers that may be missing, as JSON.
template <class T>
nlohmann::ordered_json optionalJson(const std::optional<T>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}
template <class T>
std::optional<T> optionalOf(const nlohmann::ordered_json& json) {
  return json.is_null() ? std::nullopt : std::optional(json.get<T>());
}

}  // namespace ringwatch
