#include <ringwatch/app/run/checkpoint.h>

#include <cerrno>
#include <cstring>
#include <string>

#include <fmt/format.h>

#include <ringwatch/app/output/report.h>
#include <ringwatch/app/scene/saved_json.h>
#include <ringwatch/base/atomic_file.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/fnv.h>
#include <ringwatch/base/input_file.h>
#include <ringwatch/base/pack.h>

namespace ringwatch {
namespace {

using Json = nlohmann::ordered_json;

constexpr int format = 13;  // of the file; any change of what is in it counts
constexpr std::string_view anyMark = "ringwatch checkpoint";
const std::string mark = fmt::format("{} {}\n", anyMark, format);

/// What the bytes of Checkpoint::memory depend on.
std::string buildText() { return fmt::format("{}, {} lanes", __VERSION__, nativeWidth); }

/// The first place in which two values differ: "integrator.step".
std::string firstDifference(const Json& a, const Json& b, const std::string& path) {
  if (a.type() == b.type() && (a.is_object() || a.is_array()) && (a.is_object() || a.size() == b.size())) {
    for (const auto& [key, value] : a.items()) {
      const std::string at = path.empty() ? key : path + "." + key;
      if (a.is_object() && !b.contains(key)) return at;
      const Json& other = a.is_object() ? b.at(key) : b.at(std::stoul(key));
      if (const std::string found = firstDifference(value, other, at); !found.empty()) return found;
    }
    for (const auto& [key, value] : b.items())
      if (a.is_object() && !a.contains(key)) return path.empty() ? key : path + "." + key;
    return "";
  }
  return a == b ? "" : path;
}

}  // namespace

Json binaryOf(const NodeVectors& vectors) {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(vectors.size()) * sizeof(double));
  if (!bytes.empty()) std::memcpy(bytes.data(), vectors.data(), bytes.size());
  return Json::binary(std::move(bytes));
}

NodeVectors vectorsOf(const Json& json) {
  const auto& bytes = json.get_binary();
  NodeVectors vectors(3, static_cast<Eigen::Index>(bytes.size() / (3 * sizeof(double))));
  if (static_cast<std::size_t>(vectors.size()) * sizeof(double) != bytes.size()) throw InputError("no 3×N numbers");
  if (!bytes.empty()) std::memcpy(vectors.data(), bytes.data(), bytes.size());
  return vectors;
}

std::uint64_t hashOf(const Mesh& mesh) {
  Fnv hash;
  const auto add = [&]<class T>(const T* numbers, std::size_t count) {
    hash.add({reinterpret_cast<const char*>(numbers), count * sizeof(T)});
  };
  add(mesh.X.data(), static_cast<std::size_t>(mesh.X.size()));
  for (const MeshBlock& block : mesh.blocks) {
    hash.add(elementInfo(block.type).name);
    add(block.connectivity.data(), block.connectivity.size());
  }
  return hash.value();
}

std::size_t writeCheckpoint(const std::filesystem::path& folder, const Checkpoint& checkpoint) {
  const Json content{{"format", format},
                     {"version", std::string(programVersion())},
                     {"scene_file", checkpoint.sceneFile.string()},
                     {"mesh_file", checkpoint.meshFile.string()},
                     {"scene", checkpoint.scene},
                     {"mesh", checkpoint.mesh},
                     {"time", checkpoint.state.time},
                     {"x", binaryOf(checkpoint.state.x)},
                     {"v", binaryOf(checkpoint.state.v)},
                     {"parts", checkpoint.parts},
                     {"build", checkpoint.memory.empty() ? Json(nullptr) : Json(buildText())}};
  std::string head;
  Json::to_cbor(content, head);
  std::string text(mark);
  text.reserve(mark.size() + head.size() + checkpoint.memory.size() + 2 * sizeof(std::uint64_t));
  const std::uint64_t headSize = head.size();
  text.append(reinterpret_cast<const char*>(&headSize), sizeof headSize);
  text += head;
  text += checkpoint.memory;
  text = sealed(std::move(text));
  writeFileAtomically(folder / checkpointFile, text, Outlives::machine);
  return text.size();
}

Checkpoint readCheckpoint(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / checkpointFile;
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error))
    throw InputError(fmt::format("{}: is no folder of a run", folder.string()));
  const std::string text = readBytes(
      file,
      "; a run that is stopped by a signal or has output.checkpoint_every writes it, and removes it when it has "
      "reached its end");
  std::uint64_t headSize = 0;
  if (text.starts_with(anyMark) && text.size() >= mark.size() && !text.starts_with(mark))
    throw InputError(
        fmt::format("{}: was written by another version of ringwatch, or is damaged; begin the run again or resume it "
                    "with that version",
                    file.string()));
  if (!text.starts_with(mark) || text.size() < mark.size() + 2 * sizeof headSize)
    throw InputError(fmt::format("{}: is no checkpoint", file.string()));
  std::string_view head = unsealed(text).value_or("");
  if (!head.empty()) {
    std::memcpy(&headSize, head.data() + mark.size(), sizeof headSize);
    head.remove_prefix(mark.size() + sizeof headSize);
  }
  if (headSize == 0 || headSize > head.size())
    throw InputError(fmt::format("{}: is damaged; begin the run again", file.string()));
  const std::string_view memory = head.substr(headSize);
  head = head.substr(0, headSize);
  try {
    const Json content = savedJson(head, Json::input_format_t::cbor);
    const auto version = content.at("version").get<std::string>();
    if (content.at("format").get<int>() != format || version != programVersion())
      throw InputError(
          fmt::format("{}: was written by ringwatch {} (format {}); this is {} (format {}), begin the run "
                      "again or resume it with that version",
                      file.string(), version, content.at("format").get<int>(), programVersion(), format));
    if (!memory.empty() && content.at("build") != buildText())
      throw InputError(fmt::format(
          "{}: was written by another build of ringwatch ({}; this is {}), begin the run again or resume it "
          "with that build",
          file.string(), content.at("build").get<std::string>(), buildText()));
    Checkpoint checkpoint;
    checkpoint.sceneFile = content.at("scene_file").get<std::string>();
    checkpoint.meshFile = content.at("mesh_file").get<std::string>();
    checkpoint.scene = content.at("scene");
    checkpoint.mesh = content.at("mesh").get<std::uint64_t>();
    checkpoint.state.time = content.at("time").get<double>();
    checkpoint.state.x = vectorsOf(content.at("x"));
    checkpoint.state.v = vectorsOf(content.at("v"));
    checkpoint.parts = content.at("parts");
    checkpoint.memory = memory;
    return checkpoint;
  } catch (const Json::exception& fault) {
    throw InputError(fmt::format("{}: is damaged: {}", file.string(), fault.what()));
  }
}

Scene sceneOf(const Checkpoint& checkpoint) {
  Scene scene = sceneOfEcho(checkpoint.sceneFile, checkpoint.scene);
  scene.meshFile = checkpoint.meshFile;                                     // wherever the program is called from
  scene.echo = checkpoint.scene;                                            // keys in the same order
  if (scene.device == RunDevice::automatic) scene.device = RunDevice::cpu;  // where it was written
  return scene;
}

void requireSameScene(const Checkpoint& checkpoint, const Scene& scene, const std::filesystem::path& folder) {
  const std::string key = firstDifference(checkpoint.scene, scene.echo, "");
  if (!key.empty())
    throw InputError(fmt::format("{}: is of another scene than {}: {} differs; resume without SCENE, or begin a run",
                                 (folder / checkpointFile).string(), scene.file.string(), key));
}

void requireSameMesh(const Checkpoint& checkpoint, const Scene& scene, const Body& body) {
  if (checkpoint.mesh == hashOf(body.mesh()) && checkpoint.state.x.cols() == body.nodeCount() &&
      checkpoint.state.v.cols() == body.nodeCount())
    return;
  throw InputError(fmt::format("{}: the mesh is another one than when the checkpoint was written; begin the run again",
                               scene.meshFile.empty() ? scene.file.string() : scene.meshFile.string()));
}

void requireWrittenBy(const Checkpoint& checkpoint, bool ranks, const std::filesystem::path& folder) {
  if (checkpoint.parts.contains("ranks") == ranks) return;
  throw InputError(fmt::format(
      "{}: was written by a run {}", (folder / checkpointFile).string(),
      ranks ? "of one process; go on with it without mpirun" : "on several ranks; go on with it by mpirun"));
}

std::vector<double> prescribedVelocities(const Constraints& constraints) {
  std::vector<double> velocities;
  if (constraints.moving())
    for (const std::int64_t i : constraints.components()) velocities.push_back(constraints.velocity().data()[i]);
  if (constraints.moving())
    for (const RigidBody& body : constraints.rigidBodies()) {
      const RigidGuide& guide = body.guide();
      velocities.insert(velocities.end(), guide.velocity.begin(), guide.velocity.end());
      velocities.insert(velocities.end(), guide.angularVelocity.begin(), guide.angularVelocity.end());
    }
  return velocities;
}

void resumeMotion(Constraints& constraints, const std::vector<double>& velocities) {
  const std::vector<std::int64_t> components = constraints.components();
  const std::vector<RigidBody>& bodies = constraints.rigidBodies();
  if (velocities.size() != components.size() + 6 * bodies.size()) return;  // nothing has moved
  const auto move = [&](std::size_t k, double velocity) {
    constraints.move(static_cast<std::int32_t>(components[k] / 3), static_cast<int>(components[k] % 3), velocity);
  };
  // What has moved once counts as moving, also where it rests now.
  if (!components.empty()) move(0, 1);
  for (std::size_t k = 0; k < components.size(); ++k) move(k, velocities[k]);
  for (std::size_t r = 0; r < bodies.size(); ++r) {
    const double* own = velocities.data() + components.size() + 6 * r;
    constraints.guide(bodies[r].name(), Eigen::Vector3d(own), Eigen::Vector3d(own + 3));
  }
}

}  // namespace ringwatch
