#pragma once
#include <nlohmann/json.hpp>

#include <ringwatch/app/run/run_result.h>
#include <ringwatch/app/scene/scene.h>

namespace ringwatch {

/// What a result holds at a checkpoint, of a run without handler and cuts, and that read back. Throws InputError where
/// a number is of a node, a material or an obstacle that the scene has not.
nlohmann::ordered_json savedResult(const RunResult& result);
void resumeResult(const nlohmann::ordered_json& saved, const Scene& scene, std::size_t nodes, RunResult& result);
Verdict savedVerdict(const nlohmann::ordered_json& name);

}  // namespace ringwatch
