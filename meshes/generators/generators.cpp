#include <ringwatch/meshes/generators/generators.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <unordered_map>
#include <vector>

#include <ringwatch/base/error.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/random.h>
#include <ringwatch/base/sort_unique.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/meshes/index_limits.h>
#include <ringwatch/meshes/modify/bisection.h>
#include <ringwatch/meshes/quality.h>

namespace ringwatch {
namespace {

// Prisms along x; their triangles are those of Kuhn's split.
constexpr std::uint8_t wedgesAlongX[] = {0, 2, 6, 1, 3, 7, 0, 6, 4, 1, 7, 5};
// From hexahedra (at the face of low x) to Kuhn's tetrahedra (at the face of high x): pyramids on five faces, two
// tetrahedra on the sixth.
constexpr std::uint8_t transitionPyramids[] = {0, 1, 3, 2, 8, 6, 7, 5, 4, 8, 4, 5, 1,
                                               0, 8, 7, 6, 2, 3, 8, 6, 4, 0, 2, 8};
constexpr std::uint8_t transitionTets[] = {1, 7, 3, 8, 1, 5, 7, 8};

std::string splitChoices(std::string_view element) {
  std::string text;
  for (const CellSubdivision& split : allCellSubdivisions())
    if (split.element == element) text += joinText(text.empty() ? "" : " or ", split.elementsPerCell);
  return text;
}

const CellSubdivision& findSplit(std::string_view element, int perCell) {
  if (const ElementInfo* info = findElementByName(element)) {
    for (const CellSubdivision& split : info->cellSplits)
      if (perCell == 0 || split.elementsPerCell == perCell) return split;
    throw InputError(joinText("split = ", perCell, ": ", element, " has ", splitChoices(element), " elements a cell"));
  }
  std::vector<std::string_view> names;
  for (const ElementInfo& info : allElements()) names.push_back(info.name);
  throw InputError(joinText("element = ", inQuotes(element), ": there is no way to cut a cell into these; ",
                            didYouMean(element, names), "known are ", shortList(names)));
}

/// The nodes and elements of a box of cells in index space; the caller places the nodes.
struct Grid {
  std::array<int, 3> cells;
  std::array<std::int64_t, 3> nodes{};
  std::int64_t cornerNodes = 0;
  std::vector<std::array<int, 3>> centres;  // cells with a node in their middle, in the order of these nodes

  /// closed: the last cells along x meet the first.
  Grid(const std::array<int, 3>& count, const CellSubdivision& split, bool closed = false) : cells(count) {
    double total = 1, cellTotal = 1;
    for (int k = 0; k < 3; ++k) {
      nodes[k] = std::int64_t{count[k]} + (closed && k == 0 ? 0 : 1);
      total *= static_cast<double>(nodes[k]);
      cellTotal *= count[k];
    }
    if (split.centre) total += cellTotal;
    if (total > static_cast<double>(nodeCountLimit) ||
        cellTotal * split.elementsPerCell > static_cast<double>(elementCountLimit))
      throw InputError(joinText("cells = [", count[0], ", ", count[1], ", ", count[2], "]: that is ", total,
                                " nodes and ", cellTotal * split.elementsPerCell, " elements; at most ", nodeCountLimit,
                                " and ", elementCountLimit, " are possible"));
    cornerNodes = nodes[0] * nodes[1] * nodes[2];
  }
  std::int64_t node(std::int64_t i, std::int64_t j, std::int64_t k) const {
    return i % nodes[0] + nodes[0] * (j + nodes[1] * k);
  }
  /// Corner c = x + 2y + 4z of a cell.
  std::int64_t corner(int i, int j, int k, int c) const { return node(i + (c & 1), j + ((c >> 1) & 1), k + (c >> 2)); }
};

/// Elements by their corners; `finishElements` makes them whole.
Mesh fillElements(Grid& grid, const CellSubdivision& split) {
  const ElementInfo* info = findElementByName(split.element);
  const auto [nx, ny, nz] = grid.cells;
  const std::int64_t cellCount = std::int64_t{nx} * ny * nz;
  Mesh mesh;
  mesh.X.setZero(3, grid.cornerNodes + (split.centre ? cellCount : 0));
  MeshBlock block{info->type, {}, {}};
  block.connectivity.reserve(static_cast<std::size_t>(cellCount) * split.even.size());
  std::int64_t cell = 0;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i, ++cell) {
        if (split.centre) grid.centres.push_back({i, j, k});
        for (const std::uint8_t corner : (i + j + k) % 2 == 0 ? split.even : split.odd)
          block.connectivity.push_back(corner == 8 ? grid.cornerNodes + cell : grid.corner(i, j, k, corner));
      }
  mesh.blocks.push_back(std::move(block));
  return mesh;
}

void placeCentres(Mesh& mesh, const Grid& grid) {
  for (std::size_t c = 0; c < grid.centres.size(); ++c) {
    const auto [i, j, k] = grid.centres[c];
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int corner = 0; corner < 8; ++corner) sum += mesh.X.col(grid.corner(i, j, k, corner));
    mesh.X.col(grid.cornerNodes + static_cast<std::int64_t>(c)) = sum / 8;
  }
}

/// Numbers nodes and elements, fills the set "all", and gives quadratic elements nodes in the middle of their edges. A
/// middle is in the node sets that hold both ends.
void finishElements(Mesh& mesh) {
  std::unordered_map<std::uint64_t, std::int32_t> middleOfEdge;
  std::vector<std::array<std::int32_t, 2>> middles;
  const std::int32_t corners = mesh.nodeCount();
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    MeshBlock& block = mesh.blocks[b];
    const ElementInfo& info = elementInfo(block.type);
    const std::size_t width = cornerCount(info);
    const std::size_t count = block.connectivity.size() / width;
    if (info.order > 1) {
      std::vector<std::int32_t> whole;
      whole.reserve(count * static_cast<std::size_t>(info.nodes));
      for (std::size_t e = 0; e < count; ++e) {
        const std::int32_t* nodes = block.connectivity.data() + e * width;
        whole.insert(whole.end(), nodes, nodes + width);
        for (const auto& edge : info.edges) {
          const auto [low, high] = std::minmax(nodes[edge[0]], nodes[edge[1]]);
          const std::uint64_t key = static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint32_t>(high);
          const auto [entry, isNew] =
              middleOfEdge.try_emplace(key, corners + static_cast<std::int32_t>(middles.size()));
          if (isNew) middles.push_back({low, high});
          whole.push_back(entry->second);
        }
      }
      block.connectivity = std::move(whole);
    }
    std::vector<ElementRef>& all = mesh.elementSets["all"];
    for (std::size_t e = 0; e < count; ++e) {
      block.ids.push_back(all.size());
      all.push_back({b, e});
    }
  }
  mesh.X.conservativeResize(3, corners + static_cast<Eigen::Index>(middles.size()));
  for (std::size_t m = 0; m < middles.size(); ++m)
    mesh.X.col(corners + static_cast<Eigen::Index>(m)) = (mesh.X.col(middles[m][0]) + mesh.X.col(middles[m][1])) / 2;
  if (!middles.empty())
    for (auto& [name, nodes] : mesh.nodeSets) {
      std::vector<bool> inside(corners);
      for (const std::int32_t node : nodes) inside[node] = true;
      for (std::size_t m = 0; m < middles.size(); ++m)
        if (inside[middles[m][0]] && inside[middles[m][1]]) nodes.push_back(corners + static_cast<std::int32_t>(m));
    }
  mesh.nodeIds.resize(mesh.nodeCount());
  for (std::size_t n = 0; n < mesh.nodeCount(); ++n) mesh.nodeIds[n] = static_cast<std::int64_t>(n);
}

/// Hexahedra, pyramids, tetrahedra and wedges along x in five sections, see `generateMixedBar`.
Mesh fillMixed(Grid& grid) {
  const int nx = grid.cells[0], ny = grid.cells[1], nz = grid.cells[2];
  struct Part {
    std::string_view element;
    std::span<const std::uint8_t> pattern;
  };
  const int transition = (nx * 2 + 2) / 5;  // 2 of 5 cells
  const auto sectionOf = [&](int i) {
    if (i == transition) return 2;
    return i < transition ? (2 * i < transition ? 0 : 1) : (2 * (i - transition) <= nx - transition ? 3 : 4);
  };
  const std::vector<Part> parts[] = {{{"wedge6", CellSubdivision::wedges}},
                                     {{"hex8", CellSubdivision::whole}},
                                     {{"pyramid5", transitionPyramids}, {"tet4", transitionTets}},
                                     {{"tet4", CellSubdivision::kuhn}},
                                     {{"wedge6", wedgesAlongX}}};
  Mesh mesh;
  mesh.X.setZero(3, grid.cornerNodes + std::int64_t{ny} * nz);
  for (const char* name : {"tet4", "hex8", "wedge6", "pyramid5"})
    mesh.blocks.push_back({findElementByName(name)->type, {}, {}});
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        const auto centre = grid.cornerNodes + static_cast<std::int64_t>(grid.centres.size());
        if (i == transition) grid.centres.push_back({i, j, k});
        for (const Part& part : parts[sectionOf(i)])
          for (MeshBlock& block : mesh.blocks)
            if (elementInfo(block.type).name == part.element)
              for (const std::uint8_t corner : part.pattern)
                block.connectivity.push_back(corner == 8 ? centre : grid.corner(i, j, k, corner));
      }
  return mesh;
}

void requirePositiveElements(const Mesh& mesh, const std::string& reason) {
  for (const MeshBlock& block : mesh.blocks) {
    const ElementInfo& info = elementInfo(block.type);
    const JacobianProbe probe(info);
    for (std::size_t e = 0; e < block.elementCount(); ++e) {
      const JacobianRange range = probe.range(mesh.X, block.element(e));
      if (!(range.min > 0))
        throw InputError(joinText(reason, " turns element ", e, " (", info.name,
                                  ") inside out: its Jacobian determinant is ", range.min, "; it must be above 0"));
    }
  }
}

void requirePositive(std::string_view name, double value) {
  if (!(value > 0) || !std::isfinite(value)) throw InputError(joinText(name, " = ", value, ": it must be above 0"));
}

}  // namespace

std::vector<CellSubdivision> allCellSubdivisions() {
  std::vector<CellSubdivision> all;
  for (const ElementInfo& info : allElements()) all.insert(all.end(), info.cellSplits.begin(), info.cellSplits.end());
  return all;
}

namespace {

Mesh makeBar(const BarOptions& options, bool mixed) {
  for (int k = 0; k < 3; ++k) {
    requirePositive("size", options.size[k]);
    requirePositive("cells", options.cells[k]);
    if (!std::isfinite(options.origin[k]))
      throw InputError(joinText("origin = ", options.origin[k], ": it must be finite"));
  }
  if (!(options.jitter >= 0 && options.jitter < 0.5))
    throw InputError(joinText("jitter = ", options.jitter, ": it must be 0 or more and below 0.5"));
  if (!(options.grading >= 1) || !std::isfinite(options.grading))
    throw InputError(joinText("grading = ", options.grading, ": it must be 1 or more"));
  const CellSubdivision& split = mixed ? findSplit("tet4", 6) : findSplit(options.element, options.split);
  Grid grid(options.cells, split);

  std::array<std::vector<double>, 3> line;
  for (int k = 0; k < 3; ++k) {
    const int n = options.cells[k];
    const double ratio = k == 0 && n > 1 ? std::pow(options.grading, 1.0 / (n - 1)) : 1.0;
    line[k].assign(static_cast<std::size_t>(n) + 1, 0.0);
    for (int i = 0; i <= n; ++i)
      line[k][i] = ratio == 1.0 ? double(i) / n : (std::pow(ratio, i) - 1) / (std::pow(ratio, n) - 1);
    for (double& t : line[k]) t = options.origin[k] + options.size[k] * t;
    line[k].back() = options.origin[k] + options.size[k];
    for (int i = 0; i < n; ++i)
      if (!(line[k][i + 1] > line[k][i]))
        throw InputError(joinText(k == 0 && ratio != 1 ? "grading" : "cells", " = ",
                                  k == 0 && ratio != 1 ? options.grading : n, ": cell ", i,
                                  " has no length left; use fewer cells or a smaller grading"));
  }

  Mesh mesh = mixed ? fillMixed(grid) : fillElements(grid, split);
  Random random(options.seed);
  static constexpr const char* faceNames[3][2] = {{"x-min", "x-max"}, {"y-min", "y-max"}, {"z-min", "z-max"}};
  for (int k = 0; k <= grid.cells[2]; ++k)
    for (int j = 0; j <= grid.cells[1]; ++j)
      for (int i = 0; i <= grid.cells[0]; ++i) {
        const int index[3] = {i, j, k};
        const std::int32_t node = grid.node(i, j, k);
        for (int axis = 0; axis < 3; ++axis) {
          const std::vector<double>& t = line[axis];
          const int at = index[axis], last = grid.cells[axis];
          double x = t[at];
          if (at == 0) mesh.nodeSets[faceNames[axis][0]].push_back(node);
          if (at == last) mesh.nodeSets[faceNames[axis][1]].push_back(node);
          if (options.jitter > 0) {
            const double draw =
                random.uniform(-1, 1);  // drawn for every node, so that the sequence does not depend on the shape
            if (at > 0 && at < last) x += options.jitter * draw * std::min(t[at] - t[at - 1], t[at + 1] - t[at]);
          }
          mesh.X(axis, node) = x;
        }
      }
  placeCentres(mesh, grid);
  finishElements(mesh);
  requirePositiveElements(mesh, options.jitter > 0 ? joinText("jitter = ", options.jitter) : "this shape");
  return mesh;
}

}  // namespace

Mesh generateBar(const BarOptions& options) { return makeBar(options, false); }

Mesh generateMixedBar(const BarOptions& options) {
  if (options.cells[0] < 5)
    throw InputError(
        joinText("cells = ", options.cells[0], ": a mixed bar needs at least 5 along x, one for each of its sections"));
  return makeBar(options, true);
}

namespace {

/// About how many tetrahedra a refined bar has: they take about 0.02 s³ each (measured on bars of 6000 to 250 000,
/// within a fifth), s = finest + growth × distance from the plane.
double refinedCount(const RefinedBarOptions& o) {
  // The integral of 1/s³ over distances from a to b, 0 <= a <= b.
  const auto integral = [&](double a, double b) {
    const double sa = o.finest + o.growth * a, sb = o.finest + o.growth * b;
    return (b - a) * (sa + sb) / (2 * sa * sa) / (sb * sb);
  };
  const double length = o.coarse.size[0], before = o.plane, behind = length - o.plane;
  const double along = before < 0   ? integral(-before, behind)
                       : behind < 0 ? integral(-behind, before)
                                    : integral(0, before) + integral(0, behind);
  return o.coarse.size[1] * o.coarse.size[2] * along / 0.02;
}

}  // namespace

Mesh generateRefinedBar(const RefinedBarOptions& options) {
  if (!(options.finest > 0)) throw InputError(joinText("finest = ", options.finest, " m: it must be above 0"));
  if (!(options.growth >= 0)) throw InputError(joinText("growth = ", options.growth, ": it must be 0 or more"));
  Mesh coarse = generateBar(options.coarse);
  constexpr double most = 1e8;
  if (const double count = refinedCount(options); !(count <= most))
    throw InputError(joinText("finest = ", options.finest, " m: that is about ", count, " tetrahedra; at most ", most,
                              " are possible; use a larger finest or growth"));
  const double x = options.coarse.origin[0] + options.plane;
  Mesh mesh = refineTetrahedra(std::move(coarse), [&](const Eigen::Vector3d& middle) {
    return options.finest + options.growth * std::abs(middle.x() - x);
  });
  std::iota(mesh.nodeIds.begin(), mesh.nodeIds.end(), 0);
  for (MeshBlock& block : mesh.blocks) std::iota(block.ids.begin(), block.ids.end(), 0);
  return mesh;
}

Mesh generateCube(double edge, int cells, BarOptions rest) {
  rest.size = {edge, edge, edge};
  rest.cells = {cells, cells, cells};
  return generateBar(rest);
}

Mesh generateBall(const BallOptions& options) {
  requirePositive("radius", options.radius);
  requirePositive("cells", options.cells);
  const CellSubdivision& split = findSplit(options.element, options.split);
  Grid grid({options.cells, options.cells, options.cells}, split);
  Mesh mesh = fillElements(grid, split);
  const int n = options.cells;
  static constexpr const char* sides[3][2] = {{"x0", "x1"}, {"y0", "y1"}, {"z0", "z1"}};
  for (int k = 0; k <= n; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) {
        const double x = 2.0 * i / n - 1, y = 2.0 * j / n - 1, z = 2.0 * k / n - 1;
        const double xx = x * x, yy = y * y, zz = z * z;
        const std::int32_t node = grid.node(i, j, k);
        mesh.X.col(node) = options.radius * Eigen::Vector3d(x * std::sqrt(1 - yy / 2 - zz / 2 + yy * zz / 3),
                                                            y * std::sqrt(1 - zz / 2 - xx / 2 + zz * xx / 3),
                                                            z * std::sqrt(1 - xx / 2 - yy / 2 + xx * yy / 3));
        const int index[3] = {i, j, k};
        for (int axis = 0; axis < 3; ++axis) {
          if (index[axis] == 0) mesh.nodeSets[sides[axis][0]].push_back(node);
          if (index[axis] == n) mesh.nodeSets[sides[axis][1]].push_back(node);
        }
      }
  placeCentres(mesh, grid);
  finishElements(mesh);
  std::vector<std::int32_t> surface;
  for (const auto& [name, nodes] : mesh.nodeSets) surface.insert(surface.end(), nodes.begin(), nodes.end());
  sortUnique(surface);
  mesh.nodeSets = {{"surface", std::move(surface)}};
  requirePositiveElements(mesh, joinText("cells = ", options.cells));
  return mesh;
}

Mesh generateStack(const StackOptions& options) {
  if (!(options.gap >= 0) || !std::isfinite(options.gap))
    throw InputError(joinText("gap = ", options.gap, ": it must be 0 or more and finite"));
  const BarOptions& lower = options.lower;
  BarOptions upper = lower;
  upper.size = options.upperSize;
  upper.cells = options.upperCells;
  ++upper.seed;
  for (int k = 0; k < 2; ++k)
    upper.origin[k] = lower.origin[k] + 0.5 * (lower.size[k] - upper.size[k]) + options.offset[k];
  upper.origin[2] = lower.origin[2] + lower.size[2] + options.gap;
  const Mesh boxes[2] = {generateBar(lower), generateBar(upper)};
  const auto first = static_cast<std::int32_t>(boxes[0].nodeCount());
  Mesh mesh;
  mesh.X.resize(3, boxes[0].X.cols() + boxes[1].X.cols());
  mesh.X << boxes[0].X, boxes[1].X;
  mesh.blocks = boxes[0].blocks;
  for (int box = 0; box < 2; ++box) {
    const std::string name = box == 0 ? "lower" : "upper";
    const std::int32_t firstNode = box == 0 ? 0 : first;
    std::vector<std::int32_t> all(boxes[box].nodeCount());
    std::iota(all.begin(), all.end(), firstNode);
    mesh.nodeSets[name] = std::move(all);
    for (auto [side, nodes] : boxes[box].nodeSets) {
      for (std::int32_t& node : nodes) node += firstNode;
      mesh.nodeSets[joinText(name, " ", side)] = std::move(nodes);
    }
    for (ElementRef e : boxes[box].elementSets.at("all")) {
      if (box == 1) e.element += static_cast<std::int32_t>(boxes[0].blocks[e.block].elementCount());
      mesh.elementSets[name].push_back(e);
      mesh.elementSets["all"].push_back(e);
    }
  }
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
    for (const std::int32_t node : boxes[1].blocks[b].connectivity) mesh.blocks[b].connectivity.push_back(first + node);
  for (MeshBlock& block : mesh.blocks) {
    block.ids.resize(block.elementCount());
    std::iota(block.ids.begin(), block.ids.end(), 0);
  }
  if (!boxes[0].nodeIds.empty()) {
    mesh.nodeIds.resize(mesh.nodeCount());
    std::iota(mesh.nodeIds.begin(), mesh.nodeIds.end(), 0);
  }
  return mesh;
}

Mesh generateRing(const RingOptions& options) {
  requirePositive("inner", options.inner);
  requirePositive("width", options.width);
  for (const int count : options.cells) requirePositive("cells", count);
  const auto [around, across, along] = options.cells;
  if (!(options.radius > options.inner) || !std::isfinite(options.radius))
    throw InputError(joinText("radius = ", options.radius, ": it must be above the inner one, ", options.inner));
  constexpr int leastAround = 3;
  if (around < leastAround)
    throw InputError(joinText("cells = [", around, ", …]: it must be at least ", leastAround, " around"));
  const CellSubdivision& split = findSplit(options.element, options.split);
  if (around % 2 != 0 && !std::equal(split.even.begin(), split.even.end(), split.odd.begin(), split.odd.end()))
    throw InputError(joinText("cells = [", around, ", …]: it must be even around, since neighbours are cut by turns"));
  constexpr int partsOfTooth = 4;
  if (options.teeth < 0 || (options.teeth > 0 && around % (partsOfTooth * options.teeth) != 0))
    throw InputError(joinText("teeth = ", options.teeth, ": it must be 0, or ", partsOfTooth,
                              " cells or a multiple of them must fall to each tooth; there are ", around, " around"));
  if (!(options.toothDepth >= 0 && options.toothDepth < options.radius - options.inner))
    throw InputError(joinText("tooth_depth = ", options.toothDepth, ": it must be 0 or more and below radius - inner, ",
                              options.radius - options.inner));
  Grid grid(options.cells, split, true);
  Mesh mesh = fillElements(grid, split);
  for (int i = 0; i < around; ++i) {
    // Of a pitch: out for a quarter, a flank, in for a quarter, a flank.
    const double part =
        options.teeth == 0 ? 0 : std::fmod(double(partsOfTooth) * options.teeth * i / around, partsOfTooth);
    const double depth = options.toothDepth * std::clamp(std::min(part - 1, partsOfTooth - part), 0.0, 1.0);
    const double angle = 2 * std::numbers::pi * i / around, outer = options.radius - depth;
    for (int k = 0; k <= along; ++k)
      for (int j = 0; j <= across; ++j) {
        const double r = options.inner + (outer - options.inner) * j / across;
        const std::int32_t node = grid.node(i, j, k);
        mesh.X.col(node) = Eigen::Vector3d(r * std::cos(angle), options.width * k / along, r * std::sin(angle));
        if (j == 0) mesh.nodeSets["inside"].push_back(node);
        if (j == across) mesh.nodeSets["outside"].push_back(node);
        if (k == 0) mesh.nodeSets["y-min"].push_back(node);
        if (k == along) mesh.nodeSets["y-max"].push_back(node);
      }
  }
  for (auto& [name, nodes] : mesh.nodeSets) sortUnique(nodes);
  placeCentres(mesh, grid);
  finishElements(mesh);
  requirePositiveElements(mesh, joinText("cells = ", around));
  return mesh;
}

}  // namespace ringwatch
