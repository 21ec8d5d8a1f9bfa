#include <ringwatch/app/run/run_checkpoints.h>

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include <ringwatch/app/run/saved_result.h>
#include <ringwatch/app/run/stopwatch.h>
#include <ringwatch/app/scene/capabilities.h>
#include <ringwatch/base/archive.h>
#include <ringwatch/base/error.h>
#include <ringwatch/body/domain.h>

namespace ringwatch {

bool RunCheckpoints::due() const {
  const auto& interval = run_.scene.checkpointInterval;
  return interval && run_.result.steps > 0 &&
         run_.state.time >= static_cast<double>(count_ + 1) * *interval - 1e-3 * run_.steps.step() && run_.isFinite();
}

void RunCheckpoints::write() {
  const double reached = run_.state.time + 1e-3 * run_.steps.step();
  // However many lie within a step.
  count_ = std::max(count_ + 1, static_cast<std::int64_t>(reached / *run_.scene.checkpointInterval));
  writeAndBeginAgain();
}

std::size_t RunCheckpoints::writeAndBeginAgain() {
  run_.completeState();
  run_.energies.beginBody();
  run_.watch.end();
  std::size_t bytes = 0;
  {
    const Stopwatch measured(run_.result.outputTime);
    Checkpoint checkpoint = saved();
    checkpoint.parts["recorder"] = run_.recorder.save();
    if (run_.body.domain().first()) bytes = writeCheckpoint(run_.options.folder, checkpoint);
  }
  run_.beginWatch();
  run_.loads.begin(run_.state.x);
  goOn();
  return bytes;
}

void RunCheckpoints::writeAsItIs() {
  asItIs_ = false;
  if (std::string reason = whyNone(); !reason.empty()) {
    told_ = fmt::format("there is no checkpoint of step {}: {}", run_.result.steps, reason);
    return;
  }
  const double before = run_.result.outputTime;
  const auto writeAll = [this] {
    const Stopwatch measured(run_.result.outputTime);
    Checkpoint checkpoint = saved();
    SavingArchive archive;
    run_.archive(archive);
    checkpoint.memory = archive.take();
    return writeCheckpoint(run_.options.folder, checkpoint);
  };
  std::size_t bytes = 0;
  try {
    bytes = run_.options.part ? writeAndBeginAgain() : writeAll();
  } catch (const InputError& fault) {  // the disk is full: what there was stays
    if (run_.options.part) throw;      // the others wait
    told_ = fmt::format("there is no checkpoint of step {}: {}", run_.result.steps, fault.what());
    return;
  }
  asItIs_ = true;
  const double seconds = run_.result.outputTime - before;
  told_ = fmt::format("step {}, t = {:.6g} s: checkpoint of {:.3g} MB written to {} in {:.2g} seconds",
                      run_.result.steps, run_.state.time, 1e-6 * static_cast<double>(bytes),
                      (run_.options.folder / checkpointFile).string(), seconds);
}

std::string RunCheckpoints::whyNone() const {
  if (std::string reason = whyNot(run_.scene, Feature::savedStates); !reason.empty()) return reason;
  if (!run_.scheme->stepper().keepsNothing()) return "a run on a GPU has no checkpoints";
  if (run_.result.steps == 0) return "no step was taken yet";
  if (!run_.isFinite()) return "positions or velocities are not finite";
  return {};
}

Checkpoint RunCheckpoints::saved() {
  run_.total.lap();
  Checkpoint saved;
  saved.sceneFile = run_.scene.file;
  if (!run_.scene.meshFile.empty()) saved.meshFile = std::filesystem::absolute(run_.scene.meshFile);
  saved.scene = run_.scene.echo;
  Domain& domain = run_.body.domain();
  saved.state.time = run_.state.time;
  saved.state.x = domain.gathered(run_.state.x);
  saved.state.v = domain.gathered(run_.state.v);
  const NodeVectors moved = domain.gathered(run_.body.constraints().velocity());
  if (!run_.named()) return saved;  // another process writes it
  Constraints& constraints = run_.named()->constraints();
  if (!domain.whole())
    for (const std::int64_t i : std::vector(constraints.components()))
      constraints.move(static_cast<std::int32_t>(i / 3), static_cast<int>(i % 3), moved.data()[i]);
  saved.mesh = hashOf(run_.named()->mesh());
  run_.output->sync();
  saved.parts = {{"result", savedResult(run_.result)}, {"energies", run_.energies.save()},
                 {"steps", run_.steps.save()},         {"watch", run_.watch.save()},
                 {"output", run_.output->save()},      {"moved", prescribedVelocities(constraints)},
                 {"checkpoints_due", count_},          {"last_verdict", std::string(verdictName(run_.lastVerdict))}};
  if (run_.ruleOfSteps.isOfLongerStep()) saved.parts["rule_of_longer_step"] = true;
  if (!domain.whole()) saved.parts["ranks"] = true;
  return saved;
}

void RunCheckpoints::resume(const Checkpoint& saved) {
  Domain& domain = run_.body.domain();
  if (domain.whole()) {
    requireWrittenBy(saved, false, run_.options.folder);
    requireSameMesh(saved, run_.scene, run_.body);
  }
  run_.state.time = saved.state.time;
  run_.state.x = domain.taken(saved.state.x);
  run_.state.v = domain.taken(saved.state.v);
  run_.watch.end();
  const auto damaged = [&](const char* how) {
    return InputError(fmt::format("{}: does not fit this scene: {}; begin the run again",
                                  (run_.options.folder / checkpointFile).string(), how));
  };
  try {
    domain.together([&] { resumeParts(saved); });
  } catch (const InputError& fault) {
    throw damaged(fault.what());
  } catch (const nlohmann::json::exception& fault) {
    throw damaged(fault.what());
  }
  domain.together([&] { run_.output->resume(saved.parts.at("output"), run_.result.steps); });
  if (saved.memory.empty()) goOn();
}

void RunCheckpoints::resumeParts(const Checkpoint& saved) {
  resumeResult(saved.parts.at("result"), run_.scene, static_cast<std::size_t>(saved.state.x.cols()), run_.result);
  run_.energies.resume(saved.parts.at("energies"));
  run_.steps.resume(saved.parts.at("steps"));
  run_.watch.resume(saved.parts.at("watch"));
  if (!saved.parts.value("rule_of_longer_step", false)) run_.ruleOfSteps.referToStep(run_.body);
  count_ = saved.parts.at("checkpoints_due").get<std::int64_t>();
  run_.lastVerdict = savedVerdict(saved.parts.at("last_verdict"));
  if (run_.body.domain().whole())
    resumeMotion(run_.body.constraints(), saved.parts.at("moved").get<std::vector<double>>());
  run_.beginWatch();
  run_.loads.begin(run_.state.x);
  run_.loads.setForces(run_.state.time, run_.state.x, run_.energies.balance());
  if (saved.memory.empty()) return run_.recorder.resume(saved.parts.at("recorder"));
  LoadingArchive archive(saved.memory);
  run_.archive(archive);
  archive.end();
}

/// What is done alike behind a checkpoint, by a run that goes on and by one that is resumed.
void RunCheckpoints::goOn() {
  run_.state.a.resize(3, 0);
  run_.watch.goOnWithEvents(run_.result.steps);
  run_.recordEnergies();
}

std::string RunCheckpoints::howToGoOn() const {
  const std::string command = fmt::format("ringwatch run --resume {}{} goes on ", run_.options.folder.string(),
                                          run_.options.part ? ", by mpirun," : "");
  if (asItIs_) return command + "from here";
  return told_ + (count_ > 0 ? "; " + command + "from the last one" : "");
}

}  // namespace ringwatch
