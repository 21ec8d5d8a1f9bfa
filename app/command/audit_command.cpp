#include <ringwatch/app/analysis/audit.h>
#include <ringwatch/app/command/command.h>
#include <ringwatch/app/scene/scene_keys.h>
#include <ringwatch/base/atomic_file.h>

namespace ringwatch {
namespace {

struct AuditCommand final : Command {
  using Command::Command;
  AuditOptions options;
  JsonOption json;
  std::string page, junit, lumping;

  CLI::App* declare(CLI::App& app) override {
    CLI::App* command =
        app.add_subcommand("audit", "say where a run of another program left proven ground, from its results");
    command
        ->add_option("RESULTS", options.results,
                     "results: CalculiX .frd (text), a .pvd, or .vtu or legacy .vtk files in their order")
        ->required();
    command->add_option("--scene", options.scene, "scene or deck with the mesh, the materials and what is held");
    for (const SceneKey& key : sceneKeys())
      if (key.section == "material" && isLawParameter(key.key))
        command->add_option_function<double>(
            "--" + key.key, [this, name = key.key](double value) { options.parameters.set(name, value); },
            key.help + (key.unit.empty() ? "" : ", " + key.unit));
    command->add_option("--density", options.density, "density, kg/m3");
    command->add_option("--model", options.model, "constitutive law (default: the scene's, else stvk)");
    command->add_option("--displacement", options.displacement,
                        "field of the displacement, m (default: the usual names; without any, the points are taken "
                        "for positions)");
    addTime(*command, "--step", options.step,
            "step that the run took, s (default: what the results tell, else by their times and increments)");
    command->add_option("--integrator", options.integrator,
                        "integrator whose limit counts (default: symplectic-euler)");
    command->add_option("--limit", options.limit, "largest stable h omega of theirs, instead of --integrator");
    command->add_option("--fix", options.fix, "nodes that are held, as with ringwatch inspect; may be given again")
        ->allow_extra_args(false);
    declareMatrices(*command, lumping, options.rules);
    declareUnits(*command, options.units);
    command->add_option("--every", options.every, "every so many states (default: 1)")->check(CLI::Range(1, 1000000));
    command->add_flag("--all", options.all, "a line of the table for every state; --json always has them");
    json.declare(*command, "numbers");
    command->add_option("--report", page, pageHelp)->type_name("FILE");
    command->add_option("--junit", junit, "a test case for each state in JUnit's XML, which CI systems show")
        ->type_name("FILE");
    command->add_option("--threads", options.threads, "threads (default: as many as the mesh can use)")
        ->check(CLI::Range(0, 4096));
    command->footer(
        "Exit status 1 where a step was proven unstable, an element inverted or a state was lost; 3 where some step "
        "was "
        "not proven.\n" +
        seeTopics("laws | integrators | decks") + exitStatusHint);
    return command;
  }

  ExitStatus execute() override {
    std::string written;
    if (!page.empty())
      options.page = [&](const Audit& found) {
        Audit whole = found;
        whole.json = withProvenance(std::move(whole.json), call.typed, options.scene);
        written = reportText(neededReportWriters().ofAudit(whole, page));
      };
    if (!lumping.empty()) options.lumping = lumpingNames.valueOf("--lumping", lumping);
    const AuditResult result = auditResults(options);
    if (!junit.empty()) writeFileAtomically(junit, labelled(junitOfStates(result.json)));
    json.write(result.json, result.text + written);
    return result.status;
  }
};

}  // namespace

std::unique_ptr<Command> auditCommand(const Call& call) { return std::make_unique<AuditCommand>(call); }

}  // namespace ringwatch
