// Work against precision: every integrator over a range of steps on (a) an oscillator, (b) a swinging StVK bar, (c) the
// same bar with slivers, against a converged reference; and, as the source's fig. 1.2, the cost of a millisecond of a
// bar as it is refined, explicit against implicit. For scenes of your own: ringwatch compare.
//
//   ringwatch_work_precision [FOLDER] [--quick]
//
// One thread throughout. Writes FOLDER/work_precision.json, a gnuplot script with its data for each picture, and the
// pictures when gnuplot is there. Prints which integrator is cheapest for 1 %, 0.1 % and 1e-6.
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

#include <ringwatch/app/compare.h>
#include <ringwatch/app/integrator_catalog.h>
#include <ringwatch/app/verify.h>
#include <ringwatch/base/atomic_file.h>
#ifdef RINGWATCH_HAS_SUNDIALS
#include <ringwatch/integrators/sundials/implicit.h>
#endif

int main(int argc, char** argv) try {
  using namespace ringwatch;
  std::filesystem::path folder = "work_precision";
  bool quick = false;
  for (int i = 1; i < argc; ++i) (std::string(argv[i]) == "--quick" ? (void)(quick = true) : (void)(folder = argv[i]));
  std::filesystem::create_directories(folder);
  StudyReport report;
  report.study = "work and precision";
  nlohmann::ordered_json results;
  addStandardCases(integratorCatalog().entries(), quick ? 4 : 7, quick ? 0.1 : 0.5, report,
                   [&](const WorkPrecisionCase& c, const std::vector<WorkPrecisionRun>& runs) {
                     results[c.name] = workPrecisionJson(c, runs);
                   });
#ifdef RINGWATCH_HAS_SUNDIALS
  addRefinedBar(
      [] {
        ImplicitOptions options;
        options.linearSolve = LinearSolve::conjugateGradients;
        options.relativeTolerance = options.linearTolerance = 1e-4;
        return std::make_unique<ImplicitEuler>(options);
      },
      quick ? 3 : 6, report);
  results["refinement"] = studiesJson({report})["studies"][report.study]["tables"]["refinement"];
#endif
  std::cout << studyText(report);
  for (const std::string& note : drawFigures(report, folder)) std::cerr << "note: " << note << "\n";
  writeFileAtomically(folder / "work_precision.json", results.dump(1) + "\n");
  return 0;
} catch (const std::exception& fault) {
  std::cerr << fault.what() << "\n";
  return 1;
}
