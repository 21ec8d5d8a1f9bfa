#include <ringwatch/meshes/results.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <ringwatch/base/error.h>
#include <ringwatch/base/number_format.h>
#include <ringwatch/meshes/formats/file_cursor.h>
#include <ringwatch/meshes/formats/mesh_readers.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/meshes/number_index.h>
#include <ringwatch/meshes/part_of_mesh.h>

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
    constexpr std::string_view blanks = " \t\r\n";
    for (std::size_t at = text.find(name, from); at < to; at = text.find(name, at + 1)) {
      if (blanks.find(text[at - 1]) == std::string_view::npos) continue;
      const std::size_t equals = text.find_first_not_of(blanks, at + name.size());
      if (equals >= to || text[equals] != '=') continue;
      const std::size_t quote = text.find_first_not_of(blanks, equals + 1);
      if (quote >= to || (text[quote] != '"' && text[quote] != '\'')) continue;
      return text.substr(quote + 1, text.find(text[quote], quote + 1) - quote - 1);
    }
    return std::string();
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
  detail::refuseForeignStates(file, text);
  if (text.starts_with("# vtk DataFile")) return detail::readLegacyVtkResult(file, text, names, notes);
  return detail::readVtuResult(file, text, names, notes);
}

/// States that tell numbers of their nodes or elements where the first one tells none, or none where it tells some.
struct UnlikeFirst {
  std::string of;  // what the numbers are of
  bool firstHas;
  std::size_t count = 0;
  std::string where = {};  // the first such state
  void see(bool has, const fs::path& path) {
    if (has != firstHas && count++ == 0) where = path.string();
  }
  std::string note(std::size_t states) const {
    return joinText(where, ": tells ", firstHas ? "no numbers" : "numbers", " of its ", of,
                    ", which the first state does", firstHas ? "" : " not", ": in ", count, " of ", states, " states ",
                    of, " are matched by their ", of == "nodes" ? "place in the file" : "nodes");
  }
};

/// Elements of a mesh by their type and their nodes in any order.
class ElementsByNodes {
 public:
  /// numbers: of the nodes, by which they are sought.
  ElementsByNodes(const Mesh& mesh, const std::vector<std::int32_t>& numbers) {
    for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
      for (std::size_t e = 0; e < mesh.blocks[b].elementCount(); ++e) {
        const std::int32_t* const nodes = mesh.blocks[b].element(e);
        std::vector<std::int32_t> own(nodes, nodes + mesh.blocks[b].nodesPerElement());
        for (std::int32_t& node : own) node = numbers[static_cast<std::size_t>(node)];
        std::ranges::sort(own);
        elements_.emplace(std::pair(mesh.blocks[b].type, std::move(own)), ElementRef(b, e));
      }
  }
  std::optional<ElementRef> find(const MeshBlock& block, std::size_t e) const {
    std::vector<std::int32_t> own(block.element(e), block.element(e) + block.nodesPerElement());
    std::ranges::sort(own);
    const auto found = elements_.find(std::pair(block.type, std::move(own)));
    return found == elements_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  std::map<std::pair<ElementType, std::vector<std::int32_t>>, ElementRef> elements_;
};

/// Puts positions, displacements and deleted elements of a state in the order of the first one's: nodes by their
/// numbers where both have some, elements by theirs or else by their nodes. Throws InputError where they are not the
/// same.
void orderAs(const Mesh& first, bool nodesHaveNumbers, bool elementsHaveNumbers, detail::ResultFrame& frame,
             const std::string& where) {
  const auto refuse = [&](const auto&... what) {
    throw InputError(joinText(where, ": ", what..., "; every state must have the same"));
  };
  const Mesh& mesh = frame.mesh;
  if (first.nodeCount() != mesh.nodeCount() || first.elementCount() != mesh.elementCount())
    refuse("has ", mesh.nodeCount(), " nodes and ", mesh.elementCount(), " elements, the first state ",
           first.nodeCount(), " and ", first.elementCount());
  NumberIndex numbers(mesh);
  const bool nodesByNumber = nodesHaveNumbers && frame.nodesHaveNumbers && first.nodeIds != mesh.nodeIds;
  std::vector<std::int32_t> order(first.nodeCount()), inFirst(first.nodeCount());
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(order.size()); ++i) {
    const auto node = nodesByNumber ? numbers.node(first.nodeId(i)) : i;
    if (!node) refuse("has no node ", first.nodeId(i), ", which the first state has");
    order[static_cast<std::size_t>(i)] = *node;
    inFirst[static_cast<std::size_t>(*node)] = i;
  }
  const bool byNumber = elementsHaveNumbers && frame.elementsHaveNumbers;
  std::vector<std::vector<bool>> deleted;
  std::optional<ElementsByNodes> byNodes;
  const auto hasNodesOf = [&](const MeshBlock& block, std::size_t e, ElementRef own) {
    const auto at = static_cast<std::size_t>(own.block), element = static_cast<std::size_t>(own.element);
    if (at >= mesh.blocks.size() || element >= mesh.blocks[at].elementCount() || mesh.blocks[at].type != block.type)
      return false;
    const std::int32_t* const nodes = block.element(e);
    return std::equal(
        nodes, nodes + block.nodesPerElement(), mesh.blocks[at].element(element),
        [&](std::int32_t node, std::int32_t theirs) { return node == inFirst[static_cast<std::size_t>(theirs)]; });
  };
  for (std::size_t b = 0; b < first.blocks.size(); ++b) {
    const MeshBlock& block = first.blocks[b];
    deleted.emplace_back(block.elementCount());
    for (std::size_t e = 0; e < block.elementCount(); ++e) {
      std::optional<ElementRef> own = byNumber ? numbers.element(block.id(e)) : ElementRef{b, e};
      if (!own) refuse("has no element ", block.id(e), ", which the first state has");
      if (!hasNodesOf(block, e, *own)) {
        if (!byNumber && !byNodes) byNodes.emplace(mesh, inFirst);
        own = byNumber ? std::nullopt : byNodes->find(block, e);
        if (!own || !hasNodesOf(block, e, *own))
          refuse("element ", block.id(e), " has other nodes than in the first state, or in another order");
      }
      if (!frame.deleted.empty())
        deleted[b][e] = frame.deleted[static_cast<std::size_t>(own->block)][static_cast<std::size_t>(own->element)];
    }
  }
  if (!frame.deleted.empty()) frame.deleted = std::move(deleted);
  if (!nodesByNumber) return;
  frame.mesh.X = NodeVectors(mesh.X(Eigen::all, order));
  if (frame.u) frame.u = NodeVectors((*frame.u)(Eigen::all, order));
}

/// Takes the numbers of nodes or elements that a field has: whole ones that differ. Else a note says why they are not
/// taken. notes: or nullptr.
std::vector<std::int64_t> differentNumbers(const std::string& field, const std::vector<double>& values,
                                           const std::string& source, std::vector<std::string>* notes) {
  const auto leaveOut = [&](const auto&... why) {
    if (notes != nullptr)
      notes->push_back(
          joinText(source, ": the numbers of ", field, " are not taken, ", why..., "; those of the file's order are"));
    return std::vector<std::int64_t>();
  };
  std::vector<std::int64_t> numbers;
  for (const double value : values) {
    constexpr double largest = 9007199254740992;  // up to which a double holds every whole number
    if (!(std::abs(value) <= largest) || value != std::floor(value)) return leaveOut(value, " is not a whole one");
    numbers.push_back(static_cast<std::int64_t>(value));
  }
  std::vector<std::int64_t> sorted = numbers;
  std::ranges::sort(sorted);
  if (const auto twice = std::ranges::adjacent_find(sorted); twice != sorted.end())
    return leaveOut(*twice, " stands ", std::ranges::count(sorted, *twice), " times");
  return numbers;
}

}  // namespace

void detail::requireElements(const Problems& problems) {
  for (const MeshProblem& problem : problems)
    if (problem.kind != MeshProblem::Kind::nonFinite) throw InputError(problem.text);
}

void detail::takeNodeNumbers(ResultFrame& frame, const std::vector<double>& values, const std::string& source,
                             Notes* notes) {
  if (values.size() != frame.mesh.nodeCount()) return;
  if (std::vector<std::int64_t> numbers = differentNumbers(nodeNumberField, values, source, notes); !numbers.empty()) {
    frame.mesh.nodeIds = std::move(numbers);
    frame.nodesHaveNumbers = true;
  }
}

void detail::takeCellField(ResultFrame& frame, const std::string& name, const std::vector<double>& values,
                           const std::string& source, Notes* notes) {
  if (values.size() != frame.mesh.elementCount()) return;
  const bool numbers = name == "ELEMENT_ID", eroded = name == "EROSION_STATUS", status = name == "STATUS";
  const auto isFlag = [](double value) { return value == 0 || value == 1; };
  std::vector<std::int64_t> ids;
  if (numbers && (ids = differentNumbers(name, values, source, notes)).empty()) return;
  if (!numbers && !eroded && !(status && std::ranges::all_of(values, isFlag))) return;
  if (!numbers) frame.deleted.clear();
  frame.elementsHaveNumbers = frame.elementsHaveNumbers || numbers;
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

bool detail::mayTellOfElements(std::string_view text) {
  const auto has = [&](std::string_view name) { return text.find(name) != std::string_view::npos; };
  return has(nodeNumberField) || std::ranges::any_of(resultFields, has);
}

Mesh detail::standingMesh(ResultFrame frame, const std::string& source, Notes* notes) {
  std::size_t deleted = 0;
  for (std::vector<bool>& block : frame.deleted) {
    deleted += static_cast<std::size_t>(std::ranges::count(block, true));
    block.flip();
  }
  if (deleted == 0) return std::move(frame.mesh);
  const std::size_t all = frame.mesh.elementCount();
  if (deleted == all) throw InputError(joinText(source, ": all ", all, " elements are deleted, by their status"));
  if (notes != nullptr)
    notes->push_back(joinText(source, ": ", deleted, " of ", all, deleted == 1 ? " elements is" : " elements are",
                              " deleted, by the status that the file tells, and left out with ",
                              deleted == 1 ? "its" : "their", " mass"));
  Mesh standing = meshOfElements(frame.mesh, frame.deleted);
  standing.X = std::move(frame.mesh.X);
  standing.nodeIds = std::move(frame.mesh.nodeIds);
  standing.nodeSets = std::move(frame.mesh.nodeSets);
  return standing;
}

std::vector<PvdEntry> readPvd(const fs::path& file) {
  std::vector<PvdEntry> entries;
  const auto timeOf = [&](const std::string& word) {
    const std::optional<double> time = readNumber(word);
    if (!time || !std::isfinite(*time))
      throw InputError(joinText(file.string(), ": the timestep of state ", entries.size() + 1, " is ",
                                detail::quoted(word), "; it must be a number, s"));
    return *time;
  };
  for (const auto& [time, name] : attributesOf(detail::readWholeFile(file), "DataSet", "timestep", "file"))
    entries.push_back({timeOf(time), name});
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
    entries_.push_back({state.time,
                        state.increment,
                        {},
                        joinText(file.string(), ": step ", state.step, ", increment ", state.increment)});
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
  std::vector<VtkFile> frames;
  for (const fs::path& file : files) {
    static const std::set<std::string> known{".pvd", ".vtu", ".pvtu", ".vtk"};
    if (!known.contains(file.extension().string())) {
      detail::refuseForeignStates(file, detail::readWholeFile(file));
      throw InputError(file.string() + ": holds no results; give a .frd, .pvd, .vtu, .pvtu or .vtk file");
    }
    if (file.extension() != ".pvd") {
      frames.push_back({pieceOf(file), {}});
      continue;
    }
    for (const PvdEntry& entry : readPvd(file))
      frames.push_back({pieceOf(file.parent_path() / entry.file), entry.time});
  }
  if (frames.empty()) throw InputError(files.front().string() + ": lists no files");
  const std::size_t before = notes ? notes->size() : 0;
  openFrames(frames, displacement, notes);
  const auto isBefore = [](const auto& one, const auto& other) { return one.time < other.time; };
  if (!std::ranges::all_of(entries_, [](const ResultEntry& entry) { return entry.time.has_value(); }) ||
      std::is_sorted(entries_.begin(), entries_.end(), isBefore))
    return;
  // The first one is at rest.
  for (std::size_t i = 0; i < frames.size(); ++i) frames[i].time = entries_[i].time;
  std::stable_sort(frames.begin(), frames.end(), isBefore);
  if (notes) notes->resize(before);
  openFrames(frames, displacement, notes);
  if (notes)
    notes->push_back(joinText("the states were not given in the order of their times; they are taken in it, from ",
                              frames.front().path.string(), " to ", frames.back().path.string()));
}

void ResultSeries::openFrames(const std::vector<VtkFile>& frames, const std::string& displacement,
                              std::vector<std::string>* notes) {
  entries_.clear();
  deleted_.clear();
  const std::vector<std::string> names = displacement.empty() ? usualNames : std::vector<std::string>{displacement};
  detail::ResultFrame first = readFrame(frames.front().path, names, notes);
  displacement_ = first.displacement;
  if (!first.u && !displacement.empty())
    throw InputError(joinText(frames.front().path.string(), ": ", detail::noField(displacement, first.vectors)));
  mesh_ = std::move(first.mesh);
  if (first.deformedPoints && first.u) mesh_.X -= *first.u;
  bool moved = first.u.has_value();
  const bool nodesHaveNumbers = first.nodesHaveNumbers, elementsHaveNumbers = first.elementsHaveNumbers;
  const auto readInOrder = [this, names, nodesHaveNumbers, elementsHaveNumbers](const fs::path& path) {
    detail::ResultFrame frame = readFrame(path, names, nullptr);
    orderAs(mesh_, nodesHaveNumbers, elementsHaveNumbers, frame, path.string());
    return frame;
  };
  UnlikeFirst nodes{"nodes", nodesHaveNumbers}, elements{"elements", elementsHaveNumbers};
  for (const VtkFile& file : frames) {
    const detail::ResultFrame frame = readInOrder(file.path);
    nodes.see(frame.nodesHaveNumbers, file.path);
    elements.see(frame.elementsHaveNumbers, file.path);
    moved = moved || frame.mesh.X != mesh_.X;
    entries_.push_back({file.time ? file.time : frame.time, frame.increment, frame.step, file.path.string()});
    deleted_.push_back(frame.deleted);
  }
  if (!moved)
    throw InputError(joinText(frames.front().path.string(),
                              ": the points of all states are the same, and there is none of the fields ",
                              "displacement, U and so on; name it by --displacement",
                              first.vectors.empty() ? "" : ", one of " + first.vectors));
  if (notes != nullptr)
    for (const UnlikeFirst* unlike : {&nodes, &elements})
      if (unlike->count > 0) notes->push_back(unlike->note(frames.size()));
  if (!first.u && notes != nullptr)
    notes->push_back(
        "there is no displacement: the points are taken for positions, and those of the first state for "
        "positions at rest");
  positions_ = [this, frames, readInOrder](std::size_t i) {
    detail::ResultFrame frame = readInOrder(frames[i].path);
    if (displacement_.empty() || frame.deformedPoints) return std::move(frame.mesh.X);
    if (!frame.u)
      throw InputError(joinText(frames[i].path.string(), ": no field ", detail::quoted(displacement_),
                                ", which the first state has"));
    return NodeVectors(mesh_.X + *frame.u);
  };
}

}  // namespace ringwatch
