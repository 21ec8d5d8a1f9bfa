#include <ringwatch/app/output/frames.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

#include <fmt/format.h>

#include <ringwatch/app/scene/scene_discrete.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/input_file.h>
#include <ringwatch/base/number_format.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/body/element_stress.h>
#include <ringwatch/meshes/adjacency.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/monitor/metrics/metrics.h>

namespace ringwatch {
namespace {

/// A frame's files, relative to the folder of the run, without their endings.
std::filesystem::path frameStem(std::size_t number) {
  return std::filesystem::path("frames") / fmt::format("frame_{:06}", number);
}

/// Removes a frame, of one process or of ranks. False where there is none.
bool removeFrame(const std::filesystem::path& folder, std::size_t number) {
  std::error_code ignored;
  const std::filesystem::path stem = folder / frameStem(number);
  bool removed = false;
  for (const char* ending : {".vtu", ".pvtu"})
    removed |= std::filesystem::remove(stem.string() + ending, ignored) && !ignored;
  const std::uintmax_t pieces = std::filesystem::remove_all(stem, ignored);
  return removed || (!ignored && pieces > 0);
}

}  // namespace

std::vector<PvdEntry> framesOfRun(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "run.pvd";
  const std::string text = readBytes(file, "; a run writes it when its scene has output.every");
  std::vector<PvdEntry> entries;
  const auto attribute = [&](std::size_t from, const std::string& name) {
    const std::size_t begin = text.find(name + "=\"", from);
    if (begin == std::string::npos) return std::string();
    const std::size_t first = begin + name.size() + 2;
    return text.substr(first, text.find('"', first) - first);
  };
  for (std::size_t at = text.find("<DataSet"); at != std::string::npos; at = text.find("<DataSet", at + 1)) {
    const std::string time = attribute(at, "timestep");
    entries.push_back({readNumber(time).value_or(0), attribute(at, "file")});
  }
  return entries;
}

std::string_view stepSide(Direction direction) {
  static constexpr auto sides = nameTable<Direction>({
      {Direction::upperBound, "safe"},
      {Direction::lowerBound, "optimistic"},
      {Direction::estimate, "estimate"},
  });
  return sides.nameOf(direction);
}

std::string stepFieldName(const MetricInfo& metric, Direction direction) {
  return labelled(direction == Direction::estimate
                      ? fmt::format("step estimate by {} (s)", metric.name)
                      : fmt::format("{} step by {} (s)", stepSide(direction), metric.name));
}

double stepBy(Direction direction, double lambda, const StepRule& rule) {
  return direction == Direction::lowerBound ? rule.optimistic({lambda}) : rule(lambda);
}

FrameField stepField(const MetricResult& metric, const StepRule& rule) {
  FrameField field{stepFieldName(*metric.info, metric.direction), false, {}};
  for (const auto& block : metric.elementLambda)
    for (const double lambda : block) field.values.push_back(stepBy(metric.direction, lambda, rule));
  return field;
}

namespace {

/// Which elements of a whole mesh a frame of it has. Both number the nodes alike. Throws InputError, naming `file`.
std::vector<std::vector<bool>> elementsIn(const Mesh& frame, const Mesh& whole, const std::string& file) {
  const auto nodesOf = [](const MeshBlock& block, std::size_t e) {
    std::vector<std::int32_t> nodes(block.element(e), block.element(e) + block.nodesPerElement());
    std::ranges::sort(nodes);
    return nodes;
  };
  std::set<std::pair<ElementType, std::vector<std::int32_t>>> left;
  for (const MeshBlock& block : frame.blocks)
    for (std::size_t e = 0; e < block.elementCount(); ++e) left.emplace(block.type, nodesOf(block, e));
  std::size_t found = 0;
  std::vector<std::vector<bool>> flags;
  for (const MeshBlock& block : whole.blocks) {
    flags.emplace_back();
    for (std::size_t e = 0; e < block.elementCount(); ++e) {
      flags.back().push_back(left.contains({block.type, nodesOf(block, e)}));
      found += flags.back().back() ? 1 : 0;
    }
  }
  if (frame.nodeCount() != whole.nodeCount() || found != frame.elementCount())
    throw InputError(fmt::format("{}: its elements are not of the mesh of the run, which has changed since", file));
  return flags;
}

/// As erosion leaves a body.
Body withElements(Body whole, const std::vector<std::vector<bool>>& left) {
  if (!whole.discreteForces()) return {whole, left};
  std::vector<std::int32_t> nodes(static_cast<std::size_t>(whole.nodeCount()));
  std::iota(nodes.begin(), nodes.end(), 0);
  DiscreteForces forces = whole.discreteForces()->restrictedTo(nodes);
  whole.setDiscreteForces(DiscreteForces(whole.nodeCount()));
  Body body(whole, left);
  body.setDiscreteForces(std::move(forces));
  return body;
}

}  // namespace

BodyState bodyOfFrame(const Scene& scene, const std::filesystem::path& folder, const PvdEntry& frame, int threads,
                      std::vector<std::string>* notes) {
  const std::filesystem::path file = folder / frame.file;
  const auto placed = [&](Body body, NodeVectors x) {
    if (body.discreteForces()) placeObstacles(scene, frame.time, *body.discreteForces());
    if (body.elementDamping() && body.elementDamping()->dependsOnRates()) {
      const MeshState moving = readVtuState(file, "velocity", nullptr);  // its positions are X + v
      const NodeVectors v = moving.x - moving.mesh.X;
      body.followDampingRates(x, v);
    }
    return BodyState{std::move(body), std::move(x)};
  };
  if (!scene.erosion) {
    MeshState state = loadVtuState(file, "displacement", notes);
    return placed(sceneBody(scene, std::move(state.mesh), threads, MaterialsBy::mesh), std::move(state.x));
  }
  MeshState state = readVtuState(file, "displacement", notes);
  std::vector<std::string> ofMesh;
  Body whole = sceneBody(scene, sceneMesh(scene, ofMesh), threads);
  if (notes) notes->insert(notes->end(), ofMesh.begin(), ofMesh.end());
  const std::vector<std::vector<bool>> left = elementsIn(state.mesh, whole.mesh(), file.string());
  return placed(withElements(std::move(whole), left), std::move(state.x));
}

FrameWriter::FrameWriter(std::filesystem::path folder, const Scene& scene, const Body& body, StepRule rule,
                         FramePieces* pieces)
    : folder_(std::move(folder)), scene_(scene), body_(body), rule_(std::move(rule)), pieces_(pieces) {
  std::error_code error;
  std::filesystem::create_directories(folder_ / "frames", error);
  if (error)
    throw InputError(fmt::format("{}: cannot write: {}; choose another folder with --out",
                                 (folder_ / "frames").string(), error.message()));
}

std::filesystem::path FrameWriter::fileOf(std::size_t number) const {
  return frameStem(number).string() + (pieces_ ? ".pvtu" : ".vtu");
}

bool FrameWriter::asksFor(const char* field) const {
  return std::find(scene_.fields.begin(), scene_.fields.end(), field) != scene_.fields.end();
}

FrameWriter::Steps FrameWriter::elementSteps(const std::string& metric, const NodeVectors& x, double factor) {
  if (bodyVersion_ != body_.version()) metrics_.clear();
  bodyVersion_ = body_.version();
  std::unique_ptr<MetricEvaluator>& evaluator = metrics_[metric];
  if (!evaluator) evaluator = makeMetricEvaluator(metric, body_);
  const Direction direction = metricDirection(metric, body_);
  Steps steps{stepFieldName(*findMetric(metric), direction), {}};
  for (const auto& block : evaluator->evaluate(x))
    for (double lambda : block) steps.values.push_back(factor * stepBy(direction, lambda, rule_));
  return steps;
}

void FrameWriter::write(const NodeVectors& x, const NodeVectors& v, const FrameState& state) {
  const NodeVectors displacement = x - body_.mesh().X;
  const auto values = [](const NodeVectors& vectors) {
    return std::span<const double>(vectors.data(), static_cast<std::size_t>(vectors.size()));
  };
  const std::vector<VtuField> points{{"displacement", 3, values(displacement)}, {"velocity", 3, values(v)}};

  std::vector<std::string> metrics;
  for (std::string field : scene_.fields) {
    if (field == "critical_step") field = "reduced-1-ring";
    // A ring at the border of a rank's part is not whole.
    if (!pieces_ && findMetric(field) && std::find(metrics.begin(), metrics.end(), field) == metrics.end())
      metrics.push_back(std::move(field));
  }
  std::vector<Steps> steps;
  steps.reserve(metrics.size() + 2);  // the fields point into it
  std::vector<std::int32_t> verdicts, handled, materials;
  std::vector<const StressMeasure*> measures;
  for (const std::string& field : scene_.fields)
    if (const StressMeasure* measure = findStressMeasure(field); measure && !std::ranges::count(measures, measure))
      measures.push_back(measure);
  std::vector<std::vector<double>> stresses;
  if (!measures.empty()) stresses = stressOfElements(body_, x, measures);
  std::vector<VtuField> cells;
  const auto add = [&](Steps own) {
    steps.push_back(std::move(own));
    cells.push_back({steps.back().name, 1, std::span<const double>(steps.back().values)});
  };
  for (const std::string& metric : metrics) add(elementSteps(metric, x, 1));
  if (asksFor("metric")) {
    Steps own = elementSteps(scene_.metric, x, 1 - scene_.margin);
    own.name = labelled(fmt::format("step by {} with margin (s)", scene_.metric));
    add(std::move(own));
  }
  if (asksFor("verdict")) {
    const bool certified = state.verdict == Verdict::certified;
    const auto known = std::find(metrics.begin(), metrics.end(), "reduced-1-ring");
    const Steps ring = known == metrics.end() ? elementSteps("reduced-1-ring", x, 1) : steps[known - metrics.begin()];
    for (double step : ring.values) verdicts.push_back(state.h > step ? 2 : certified ? 0 : 1);
    cells.push_back({"verdict", 1, std::span<const std::int32_t>(verdicts)});
  }
  if (asksFor("handler")) {
    handled.assign(body_.mesh().elementCount(), 0);
    const std::vector<std::size_t> first = blockOffsets(body_.mesh());
    for (const ElementRef e : state.handled) handled[first[e.block] + static_cast<std::size_t>(e.element)] = 1;
    cells.push_back({"handler", 1, std::span<const std::int32_t>(handled)});
  }
  for (std::size_t m = 0; m < measures.size(); ++m)
    cells.push_back(
        {labelled(std::string(measures[m]->title)), measures[m]->components, std::span<const double>(stresses[m])});

  if (const std::vector<int> ofBlocks = materialOfBlocks(body_.mesh()); !ofBlocks.empty()) {
    for (std::size_t b = 0; b < ofBlocks.size(); ++b)
      materials.insert(materials.end(), body_.mesh().blocks[b].elementCount(), ofBlocks[b]);
    cells.push_back({"material", 1, std::span<const std::int32_t>(materials)});
  }

  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  const double safe = state.safe.value_or(unknown), optimistic = state.optimistic.value_or(unknown);
  const std::int32_t verdict = state.verdict ? static_cast<std::int32_t>(*state.verdict) : -1, deformed = 1;
  const VtuField frame[] = {{labelled("safe step (s)"), 1, std::span(&safe, 1)},
                            {labelled("optimistic step (s)"), 1, std::span(&optimistic, 1)},
                            {labelled("step (s)"), 1, std::span(&state.h, 1)},
                            {"verdict", 1, std::span(&verdict, 1)},
                            {deformedPointsMark, 1, std::span(&deformed, 1)}};
  const std::filesystem::path file = fileOf(entries_.size() + 1);
  if (pieces_)
    pieces_->write(folder_ / file, x, points, cells, state.time, frame);
  else
    writeVtu(folder_ / file, body_.mesh(), x, points, cells, state.time, frame);
  entries_.push_back({state.time, file});
  // Rewritten at every frame, so that a run can be examined while it goes on.
  if (writesList()) writePvd(folder_ / "run.pvd", entries_);
}

std::vector<double> FrameWriter::times() const {
  std::vector<double> times;
  for (const PvdEntry& entry : entries_) times.push_back(entry.time);
  return times;
}

void FrameWriter::goOnBehind(const std::vector<double>& times) {
  entries_.clear();
  for (const double time : times) {
    const std::filesystem::path file = fileOf(entries_.size() + 1);
    std::error_code error;
    if (!std::filesystem::exists(folder_ / file, error))
      throw InputError(
          fmt::format("{}: is missing; the checkpoint needs it, begin the run again", (folder_ / file).string()));
    entries_.push_back({time, file});
  }
  if (!entries_.empty() && writesList()) writePvd(folder_ / "run.pvd", entries_);
}

void FrameWriter::removeStale() const {
  if (!writesList()) return;
  for (std::size_t i = entries_.size() + 1; removeFrame(folder_, i); ++i) {
  }
  // Of a run on ranks before one of one process, or the other way round.
  std::error_code ignored;
  for (std::size_t i = 1; i <= entries_.size(); ++i) {
    const std::filesystem::path stem = folder_ / frameStem(i);
    std::filesystem::remove(stem.string() + (pieces_ ? ".vtu" : ".pvtu"), ignored);
    if (!pieces_) std::filesystem::remove_all(stem, ignored);
  }
}

}  // namespace ringwatch
