#include <ringwatch/meshes/results.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <set>
#include <string>

#include <ringwatch/base/error.h>
#include <ringwatch/base/sort_unique.h>
#include <ringwatch/meshes/formats/file_cursor.h>
#include <ringwatch/meshes/formats/mesh_readers.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/meshes/number_index.h>

namespace ringwatch {
namespace {

namespace fs = std::filesystem;

/// Names that programs give to displacements.
const std::vector<std::string> usualNames{
    "displacement", "Displacement", "displacements", "Displacements", "DISP", "disp", "U", "u", "uh"};

/// The values of an attribute in a text of XML, in order; "" where a tag has none.
std::vector<std::pair<std::string, std::string>> attributesOf(const std::string& text, const std::string& tag,
                                                              const std::string& one, const std::string& other) {
  const auto attribute = [&](std::size_t from, std::size_t to, const std::string& name) {
    const std::size_t begin = text.find(" " + name + "=\"", from);
    if (begin == std::string::npos || begin > to) return std::string();
    const std::size_t first = begin + name.size() + 3;
    return text.substr(first, text.find('"', first) - first);
  };
  std::vector<std::pair<std::string, std::string>> values;
  for (std::size_t at = text.find("<" + tag); at != std::string::npos; at = text.find("<" + tag, at + 1)) {
    const std::size_t end = std::min(text.find('>', at), text.size());
    values.emplace_back(attribute(at, end, one), attribute(at, end, other));
  }
  return values;
}

/// The .vtu file of a .pvtu with a single piece; other files are as they are.
fs::path pieceOf(const fs::path& file) {
  if (file.extension() != ".pvtu") return file;
  const auto pieces = attributesOf(detail::readWholeFile(file), "Piece", "Source", "Source");
  if (pieces.size() != 1)
    throw InputError(
        joinText(file.string(), ": is in ", pieces.size(), " pieces; results of one process, in one piece, are read"));
  return file.parent_path() / pieces.front().first;
}

detail::ResultFrame readFrame(const fs::path& file, const std::vector<std::string>& names,
                              std::vector<std::string>* notes) {
  const std::string text = detail::readWholeFile(file);
  detail::refuseForeign(file, text);
  if (text.starts_with("# vtk DataFile")) return detail::readLegacyVtkResult(file, text, names, notes);
  return detail::readVtuResult(file, text, names, notes);
}

void requireSameElements(const Mesh& first, const Mesh& mesh, const std::string& where) {
  const auto same = [](const MeshBlock& a, const MeshBlock& b) {
    return a.type == b.type && a.connectivity == b.connectivity;
  };
  if (first.nodeCount() != mesh.nodeCount() || first.blocks.size() != mesh.blocks.size() ||
      !std::equal(first.blocks.begin(), first.blocks.end(), mesh.blocks.begin(), same))
    throw InputError(joinText(where, ": has ", mesh.nodeCount(), " nodes and ", mesh.elementCount(),
                              " elements, which are not the ", first.nodeCount(), " and ", first.elementCount(),
                              " of the first state; every state must have the same"));
}

/// Whole numbers that differ; empty for others.
std::vector<std::int64_t> differentNumbers(const std::vector<double>& values) {
  std::vector<std::int64_t> numbers;
  for (const double value : values) {
    constexpr double largest = 9007199254740992;  // up to which a double holds every whole number
    if (!(std::abs(value) <= largest) || value != std::floor(value)) return {};
    numbers.push_back(static_cast<std::int64_t>(value));
  }
  std::vector<std::int64_t> sorted = numbers;
  sortUnique(sorted);
  return sorted.size() == numbers.size() ? numbers : std::vector<std::int64_t>();
}

}  // namespace

void detail::takeNodeNumbers(ResultFrame& frame, const std::vector<double>& values) {
  if (std::vector<std::int64_t> numbers = differentNumbers(values); numbers.size() == frame.mesh.nodeCount())
    frame.mesh.nodeIds = std::move(numbers);
}

void detail::takeCellField(ResultFrame& frame, const std::string& name, const std::vector<double>& values) {
  if (values.size() != frame.mesh.elementCount()) return;
  const bool numbers = name == "ELEMENT_ID", eroded = name == "EROSION_STATUS", status = name == "STATUS";
  const auto isFlag = [](double value) { return value == 0 || value == 1; };
  std::vector<std::int64_t> ids;
  if (numbers && (ids = differentNumbers(values)).empty()) return;
  if (!numbers && !eroded && !(status && std::ranges::all_of(values, isFlag))) return;
  if (!numbers) frame.deleted.clear();
  std::size_t first = 0;
  for (MeshBlock& block : frame.mesh.blocks) {
    const std::size_t count = block.elementCount();
    if (numbers) {
      block.ids.assign(ids.begin() + static_cast<std::ptrdiff_t>(first),
                       ids.begin() + static_cast<std::ptrdiff_t>(first + count));
    } else {
      std::vector<bool>& deleted = frame.deleted.emplace_back(count);
      for (std::size_t e = 0; e < count; ++e) deleted[e] = (values[first + e] != 0) == eroded;
    }
    first += count;
  }
}

std::vector<PvdEntry> readPvd(const fs::path& file) {
  std::vector<PvdEntry> entries;
  for (const auto& [time, name] : attributesOf(detail::readWholeFile(file), "DataSet", "timestep", "file"))
    entries.push_back({std::strtod(time.c_str(), nullptr), name});
  return entries;
}

ResultSeries::ResultSeries(const std::vector<fs::path>& files, const std::string& displacement,
                           std::vector<std::string>* notes) {
  if (files.empty()) throw InputError("no file of results is given");
  const std::string text = detail::readWholeFile(files.front()).substr(0, 6);
  if (text == "    1C" || text == "    2C") {
    if (files.size() > 1)
      throw InputError(files[1].string() + ": one .frd file has all states of a run; give it alone");
    openFrd(files.front(), displacement, notes);
  } else {
    openVtk(files, displacement, notes);
  }
}

void ResultSeries::openFrd(const fs::path& file, const std::string& displacement, std::vector<std::string>* notes) {
  const auto text = std::make_shared<const std::string>(detail::readWholeFile(file));
  mesh_ = detail::readFrd(file, *text, notes, nullptr);
  displacement_ = displacement.empty() ? "DISP" : displacement;
  const auto states =
      std::make_shared<const std::vector<detail::FrdState>>(detail::frdStates(file, *text, displacement_));
  if (states->empty())
    throw InputError(
        joinText(file.string(), ": has no ", displacement_, "; let CalculiX write it with *NODE FILE and U"));
  for (const detail::FrdState& state : *states)
    entries_.push_back(
        {state.time, state.increment, joinText(file.string(), ": step ", state.step, ", increment ", state.increment)});
  const auto numbers = std::make_shared<NumberIndex>(mesh_);
  positions_ = [this, file, text, states, numbers](std::size_t i) {
    NodeVectors x = mesh_.X;
    for (const auto& [id, u] : detail::frdVectors(file, *text, (*states)[i]))
      if (const auto node = numbers->node(id)) x.col(*node) += u;
    return x;
  };
}

void ResultSeries::openVtk(const std::vector<fs::path>& files, const std::string& displacement,
                           std::vector<std::string>* notes) {
  std::vector<fs::path> frames;
  std::vector<std::optional<double>> times;
  for (const fs::path& file : files) {
    static const std::set<std::string> known{".pvd", ".vtu", ".pvtu", ".vtk"};
    if (!known.contains(file.extension().string()))
      throw InputError(file.string() + ": holds no results; give a .frd, .pvd, .vtu, .pvtu or .vtk file");
    if (file.extension() != ".pvd") {
      frames.push_back(pieceOf(file));
      times.emplace_back();
      continue;
    }
    for (const PvdEntry& entry : readPvd(file)) {
      frames.push_back(pieceOf(file.parent_path() / entry.file));
      times.emplace_back(entry.time);
    }
  }
  if (frames.empty()) throw InputError(files.front().string() + ": lists no files");
  const std::vector<std::string> names = displacement.empty() ? usualNames : std::vector<std::string>{displacement};
  detail::ResultFrame first = readFrame(frames.front(), names, notes);
  displacement_ = first.displacement;
  if (!first.u && !displacement.empty())
    throw InputError(joinText(frames.front().string(), ": no field ", detail::quoted(displacement),
                              " of three components; ",
                              first.vectors.empty() ? "there are none at the points" : "there are " + first.vectors));
  mesh_ = std::move(first.mesh);
  if (first.deformedPoints && first.u) mesh_.X -= *first.u;
  bool moved = first.u.has_value();
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const detail::ResultFrame frame = readFrame(frames[i], names, nullptr);
    requireSameElements(mesh_, frame.mesh, frames[i].string());
    moved = moved || frame.mesh.X != mesh_.X;
    entries_.push_back({times[i] ? times[i] : frame.time, frame.increment, frames[i].string()});
    deleted_.push_back(frame.deleted);
  }
  if (!moved)
    throw InputError(joinText(frames.front().string(),
                              ": the points of all states are the same, and there is none of the fields ",
                              "displacement, U and so on; name it by --displacement",
                              first.vectors.empty() ? "" : ", one of " + first.vectors));
  if (!first.u && notes != nullptr)
    notes->push_back(
        "there is no displacement: the points are taken for positions, and those of the first state for "
        "positions at rest");
  positions_ = [this, frames, names](std::size_t i) {
    detail::ResultFrame frame = readFrame(frames[i], names, nullptr);
    if (displacement_.empty() || frame.deformedPoints) return std::move(frame.mesh.X);
    if (!frame.u)
      throw InputError(
          joinText(frames[i].string(), ": no field ", detail::quoted(displacement_), ", which the first state has"));
    return NodeVectors(mesh_.X + *frame.u);
  };
}

}  // namespace ringwatch
