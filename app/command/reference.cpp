#include <ringwatch/app/command/reference.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <ringwatch/app/command/help.h>
#include <ringwatch/app/command/schema.h>
#include <ringwatch/app/command/verify.h>
#include <ringwatch/app/output/exit_status.h>
#include <ringwatch/app/output/output_fields.h>
#include <ringwatch/app/output/report.h>
#include <ringwatch/app/scene/capabilities.h>
#include <ringwatch/app/scene/deck_keywords.h>
#include <ringwatch/app/scene/integrator_catalog.h>
#include <ringwatch/app/scene/probe_quantity.h>
#include <ringwatch/app/scene/scene_keys.h>
#include <ringwatch/app/scene/scene_mesh.h>
#include <ringwatch/base/name_table.h>
#include <ringwatch/body/body.h>
#include <ringwatch/elements/registry.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/materials/registry.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/monitor/metrics/metrics.h>

namespace ringwatch {
namespace {

// ---- the command line

/// An option or positional argument as it was declared.
struct Argument {
  std::vector<std::string> names;  // with dashes; empty for a positional one
  std::string positional;
  std::string value;  // what stands for its value, "" for a flag
  std::string range;  // of the value, "" for any
  std::string help;
  bool required = false, several = false;
};

struct Command {
  std::string path;  // "ringwatch mesh generate"
  std::string help;
  std::vector<Argument> arguments;
  std::vector<std::string> commands;  // names of its subcommands
};

using Commands = std::vector<Command>;

Argument argumentOf(const CLI::Option& option) {
  Argument result;
  for (const std::string& name : option.get_snames()) result.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) result.names.push_back("--" + name);
  if (option.get_positional()) result.positional = option.get_name(true);
  if (option.get_items_expected_max() > 0) {
    result.value = option.get_type_name();
    if (const std::size_t colon = result.value.find(':'); colon != std::string::npos) {
      result.range = result.value.substr(colon + 1);
      result.value.resize(colon);
    }
  }
  result.help = option.get_description();
  result.required = option.get_required();
  result.several = option.get_items_expected_max() > 1;
  return result;
}

void addCommands(const CLI::App& app, const std::string& path, Commands& commands) {
  Command command{path, app.get_description(), {}, {}};
  for (const CLI::Option* option : app.get_options()) command.arguments.push_back(argumentOf(*option));
  const auto inner = app.get_subcommands([](const CLI::App*) { return true; });
  for (const CLI::App* one : inner) command.commands.push_back(one->get_name());
  commands.push_back(std::move(command));
  for (const CLI::App* one : inner) addCommands(*one, path + " " + one->get_name(), commands);
}

Commands commandsOf(const CLI::App& app) {
  Commands commands;
  addCommands(app, app.get_name(), commands);
  return commands;
}

/// "ringwatch run [SCENE] [OPTIONS]"
std::string usageOf(const Command& command) {
  std::string text = command.path;
  for (const Argument& argument : command.arguments)
    if (!argument.positional.empty()) {
      const std::string name = argument.positional + (argument.several ? "..." : "");
      text += argument.required ? " " + name : fmt::format(" [{}]", name);
    }
  if (!command.commands.empty()) text += " COMMAND";
  for (const Argument& argument : command.arguments)
    if (!argument.names.empty() && argument.required)
      text += fmt::format(" {} {}", argument.names.back(), argument.value);
  return text + " [OPTIONS]";
}

/// "-o, --output FILE" or "SCENE"
std::string headOf(const Argument& argument) {
  if (!argument.positional.empty()) return argument.positional;
  return fmt::format("{}{}{}", fmt::join(argument.names, ", "), argument.value.empty() ? "" : " ", argument.value);
}

// ---- pages

std::string cell(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '|' || c == '<' || c == '*') result += '\\';
    result += c == '\n' ? ' ' : c;
  }
  return result;
}
std::string code(std::string_view text) {
  if (text.empty()) return "";
  std::string result = "`";
  for (const char c : text) result += c == '|' ? std::string("\\|") : std::string(1, c);
  return result + "`";
}
std::string codes(const std::vector<std::string>& texts) {
  std::string result;
  for (const std::string& text : texts) result += (result.empty() ? "" : ", ") + code(text);
  return result;
}

class Page {
 public:
  Page(std::string_view title, std::string_view text) : text_(fmt::format("# {}\n\n{}\n", title, text)) {}
  Page& heading(std::string_view title, std::string_view text = {}) {
    text_ += fmt::format("\n## {}\n", title);
    return text.empty() ? *this : paragraph(text);
  }
  Page& paragraph(std::string_view text) {
    text_ += fmt::format("\n{}\n", text);
    return *this;
  }
  Page& table(const std::vector<std::string>& head) {
    text_ += "\n";
    row(head);
    return row(std::vector<std::string>(head.size(), "---"));
  }
  Page& row(const std::vector<std::string>& cells) {
    text_ += "|";
    for (const std::string& one : cells) text_ += one.empty() ? " |" : fmt::format(" {} |", one);
    text_ += "\n";
    return *this;
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

constexpr std::string_view typeName(FieldType type) {
  constexpr auto names = nameTable<FieldType>({{FieldType::number, "number"},
                                               {FieldType::integer, "integer"},
                                               {FieldType::text, "text"},
                                               {FieldType::boolean, "true or false"},
                                               {FieldType::object, "object"},
                                               {FieldType::any, "any"}});
  return names.nameOf(type);
}
constexpr std::string_view presenceName(Presence presence) {
  constexpr auto names = nameTable<Presence>({{Presence::always, ""},
                                              {Presence::orNull, "or null"},
                                              {Presence::sometimes, "may be missing"},
                                              {Presence::sometimesOrNull, "or null, may be missing"}});
  return names.nameOf(presence);
}

void addFields(Page& page, std::span<const OutputField> fields, bool ofJson) {
  page.table(ofJson ? std::vector<std::string>{"key", "type", "unit", "meaning"}
                    : std::vector<std::string>{"name", "unit", "meaning"});
  for (const OutputField& field : fields) {
    std::vector<std::string> cells{code(field.name), std::string(field.unit), cell(field.help)};
    if (ofJson) {
      const std::string_view presence = presenceName(field.presence);
      cells.insert(cells.begin() + 1,
                   fmt::format("{}{}{}", typeName(field.type), presence.empty() ? "" : ", ", presence));
    }
    page.row(cells);
  }
}

std::string commandsPage(const Commands& commands) {
  Page page("Command line", "Every command with its arguments and options. `ringwatch help COMMAND` prints the same.");
  for (const Command& command : commands) {
    page.heading(command.path, cell(command.help) + ".");
    page.paragraph(fmt::format("```text\n{}\n```", usageOf(command)));
    page.table({"argument", "meaning"});
    for (const Argument& argument : command.arguments)
      page.row({code(headOf(argument)),
                cell(fmt::format("{}{}{}", argument.help, argument.range.empty() ? "" : "; ", argument.range))});
  }
  return page.text();
}

std::string rangeOf(const NumberRange& range, std::string_view unit) {
  const std::string text = range.text();
  return cell(fmt::format("{}{}{}", text, text.empty() || unit.empty() ? "" : " ", unit));
}

std::string scenePage(const Commands&) {
  Page page("Scene file",
            "A scene is a TOML file. Any consistent units will do; those that are named here are of the SI. "
            "`ringwatch help scene` prints the same, and `ringwatch schema scene` says it to programs and editors.");
  for (const SceneSection& section : sceneSections()) {
    page.heading(section.head(), fmt::format("{}{}.", cell(section.help), section.required ? "; required" : ""));
    for (const SceneAlternative& one : section.alternatives)
      page.paragraph(
          fmt::format(fmt::runtime(!one.third.empty() && one.need == SceneAlternative::Need::any ? "Give {}, {} or {}."
                                   : !one.third.empty()                      ? "Give one of {}, {} and {}."
                                   : one.need == SceneAlternative::Need::one ? "Give either {} or {}."
                                   : one.need == SceneAlternative::Need::any ? "Give {} or {}, or both."
                                   : one.need == SceneAlternative::Need::atMostOne
                                       ? "Give {} or {}, or neither."
                                       : "Where there are several, give each either {} or {}."),
                      code(one.first), code(one.second), code(one.third)));
    page.table({"key", "type", "range, unit", "default", "meaning"});
    for (const SceneKey& key : section.keys) {
      std::string help = cell(key.help);
      if (!key.choices.empty()) help += "; one of " + codes(key.choices);
      for (const auto& [alias, meant] : key.aliases)
        help += fmt::format("; {} is another name of {}", code(alias), code(meant));
      page.row({code(key.key), std::string(sceneTypeName(key.type)),
                key.range.text().empty() ? key.unit : rangeOf(key.range, key.unit),
                key.required ? "required" : code(key.fallback), help});
    }
  }
  return page.text();
}

std::string historyPage(const Commands&) {
  Page page("Columns of history.csv",
            "A run writes a row every `output.history_every` steps. A cell is empty where nothing was computed.");
  addFields(page, historyColumns(), false);
  page.heading(
      "Columns of probes.csv",
      "With `[[probe]]` or `output.reactions` a run writes a row every `output.probe_every` steps: `step`, "
      "`time_s` and the columns below, which `summary.json` lists with their units. A cell is empty where there "
      "is no number. `NAME` is that of the probe.");
  page.table({"what", "columns", "unit", "as", "meaning"});
  for (const ProbeQuantity& quantity : allProbeQuantities()) {
    std::vector<std::string> as;
    for (const ProbeReduction one : quantity.as) as.emplace_back(probeReductionNames.nameOf(one));
    std::string columns;
    for (const std::string& part : quantity.parts)
      columns += fmt::format("{}`NAME.{}{}{}{}{}`", columns.empty() ? "" : ", ",
                             quantity.kind == ProbeQuantity::Kind::step ? "SIDE_step" : quantity.name,
                             part.empty() ? "" : "_", part, quantity.unit.empty() ? "" : "_", quantity.unit);
    page.row({code(quantity.name), columns, quantity.unit, codes(as), cell(quantity.help)});
  }
  page.row({code("output.reactions"), "`fix.N.reaction_x_N`, `move.N.reaction_x_N`, …", "N", code("sum"),
            "of each `[[fix]]` and `[[move]]`, counted from 0"});
  page.heading("Fields of frames",
               "`frames/*.vtu`, listed with their times in `run.pvd`, every `output.every` seconds, for ParaView.");
  addFields(page, frameFields(), false);
  return page.text();
}

std::string jsonPage(const Commands&) {
  Page page("JSON files",
            "Keys of objects are joined by dots; `[]` stands for each entry of a list, `*` for any key. `ringwatch "
            "schema NAME` prints the JSON Schema of each file.");
  for (const JsonOutput& output : jsonOutputs()) {
    page.heading(output.name, fmt::format("{}.", cell(output.help)));
    addFields(page, output.fields, true);
  }
  return page.text();
}

std::string elementsPage(const Commands&) {
  Page page("Elements",
            "Elements with their quadrature rules, the first of which is the default. Node order is VTK's, of a wedge6 "
            "gmsh's.");
  page.table({"element", "nodes", "order", "VTK cell", "gmsh type"});
  const auto numberIn = [](int type) { return type > 0 ? std::to_string(type) : std::string("none"); };
  for (const ElementInfo& info : allElements())
    page.row({code(info.name), std::to_string(info.nodes), std::to_string(info.order), numberIn(info.vtkCellType),
              numberIn(info.gmshType)});
  page.heading("Quadrature rules", "Chosen by `material.rules` in a scene and by `--rule`.");
  page.table({"element", "rule", "what it is"});
  for (const ElementInfo& info : allElements())
    for (const QuadratureRule& rule : info.rules) page.row({code(info.name), code(rule.name), cell(rule.help)});
  return page.text();
}

void addOptions(Page& page, std::span<const OptionInfo> options) {
  page.table({"name", "range, unit", "default", "meaning"});
  for (const OptionInfo& option : options) {
    std::string help = cell(option.help);
    if (!option.choices.empty()) help += "; one of " + codes({option.choices.begin(), option.choices.end()});
    if (!option.onlyWith.option.empty()) {
      const std::vector<std::string> values(option.onlyWith.values.begin(), option.onlyWith.values.end());
      help += fmt::format("; only with {} {}", code(option.onlyWith.option), codes(values));
    }
    page.row({code(option.name),
              option.range.text().empty() ? std::string(option.unit) : rangeOf(option.range, option.unit),
              option.fallback.empty() ? "required" : code(option.fallback), help});
  }
}

std::string lawsPage(const Commands&) {
  Page page("Laws", "Constitutive laws: `material.model` in a scene and `--model`.");
  const auto yes = [](bool value) { return value ? "yes" : "no"; };
  page.table({"law", "what it is", "objective", "isotropic", "constant tangent", "defined for inverted elements",
              "allows inversion"});
  for (const LawInfo& law : allLaws())
    page.row({code(law.name), cell(law.help), yes(law.objective), yes(law.isotropic), yes(law.tangentIsConstant),
              yes(law.definedInverted), yes(law.allowsInversion)});
  for (const LawInfo& law : allLaws()) {
    page.heading(law.name, "Its parameters:");
    addOptions(page, law.parameters);
  }
  return page.text();
}

std::string integratorsPage(const Commands&) {
  Page page("Integrators",
            "`integrator.method` in a scene and `--integrator`. The limit is the largest stable h·ω without damping. "
            "[Integrators](../integrators.md) tells which to take.");
  page.table({"integrator", "what it is", "order", "forces a step", "limit of h·ω", "symplectic", "reversible"});
  for (const IntegratorInfo& info : integratorInfos())
    page.row({code(info.name), cell(info.help), std::to_string(info.order),
              info.forceEvaluations > 0 ? std::to_string(info.forceEvaluations) : std::string("varies"),
              std::isinf(info.imaginaryLimit) ? std::string("none: stable at every step")
              : info.imaginaryLimit > 0       ? fmt::format("{:.6g}", info.imaginaryLimit)
                                              : std::string("0: stable at no step"),
              info.symplectic ? "yes" : "no", info.reversible ? "yes" : "no"});
  return page.text();
}

std::string metricsPage(const Commands&) {
  Page page("Metrics",
            "Estimates of the highest frequency: `monitor.metric` in a scene and `--metric`. An upper bound of the "
            "frequency gives a safe step, a lower bound a step that is proven too large.");
  page.table({"metric", "what it is", "frequency"});
  for (const MetricInfo& info : allMetrics())
    page.row({code(info.name), cell(info.help), std::string(directionName(info.direction))});
  return page.text();
}

std::string handlersPage(const Commands&) {
  Page page("Handlers",
            "`handler.method` in a scene: ways to keep a step that is too large for some elements. "
            "[A few bad elements](../handlers.md) tells what they cost. The keys that all of them take are in the "
            "[scene file](scene.md).");
  page.table({"handler", "what it does", "other name", "adds mass"});
  for (const HandlerEntry& entry : allHandlers())
    page.row(
        {code(entry.info->name), cell(entry.info->help), code(entry.info->alias), entry.info->addsMass ? "yes" : "no"});
  for (const HandlerEntry& entry : allHandlers()) {
    if (entry.info->options.empty()) continue;
    page.heading(entry.info->name, "Its own keys of `[handler]`:");
    addOptions(page, entry.info->options);
  }
  return page.text();
}

std::string formatsPage(const Commands&) {
  Page page("Mesh formats", "By the extension of the file.");
  page.table({"extension", "format", "read", "written", "what it holds"});
  for (const MeshFormatInfo& info : allMeshFormats())
    page.row({code(info.extensions), cell(info.name), "yes", info.writes ? "yes" : "no", cell(info.help)});
  return page.text();
}

std::string generatorsPage(const Commands&) {
  Page page(
      "Mesh generators",
      "`mesh.generate` in a scene and `ringwatch mesh generate KIND`; parameters are keys of `[mesh]` and options "
      "of the command.");
  for (const GeneratorInfo& generator : allGenerators()) {
    page.heading(generator.name, cell(generator.help) + ".");
    page.table({"parameter", "range", "unit", "meaning"});
    for (const GeneratorParameter& p : generator.parameters)
      page.row({code(p.name), cell(parameterRange(p)), std::string(p.unit), cell(p.help)});
  }
  return page.text();
}

std::string decksPage(const Commands&) {
  Page page("Keywords of decks",
            "What is done with each keyword of Abaqus, CalculiX and LS-DYNA; `ringwatch help decks` prints the same.");
  page.paragraph("```text\n" + deckHelp() + "```");
  return page.text();
}

std::string capabilitiesPage(const Commands&) {
  Page page("What goes together",
            "`ringwatch help together` prints the same, and `ringwatch schema scene` has it as data.");
  page.paragraph("```text\n" + capabilitiesText() + "```");
  return page.text();
}

std::string studiesPage(const Commands&) {
  Page page("Studies", "What `ringwatch verify STUDY` runs; `ringwatch verify all` runs them all.");
  page.table({"study", "what it measures", "former name"});
  for (const StudyInfo& study : allStudies()) page.row({code(study.name), cell(study.help), code(study.formerName)});
  return page.text();
}

std::string exitStatusPage(const Commands&) {
  Page page("Exit statuses", "Of every command.");
  page.table({"status", "meaning"});
  for (const ExitStatusInfo& info : exitStatuses)
    page.row({std::to_string(static_cast<int>(info.status)), cell(info.meaning)});
  return page.text();
}

struct NamedPage {
  std::string_view file, title, help;
  std::string (*text)(const Commands& commands);
};

constexpr NamedPage pages[] = {
    {"commands", "Command line", "commands, arguments and options", commandsPage},
    {"scene", "Scene file", "sections and keys with type, range, unit and default", scenePage},
    {"together", "What goes together", "what of a scene does not, and why", capabilitiesPage},
    {"history", "History and frames", "columns of history.csv, fields of frames", historyPage},
    {"json", "JSON files", "keys of summary.json and of what `--json` writes", jsonPage},
    {"elements", "Elements", "elements and quadrature rules", elementsPage},
    {"laws", "Laws", "constitutive laws and their parameters", lawsPage},
    {"integrators", "Integrators", "order, cost and stability limit", integratorsPage},
    {"metrics", "Metrics", "metrics and the direction that each errs in", metricsPage},
    {"handlers", "Handlers", "handlers and their own keys", handlersPage},
    {"formats", "Mesh formats", "what is read and written", formatsPage},
    {"decks", "Keywords of decks", "what is done with each keyword of Abaqus, CalculiX and LS-DYNA", decksPage},
    {"generators", "Mesh generators", "kinds of generated meshes and their parameters", generatorsPage},
    {"studies", "Studies", "what `ringwatch verify` runs", studiesPage},
    {"exit_status", "Exit statuses", "of every command", exitStatusPage},
};

std::string indexPage() {
  Page page(
      "Reference",
      "Made from the program's own tables by `scripts/reference`; a test compares these pages with the program, so "
      "change the tables and not the pages.");
  page.table({"page", "what it lists"});
  for (const NamedPage& one : pages) page.row({fmt::format("[{}]({}.md)", one.title, one.file), std::string(one.help)});
  return page.text();
}

// ---- manual page

/// Text of roff: no character of it is a request.
std::string roff(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else if (c == '\n')
      result += ' ';
    else
      result += c;
  }
  return result.starts_with('.') || result.starts_with('\'') ? "\\&" + result : result;
}

std::string manualPage(const Commands& commands) {
  std::string text = fmt::format(".TH RINGWATCH 1 \"\" \"ringwatch {}\" \"User Commands\"\n", programVersion());
  text += ".SH NAME\nringwatch \\- watch the stability of explicit finite element runs\n.SH SYNOPSIS\n.nf\n";
  for (const Command& command : commands)
    if (command.commands.empty()) text += roff(usageOf(command)) + "\n";
  text += ".fi\n.SH DESCRIPTION\n" + roff(commands.front().help) + ".\n.PP\n" + roff(unitsText) + "\n.SH COMMANDS\n";
  for (const Command& command : commands) {
    text += fmt::format(".SS {}\n{}.\n", roff(command.path), roff(command.help));
    for (const Argument& argument : command.arguments)
      text += fmt::format(".TP\n.B {}\n{}{}{}\n", roff(headOf(argument)), roff(argument.help),
                          argument.range.empty() ? "" : "; ", roff(argument.range));
  }
  text += ".SH TOPICS OF RINGWATCH HELP\n";
  for (const HelpTopic& topic : helpTopics())
    text += fmt::format(".TP\n.B {}\n{}\n", roff(topic.name), roff(topic.help));
  text += ".SH EXIT STATUS\n";
  for (const ExitStatusInfo& info : exitStatuses)
    text += fmt::format(".TP\n.B {}\n{}\n", static_cast<int>(info.status), roff(info.meaning));
  return text;
}

// ---- completion

std::vector<std::string> valuesOf(const std::string& kind, bool& files) {
  files = false;
  for (const ArgumentKind& known : argumentKinds()) {
    if (known.name != kind) continue;
    files = known.values == nullptr;
    return known.values != nullptr ? known.values() : std::vector<std::string>{};
  }
  return {};
}

std::string bashCompletion(const Commands& commands) {
  std::string text =
      "# Completion of ringwatch for bash, made by ringwatch reference.\n"
      "_ringwatch() {\n"
      "  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} command=ringwatch word\n"
      "  for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n"
      "    case \"$command $word\" in\n";
  for (const Command& command : commands)
    if (&command != &commands.front()) text += fmt::format("      \"{}\") command+=\" $word\" ;;\n", command.path);
  text +=
      "    esac\n"
      "  done\n"
      "  local options= values= files= taken=\n"
      "  case $command in\n";
  for (const Command& command : commands) {
    std::string options, positional, cases;
    bool positionalFiles = false;
    for (const std::string& name : command.commands) positional += " " + name;
    for (const Argument& argument : command.arguments) {
      bool files = false;
      const std::vector<std::string> values = valuesOf(argument.value, files);
      if (!argument.positional.empty()) {
        positional += fmt::format("{}{}", values.empty() ? "" : " ", fmt::join(values, " "));
        positionalFiles = positionalFiles || files;
        continue;
      }
      for (const std::string& name : argument.names) options += " " + name;
      if (!argument.value.empty())
        cases += fmt::format("        {}) taken=1 values='{}' files={} ;;\n", fmt::join(argument.names, "|"),
                             fmt::join(values, " "), files ? "1" : "");
    }
    text += fmt::format("    \"{}\")\n      options='{}' values='{}' files={}\n", command.path,
                        options.empty() ? options : options.substr(1),
                        positional.empty() ? positional : positional.substr(1), positionalFiles ? "1" : "");
    if (!cases.empty()) text += "      case $previous in\n" + cases + "      esac\n";
    text += "      ;;\n";
  }
  return text +
         "  esac\n"
         "  [[ $current == -* && ! $taken ]] && values=$options files=\n"
         "  mapfile -t COMPREPLY < <(compgen -W \"$values\" -- \"$current\")\n"
         "  if [[ $files ]]; then\n"
         "    compopt -o filenames 2>/dev/null\n"
         "    mapfile -t -O \"${#COMPREPLY[@]}\" COMPREPLY < <(compgen -f -- \"$current\")\n"
         "  fi\n"
         "}\n"
         "complete -F _ringwatch ringwatch\n";
}

/// A text inside of a '…[…]:…' of _arguments.
std::string zshText(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'')
      result += "'\\''";
    else if (c == '[' || c == ']' || c == ':' || c == '\\')
      result += std::string("\\") + c;
    else
      result += c == '\n' ? ' ' : c;
  }
  return result;
}

std::string zshAction(const Argument& argument) {
  bool files = false;
  const std::vector<std::string> values = valuesOf(argument.value, files);
  return files ? "_files" : values.empty() ? " " : fmt::format("({})", fmt::join(values, " "));
}

std::string zshFunctionOf(std::string path) {
  std::ranges::replace(path, ' ', '_');
  return "_" + path;
}

std::string zshCompletion(const Commands& commands) {
  std::string text = "#compdef ringwatch\n# Completion of ringwatch for zsh, made by ringwatch reference.\n";
  for (const Command& command : commands) {
    text += fmt::format("\n{}() {{\n", zshFunctionOf(command.path));
    std::string specifications;
    for (const Argument& argument : command.arguments) {
      if (!argument.positional.empty()) {
        specifications += fmt::format(" \\\n    '{}:{}:{}'",
                                      argument.several    ? "*"
                                      : argument.required ? ""
                                                          : ":",
                                      zshText(argument.positional), zshAction(argument));
        continue;
      }
      for (const std::string& name : argument.names)
        specifications += fmt::format(
            " \\\n    '*{}[{}]{}'", name, zshText(argument.help),
            argument.value.empty() ? "" : fmt::format(":{}:{}", zshText(argument.value), zshAction(argument)));
    }
    if (command.commands.empty()) {
      text += "  _arguments" + specifications + "\n}\n";
      continue;
    }
    text += "  local state line\n  _arguments -C" + specifications +
            fmt::format(
                " \\\n    '1:command:({})' \\\n    '*::argument:->inner'\n  [[ $state == inner ]] || return\n  "
                "case $line[1] in\n",
                fmt::join(command.commands, " "));
    for (const std::string& name : command.commands)
      text += fmt::format("    {}) {} ;;\n", name, zshFunctionOf(command.path + " " + name));
    text += "  esac\n}\n";
  }
  return text + "\n_ringwatch \"$@\"\n";
}

// ---- kinds of arguments

template <class Table>
std::vector<std::string> namesOf(const Table& table) {
  std::vector<std::string> names;
  for (const auto& entry : table) names.emplace_back(entry.name);
  return names;
}
std::vector<std::string> withAll(std::vector<std::string> names) {
  names.emplace_back("all");
  return names;
}
std::vector<std::string> handlerNames() {
  std::vector<std::string> names;
  for (const HandlerEntry& entry : allHandlers()) names.emplace_back(entry.info->name);
  return names;
}

const ArgumentKind kinds[] = {
    {"FILE", nullptr},
    {"DIR", nullptr},
    {"MESH", nullptr},
    {"SCENE", nullptr},
    {"INTEGRATOR", [] { return namesOf(integratorInfos()); }},
    {"INTEGRATORS", [] { return withAll(namesOf(integratorInfos())); }},
    {"HANDLERS", [] { return withAll(handlerNames()); }},
    {"LAW", [] { return namesOf(allLaws()); }},
    {"LUMPING", [] { return lumpingNames.names(); }},
    {"METRICS", [] { return withAll(namesOf(allMetrics())); }},
    {"KIND", [] { return generatorNames(); }},
    {"STUDY", [] { return withAll(namesOf(allStudies())); }},
    {"TOPIC", [] { return namesOf(helpTopics()); }},
    {"SCHEMA", [] { return namesOf(allSchemas()); }},
};

}  // namespace

std::span<const ArgumentKind> argumentKinds() { return kinds; }

std::vector<ReferenceFile> referenceFiles(const CLI::App& app) {
  const Commands commands = commandsOf(app);
  const std::filesystem::path folder = "doc/ringwatch/reference";
  std::vector<ReferenceFile> files{{folder / "README.md", indexPage()}};
  for (const NamedPage& page : pages) files.push_back({folder / fmt::format("{}.md", page.file), page.text(commands)});
  for (const SchemaInfo& schema : allSchemas())
    files.push_back({folder / fmt::format("{}.schema.json", schema.name), schemaOf(schema.name).dump(1) + "\n"});
  files.push_back({"man/man1/ringwatch.1", manualPage(commands)});
  files.push_back({"bash-completion/completions/ringwatch", bashCompletion(commands)});
  files.push_back({"zsh/site-functions/_ringwatch", zshCompletion(commands)});
  return files;
}

}  // namespace ringwatch
