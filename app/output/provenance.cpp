#include <ringwatch/app/output/provenance.h>

#include <sys/utsname.h>

#include <ctime>
#include <fstream>
#include <iterator>
#include <thread>

#include <fmt/format.h>

#include <ringwatch/base/error.h>
#include <ringwatch/base/input_file.h>

namespace ringwatch {
namespace {

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name"))
      if (const std::size_t colon = line.find(": "); colon != std::string::npos) return line.substr(colon + 2);
  return "unknown processor";
}

std::string machine() {
  utsname system{};
  const std::string name =
      uname(&system) == 0 ? fmt::format("{} {} {}", system.sysname, system.release, system.machine) : "unknown system";
  return fmt::format("{}, {}, {} hardware threads", name, processor(), std::thread::hardware_concurrency());
}

}  // namespace

std::string timeNow() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  char text[sizeof "2026-01-31T23:59:59Z"] = "";
  if (gmtime_r(&now, &utc) == nullptr || std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc) == 0)
    return "unknown";
  return text;
}

nlohmann::ordered_json provenanceOf(const std::string& command, const std::filesystem::path& scene) {
  nlohmann::ordered_json text;
  try {
    text = readBytes(scene);
    text.dump();
  } catch (const InputError&) {  // it was there when it was read
    text = nullptr;
  } catch (const nlohmann::json::type_error&) {  // not UTF-8
    text = nullptr;
  }
  return {{"command", command}, {"started", timeNow()}, {"machine", machine()}, {"scene_text", std::move(text)}};
}

}  // namespace ringwatch
