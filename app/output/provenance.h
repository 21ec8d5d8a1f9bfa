#pragma once
#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

namespace ringwatch {

/// Where results come from, for summary.json: { command, started, machine, scene_text }. started: UTC, ISO 8601;
/// machine: system, processor and number of hardware threads; scene_text: the scene's file as it is now, null where
/// there is none or it is not UTF-8.
nlohmann::ordered_json provenanceOf(const std::string& command, const std::filesystem::path& scene);

/// The time of day, UTC, ISO 8601.
std::string timeNow();

}  // namespace ringwatch
