#include <ringwatch/app/report/mesh_pack.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <ringwatch/app/output/report.h>
#include <ringwatch/app/report/surface_picture.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/sort_unique.h>
#include <ringwatch/base/units.h>
#include <ringwatch/meshes/adjacency.h>
#include <ringwatch/meshes/quality.h>

namespace ringwatch {
namespace {

using Json = nlohmann::ordered_json;

bool isStepName(const std::string& field) {
  return field.ends_with(labelled(" (s)")) && field.find("step") != std::string::npos;
}

bool isStepField(const FrameField& field) { return !field.integer && isStepName(field.name); }

bool sameElements(const Mesh& a, const Mesh& b) {
  if (a.nodeCount() != b.nodeCount() || a.blocks.size() != b.blocks.size()) return false;
  for (std::size_t i = 0; i < a.blocks.size(); ++i)
    if (a.blocks[i].type != b.blocks[i].type || a.blocks[i].connectivity != b.blocks[i].connectivity) return false;
  return true;
}

/// Orders elements by their steps; those without one come last.
auto bySteps(const std::vector<double>& steps) {
  return [&steps](std::int32_t a, std::int32_t b) {
    const double first = std::isnan(steps[a]) ? infinity : steps[a],
                 second = std::isnan(steps[b]) ? infinity : steps[b];
    return first != second ? first < second : a < b;
  };
}

/// The triangles of a face.
std::vector<std::array<int, 3>> trianglesOf(const std::array<int, 4>& face) {
  std::vector<std::array<int, 3>> triangles{{face[0], face[1], face[2]}};
  if (face[3] >= 0) triangles.push_back({face[0], face[2], face[3]});
  return triangles;
}

int cornersOf(const ElementInfo& info) {
  int most = 0;
  for (const auto& face : info.faces) most = std::max(most, *std::max_element(face.begin(), face.end()));
  return most + 1;
}

/// Numbers in 16 bits, linear or logarithmic between the least and the largest: exact to 1 in 65 000 of the range.
struct Packed {
  static constexpr std::uint16_t top = 65533, noLimit = 65534, none = 65535;
  std::vector<std::uint16_t> codes;
  double least = 0, largest = 0;
};

Packed packed(const std::vector<float>& values, const std::vector<std::int32_t>& which, bool logarithmic) {
  Packed result;
  double least = infinity, largest = -least;
  const auto counts = [&](float value) { return std::isfinite(value) && (!logarithmic || value > 0); };
  for (const std::int32_t e : which)
    if (counts(values[e])) {
      least = std::min<double>(least, values[e]);
      largest = std::max<double>(largest, values[e]);
    }
  const auto map = [&](double value) { return logarithmic ? std::log(value) : value; };
  if (least <= largest) {
    result.least = least;
    result.largest = largest;
  }
  const double range = map(result.largest) - map(result.least);
  for (const std::int32_t e : which) {
    const float value = values[e];
    if (!counts(value))
      result.codes.push_back(std::isinf(value) && value > 0 ? Packed::noLimit : Packed::none);
    else
      result.codes.push_back(
          range > 0 ? static_cast<std::uint16_t>(std::lround((map(value) - map(result.least)) / range * Packed::top))
                    : std::uint16_t{0});
  }
  return result;
}

}  // namespace

struct MeshPack::KeptFrame {
  std::int64_t number;
  double time;
  Eigen::Matrix3Xf positions;
  std::vector<std::string> names;
  std::vector<bool> integers;
  std::vector<std::vector<float>> fields;
  std::map<std::string, double> values;
  double completeBelow;  // s; infinite when all elements are in the page
};

struct MeshPack::Group {
  Mesh mesh;  // of the first frame
  std::vector<ElementFace> surface;
  std::vector<std::size_t> first;   // blockOffsets
  std::vector<std::int32_t> solid;  // elements shown through the body, not yet sorted
  std::vector<KeptFrame> frames;
};

void MeshPack::add(const PageFrame& frame, bool keyFrame, const std::vector<ElementRef>& controlling) {
  const VtuFrame& state = frame.state;
  if (!group_ || !sameElements(group_->mesh, state.mesh)) {
    closeGroup();
    group_ = std::make_shared<Group>();
    group_->mesh = state.mesh;
    group_->surface = boundaryFaces(state.mesh);
    group_->first = blockOffsets(state.mesh);
  }
  elementCount_ = state.mesh.elementCount();
  const std::vector<double>* steps = nullptr;
  for (const FrameField& field : state.cells) {
    if (stepField_.empty() && isStepField(field)) stepField_ = field.name;
    if (field.name == stepField_) steps = &field.values;
  }

  KeptFrame kept{frame.number, frame.time, state.mesh.X.cast<float>(), {}, {}, {}, state.values, infinity};
  for (const FrameField& field : state.cells) {
    kept.names.push_back(field.name);
    kept.integers.push_back(field.integer);
    kept.fields.emplace_back(field.values.begin(), field.values.end());
  }
  std::vector<std::int32_t>& solid = group_->solid;
  if (elementCount_ <= allElements) {
    if (group_->frames.empty()) {
      solid.resize(elementCount_);
      std::iota(solid.begin(), solid.end(), 0);
    }
  } else {
    std::vector<std::int32_t> order(elementCount_);
    std::iota(order.begin(), order.end(), 0);
    if (steps) {
      const auto end = order.begin() + leastElements;
      std::nth_element(order.begin(), end, order.end(), bySteps(*steps));
      if (!std::isnan((*steps)[*end])) kept.completeBelow = (*steps)[*end];
      solid.insert(solid.end(), order.begin(), end);
    } else {
      kept.completeBelow = 0;
    }
    sortUnique(solid);
  }
  group_->frames.push_back(std::move(kept));
  if (keyFrame) makeKeyFrame(frame, steps, controlling);
}

ColourRange ColourRange::about(double low, double high) {
  if (!(low > 0) || high > least * low) return {low, high};
  const double middle = std::sqrt(low * high), half = std::sqrt(least);
  return {middle / half, middle * half};
}

void MeshPack::makeKeyFrame(const PageFrame& frame, const std::vector<double>* steps,
                            const std::vector<ElementRef>& controlling) {
  const Mesh& mesh = frame.state.mesh;
  std::vector<double> share;
  if (steps) {
    double least = infinity, largest = 0;
    for (const double step : *steps)
      if (std::isfinite(step) && step > 0) {
        least = std::min(least, step);
        largest = std::max(largest, step);
      }
    pictureScale_ = ColourRange::about(least <= largest ? least : 0, largest);
    const auto [low, high] = pictureScale_;
    for (const double step : *steps)
      share.push_back(step > 0 && low < high ? std::log(step / low) / std::log(high / low)
                                             : std::numeric_limits<double>::quiet_NaN());
  }
  std::vector<ColouredTriangle> triangles;
  for (const ElementFace& face : group_->surface) {
    const MeshBlock& block = mesh.blocks[face.block];
    const std::int32_t* nodes = block.element(face.element);
    const auto colour = scaleColour(share.empty() ? std::numeric_limits<double>::quiet_NaN()
                                                  : share[group_->first[face.block] + face.element]);
    for (const auto& t : trianglesOf(elementInfo(block.type).faces[face.face]))
      triangles.push_back({{nodes[t[0]], nodes[t[1]], nodes[t[2]]}, colour});
  }
  constexpr int width = 720, height = 400;
  picture_ = surfacePng(group_->frames.back().positions, triangles, width, height);

  if (!steps) return;
  constexpr std::size_t most = 10;
  std::vector<std::int32_t> order(steps->size());
  std::iota(order.begin(), order.end(), 0);
  const auto end = order.begin() + static_cast<std::ptrdiff_t>(std::min(most, order.size()));
  std::partial_sort(order.begin(), end, order.end(), bySteps(*steps));
  // Volumes of a million elements take a second; "small" is told of meshes up to this size.
  constexpr std::size_t meanUpTo = 200000;
  const double meanVolume =
      steps->size() <= meanUpTo ? std::abs(meshVolume(mesh)) / static_cast<double>(steps->size()) : 0;
  const auto cardOf = [&](ElementRef ref) {
    WorstCard card;
    card.element = static_cast<std::int64_t>(group_->first[ref.block]) + ref.element;
    card.ref = ref;
    const MeshBlock& own = mesh.blocks[ref.block];
    card.ofFile = !own.ids.empty();
    const ElementInfo& info = elementInfo(own.type);
    const std::int32_t* nodes = own.element(card.ref.element);
    bool finite = true;
    for (int a = 0; a < info.nodes; ++a) finite = finite && mesh.X.col(nodes[a]).allFinite();
    card.id = own.id(card.ref.element);
    card.type = info.name;
    card.step = (*steps)[card.element];
    if (finite) {
      const ElementQuality q = elementQuality(own, card.ref.element, mesh.X);
      card.shape = elementShape(own, card.ref.element, mesh.X, meanVolume).text();
      card.volume = q.volume;
      card.minHeight = q.minHeight;
      card.minEdge = q.minEdge;
      card.maxEdge = q.maxEdge;
      for (int a = 0; a < cornersOf(info); ++a)
        card.corners.push_back({mesh.X(0, nodes[a]), mesh.X(1, nodes[a]), mesh.X(2, nodes[a])});
      for (const auto& edge : info.edges) card.edges.push_back({edge[0], edge[1]});
      for (const auto& face : info.faces) {
        card.faces.emplace_back(face.begin(), face.end());
        if (face[3] < 0) card.faces.back().pop_back();
      }
    }
    return card;
  };
  worst_.clear();
  controlling_.clear();
  for (auto it = order.begin(); it != end; ++it) {
    const std::int32_t block =
        std::upper_bound(group_->first.begin(), group_->first.end(), *it) - group_->first.begin() - 1;
    worst_.push_back(cardOf({block, static_cast<std::int32_t>(*it - static_cast<std::int64_t>(group_->first[block]))}));
  }
  for (const ElementRef ref : controlling)
    if (ref.block >= 0 && static_cast<std::size_t>(ref.block) < mesh.blocks.size() && ref.element >= 0 &&
        static_cast<std::size_t>(ref.element) < mesh.blocks[ref.block].elementCount())
      controlling_.push_back(cardOf(ref));
}

void MeshPack::closeGroup() {
  if (!group_) return;
  const Mesh& mesh = group_->mesh;
  sortUnique(group_->solid);

  // The elements of the page: those with a face on the surface, and those that are shown through the body.
  std::vector<std::int32_t> cells = group_->solid;
  for (const ElementFace& face : group_->surface)
    cells.push_back(static_cast<std::int32_t>(group_->first[face.block]) + face.element);
  sortUnique(cells);
  std::vector<std::int32_t> nodeNumber(mesh.nodeCount(), -1), nodes;
  const auto numberOf = [&](std::int32_t node) {
    if (nodeNumber[node] < 0) {
      nodeNumber[node] = static_cast<std::int32_t>(nodes.size());
      nodes.push_back(node);
    }
    return nodeNumber[node];
  };
  const auto cellNumber = [&](std::int64_t element) {
    return static_cast<std::int32_t>(std::lower_bound(cells.begin(), cells.end(), element) - cells.begin());
  };

  std::vector<std::int32_t> corners, owners;  // of the surface's triangles
  for (const ElementFace& face : group_->surface) {
    const MeshBlock& block = mesh.blocks[face.block];
    const std::int32_t* own = block.element(face.element);
    for (const auto& t : trianglesOf(elementInfo(block.type).faces[face.face])) {
      for (const int corner : t) corners.push_back(numberOf(own[corner]));
      owners.push_back(cellNumber(static_cast<std::int64_t>(group_->first[face.block]) + face.element));
    }
  }
  Json types = Json::array();
  std::vector<std::int32_t> solid, solidNodes;
  std::vector<double> ids(cells.size());
  std::size_t at = 0;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const MeshBlock& block = mesh.blocks[b];
    const ElementInfo& info = elementInfo(block.type);
    const int count = cornersOf(info);
    Json triangles = Json::array();
    for (const auto& face : info.faces)
      for (const auto& t : trianglesOf(face)) triangles.push_back(t);
    std::size_t solids = 0;
    for (; at < group_->solid.size() && static_cast<std::size_t>(group_->solid[at]) < group_->first[b + 1]; ++at) {
      ++solids;
      const std::int32_t* own = block.element(group_->solid[at] - group_->first[b]);
      solid.push_back(cellNumber(group_->solid[at]));
      for (int a = 0; a < count; ++a) solidNodes.push_back(numberOf(own[a]));
    }
    types.push_back(Json{{"name", std::string(info.name)},
                         {"elements", block.elementCount()},
                         {"first", group_->first[b]},
                         {"solids", solids},
                         {"corners", count},
                         {"triangles", std::move(triangles)}});
  }
  for (std::size_t c = 0; c < cells.size(); ++c) {
    std::size_t b = 0;
    while (static_cast<std::size_t>(cells[c]) >= group_->first[b + 1]) ++b;
    ids[c] = static_cast<double>(mesh.blocks[b].id(cells[c] - group_->first[b]));
  }

  Json frames = Json::array();
  for (const KeptFrame& frame : group_->frames) {
    Eigen::Vector3d least = Eigen::Vector3d::Constant(infinity), largest = -least;
    for (const std::int32_t n : nodes)
      if (frame.positions.col(n).allFinite()) {
        least = least.cwiseMin(frame.positions.col(n).cast<double>());
        largest = largest.cwiseMax(frame.positions.col(n).cast<double>());
      }
    if (!(least.x() <= largest.x())) least = largest = Eigen::Vector3d::Zero();
    std::vector<std::uint16_t> coordinates;  // x of all nodes, then y, then z
    coordinates.reserve(3 * nodes.size());
    for (int k = 0; k < 3; ++k)
      for (const std::int32_t n : nodes) {
        const double range = largest[k] - least[k], value = frame.positions(k, n);
        coordinates.push_back(!std::isfinite(value) || range == 0
                                  ? std::uint16_t{0}
                                  : static_cast<std::uint16_t>(std::lround((value - least[k]) / range * 65535)));
      }
    Json fields = Json::array();
    for (std::size_t f = 0; f < frame.fields.size(); ++f) {
      const bool step = isStepName(frame.names[f]);
      if (frame.integers[f]) {
        std::vector<std::int32_t> values;
        for (const std::int32_t c : cells) values.push_back(static_cast<std::int32_t>(frame.fields[f][c]));
        fields.push_back(Json{
            {"name", frame.names[f]}, {"kind", "class"}, {"array", data_.add(std::span<const std::int32_t>(values))}});
        continue;
      }
      const Packed values = packed(frame.fields[f], cells, step);
      fields.push_back(Json{{"name", frame.names[f]},
                            {"kind", step ? "logarithmic" : "linear"},
                            {"min", values.least},
                            {"max", values.largest},
                            {"array", data_.add(std::span<const std::uint16_t>(values.codes))}});
    }
    const auto value = [&](const std::string& name) {
      const auto found = frame.values.find(name);
      return found == frame.values.end() ? Json(nullptr) : numberOrNull(found->second);
    };
    frames.push_back(Json{{"number", frame.number},
                          {"time", frame.time},
                          {"safe", value(labelled("safe step (s)"))},
                          {"optimistic", value(labelled("optimistic step (s)"))},
                          {"h", value(labelled("step (s)"))},
                          {"verdict", value("verdict")},
                          {"min", {least.x(), least.y(), least.z()}},
                          {"max", {largest.x(), largest.y(), largest.z()}},
                          {"positions", data_.add(std::span<const std::uint16_t>(coordinates))},
                          {"completeBelow", numberOrNull(frame.completeBelow)},
                          {"fields", std::move(fields)}});
  }
  groups_.push_back(Json{{"nodes", nodes.size()},
                         {"elements", mesh.elementCount()},
                         {"types", std::move(types)},
                         {"cells", data_.add(std::span<const std::int32_t>(cells))},
                         {"ids", data_.add(std::span<const double>(ids))},
                         {"triangles", data_.add(std::span<const std::int32_t>(corners))},
                         {"owners", data_.add(std::span<const std::int32_t>(owners))},
                         {"solid", data_.add(std::span<const std::int32_t>(solid))},
                         {"solidNodes", data_.add(std::span<const std::int32_t>(solidNodes))},
                         {"frames", std::move(frames)}});
  group_.reset();
}

Json MeshPack::finish() {
  closeGroup();
  return Json{{"stepField", stepField_}, {"groups", std::move(groups_)}};
}

}  // namespace ringwatch
