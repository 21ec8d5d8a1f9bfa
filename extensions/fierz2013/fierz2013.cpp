#include <ringwatch/extensions/fierz2013/fierz2013.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include <Eigen/Geometry>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/meshes/adjacency.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/stability_monitor.h>
#include <ringwatch/verify/processor_time.h>
#include <ringwatch/verify/study_bodies.h>

namespace ringwatch {
namespace {

using Cell = StudyTable::Cell;
using Eigen::Vector3d;

constexpr double edge = 0.05;    // m, of the cube; the bar is twice as long
constexpr double target = 4e-4;  // s, Fierz 2013's step
using detail::young, detail::density, detail::verletLimit;
constexpr double ramp = 0.1;  // s, in which a face moves over the length of the cube

/// How a mode moves or loads its face.
struct Mode {
  std::string_view name;
  double amount;                   // stretch, or rad
  double traction;                 // Pa; of twist, at the middle of an edge of the face
  std::array<double, 2> forceEnd;  // s, cube and bar: soon before the dead load has pulled it as far as it will go
};
constexpr std::array<Mode, 4> modes{{{"stretch", 0.4, 6e3, {0.016, 0.032}},
                                     {"compress", -0.2, -3e3, {0.016, 0.032}},
                                     {"bend", std::numbers::pi / 4, 900, {0.026, 0.05}},
                                     {"twist", std::numbers::pi / 4, 1900, {0.026, 0.052}}}};
const Mode& modeOf(const Deformation& d) {
  return *std::find_if(modes.begin(), modes.end(), [&](const Mode& m) { return m.name == d.mode; });
}

bool isBar(const Deformation& d) { return d.mesh == "bar"; }

/// The frame of a mesh: along from the held to the moving face, and where bending goes.
struct Frame {
  Vector3d along, sideways, heldCentre;
  double length;
  const char *held, *moving;
};
Frame frameOf(const Deformation& d) {
  if (isBar(d)) return {Vector3d::UnitX(), -Vector3d::UnitZ(), {0, edge / 2, edge / 2}, 2 * edge, "x-min", "x-max"};
  return {Vector3d::UnitZ(), -Vector3d::UnitX(), {edge / 2, edge / 2, 0}, edge, "z-min", "z-max"};
}

/// Where a point of the moving face belongs when a share s of the way is done.
Vector3d prescribedPosition(const Deformation& d, const Vector3d& X, double s) {
  const Frame frame = frameOf(d);
  const double amount = s * modeOf(d).amount * (isBar(d) && modeOf(d).name == "twist" ? 2 : 1);
  const Vector3d centre = frame.heldCentre + frame.length * frame.along;
  if (d.mode == "twist") return centre + Eigen::AngleAxisd(amount, frame.along) * (X - centre);
  if (d.mode != "bend") return X + amount * frame.length * frame.along;
  if (amount == 0) return X;
  // Along a circle, with the length of the middle line kept.
  const Vector3d moved =
      frame.heldCentre +
      frame.length / amount * (std::sin(amount) * frame.along + (1 - std::cos(amount)) * frame.sideways);
  return moved + Eigen::AngleAxisd(amount, frame.along.cross(frame.sideways)) * (X - centre);
}

/// Smoothly from 0 to 1.
double shareAt(const Deformation& d, double t) {
  const double s = std::clamp(t / d.end(), 0.0, 1.0);
  return s * s * (3 - 2 * s);
}

Mesh meshOf(const Deformation& d) {
  RefinedBarOptions options;
  options.coarse.size = {isBar(d) ? 2 * edge : edge, edge, edge};
  options.coarse.cells = {isBar(d) ? 10 : 5, 5, 5};
  options.coarse.jitter = 0.25;
  options.finest = 0.005;
  options.growth = 0.5;
  options.plane = isBar(d) ? edge : 0;
  return generateRefinedBar(options);
}

/// Traction over the moving face as nodal forces, by areas at rest.
void load(const Deformation& d, Body& body) {
  const Frame frame = frameOf(d);
  const Mesh& mesh = body.mesh();
  std::vector<bool> loaded(mesh.nodeCount(), false);
  for (const std::int32_t n : mesh.nodeSets.at(frame.moving)) loaded[n] = true;
  const Vector3d centre = frame.heldCentre + frame.length * frame.along;
  for (const ElementFace& f : boundaryFaces(mesh)) {
    const MeshBlock& block = mesh.blocks[f.block];
    const std::array<int, 4>& corners = elementInfo(block.type).faces[f.face];
    const std::int32_t* nodes = block.element(f.element);
    const std::array<std::int32_t, 3> n{nodes[corners[0]], nodes[corners[1]], nodes[corners[2]]};
    if (!std::all_of(n.begin(), n.end(), [&](std::int32_t i) { return loaded[i]; })) continue;
    const double area =
        (mesh.X.col(n[1]) - mesh.X.col(n[0])).cross(Vector3d(mesh.X.col(n[2]) - mesh.X.col(n[0]))).norm() / 2;
    const Vector3d middle = (mesh.X.col(n[0]) + mesh.X.col(n[1]) + mesh.X.col(n[2])) / 3;
    const double traction = modeOf(d).traction;
    Vector3d t = traction * frame.along;
    if (d.mode == "bend") t = (isBar(d) ? 0.5 : 1.0) * traction * frame.sideways;
    if (d.mode == "twist") t = traction / (edge / 2) * frame.along.cross(Vector3d(middle - centre));
    for (const std::int32_t i : n) body.externalForce().col(i) += area / 3 * t;
  }
}

struct Ran {
  NodeVectors x;
  double energy = 0;   // J, kinetic and strain, at the end
  double seconds = 0;  // of computing, steps alone
  std::string lost;
};

/// The deformation in steps of at most h that divide the target step, the best time of some repetitions.
Ran run(const Deformation& d, Body& body, Integrator& integrator, double h) {
  const int substeps = static_cast<int>(std::ceil(target / h - 1e-9));
  const auto frames = static_cast<int>(std::llround(d.end() / target));
  BodySystem system(body);
  State state = system.initialState();
  Ran result;
  for (int k = 0; k < frames && result.lost.empty(); ++k) {
    d.prescribeMotion(body, k * target, target);
    body.constraints().imposeVelocity(state.v);
    const double start = processorSeconds();
    for (int i = 0; i < substeps && result.lost.empty(); ++i)
      result.lost = integrator.step(system, state, target / substeps).reason;
    result.seconds += processorSeconds() - start;
  }
  if (result.lost.empty() && !state.x.allFinite()) result.lost = "positions are not finite";
  Body::Workspace workspace;
  if (result.lost.empty())
    result.energy =
        body.energy(state.x, workspace) + 0.5 * (state.v.colwise().squaredNorm() * body.lumpedMass()).value();
  result.x = state.x;
  return result;
}

/// A method at a step.
struct Contestant {
  std::string name;
  double h;  // s
  std::string handler = {};
  HandlerOptions options = {};
  bool implicitEuler = false;
};

/// Allowed mean errors, % of the largest displacement.
struct AllowedErrors {
  std::string_view mode;
  double accurate;  // local-time-stepping, and imex with either selection
  double implicitEuler, fePbd;
  double modalFilter, modalFilterBeyond;  // up to and beyond nu = 0.3, where it handles more elements
};
/// What the study expects of a handler.
struct Expectation {
  std::string_view handler;  // "": all that are not named
  double stepShare;          // of the steps of the others
  double AllowedErrors::*allowed;
  double AllowedErrors::*allowedBeyond;  // nu = 0.3
};
constexpr std::array<Expectation, 3> expectations{{
    {"modal-filter", 0.5, &AllowedErrors::modalFilter, &AllowedErrors::modalFilterBeyond},
    {"fe-pbd", 1, &AllowedErrors::fePbd, &AllowedErrors::fePbd},
    {"", 1, &AllowedErrors::accurate, &AllowedErrors::accurate},
}};
Expectation expectationOf(std::string_view handler) {
  const auto own = std::ranges::find(expectations, handler, &Expectation::handler);
  return own == expectations.end() ? expectations.back() : *own;
}
/// Integrators of the whole body that the handlers are compared with, where the program has them.
constexpr std::array<std::string_view, 1> baselines{"implicit-euler"};

std::vector<Contestant> contestants(double h) {
  std::vector<Contestant> all;
  for (const HandlerEntry& entry : allHandlers()) {
    const std::string name(entry.info->name);
    all.push_back({.name = name, .h = h * expectationOf(name).stepShare, .handler = name});
  }
  HandlerOptions ring{.selection = Selection::fierzRing};
  all.push_back({.name = "imex, fierz-ring", .h = h, .handler = "imex", .options = ring});
  ring.own.set("dissipation", 1).set("solver", "linear");  // implicit Euler, by one linear system a step
  all.push_back({.name = "imex, as in Fierz 2013", .h = h, .handler = "imex", .options = ring, .implicitEuler = true});
  return all;
}

// Within three times the largest that the full form measures; by force, of the cube at nu = 0.3, which the quick form
// has.
constexpr std::array<AllowedErrors, 4> allowedByForce{{
    {.mode = "stretch",
     .accurate = 0.7,
     .implicitEuler = 2.5,
     .fePbd = 2.9,
     .modalFilter = 0.36,
     .modalFilterBeyond = 0.5},
    {.mode = "compress",
     .accurate = 0.78,
     .implicitEuler = 3.2,
     .fePbd = 3.5,
     .modalFilter = 0.36,
     .modalFilterBeyond = 0.5},
    {.mode = "bend",
     .accurate = 0.18,
     .implicitEuler = 0.78,
     .fePbd = 0.75,
     .modalFilter = 0.09,
     .modalFilterBeyond = 0.2},
    {.mode = "twist",
     .accurate = 0.27,
     .implicitEuler = 1.15,
     .fePbd = 1.4,
     .modalFilter = 0.12,
     .modalFilterBeyond = 0.25},
}};
constexpr std::array<AllowedErrors, 4> allowedByPosition{{
    {.mode = "stretch",
     .accurate = 0.03,
     .implicitEuler = 0.08,
     .fePbd = 2.9,
     .modalFilter = 0.009,
     .modalFilterBeyond = 0.2},
    {.mode = "compress",
     .accurate = 0.04,
     .implicitEuler = 0.12,
     .fePbd = 2.6,
     .modalFilter = 0.013,
     .modalFilterBeyond = 0.17},
    {.mode = "bend",
     .accurate = 0.04,
     .implicitEuler = 0.12,
     .fePbd = 1.8,
     .modalFilter = 0.006,
     .modalFilterBeyond = 0.14},
    {.mode = "twist",
     .accurate = 0.02,
     .implicitEuler = 0.075,
     .fePbd = 0.6,
     .modalFilter = 0.004,
     .modalFilterBeyond = 0.045},
}};
double allowedError(const Deformation& d, const Contestant& c) {
  const std::array<AllowedErrors, 4>& table = d.byForce ? allowedByForce : allowedByPosition;
  const AllowedErrors& allowed =
      *std::find_if(table.begin(), table.end(), [&](const AllowedErrors& row) { return row.mode == d.mode; });
  if (c.implicitEuler) return allowed.implicitEuler;
  const Expectation expected = expectationOf(c.handler);
  return allowed.*(d.poisson > 0.3 ? expected.allowedBeyond : expected.allowed);
}

/// Fierz 2013's mean errors, mm (tables 4.2 to 4.6); NaN where its constraints could not be solved.
struct FierzErrors {
  std::string_view mode, mesh;
  std::array<double, 4> force, position;  // as in fierzHandlers
};
constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<FierzErrors, 8> fierzErrors{{
    {"stretch", "bar", {none, 0.34, 0.01, 0.03}, {none, 0.73, 0.07, 0.1}},
    {"stretch", "cube", {0.13, 0.26, 0.02, 0.007}, {0.18, 0.25, 0.06, 0.03}},
    {"compress", "bar", {none, 0.29, 0.009, 0.003}, {none, 0.7, 0.18, 0.05}},
    {"compress", "cube", {0.17, 0.19, 0.02, 0.005}, {0.3, 0.4, 0.07, 0.03}},
    {"bend", "bar", {none, 0.37, 0.14, 0.11}, {none, 0.35, 0.02, 0.01}},
    {"bend", "cube", {0.27, 0.31, 0.06, 0.02}, {0.21, 0.20, 0.012, 0.01}},
    {"twist", "bar", {none, 0.11, 0.03, 0.02}, {none, 0.21, 0.11, 0.03}},
    {"twist", "cube", {0.08, 0.09, 0.05, 0.04}, {0.33, 0.23, 0.03, 0.02}},
}};
constexpr std::array<std::string_view, 4> fierzHandlers{"modal-filter", "fe-pbd", "imex", "local-time-stepping"};
/// NaN when Fierz 2013 has no such row.
double fierzError(const Deformation& d, std::string_view handler) {
  const auto column = std::find(fierzHandlers.begin(), fierzHandlers.end(), handler) - fierzHandlers.begin();
  for (const FierzErrors& row : fierzErrors)
    if (row.mode == d.mode && row.mesh == d.mesh && d.poisson == 0.3 && column < 4)
      return (d.byForce ? row.force : row.position)[column];
  return none;
}

Cell numberOr(double value, const char* otherwise) { return std::isfinite(value) ? Cell(value) : Cell(otherwise); }

StudySurfaces::Panel surfaceOf(std::string label, const Mesh& mesh, const NodeVectors& x,
                               const Eigen::VectorXd& error) {
  StudySurfaces::Panel panel{std::move(label), {}, {}};
  for (const ElementFace& f : boundaryFaces(mesh)) {
    const MeshBlock& block = mesh.blocks[f.block];
    const std::int32_t* nodes = block.element(f.element);
    const std::array<int, 4>& corners = elementInfo(block.type).faces[f.face];
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3d p = 1e2 * x.col(nodes[corners[k]]);  // cm
      panel.points.push_back({p.x(), p.y(), p.z()});
      panel.values.push_back(1e3 * error[nodes[corners[k]]]);
    }
  }
  return panel;
}

/// A method through a deformation, beside the reference.
struct MethodRun {
  Deformation deformation;
  std::string method;
  double h = 0;                                              // s
  std::int64_t handled = 0;                                  // elements
  double meanError = 0, largestError = 0, displacement = 0;  // m
  double secondsATarget = 0;                                 // of computing the target step
  double timeOverReference = 1;                              // over Verlet in a fourth or a fifth of the target step
  double energyOverReference = 1;
  std::string lost;

  double meanPercent() const { return lost.empty() ? 100 * meanError / displacement : infinity; }
};
std::vector<Cell> rowOf(const MethodRun& run) {
  const bool lost = !run.lost.empty();
  return {std::string(run.deformation.mesh),
          std::string(run.deformation.mode),
          run.deformation.byForce ? "force" : "position",
          run.deformation.poisson,
          run.method,
          1e3 * run.h,
          run.handled,
          lost ? Cell("") : Cell(1e3 * run.meanError),
          lost ? Cell("") : Cell(1e3 * run.largestError),
          lost ? Cell("") : Cell(run.meanPercent()),
          1e3 * run.secondsATarget,
          run.timeOverReference,
          lost ? Cell("") : Cell(100 * (run.energyOverReference - 1)),
          run.lost};
}

/// The fastest of up to three repetitions, for the time alone.
template <class Once>
Ran fastest(const Once& once) {
  Ran best = once();
  for (int i = 0; i < 2 && best.lost.empty() && best.seconds < 0.1; ++i)
    best.seconds = std::min(best.seconds, once().seconds);
  return best;
}

class Study {
 public:
  explicit Study(std::span<const IntegratorEntry> integrators) : integrators_(integrators) {}

  void add(const Deformation& d, bool withBaselines) {
    const double reduced = d.poisson > 0.46 ? 0.5 : 1;  // Fierz 2013's target step there
    Body body = d.body();
    const NodeVectors X = body.mesh().X;
    const auto verlet = [] { return makeIntegrator("verlet"); };
    const Ran exact = run(d, body, *verlet(), reduced * 5e-5 / (d.poisson > 0.42 ? 2 : 1));
    if (!exact.lost.empty()) throw NumericalError(joinText("verify fierz2013: the reference is lost: ", exact.lost));
    const auto verletIn = [&](double h) {
      return fastest([&] {
        Body own = d.body();
        return run(d, own, *verlet(), h);
      });
    };
    // Fierz 2013's reference: 4 steps in the target one at nu = 0.3 and 0.4, 5 beyond.
    const double referenceStep = d.poisson > 0.42 ? reduced * target / 5 : target / 4;
    const Ran reference = verletIn(referenceStep);
    const auto keep = [&](const std::string& method, double h, std::int64_t handled,
                          const Ran& ran) -> const MethodRun& {
      const Eigen::VectorXd error = (ran.x - exact.x).colwise().norm();
      runs_.push_back({.deformation = d,
                       .method = method,
                       .h = h,
                       .handled = handled,
                       .meanError = error.mean(),
                       .largestError = error.maxCoeff(),
                       .displacement = (exact.x - X).colwise().norm().maxCoeff(),
                       .secondsATarget = ran.seconds * target / d.end(),
                       .timeOverReference = ran.seconds / reference.seconds,
                       .energyOverReference = ran.energy / exact.energy,
                       .lost = ran.lost});
      return runs_.back();
    };
    keep("verlet", referenceStep, 0, reference);
    const double safe = 0.95 * criticalStep(body, X, verletLimit).safe;
    keep("verlet, certified", target / std::ceil(target / safe), 0, verletIn(safe));
    for (const Contestant& c : contestants(reduced * target)) {
      std::int64_t handled = 0;
      Ran ran;
      try {
        ran = fastest([&] {
          Body own = d.body();
          const auto handler = makeHandler(c.handler, own, verlet(), c.options);
          handler->prepare(X, c.h);
          handled = static_cast<std::int64_t>(handler->elements().size());
          return run(d, own, *handler, c.h);
        });
      } catch (const NumericalError& fault) {
        ran.lost = fault.what();
        ran.x = X;
      }
      const MethodRun& own = keep(c.name, c.h, handled, ran);
      compare(d, c, own);
      compareWithFierz(own);
      if (ran.lost.empty() && d.poisson == 0.3 && c.name.find(',') == std::string::npos)
        picture(d).panels.push_back(surfaceOf(joinText(c.name, d.byForce ? ", force" : ", position"), body.mesh(),
                                              ran.x, Eigen::VectorXd((ran.x - exact.x).colwise().norm().transpose())));
    }
    if (!withBaselines) return;
    for (const IntegratorEntry& entry : integrators_)
      if (std::ranges::count(baselines, entry.info->name) > 0) {
        Body own = d.body();
        keep(std::string(entry.info->name), target, 0, run(d, own, *entry.make(), target));
      }
  }

  StudyReport finish() {
    report_.study = "fierz2013";
    addErrorAgainstTime();
    StudyTable table{
        "deformations",
        "Every handler on a cube and a bar with small elements; errors against Verlet at 0.05 ms, times of one "
        "target step over four steps of Verlet at 0.1 ms",
        {"mesh", "mode", "driven by", "nu", "method", "step (ms)", "handled", "mean error (mm)", "largest error (mm)",
         "mean error (% of displacement)", "time of 0.4 ms (ms)", "time/reference", "energy/reference - 1 (%)", "lost"},
        {}};
    for (const MethodRun& run : runs_) table.rows.push_back(rowOf(run));
    report_.tables.push_back(std::move(table));
    report_.tables.push_back(std::move(besideFierz_));
    return std::move(report_);
  }

 private:
  void compare(const Deformation& d, const Contestant& c, const MethodRun& run) {
    const std::string what =
        joinText(d.mesh, ", ", d.mode, d.byForce ? " by force, nu = " : " by position, nu = ", d.poisson, ", ", c.name);
    // What mass scaling does to the motion is its own affair.
    if (findHandler(c.handler)->addsMass)
      checkNear(report_, what + ": lost", run.lost.empty() ? 0 : 1, 0, 0);
    else
      checkBelow(report_, what + ": mean error (% of the largest displacement)", run.meanPercent(), allowedError(d, c));
  }

  StudySurfaces& picture(const Deformation& d) {
    const std::string name = joinText("deformation_", d.mesh, "_", d.mode);
    for (StudySurfaces& surfaces : report_.surfaces)
      if (surfaces.name == name) return surfaces;
    report_.surfaces.push_back({name, joinText(d.mesh, ", ", d.mode, ": error at the end"), "error (mm)", {}});
    return report_.surfaces.back();
  }

  void compareWithFierz(const MethodRun& run) {
    const Deformation& d = run.deformation;
    const bool named = std::find(fierzHandlers.begin(), fierzHandlers.end(), run.method) != fierzHandlers.end();
    if (!named || d.poisson != 0.3) return;
    const double theirs = fierzError(d, run.method), ours = run.lost.empty() ? 1e3 * run.meanError : infinity;
    const bool unsolved = std::isnan(theirs);
    besideFierz_.rows.push_back({std::string(d.mode), std::string(d.mesh), d.byForce ? "force" : "position", run.method,
                                 numberOr(theirs, "unsolvable"), numberOr(ours, "lost"),
                                 unsolved ? "a result" : (ours <= theirs ? "better" : "worse")});
  }

  /// A point for every deformation at nu = 0.3, by method.
  void addErrorAgainstTime() {
    for (const std::string_view mesh : {"cube", "bar"}) {
      StudyFigure figure{joinText("deformations_", mesh),
                         joinText("The ", mesh, " with small elements: eight deformations by every method"),
                         "time over four steps of Verlet at 0.1 ms",
                         "mean error (mm)",
                         true,
                         true,
                         {},
                         false};
      for (const MethodRun& run : runs_) {
        if (run.deformation.mesh != mesh || run.deformation.poisson != 0.3) continue;
        if (!run.lost.empty() || !(run.meanError > 0)) continue;
        auto curve = std::find_if(figure.curves.begin(), figure.curves.end(),
                                  [&](const StudyFigure::Curve& known) { return known.label == run.method; });
        if (curve == figure.curves.end()) curve = figure.curves.insert(curve, {run.method, {}, {}});
        curve->x.push_back(run.timeOverReference);
        curve->y.push_back(1e3 * run.meanError);
      }
      if (!figure.curves.empty()) report_.figures.push_back(std::move(figure));
    }
  }

  std::span<const IntegratorEntry> integrators_;
  StudyReport report_;
  std::vector<MethodRun> runs_;
  StudyTable besideFierz_{"fierz2013",
                          "Mean errors beside Fierz 2013's (mm); its motions are the same in kind, not in size",
                          {"mode", "mesh", "driven by", "handler", "Fierz 2013", "ours", "ours is"},
                          {}};
};

}  // namespace

double Deformation::end() const {
  const double t = byForce ? modeOf(*this).forceEnd[isBar(*this)] : ramp * (isBar(*this) ? 2 : 1);
  return target * std::round(t / target);
}

Body Deformation::body() const {
  Body b(meshOf(*this), makeMaterial("corotational", young, poisson, density), {{}, Lumping::rowSum, 1});
  const Frame frame = frameOf(*this);
  for (const std::int32_t n : b.mesh().nodeSets.at(frame.held)) b.constraints().fix(n);
  if (byForce)
    load(*this, b);
  else
    for (const std::int32_t n : b.mesh().nodeSets.at(frame.moving)) b.constraints().fix(n);
  return b;
}

void Deformation::prescribeMotion(Body& body, double t, double dt) const {
  if (byForce) return;
  const NodeVectors& X = body.mesh().X;
  const double from = shareAt(*this, t), to = shareAt(*this, t + dt);
  for (const std::int32_t n : body.mesh().nodeSets.at(frameOf(*this).moving)) {
    const Vector3d velocity =
        (prescribedPosition(*this, X.col(n), to) - prescribedPosition(*this, X.col(n), from)) / dt;
    for (int c = 0; c < 3; ++c) body.constraints().move(n, c, velocity[c]);
  }
}

std::vector<Deformation> allDeformations(double poisson) {
  std::vector<Deformation> all;
  for (const std::string_view mesh : {"cube", "bar"})
    for (const Mode& mode : modes)
      for (const bool byForce : {false, true}) all.push_back({mesh, mode.name, byForce, poisson});
  return all;
}

StudyReport verifyFierz2013(StudyEffort effort, std::span<const IntegratorEntry> integrators) {
  const bool full = effort == StudyEffort::full;
  Study study(integrators);
  for (const Deformation& d : allDeformations(0.3))
    if (full || (d.mesh == "cube" && d.byForce)) study.add(d, full && d.mesh == "cube");
  if (full)
    for (const double poisson : {0.4, 0.45, 0.49})
      for (const Deformation& d : allDeformations(poisson))
        if (d.mesh == "cube") study.add(d, false);
  return study.finish();
}

}  // namespace ringwatch
