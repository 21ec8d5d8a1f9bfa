#pragma once
#include <nlohmann/json.hpp>

#include <ringwatch/app/run/run_result.h>

namespace ringwatch {

/// What a result holds at a checkpoint, of a run without handler and cuts, and that read back.
nlohmann::ordered_json savedResult(const RunResult& result);
void resumeResult(const nlohmann::ordered_json& saved, RunResult& result);

}  // namespace ringwatch
