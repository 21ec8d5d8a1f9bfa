#include <ringwatch/app/frames.h>

#include <algorithm>

#include <fmt/format.h>

#include <ringwatch/base/error.h>
#include <ringwatch/meshes/adjacency.h>
#include <ringwatch/monitor/metrics.h>

namespace ringwatch {
namespace {

std::string frameName(std::size_t number) { return fmt::format("frame_{:06}.vtu", number); }

}  // namespace

std::vector<std::string> frameFieldNames() { return {"critical_step", "metric", "verdict", "handler"}; }

FrameWriter::FrameWriter(std::filesystem::path folder, const Scene& scene, const Body& body, StepRule rule)
    : folder_(std::move(folder)), scene_(scene), body_(body), rule_(std::move(rule)) {
  std::error_code error;
  std::filesystem::create_directories(folder_ / "frames", error);
  if (error)
    throw InputError(fmt::format("{}: cannot write: {}; choose another folder with --out",
                                 (folder_ / "frames").string(), error.message()));
}

bool FrameWriter::asksFor(const char* field) const {
  return std::find(scene_.fields.begin(), scene_.fields.end(), field) != scene_.fields.end();
}

std::vector<double> FrameWriter::elementSteps(const std::string& metric, const NodeVectors& x, double factor) const {
  std::vector<double> steps;
  for (const auto& block : evaluateMetric(metric, body_, x).elementLambda)
    for (double lambda : block) steps.push_back(factor * rule_(lambda));
  return steps;
}

void FrameWriter::write(double time, const NodeVectors& x, const NodeVectors& v, double h, Verdict verdict,
                        std::span<const ElementRef> handledElements) {
  const NodeVectors displacement = x - body_.mesh().X;
  const auto values = [](const NodeVectors& vectors) {
    return std::span<const double>(vectors.data(), static_cast<std::size_t>(vectors.size()));
  };
  const std::vector<VtuField> points{{"displacement", 3, values(displacement)}, {"velocity", 3, values(v)}};

  std::vector<double> ring, metric;
  std::vector<std::int32_t> verdicts, handled;
  std::vector<VtuField> cells;
  if (asksFor("critical_step") || asksFor("verdict")) ring = elementSteps("reduced-1-ring", x, 1);
  if (asksFor("critical_step")) cells.push_back({"critical_step", 1, std::span<const double>(ring)});
  if (asksFor("metric")) {
    metric = elementSteps(scene_.metric, x, 1 - scene_.margin);
    cells.push_back({"metric", 1, std::span<const double>(metric)});
  }
  if (asksFor("verdict")) {
    for (double step : ring) verdicts.push_back(h > step ? 2 : verdict == Verdict::certified ? 0 : 1);
    cells.push_back({"verdict", 1, std::span<const std::int32_t>(verdicts)});
  }
  if (asksFor("handler")) {
    handled.assign(body_.mesh().elementCount(), 0);
    const std::vector<std::size_t> first = blockOffsets(body_.mesh());
    for (const ElementRef e : handledElements)
      handled[first[static_cast<std::size_t>(e.block)] + static_cast<std::size_t>(e.element)] = 1;
    cells.push_back({"handler", 1, std::span<const std::int32_t>(handled)});
  }

  const std::filesystem::path file = std::filesystem::path("frames") / frameName(entries_.size() + 1);
  writeVtu(folder_ / file, body_.mesh(), x, points, cells, time);
  entries_.push_back({time, file});
  // Rewritten at every frame, so that a run can be looked at while it goes on.
  writePvd(folder_ / "run.pvd", entries_);
}

void FrameWriter::removeStale() const {
  std::error_code ignored;
  for (std::size_t i = entries_.size() + 1; std::filesystem::remove(folder_ / "frames" / frameName(i), ignored); ++i) {
  }
}

}  // namespace ringwatch
