#pragma once
#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include <ringwatch/app/run/run_result.h>
#include <ringwatch/app/scene/scene.h>

namespace ringwatch {

/// summary.json of a run.
nlohmann::ordered_json summaryJson(const Scene& scene, const Body& body, const RunResult& result);
/// The few lines that a run says of itself. page: of a page that was written too.
std::string summaryText(const Scene& scene, const Body& body, const RunResult& result,
                        const std::filesystem::path& folder, const std::string& page = "");

}  // namespace ringwatch
