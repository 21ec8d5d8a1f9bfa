#include <ringwatch/app/analysis/inspect.h>
#include <ringwatch/app/command/command.h>
#include <ringwatch/app/ranks/rank_program.h>
#include <ringwatch/app/scene/number_text.h>
#include <ringwatch/app/scene/scene_keys.h>
#include <ringwatch/integrators/integrator.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/monitor/metrics/metrics.h>

namespace ringwatch {
namespace {

struct InspectCommand final : Command {
  using Command::Command;
  InspectOptions options;
  JsonOption json;
  std::string picture, vtu, lumping, certificate, page, stretch;
  std::string ranksWanted = "auto";

  CLI::App* declare(CLI::App& app) override {
    CLI::App* command = app.add_subcommand("inspect", "report the steps that a mesh can take, and what limits them");
    command
        ->add_option("MESH", options.mesh,
                     "mesh file: " + readableExtensions() + "; a MuJoCo model, .xml; or the folder of a run")
        ->required()
        ->type_name("MESH");
    for (const SceneKey& key : sceneKeys())
      if (key.section == "material" && isLawParameter(key.key))
        command->add_option_function<double>(
            "--" + key.key, [this, name = key.key](double value) { options.parameters.set(name, value); },
            fmt::format("{}{}{}{}{}", key.help, key.unit.empty() ? "" : ", ", key.unit,
                        key.range.text().empty() ? "" : ", ", key.range.text()));
    command->add_option("--density", options.density,
                        "density, kg/m3; it and the parameters of the law are required with a mesh file");
    command
        ->add_option("--model", options.model,
                     fmt::format("constitutive law (default: {})", InspectOptions::usualModel))
        ->type_name("LAW");
    command->add_flag("--repair", options.repair, "mend the mesh first, as ringwatch mesh repair does");
    command
        ->add_option("--displacement", options.displacement,
                     "field of displacements, m, in a .vtu or .vtk file: inspect that deformed state")
        ->type_name("FIELD");
    command->add_option("--frame", options.frame,
                        "inspect this frame of a run, counted from 1; material, supports, integrator and damping are "
                        "those of its scene unless given");
    command
        ->add_option(
            "--integrator", options.integrator,
            fmt::format("integrator whose stability limit counts (default: {})", InspectOptions::usualIntegrator))
        ->type_name("INTEGRATOR");
    declareMatrices(*command, lumping, options.rules);
    declareUnits(*command, options.units);
    addTime(*command, "--step", options.step,
            "list the elements that need a smaller step than this, s, and count what a handler would take");
    command->add_option("--metric", options.metrics, "metrics, separated by commas, or all")
        ->type_name("METRICS")
        ->delimiter(',')
        ->allow_extra_args(false);
    command
        ->add_option(
            "--fix", options.fix,
            "nodes that are held, by a condition or set:NAME, and behind a colon the components: \"x < 1e-6\", "
            "\"set:left:x\"; may be given again")
        ->type_name("CONDITION")
        ->allow_extra_args(false);
    command->add_flag("--global", options.global, "also the exact critical step, by a global eigenvalue");
    command->add_option("--width", options.width,
                        "optimistic over safe step, less 1, that is narrow enough (default: 0.01); more is faster");
    command->add_option("--lanczos", options.lanczos,
                        "also a step that is safe but for this probability, e.g. 1e-9, within 1 %, by Lanczos");
    command->add_flag("--exact", options.exact,
                      "also the critical step between two proven sides, 1e-6 apart where rounding allows, by a sparse "
                      "factorisation; says on a terminal what that takes");
    command->add_option("--stretch", stretch,
                        "a:b, also a step that is proven for every state whose stretches stay between these two, "
                        "e.g. 0.7:1.5");
    addTime(*command, "--prove", options.prove,
            "prove that this step, s, is stable, by a sparse factorisation; exit status 1 when it is proven "
            "unstable, 3 when neither is proven");
    json.declare(*command, "numbers");
    command->add_flag("--distribution", options.distribution,
                      "histogram and cumulative share of the elements' steps by metric; the ten worst elements");
    command->add_option("--picture", picture, "draw the distribution into this file, .svg or .png")->type_name("FILE");
    command->add_option("--vtu", vtu, "write the mesh with the steps by each metric for ParaView")->type_name("FILE");
    command
        ->add_option("--certificate", certificate,
                     "write a proof that ringwatch-check can check: of the bracket by the nodal bound, or of what "
                     "--exact or --prove finds")
        ->type_name("FILE");
    command->add_option("--report", page, pageHelp)->type_name("FILE");
    command->add_option("--threads", options.threads, "threads (default: as many as the mesh has work for)")
        ->check(CLI::Range(0, 4096));
    declareRanks(*command, ranksWanted);
    command->footer(std::string(unitsText) + "\n" + seeTopics("laws | integrators | metrics | formats") +
                    exitStatusHint);
    return command;
  }

  ExitStatus execute() override {
    if (!vtu.empty()) options.vtu = vtu;
    if (!certificate.empty()) options.certificate = certificate;
    if (!stretch.empty()) options.stretch = parseStretchRange(stretch, "--stretch");
    if (!picture.empty()) options.picture = picture;
    if (!lumping.empty()) options.lumping = lumpingNames.valueOf("--lumping", lumping);
    std::string written;
    if (!page.empty())
      options.page = [&](const Inspection& found) {
        Inspection whole = found;
        whole.json = withProvenance(std::move(whole.json), call.typed, "");
        written = reportText(neededReportWriters().ofInspection(whole, page));
      };
    InspectResult result = call.ranks ? call.ranks->inspect(options) : inspectMesh(options);
    result.text += written;
    if (call.ranks && !call.ranks->speaks()) return result.status;
    json.write(result.json, result.text);
    return result.failure.empty() ? result.status : complain(result.failure, ExitStatus::unstable);
  }
};

}  // namespace

std::unique_ptr<Command> inspectCommand(const Call& call) { return std::make_unique<InspectCommand>(call); }

}  // namespace ringwatch
