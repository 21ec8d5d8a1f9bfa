#include <ringwatch/app/report/inspection_report.h>

#include <fmt/format.h>

#include <ringwatch/app/analysis/step_answer.h>
#include <ringwatch/app/output/frames.h>
#include <ringwatch/app/output/step_reasons.h>
#include <ringwatch/app/report/report_page.h>
#include <ringwatch/app/report/state_frame.h>
#include <ringwatch/base/atomic_file.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/meshes/quality.h>
#include <ringwatch/monitor/stability_monitor.h>

namespace ringwatch {
namespace {

/// The state as a frame: first the steps by the metric that tells elements apart best.
VtuFrame frameOf(const Inspection& inspection) {
  VtuFrame frame = stateFrame(inspection.body, inspection.x, &inspection.step, inspection.asked);
  static constexpr std::string_view usual = "reduced-1-ring";
  const auto found = std::find_if(inspection.metrics.begin(), inspection.metrics.end(),
                                  [](const MetricResult& metric) { return metric.info->name == usual; });
  frame.cells.push_back(found != inspection.metrics.end()
                            ? stepField(*found, inspection.rule)
                            : stepField(evaluateMetric(usual, inspection.body, inspection.x), inspection.rule));
  for (const MetricResult& metric : inspection.metrics)
    if (metric.info->name != usual) frame.cells.push_back(stepField(metric, inspection.rule));
  FrameField heights{labelled("least height at rest (m)"), false, {}};
  for (const auto& block : meshQuality(inspection.body.mesh()))
    for (const ElementQuality& q : block) heights.values.push_back(q.minHeight);
  frame.cells.push_back(std::move(heights));
  return frame;
}

PageVerdict verdictOf(const Inspection& inspection, const std::optional<RunAnalysis>& analysis) {
  using Tone = PageVerdict::Tone;
  PageVerdict verdict;
  const CriticalStep& step = inspection.step;
  const std::optional<double> asked = inspection.asked;
  verdict.title = fmt::format("Stable up to {} s", stepRoundedDown(step.safe));
  verdict.tone = Tone::good;
  if (asked && *asked > step.optimistic)
    verdict.title = fmt::format("{:.4g} s is too large", *asked), verdict.tone = Tone::bad;
  else if (asked && verdictOfState(*asked, step) != Verdict::certified)
    verdict.title = fmt::format("{:.4g} s is not proven", *asked), verdict.tone = Tone::unsure;
  else if (asked)
    verdict.title = fmt::format("{:.4g} s is stable", *asked);
  else if (!(step.safe > 0) || step.indefinite())
    verdict.title = "No step is proven", verdict.tone = Tone::unsure;
  verdict.sentence = fmt::format(
      "The critical step of the mesh {} lies between {} s, up to which it is proven {}, and {} s, above which "
      "it is proven unstable.{}",
      inspection.state, stepRoundedDown(step.safe), stableUpTo(step), stepRoundedUp(step.optimistic),
      reasonsText(inspection.json["why"], " ", "", Reasons::alone));
  if (step.indefinite())
    verdict.sentence +=
        " The tangent has a negative eigenvalue there: no step cures that, the state itself is unstable.";

  if (asked && *asked > step.safe && step.safe > 0 && !step.indefinite())
    verdict.remedies.push_back(fmt::format("Take a smaller step: {} s is proven.", stepRoundedDown(step.safe)));
  else if (step.safe > 0 && !step.indefinite())
    verdict.remedies.push_back(fmt::format("Take steps of at most {} s.", stepRoundedDown(step.safe)));
  std::vector<std::string> more;
  if (analysis) {
    const WhatIf* row = analysis->inTheWay();
    more = row && !row->way.all.empty() ? remediesFor(*row, *analysis) : largerSteps(*analysis);
  }
  if (more.empty()) more = remediesOf(inspection.json["why"]);
  verdict.remedies.insert(verdict.remedies.end(), more.begin(), more.end());
  return verdict;
}

}  // namespace

ReportResult writeInspectionReport(const Inspection& inspection, const std::filesystem::path& file) {
  PageContent page;
  page.ofRun = false;
  page.words.writtenBy = "inspected by";
  page.words.elsewhere = "the files of --json and --vtu";
  page.words.frameFiles = "the mesh file, and the file of --vtu for ParaView";
  page.words.summaryFile = "the file of --json";
  page.name = "Mesh " + inspection.name;
  page.summary = inspection.json;
  page.elements = inspection.body.mesh().elementCount();
  page.notes = inspection.notes;
  page.keyFrame = 1;
  page.keyStep = inspection.asked;
  page.where = inspection.state;
  MeshPack pack(page.data);
  const PageFrame shown{1, 0, frameOf(inspection)};
  pack.add(shown, true, {inspection.step.controlling});
  page.takeMesh(pack);
  page.frames = page.framesShown = 1;
  if (page.elements > analysedElements) {
    page.analysis = analyseFrame({shown.state, waveSpeedsOf(inspection.body), blockOfElements(inspection.body),
                                  inspection.rule, inspection.step.safe, inspection.step.optimistic, inspection.asked});
  } else {
    page.analysis =
        analyseState({inspection.body, inspection.x, inspection.integrator, inspection.rule, inspection.damping,
                      inspection.step.safe, inspection.step.optimistic, inspection.asked});
  }
  page.analysis->where = inspection.state;
  page.verdict = verdictOf(inspection, page.analysis);
  return writtenPage(reportPage(page), page.verdict, page.notes, file);
}

}  // namespace ringwatch
