#include <ringwatch/verify/remeshing/remeshing.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include <Eigen/Geometry>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/meshes/adjacency.h>
#include <ringwatch/meshes/modify/cut.h>
#include <ringwatch/meshes/quality.h>
#include <ringwatch/monitor/critical_step.h>
#include <ringwatch/verify/processor_time.h>
#include <ringwatch/verify/remeshing/mesh_programs.h>
#include <ringwatch/verify/remeshing/surfaces.h>
#include <ringwatch/verify/study_bodies.h>

namespace ringwatch {
namespace {

using Cell = StudyTable::Cell;
using Eigen::Vector3d;

using namespace detail;

constexpr double ownShare = 0.95;  // of a critical step, that runs take

Body bodyFrom(Mesh mesh) {
  return {std::move(mesh), makeMaterial("corotational", young, poisson, density), {{}, Lumping::rowSum, 1}};
}

/// A way to mesh a surface.
struct Mesher {
  std::string name;
  std::function<ProgramMesh(const TriangleSurface&)> mesh;
};

/// Volume of a regular tetrahedron with the mean edge of a surface, m³.
double evenVolume(const TriangleSurface& surface) { return std::pow(meanEdge(surface), 3) / (6 * std::sqrt(2.0)); }

std::vector<Mesher> allMeshers() {
  std::vector<Mesher> meshers;
  for (const char* switches : {"-p", "-pY", "-pq", "-pqY"})
    meshers.push_back({std::string("tetgen ") + switches,
                       [switches](const TriangleSurface& surface) { return meshByTetgen(surface, switches); }});
  for (const char* switches : {"-pq", "-pqY"})
    meshers.push_back({std::string("tetgen ") + switches + "a", [switches](const TriangleSurface& surface) {
                         return meshByTetgen(surface, switches, evenVolume(surface));
                       }});
  meshers.push_back({"gmsh", [](const TriangleSurface& s) { return meshByGmsh(s, GmshOptimizer::none); }});
  meshers.push_back({"gmsh -optimize", [](const TriangleSurface& s) { return meshByGmsh(s, GmshOptimizer::own); }});
  meshers.push_back(
      {"gmsh -optimize_netgen", [](const TriangleSurface& s) { return meshByGmsh(s, GmshOptimizer::netgen); }});
  return meshers;
}

/// What the shapes of a mesh's elements come to.
struct Shapes {
  double leastDihedral = 180, largestDihedral = 0, largestRadiusEdge = 0;
  std::vector<ElementRef> bad;  // needles, wedges, spindles, slivers and caps
};
Shapes shapesOf(const Mesh& mesh) {
  Shapes shapes;
  const MeshBlock& block = mesh.blocks.front();
  for (std::size_t e = 0; e < block.elementCount(); ++e) {
    const ElementShape shape = elementShape(block, e, mesh.X, 0);
    shapes.leastDihedral = std::min(shapes.leastDihedral, shape.minDihedral);
    shapes.largestDihedral = std::max(shapes.largestDihedral, shape.maxDihedral);
    if (shape.shape != ShapeClass::round && shape.shape != ShapeClass::small) shapes.bad.emplace_back(0, e);
    const std::int32_t* const n = block.element(e);
    const Vector3d a = mesh.X.col(n[1]) - mesh.X.col(n[0]), b = mesh.X.col(n[2]) - mesh.X.col(n[0]),
                   c = mesh.X.col(n[3]) - mesh.X.col(n[0]);
    const double radius =
        (a.squaredNorm() * b.cross(c) + b.squaredNorm() * c.cross(a) + c.squaredNorm() * a.cross(b)).norm() /
        (2 * std::abs(a.dot(b.cross(c))));
    const double shortest = std::min({a.norm(), b.norm(), c.norm(), (b - a).norm(), (c - a).norm(), (c - b).norm()});
    shapes.largestRadiusEdge = std::max(shapes.largestRadiusEdge, radius / shortest);
  }
  return shapes;
}

/// A free body that is stretched along its axes at the start, and swings.
struct Swing {
  double end;                         // s
  static constexpr int moments = 8;   // at which positions are compared
  static constexpr double rate = 10;  // 1/s, of the stretch along x
  static NodeVectors velocities(const NodeVectors& X) { return Vector3d(rate, -rate / 2, -rate / 2).asDiagonal() * X; }
  std::int64_t stepsFor(double h) const {
    return moments * static_cast<std::int64_t>(std::ceil(end / (moments * h) - 1e-9));
  }
};

struct Swung {
  std::vector<NodeVectors> x;  // of the watched nodes, by moment
  double step = 0, seconds = 0;
  std::string lost;
};
Swung swing(const Swing& motion, const Body& body, Integrator& integrator, double h,
            const std::vector<std::int32_t>& watched) {
  BodySystem system(body);
  State state = system.initialState();
  state.v = Swing::velocities(body.mesh().X);
  const std::int64_t steps = motion.stepsFor(h);
  Swung result;
  result.step = motion.end / static_cast<double>(steps);
  for (int k = 0; k < Swing::moments && result.lost.empty(); ++k) {
    const double begin = processorSeconds();
    for (std::int64_t i = 0; i < steps / Swing::moments && result.lost.empty(); ++i)
      result.lost = integrator.step(system, state, result.step).reason;
    result.seconds += processorSeconds() - begin;
    if (result.lost.empty() && !state.x.allFinite()) result.lost = "positions are not finite";
    NodeVectors at(3, static_cast<Eigen::Index>(watched.size()));
    for (std::size_t n = 0; n < watched.size(); ++n) at.col(static_cast<Eigen::Index>(n)) = state.x.col(watched[n]);
    result.x.push_back(std::move(at));
  }
  return result;
}

/// The nodes of a mesh where a surface has its own. Throws NumericalError where one is missing.
std::vector<std::int32_t> nodesAt(const Mesh& mesh, const TriangleSurface& surface) {
  std::vector<std::int32_t> nodes;
  const double near = 1e-9 * meanEdge(surface);
  for (Eigen::Index n = 0; n < surface.X.cols(); ++n) {
    Eigen::Index at = n;
    if (n >= mesh.X.cols() || (mesh.X.col(n) - surface.X.col(n)).norm() > near)
      (mesh.X.colwise() - surface.X.col(n)).colwise().squaredNorm().minCoeff(&at);
    if ((mesh.X.col(at) - surface.X.col(n)).norm() > near)
      throw NumericalError(joinText("remeshing: node ", n, " of the surface is none of the mesh"));
    nodes.push_back(static_cast<std::int32_t>(at));
  }
  return nodes;
}

double stepOf(double lambda) { return verletLimit / std::sqrt(lambda); }

/// A limit in the quick and in the full form; each within three times what was measured.
struct Allowed {
  double quick, full;
  double in(StudyEffort effort) const { return effort == StudyEffort::full ? full : quick; }
};
constexpr double volumeTolerance = 1e-12;     // of sums over thousands of elements, of numbers with 16 or 17 digits
constexpr double cutVolumeTolerance = 4e-7;   // where TetGen takes nodes of small triangles as one
constexpr double provenTolerance = 0.025;     // that the proven step is shorter than the exact one
constexpr Allowed fineEnough{0.2, 0.2};       // error of plain runs in meshes with a volume bound, of the displacement
constexpr Allowed handledError{0.02, 0.025};  // what imex and local-time-stepping add to that of the mesh

class RemeshingStudy {
 public:
  explicit RemeshingStudy(StudyEffort effort) : effort_(effort), full_(effort == StudyEffort::full) {
    report_.study = "remeshing";
  }

  StudyReport make() {
    constexpr int level = 3;
    const std::size_t nodes = full_ ? 160 : 100;
    for (const auto& [name, surface] :
         {std::pair{"bumpy ball", bumpyBall(level, nodes, 1)}, std::pair{"jack", jack(level, nodes, 2)}}) {
      meshAll(name, surface);
      cutAll(name, surface);
    }
    addSourceRows();
    for (StudyTable* table : {&meshes_, &runs_, &cutSteps_, &cutTimes_, &skipped_})
      if (!table->rows.empty()) report_.tables.push_back(std::move(*table));
    return std::move(report_);
  }

 private:
  std::int64_t count(std::size_t n) { return static_cast<std::int64_t>(n); }
  void skip(const std::string& body, const std::string& mesher, const std::string& why) {
    skipped_.rows.push_back({body, mesher, why});
  }

  void meshAll(const std::string& name, const TriangleSurface& surface) {
    const Swing motion{full_ ? 0.03 : 0.02};
    const std::vector<NodeVectors> reference = fineMotion(name, surface, motion);
    for (const Mesher& mesher : allMeshers()) {
      const ProgramMesh made = mesher.mesh(surface);
      if (!made.mesh) {
        skip(name, mesher.name, made.note);
        continue;
      }
      const Body body = bodyFrom(*made.mesh);
      const Shapes shapes = shapesOf(body.mesh());
      const double safe = criticalStep(body, body.mesh().X, verletLimit).safe,
                   exact = stepOf(highestEigenvalue(body, 1e-8));
      const std::string what = joinText(name, ", ", mesher.name);
      meshes_.rows.push_back({name, mesher.name, count(surface.triangles.size()), count(body.mesh().elementCount()),
                              count(body.mesh().nodeCount()), shapes.leastDihedral, shapes.largestDihedral,
                              shapes.largestRadiusEdge, count(shapes.bad.size()), 1e3 * safe, 1e3 * exact,
                              made.seconds});
      checkNear(report_, what + ": volume over that of the surface", meshVolume(body.mesh()) / enclosedVolume(surface),
                1, volumeTolerance);
      checkSteps(what, safe, exact);
      if (!reference.empty())
        runAll(name, mesher.name, body, shapes, motion, safe, nodesAt(body.mesh(), surface), reference);
    }
  }

  void checkSteps(const std::string& what, double safe, double exact) {
    checkAtMost(report_, what + ": proven step over the exact one", safe / exact, 1, 0);
    checkAtLeast(report_, what + ": proven step over the exact one, from below", safe / exact, 1, provenTolerance);
  }

  /// The surface's nodes in a mesh of many small elements; empty without TetGen.
  std::vector<NodeVectors> fineMotion(const std::string& name, const TriangleSurface& surface, const Swing& motion) {
    const ProgramMesh made = meshByTetgen(surface, "-pq1.4", evenVolume(surface) / (full_ ? 16 : 12));
    if (!made.mesh) {
      skip(name, "runs, which are compared with a fine mesh of TetGen's", made.note);
      return {};
    }
    const Body body = bodyFrom(*made.mesh);
    const double safe = criticalStep(body, body.mesh().X, verletLimit).safe;
    const Swung fine = swing(motion, body, *makeIntegrator("verlet"), ownShare * safe, nodesAt(body.mesh(), surface));
    if (!fine.lost.empty()) throw NumericalError("remeshing, fine mesh: " + fine.lost);
    runs_.rows.push_back({name, std::string("fine mesh, to compare with"), std::string("none"),
                          count(body.mesh().elementCount()), std::int64_t{0}, 1e3 * fine.step, Cell(""),
                          fine.seconds / motion.end, Cell("")});
    return fine.x;
  }

  void runAll(const std::string& name, const std::string& mesher, const Body& body, const Shapes& shapes,
              const Swing& motion, double safe, const std::vector<std::int32_t>& watched,
              const std::vector<NodeVectors>& reference) {
    NodeVectors start(3, static_cast<Eigen::Index>(watched.size()));
    for (std::size_t n = 0; n < watched.size(); ++n)
      start.col(static_cast<Eigen::Index>(n)) = body.mesh().X.col(watched[n]);
    const auto errorOf = [&](const Swung& swung) {
      double largest = 0, error = 0;
      for (std::size_t k = 0; k < reference.size(); ++k) {
        largest = std::max(largest, (reference[k] - start).norm());
        error = std::max(error, (swung.x[k] - reference[k]).norm());
      }
      return error / largest;
    };
    double plainSeconds = 0;
    const auto add = [&](const std::string& handler, const Swung& swung, std::size_t handled) {
      const bool lost = !swung.lost.empty();
      runs_.rows.push_back({name, mesher, handler, count(body.mesh().elementCount()), count(handled), 1e3 * swung.step,
                            lost ? Cell(swung.lost) : Cell(100 * errorOf(swung)), swung.seconds / motion.end,
                            plainSeconds > 0 ? Cell(swung.seconds / plainSeconds) : Cell("")});
      return lost ? infinity : errorOf(swung);
    };
    const Swung plain = swing(motion, body, *makeIntegrator("verlet"), ownShare * safe, watched);
    plainSeconds = plain.seconds;
    const double plainError = add("none", plain, 0);
    if (mesher == "tetgen -pqa")
      checkBelow(report_, joinText(name, ", ", mesher, ", plain: error"), plainError, fineEnough.in(effort_));

    ElementFlags good = noElements(body.mesh());
    for (const ElementRef e : shapes.bad) good[e.block][e.element] = true;
    if (shapes.bad.empty() || shapes.bad.size() == body.mesh().elementCount()) return;
    const Body rest(body, complement(std::move(good)));
    const double h = ownShare * criticalStep(rest, body.mesh().X, verletLimit).safe;
    constexpr double worthIt = 1.05;
    if (h < worthIt * ownShare * safe) return;
    for (const HandlerEntry& entry : allHandlers()) {
      const std::string handlerName(entry.info->name);
      Body own = bodyFrom(body.mesh());
      const auto handler = makeHandler(handlerName, own, makeIntegrator("verlet"));
      const double step = motion.end / static_cast<double>(motion.stepsFor(h));
      handler->prepare(own.mesh().X, step);
      const double error = add(handlerName, swing(motion, own, *handler, step, watched), handler->elements().size());
      if (handlerName == "imex" || handlerName == "local-time-stepping")
        checkBelow(report_, joinText(name, ", ", mesher, ", ", handlerName, ": error beyond that of plain"),
                   std::abs(error - plainError), handledError.in(effort_));
    }
  }

  // Cuts, Fierz 2013's section 1.2.

  static std::array<CutSurface, 4> fourCuts(const Mesh& mesh) {
    const Vector3d low = mesh.X.rowwise().minCoeff(), size = Vector3d(mesh.X.rowwise().maxCoeff()) - low;
    const auto at = [&](double x, double y, double z) { return Vector3d(low + size.cwiseProduct(Vector3d(x, y, z))); };
    return {CutSurface::plane(at(0.5, 0.5, 0.5), {1, 0.2, 0.1}), CutSurface::plane(at(0.3, 0.5, 0.5), {1, -0.5, 0.3}),
            CutSurface::plane(at(0.5, 0.45, 0.5), {0.1, 1, 0.2}), CutSurface::plane(at(0.7, 0.5, 0.6), {0.6, 0.1, 1})};
  }

  /// The pieces of a cut mesh, each meshed anew from its surface.
  static ProgramMesh partsAnew(const Mesh& mesh, ProgramMesh (*mesher)(const TriangleSurface&)) {
    const MeshParts parts = connectedParts(mesh);
    ProgramMesh all;
    all.mesh.emplace();
    all.mesh->blocks.push_back({ringwatch::elementTypeOf<Tet4>, {}, {}});
    for (std::int32_t part = 0; part < parts.count; ++part) {
      Mesh piece;
      piece.X = mesh.X;
      piece.blocks.push_back({ringwatch::elementTypeOf<Tet4>, {}, {}});
      const MeshBlock& block = mesh.blocks.front();
      for (std::size_t e = 0; e < block.elementCount(); ++e)
        if (parts.partOfElement[e] == part)
          piece.blocks[0].connectivity.insert(piece.blocks[0].connectivity.end(), block.element(e),
                                              block.element(e) + 4);
      const ProgramMesh made = mesher(boundarySurface(piece));
      all.seconds += made.seconds;
      if (!made.mesh) return {{}, all.seconds, made.note};
      const auto before = all.mesh->X.cols();
      all.mesh->X.conservativeResize(3, before + made.mesh->X.cols());
      all.mesh->X.rightCols(made.mesh->X.cols()) = made.mesh->X;
      for (const std::int32_t n : made.mesh->blocks.front().connectivity)
        all.mesh->blocks[0].connectivity.push_back(n + static_cast<std::int32_t>(before));
    }
    return all;
  }

  void cutAll(const std::string& name, const TriangleSurface& surface) {
    struct Repair {
      std::string name;
      ProgramMesh (*mesher)(const TriangleSurface&);
    };
    const ProgramMesh initial = meshByTetgen(surface, "-pq", evenVolume(surface));
    if (!initial.mesh) return skip(name, "cuts, of a mesh of TetGen's", initial.note);
    const double atFirst = criticalStep(bodyFrom(*initial.mesh), initial.mesh->X, verletLimit).safe;
    for (const Repair& repair :
         {Repair{"none", nullptr},
          Repair{"tetgen -pq after each", [](const TriangleSurface& s) { return meshByTetgen(s, "-pq"); }},
          Repair{"gmsh -optimize after each",
                 [](const TriangleSurface& s) { return meshByGmsh(s, GmshOptimizer::own); }}}) {
      Mesh mesh = *initial.mesh;
      std::vector<Cell> steps{name, repair.name, 1e3 * atFirst}, times{name, repair.name};
      std::vector<Cell> repairTimes;
      for (const CutSurface& surfaceOfCut : fourCuts(*initial.mesh)) {
        const double begin = processorSeconds();
        mesh = cutMesh(mesh, surfaceOfCut, mesh.X).mesh;
        times.emplace_back(processorSeconds() - begin);
        if (repair.mesher) {
          ProgramMesh repaired = partsAnew(mesh, repair.mesher);
          repairTimes.emplace_back(repaired.seconds);
          if (!repaired.mesh) {
            skip(name, joinText("cut ", times.size() - 2, ", ", repair.name), repaired.note);
            break;
          }
          mesh = std::move(*repaired.mesh);
        }
        steps.emplace_back(1e3 * criticalStep(bodyFrom(mesh), mesh.X, verletLimit).safe);
      }
      const bool whole = steps.size() == 7;
      for (std::vector<Cell>* row : {&steps, &times})
        while (row->size() < (row == &steps ? 7U : 6U)) row->emplace_back("");
      while (repairTimes.size() < 4) repairTimes.emplace_back("");
      times.insert(times.end(), repairTimes.begin(), repairTimes.end());
      cutSteps_.rows.push_back(std::move(steps));
      cutTimes_.rows.push_back(std::move(times));
      if (!whole) continue;
      const Body body = bodyFrom(mesh);
      const std::string what = joinText(name, ", four cuts, ", repair.name);
      checkNear(report_, what + ": volume over that of the surface", meshVolume(mesh) / enclosedVolume(surface), 1,
                repair.mesher ? cutVolumeTolerance : volumeTolerance);
      checkSteps(what, criticalStep(body, mesh.X, verletLimit).safe, stepOf(highestEigenvalue(body, 1e-8)));
    }
  }

  /// Fierz 2013's Tables 1.1, 1.2 (ms) and 1.3 (s, one core of a Core 2 Quad Q9400).
  void addSourceRows() {
    if (cutSteps_.rows.empty()) return;
    struct Source {
      const char* name;
      std::array<double, 5> cut, optimised;
      std::array<double, 4> cutting, optimising;
    };
    for (const Source& s : {Source{"Armadillo",
                                   {0.032, 0.017, 0.017, 0.017, 0.017},
                                   {0.032, 0.017, 0.017, 0.017, 0.017},
                                   {0.028, 0.023, 0.279, 0.330},
                                   {0.424, 0.578, 5.655, 5.731}},
                            Source{"Bunny (C)",
                                   {1.64, 0.34, 0.34, 0.34, 0.34},
                                   {1.64, 0.63, 0.6, 0.6, 0.6},
                                   {0.067, 0.128, 0.034, 0.038},
                                   {0.236, 0.328, 0.154, 0.141}},
                            Source{"Dragon",
                                   {0.039, 0.024, 0.024, 0.024, 0.017},
                                   {0.039, 0.033, 0.027, 0.027, 0.027},
                                   {0.230, 0.360, 0.216, 0.207},
                                   {0.533, 0.877, 0.519, 0.491}},
                            Source{"Duck",
                                   {0.058, 0.058, 0.038, 0.017, 0.009},
                                   {0.058, 0.077, 0.056, 0.056, 0.011},
                                   {0.024, 0.013, 0.028, 0.193},
                                   {0.159, 0.123, 0.095, 2.946}}}) {
      const std::string name = joinText("Fierz 2013: ", s.name);
      const std::vector<Cell> heading{name, std::string("flips and smoothing after each")};
      std::vector<Cell> cut{name, std::string("none")}, optimised = heading, times = heading;
      cut.insert(cut.end(), s.cut.begin(), s.cut.end());
      optimised.insert(optimised.end(), s.optimised.begin(), s.optimised.end());
      times.insert(times.end(), s.cutting.begin(), s.cutting.end());
      times.insert(times.end(), s.optimising.begin(), s.optimising.end());
      cutSteps_.rows.push_back(std::move(cut));
      cutSteps_.rows.push_back(std::move(optimised));
      cutTimes_.rows.push_back(std::move(times));
    }
  }

  StudyEffort effort_;
  bool full_;
  StudyReport report_;
  StudyTable meshes_{
      "meshes",
      "Surfaces of badly shaped triangles, meshed: corotational, 30 kPa, 0.3, 1000 kg/m³",
      {"body", "mesher", "triangles", "tetrahedra", "nodes", "least dihedral angle (°)", "largest dihedral angle (°)",
       "largest radius/edge", "badly shaped", "proven step (ms)", "exact step (ms)", "time to mesh (s)"},
      {}};
  StudyTable runs_{"runs",
                   "Stretched and let go: error against a fine mesh, the largest of eight moments",
                   {"body", "mesher", "handler", "tetrahedra", "handled", "step (ms)", "error (% of displacement)",
                    "seconds a simulated second", "time/plain"},
                   {}};
  StudyTable cutSteps_{
      "cut_steps",
      "Proven critical step after cuts",
      {"body", "remeshing", "initial (ms)", "1st cut (ms)", "2nd cut (ms)", "3rd cut (ms)", "4th cut (ms)"},
      {}};
  StudyTable cutTimes_{"cut_times",
                       "Processor time of cutting and remeshing",
                       {"body", "remeshing", "1st cut (s)", "2nd cut (s)", "3rd cut (s)", "4th cut (s)",
                        "1st remeshing (s)", "2nd remeshing (s)", "3rd remeshing (s)", "4th remeshing (s)"},
                       {}};
  StudyTable skipped_{"skipped", "What could not be had", {"body", "what", "why"}, {}};
};

}  // namespace

StudyReport verifyRemeshing(StudyEffort effort) { return RemeshingStudy(effort).make(); }

}  // namespace ringwatch
