#include <ringwatch/app/run/run_checkpoints.h>

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include <ringwatch/app/run/saved_result.h>
#include <ringwatch/app/run/stopwatch.h>
#include <ringwatch/base/error.h>

namespace ringwatch {

bool RunCheckpoints::due() const {
  const auto& interval = run_.scene.checkpointInterval;
  return interval && run_.result.steps > 0 && isFinite(run_.state, run_.body.threads()) &&
         run_.state.time >= static_cast<double>(count_ + 1) * *interval - 1e-3 * run_.steps.step();
}

void RunCheckpoints::write() {
  run_.scheme->stepper().complete(run_.state);
  run_.recordEnergies();
  run_.energies.beginBody();
  run_.watch.end();
  const double reached = run_.state.time + 1e-3 * run_.steps.step();
  // However many lie within a step.
  count_ = std::max(count_ + 1, static_cast<std::int64_t>(reached / *run_.scene.checkpointInterval));
  {
    const Stopwatch measured(run_.result.outputTime);
    Checkpoint saved;
    saved.sceneFile = run_.scene.file;
    if (!run_.scene.meshFile.empty()) saved.meshFile = std::filesystem::absolute(run_.scene.meshFile);
    saved.scene = run_.scene.echo;
    saved.mesh = hashOf(run_.body.mesh());
    saved.state.time = run_.state.time;
    saved.state.x = run_.state.x;
    saved.state.v = run_.state.v;
    saved.parts = {{"result", savedResult(run_.result)},
                   {"energies", run_.energies.save()},
                   {"steps", run_.steps.save()},
                   {"watch", run_.watch.save()},
                   {"output", run_.output->save()},
                   {"checkpoints_due", count_},
                   {"last_verdict", static_cast<int>(run_.lastVerdict)}};
    writeCheckpoint(run_.options.folder, saved);
  }
  run_.beginWatch();
  run_.loads.begin(run_.state.x);
  goOn();
}

void RunCheckpoints::resume(const Checkpoint& saved) {
  if (saved.mesh != hashOf(run_.body.mesh()) || saved.state.x.cols() != run_.body.nodeCount() ||
      saved.state.v.cols() != run_.body.nodeCount())
    throw InputError(
        fmt::format("{}: the mesh is another one than when the checkpoint was written; begin the run again",
                    run_.scene.meshFile.empty() ? run_.scene.file.string() : run_.scene.meshFile.string()));
  run_.state.time = saved.state.time;
  run_.state.x = saved.state.x;
  run_.state.v = saved.state.v;
  run_.watch.end();
  resumeResult(saved.parts.at("result"), run_.result);
  run_.energies.resume(saved.parts.at("energies"));
  run_.steps.resume(saved.parts.at("steps"));
  run_.watch.resume(saved.parts.at("watch"));
  count_ = saved.parts.at("checkpoints_due").get<std::int64_t>();
  run_.lastVerdict = static_cast<Verdict>(saved.parts.at("last_verdict").get<int>());
  run_.beginWatch();
  run_.loads.begin(run_.state.x);
  run_.loads.setForces(run_.state.time, run_.state.x);
  run_.output->resume(saved.parts.at("output"), run_.result.steps);
  goOn();
}

/// What is done alike behind a checkpoint, by a run that goes on and by one that is resumed.
void RunCheckpoints::goOn() {
  run_.state.a.resize(3, 0);
  run_.output->certificates().forget();
  run_.watch.goOnWithEvents(run_.result.steps);
  run_.recordEnergies();
}

std::string RunCheckpoints::howToGoOn() const {
  if (!run_.scene.checkpointInterval) return {};
  if (count_ == 0) return "there was no checkpoint yet to go on from";
  return fmt::format("ringwatch run --resume {} goes on from its last checkpoint", run_.options.folder.string());
}

}  // namespace ringwatch
