#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include <ringwatch/app/scene/capabilities.h>
#include <ringwatch/app/scene/scene.h>
#include <ringwatch/integrators/integrator.h>
#include <ringwatch/monitor/step_limit.h>

namespace ringwatch {

/// A scene as it starts: what is asked of it before it runs.
struct SceneStart {
  Scene scene;
  const IntegratorInfo* integrator;
  StepRule rule;
  Body body;
  State state;
  std::vector<std::string> notes;  // of the mesh reader, and on what the bracket at the start leaves out
};

/// use: advise, suggest or scale-mass. Springs and contact count at every node that they can have, touching or not: the
/// safe side holds whatever touches. Throws InputError for bad input, for what the command does not take, and for an
/// integrator without a critical step.
SceneStart startOf(const std::filesystem::path& scene, const std::vector<std::string>& overrides, int threads,
                   SceneUse use);

}  // namespace ringwatch
