#pragma once
#include <filesystem>
#include <string>
#include <vector>

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
  std::vector<std::string> notes;  // of the mesh reader
};

/// What becomes of springs and contact.
enum class DiscreteAtStart {
  refused,
  counted  ///< contact at every node that it can have, touching or not: the safe side holds whatever touches
};

/// Throws InputError for bad input, and for an integrator without a critical step.
SceneStart startOf(const std::filesystem::path& scene, const std::vector<std::string>& overrides, int threads,
                   DiscreteAtStart discrete = DiscreteAtStart::refused);

}  // namespace ringwatch
