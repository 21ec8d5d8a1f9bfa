#include <ringwatch/app/command/help.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <ringwatch/app/command/verify.h>
#include <ringwatch/app/output/exit_status.h>
#include <ringwatch/app/output/output_fields.h>
#include <ringwatch/app/scene/capabilities.h>
#include <ringwatch/app/scene/deck_keywords.h>
#include <ringwatch/app/scene/integrator_catalog.h>
#include <ringwatch/app/scene/scene_keys.h>
#include <ringwatch/app/scene/scene_mesh.h>
#include <ringwatch/elements/registry.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/materials/registry.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/monitor/metrics/metrics.h>

namespace ringwatch {
namespace {

std::vector<HandlerInfo> handlerInfos() {
  std::vector<HandlerInfo> infos;
  for (const HandlerEntry& entry : allHandlers()) infos.push_back(*entry.info);
  return infos;
}

template <class Table>
std::string listing(const Table& table) {
  std::string text;
  for (const auto& entry : table) text += fmt::format("  {:<17} {}\n", entry.name, entry.help);
  return text;
}

template <class Table>
std::string namesIn(const Table& table) {
  std::vector<std::string_view> names;
  for (const auto& entry : table) names.push_back(entry.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string elementsText() {
  std::string text =
      "Elements with their quadrature rules, the first of which is the default. Node order is VTK's, of a wedge6 "
      "gmsh's.\n\n";
  const auto numberIn = [](int type) { return type > 0 ? fmt::format("{}", type) : "none"; };  // of a file format
  for (const ElementInfo& info : allElements()) {
    text += fmt::format("  {:<17} {} nodes, order {}; VTK cell {}, gmsh type {}\n", info.name, info.nodes, info.order,
                        numberIn(info.vtkCellType), numberIn(info.gmshType));
    for (const QuadratureRule& rule : info.rules) text += fmt::format("    {:<15} {}\n", rule.name, rule.help);
  }
  return text;
}

std::string lawsText() {
  std::string text = "Constitutive laws, material.model in a scene and --model, with their parameters:\n\n";
  for (const LawInfo& law : allLaws()) {
    text += fmt::format("  {:<17} {}\n", law.name, law.help);
    for (const OptionInfo& parameter : law.parameters)
      text += fmt::format("  {:<17}   {}: {}{}{}{}{}\n", "", parameter.name, parameter.help,
                          parameter.unit.empty() ? "" : ", ", parameter.unit,
                          parameter.range.text().empty() ? "" : ", ", parameter.range.text());
  }
  return text;
}

std::string integratorsText() {
  std::string text = "Integrators, integrator.method in a scene and --integrator:\n\n";
  for (const IntegratorInfo& info : integratorInfos())
    text += fmt::format("  {:<17} {}; stable for h omega {}\n", info.name, info.help,
                        std::isinf(info.imaginaryLimit) ? "at every step"
                        : info.imaginaryLimit > 0       ? fmt::format("< {:.6g}", info.imaginaryLimit)
                                                        : "at no step");
  return text;
}

std::string metricsText() {
  std::string text =
      "Metrics of the highest frequency, monitor.metric in a scene and --metric. An upper-bound of the frequency gives "
      "a "
      "safe step,\na lower-bound a step that is proven too large.\n\n";
  for (const MetricInfo& info : allMetrics())
    text += fmt::format("  {:<31} {}; {}\n", info.name, info.help, directionName(info.direction));
  return text;
}

std::string handlersText() {
  std::string text;
  for (const HandlerInfo& info : handlerInfos()) {
    text += fmt::format("  {:<20} {}\n", info.name, info.help);
    if (!info.options.empty()) text += fmt::format("  {:<20}   options: {}\n", "", namesIn(info.options));
    if (!info.alias.empty()) text += fmt::format("  {:<20}   older name: {}\n", "", info.alias);
  }
  return "Handlers, handler.method in a scene, keep a step that is too large for some elements:\n\n" + text +
         "\nTheir options are keys of [handler]: ringwatch help scene\n";
}

std::string formatsText() {
  std::string text = "Mesh formats by the extension of the file:\n\n";
  for (const MeshFormatInfo& info : allMeshFormats())
    text += fmt::format("  {:<17} {:<10} {}: {}\n", info.extensions, info.writes ? "read/write" : "read", info.name,
                        info.help);
  return text;
}
std::string formatNames() {
  std::vector<std::string_view> names;
  for (const MeshFormatInfo& info : allMeshFormats()) names.push_back(info.extensions);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string generatorsText() {
  return "Mesh generators with their parameters, keys of [mesh] in a scene and options of ringwatch mesh "
         "generate:\n\n" +
         generatorHelp();
}

std::string studiesText() { return "Studies that ringwatch verify runs:\n\n" + listing(allStudies()); }

std::string fieldsText(std::span<const OutputField> fields) {
  std::string text;
  for (const OutputField& field : fields)
    text += fmt::format("  {:<39} {}{}\n", field.name, field.unit.empty() ? "" : fmt::format("[{}] ", field.unit),
                        field.help);
  return text;
}

std::string outputsText() {
  return "What a run leaves in its folder.\n\n"
         "history.csv, a row every output.history_every steps; a cell is empty where nothing was computed:\n\n" +
         fieldsText(historyColumns()) +
         "\nprobes.csv, with [[probe]] or output.reactions, a row every output.probe_every steps; step, time_s and the "
         "columns that summary.json lists with their units; a cell is empty where there is no number.\n"
         "\nsummary.json; a key is null where the run has none of it, [] stands for each entry of a list, * for any "
         "key:\n\n" +
         fieldsText(summaryKeys()) +
         "\nframes/*.vtu, listed with their times in run.pvd for ParaView, every output.every seconds:\n\n" +
         fieldsText(frameFields()) +
         "\ncritical_step.png, drawn by gnuplot from critical_step.gp and critical_step.dat: the bracket and the step "
         "along the run. checkpoint.bin, of a run that was stopped or with output.checkpoint_every: what --resume goes "
         "on from. certificates/, with "
         "monitor.certificates: proofs that ringwatch-check verifies.\n";
}

std::string exitStatusText() {
  std::string text = "Exit statuses of every command:\n\n";
  for (const ExitStatusInfo& info : exitStatuses)
    text += fmt::format("  {}  {}\n", static_cast<int>(info.status), info.meaning);
  return text;
}

std::vector<std::string> sceneSectionNames() {
  std::vector<std::string> names;
  for (const SceneSection& section : sceneSections()) names.emplace_back(section.name);
  return names;
}

constexpr std::array<HelpTopic, 13> topics{{
    {"scene", "sections of a scene file; with the name of one, its keys with type, unit, range and default",
     sceneOverview, nullptr, sceneHelp, sceneSectionNames},
    {"together", "what of a scene does not go together, and by whom it is not taken", capabilitiesText, nullptr},
    {"elements", "elements and their quadrature rules", elementsText, [] { return namesIn(allElements()); }},
    {"laws", "constitutive laws", lawsText, [] { return namesIn(allLaws()); }},
    {"integrators", "integrators and their stability limits", integratorsText,
     [] { return namesIn(integratorInfos()); }},
    {"metrics", "metrics of the highest frequency, with the direction that each errs in", metricsText, nullptr},
    {"handlers", "ways to keep a step that is too large for some elements", handlersText,
     [] { return namesIn(handlerInfos()); }},
    {"decks", "keywords of decks of Abaqus, CalculiX and LS-DYNA that run and inspect take", deckHelp, nullptr},
    {"formats", "mesh formats that are read and written", formatsText, formatNames},
    {"generators", "mesh generators and their parameters", generatorsText, [] { return namesIn(allGenerators()); }},
    {"studies", "studies of ringwatch verify", studiesText, [] { return namesIn(allStudies()); }},
    {"outputs", "what a run leaves: columns of history.csv, keys of summary.json, fields of frames", outputsText,
     nullptr},
    {"exit-status", "exit statuses", exitStatusText, nullptr},
}};

}  // namespace

std::span<const HelpTopic> helpTopics() { return topics; }

const HelpTopic* findHelpTopic(std::string_view name) {
  for (const HelpTopic& topic : topics)
    if (topic.name == name) return &topic;
  return nullptr;
}

std::string helpTopicListing() {
  std::string text;
  for (const HelpTopic& topic : topics) {
    text += fmt::format("  {:<12} {}\n", topic.name, topic.help);
    // This program may not know some: the studies are a program of their own.
    if (const std::string names = topic.names != nullptr ? topic.names() : ""; !names.empty())
      text += fmt::format("  {:<12}   {}\n", "", names);
  }
  return text;
}

}  // namespace ringwatch
