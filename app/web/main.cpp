// What the page asks of ringwatch: one inspection, by the functions of `ringwatch inspect`.
#include <string>

#include <nlohmann/json.hpp>
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_NO_STDIO
#include <stb/stb_image.h>

#include <ringwatch/app/analysis/inspect.h>
#include <ringwatch/app/output/report.h>
#include <ringwatch/app/report/inspection_report.h>
#include <ringwatch/app/scene/mjcf_model.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/input_file.h>
#include <ringwatch/base/subprocess.h>
#include <ringwatch/meshes/formats/file_cursor.h>
#include <ringwatch/meshes/formats/mesh_readers.h>

namespace ringwatch {

// What stands in for files that start programs or need libraries which are there for the machine alone.
ProgramResult runProgram(const std::vector<std::string>& command, const std::filesystem::path&,
                         const std::filesystem::path&) {
  throw InputError("a page cannot start " + command.front() + ", which reads this file; ringwatch inspect can");
}
bool isMjcfFile(const std::filesystem::path&) { return false; }
FlexModel readFlexModel(const std::filesystem::path& file) {
  throw InputError(file.string() + ": a page reads no model of MuJoCo; ringwatch inspect does");
}
std::vector<double> Flex::differentMasses() const { return {}; }
Mesh meshOfFlexes(const FlexModel&) { return {}; }

namespace detail {
std::string_view readByMeshioScript() { return {}; }
bool unpack(const std::string& source, const std::string& compressor, const char* in, std::size_t inSize, char* out,
            std::size_t outSize) {
  if (compressor != "vtkZLibDataCompressor")
    throw InputError(joinText(source, ": the compressor is ", detail::quoted(compressor),
                              "; a page unpacks vtkZLibDataCompressor alone"));
  const int size = static_cast<int>(outSize);
  return stbi_zlib_decode_buffer(out, size, in, static_cast<int>(inSize)) == size;
}
}  // namespace detail

}  // namespace ringwatch

/// Inspects as a request says: {"mesh": path, "options": {"young": 210e9, …} of the law, "fix": [conditions], and
/// "density", "step" and "units" where they are given}. Returns {"inspection": the JSON of `ringwatch inspect
/// --distribution`, "verdict" and "report": a page and its title} or {"error": one line}; valid until the next call.
extern "C" const char* ringwatchInspect(const char* request) {
  static std::string answer;
  nlohmann::ordered_json json;
  try {
    const auto asked = nlohmann::json::parse(request);
    ringwatch::InspectOptions options;
    options.mesh = asked.at("mesh").get<std::string>();
    for (const auto& [name, value] : asked.at("options").items()) options.parameters.set(name, value.get<double>());
    if (asked.contains("density")) options.density = asked.at("density").get<double>();
    if (asked.contains("step")) options.step = asked.at("step").get<double>();
    if (asked.contains("units"))
      options.units = ringwatch::unitSystems.valueOf("units", asked.at("units").get<std::string>());
    options.fix = asked.at("fix").get<std::vector<std::string>>();
    options.distribution = true;
    const std::filesystem::path report = "report.html";
    options.page = [&](const ringwatch::Inspection& found) {
      json["verdict"] = ringwatch::labelled(ringwatch::writeInspectionReport(found, report).title);
    };
    json["inspection"] = ringwatch::labelledJson(ringwatch::inspectMesh(options).json);
    json["report"] = ringwatch::readBytes(report);
  } catch (const std::exception& fault) {
    json = {{"error", fault.what()}};
  }
  answer = json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  return answer.c_str();
}
