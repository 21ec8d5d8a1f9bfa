#include <ringwatch/app/run/run_cuts.h>

#include <fmt/format.h>

#include <ringwatch/app/run/stopwatch.h>
#include <ringwatch/base/error.h>

namespace ringwatch {

void requireCuttable(const Scene& scene, const Mesh& mesh) {
  for (const Scene::Cut& cut : scene.cuts)
    for (const MeshBlock& block : mesh.blocks)
      if (block.type != elementTypeOf<Tet4>)
        throw InputError(fmt::format("{}: only tetrahedra of four nodes can be cut; the mesh has {}", cut.origin,
                                     elementInfo(block.type).name));
}

void RunCuts::makeThoseDue() {
  while (due()) make(run_.scene.cuts[next_++]);
}

bool RunCuts::due() const {
  return next_ < run_.scene.cuts.size() && !(run_.state.time < run_.scene.cuts[next_].time - 1e-3 * run_.steps.step());
}

double RunCuts::kineticEnergy() const {
  return 0.5 * (run_.state.v.colwise().squaredNorm() * run_.body.lumpedMass()).value();
}

std::int64_t RunCuts::handledElements() const { return run_.scheme->handler() ? run_.scheme->treatedElements() : 0; }

void RunCuts::make(const Scene::Cut& wanted) {
  CutRecord record;
  record.step = run_.result.steps;
  record.time = run_.state.time;
  record.elementsBefore = static_cast<std::int64_t>(run_.body.mesh().elementCount());
  run_.output->open();
  run_.completeState();
  if (wanted.criticalStep) record.before = run_.criticalStepHere();
  record.kineticBefore = kineticEnergy();
  record.handledBefore = handledElements();
  {
    const Stopwatch measured(record.cutTime);
    const CutMesh made =
        cutMesh(run_.body.mesh(), wanted.surface,
                wanted.positions == CutPositions::reference ? run_.body.mesh().X : run_.state.x, wanted.snap);
    if (made.facesOpened == 0) {
      run_.result.notes.push_back(fmt::format(
          "{}: at t = {:.6g} s it opens nothing: no face of the mesh lies within it", wanted.origin, run_.state.time));
      return;
    }
    moveTo(made, record);
    record.elementsCut = static_cast<std::int64_t>(made.elementsCut);
    record.nodesAdded = static_cast<std::int64_t>(made.nodesAdded);
    record.facesOpened = static_cast<std::int64_t>(made.facesOpened);
    record.area = made.area;
    record.atMost = optimisticStep(highestReducedRing(run_.body, run_.state.x, made.changed), run_.rule);
  }
  // The energy balance of the new body starts here, however long it is to the next row.
  run_.recordEnergies();
  record.cutTime -= record.selectionTime;
  record.elementsAfter = static_cast<std::int64_t>(run_.body.mesh().elementCount());
  if (wanted.criticalStep) record.after = run_.criticalStepHere();
  record.kineticAfter = kineticEnergy();
  record.handledAfter = handledElements();
  run_.result.cuts.push_back(record);
}

void RunCuts::moveTo(const CutMesh& made, CutRecord& record) {
  run_.watch.end();
  const std::unique_ptr<RunScheme> before = std::move(run_.scheme);  // holds what its handler has chosen
  run_.state.x = carriedOver(made, run_.state.x);
  run_.state.v = carriedOver(made, run_.state.v);
  run_.state.a.resize(3, 0);
  run_.body = sceneBody(run_.scene, made.mesh, run_.body.threads(), MaterialsBy::mesh);
  run_.recorder.follow(run_.body.mesh());
  run_.probes.follow();
  run_.body.constraints().imposeVelocity(run_.state.v);
  run_.energies.beginBody();
  {
    const Stopwatch selection(record.selectionTime);
    run_.scheme =
        std::make_unique<RunScheme>(run_.scene, run_.body, run_.result, run_.state.x, run_.steps.step(), made, *before);
  }
  if (const Handler* handler = run_.scheme->handler()) record.selectionCost = handler->selectionCost();
  run_.beginWatch();
}

}  // namespace ringwatch
