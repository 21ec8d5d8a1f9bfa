#pragma once
#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <ringwatch/app/scene/deck_scene.h>
#include <ringwatch/app/scene/probe_quantity.h>
#include <ringwatch/app/scene/scene_materials.h>
#include <ringwatch/app/scene/time_table.h>
#include <ringwatch/app/scene/where_expression.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/units.h>
#include <ringwatch/body/body.h>
#include <ringwatch/body/obstacle.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/integrators/integrator.h>
#include <ringwatch/meshes/mesh.h>
#include <ringwatch/meshes/modify/cut.h>
#include <ringwatch/monitor/stability_monitor.h>

namespace ringwatch {

/// Nodes that a scene or a command line names: by a condition on their position or by a named set of the mesh.
struct NodeSelection {
  std::optional<WhereExpression> where;
  std::string set;     // used when there is no condition; "#3,7" are the nodes with these numbers in the mesh file
  std::string origin;  // "scene.toml:12: fix.where", for messages

  /// The condition, or `set:NAME`.
  static NodeSelection parse(const std::string& text, const std::string& origin);
  /// Positions of the selected nodes, ascending. Throws InputError for an unknown set and for a selection without
  /// nodes.
  std::vector<std::int32_t> nodesOf(const Mesh& mesh) const;
  /// The same of a part of a mesh, which may have none of them. Throws InputError for an unknown set.
  std::vector<std::int32_t> nodesIn(const Mesh& part) const;
  /// Throws InputError where a mesh has none of the nodes; low, high: corners of its bounding box, m.
  void requireSome(std::int64_t count, const Eigen::Vector3d& low, const Eigen::Vector3d& high) const;
  /// Numbers in the mesh file that it names; empty for a set or a condition. Throws InputError for what is none.
  std::vector<std::int64_t> numbers() const;
  /// For a number that the mesh does not have.
  InputError noSuchNode(std::int64_t number) const;
};

/// What a run does when the monitor no longer certifies its step.
enum class OnViolation { stop, warn, reduceStep, repeat, handle };
inline constexpr auto onViolationNames = nameTable<OnViolation>({
    {OnViolation::stop, "stop", "stop the run"},
    {OnViolation::warn, "warn", "go on"},
    {OnViolation::reduceStep, "reduce-step",
     "shorten the step as soon as it is no longer certified, and lengthen it again where clearly more is"},
    {OnViolation::repeat, "repeat", "go back to the last certified state and take a smaller step from there"},
    {OnViolation::handle, "handle", "give the handler more elements"},
});

/// Where a run takes its steps. automatic: on a GPU if that can be, else on the CPU.
enum class RunDevice { cpu, cuda, automatic };
inline constexpr auto runDeviceNames = nameTable<RunDevice>({
    {RunDevice::cpu, "cpu"},
    {RunDevice::cuda, "cuda"},
    {RunDevice::automatic, "auto"},
});

/// Where the surface of a cut lies: in space, or in the body at rest.
enum class CutPositions { deformed, reference };
inline constexpr auto cutPositionsNames = nameTable<CutPositions>({
    {CutPositions::deformed, "deformed"},
    {CutPositions::reference, "reference"},
});

/// A validated description of a run. SI units.
struct Scene {
  /// How a [[fix]] or [[move]] of a rigid body takes it.
  struct Guide {
    std::string body;
    bool turns = false;                              // it turns freely
    Eigen::Vector3d axis = Eigen::Vector3d::Zero();  // about this one alone; zero: about all
    std::optional<Eigen::Vector3d> point;            // m, at rest; empty: its centre of mass
  };
  struct Fix {
    NodeSelection nodes = {};
    std::array<bool, 3> components = {};
    std::optional<Guide> guide = {};  // of a rigid body, whose nodes these are
  };
  struct Move {
    NodeSelection nodes;
    std::array<bool, 3> components = {};
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  // m/s
    std::optional<TimeTable> table;                      // its factor; empty: 1
    /// rad/s, about an axis through `point` (m) that stays; the table is its factor too
    Eigen::Vector3d angularVelocity = Eigen::Vector3d::Zero(), point = Eigen::Vector3d::Zero();

    /// m, whose factor is the table, in place of both velocities; the factor begins at 0
    std::optional<Eigen::Vector3d> way = {};
    std::optional<Guide> guide = {};  // of a rigid body, whose nodes these are

    bool rotates() const { return !angularVelocity.isZero(0); }
    /// Whether the velocity changes with time.
    bool changes() const { return table || rotates(); }
    /// Displacement of a node from where it was at rest, X (m), at a time (s), m.
    Eigen::Vector3d displacement(const Eigen::Vector3d& X, double time) const;
    /// Its velocity at time zero, m/s.
    Eigen::Vector3d velocityAtStart(const Eigen::Vector3d& X) const;
    /// By how much it has turned at a time, radians, about the direction of the angular velocity.
    Eigen::Vector3d turned(double time) const;
    /// Its mean velocity over [time, time + h], m/s, which brings it to its place at the end.
    Eigen::Vector3d meanVelocity(const Eigen::Vector3d& X, double time, double h) const;
    /// An upper bound of its speed, m/s, but for expressions, which are asked at some times.
    double largestSpeed(const Eigen::Vector3d& X) const;
  };
  /// Velocities at the start, on top of those of others.
  struct Initial {
    NodeSelection nodes;
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();         // m/s
    Eigen::Vector3d angularVelocity = Eigen::Vector3d::Zero();  // rad/s
    Eigen::Vector3d point = Eigen::Vector3d::Zero();            // m, on the axis
  };
  struct Force {
    NodeSelection nodes;
    std::optional<Eigen::Vector3d> acceleration;  // m/s²
    std::optional<Eigen::Vector3d> total;         // N, spread over the nodes by mass
    std::optional<Eigen::Vector3d> each;          // N, on each of the nodes
    std::optional<TimeTable> table;               // its factor; empty: 1
  };

  /// Nodes that move as a rigid body of their mass.
  struct Rigid {
    std::string name;
    NodeSelection nodes;
    std::string origin;  // "scene.toml:31: [[rigid]]", for messages
  };

  /// Mass at nodes that no element has.
  struct PointMass {
    NodeSelection nodes;
    double mass = 0;                   // kg, of all nodes together
    std::optional<double> nodal = {};  // kg, instead: what each node has with it in all
    std::string origin = {};           // "scene.toml:31: [[mass]]", for messages
  };
  /// Damping of some nodes in proportion to their mass.
  struct MassDamping {
    NodeSelection nodes;
    double rate = 0;     // 1/s
    std::string origin;  // "scene.toml:31: [[mass_damping]]", for messages
  };
  /// A spring and a dashpot at each of some nodes.
  struct SpringSet {
    NodeSelection nodes;
    std::optional<NodeSelection> to;           // each to the nearest of these; empty: to the ground
    double stiffness = 0, damping = 0;         // N/m, N s/m, of each
    std::optional<Eigen::Vector3d> direction;  // to the ground
    std::optional<double> length;              // m, at rest; empty: as it is at the start
    bool alongEdges = false;                   // of elements, both of whose ends are selected
    std::string origin;                        // "scene.toml:31: [[spring]]", for messages
  };
  struct MovingObstacle {
    std::string name;
    const ObstacleKind* kind = nullptr;
    ObstacleParameters parameters;
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  // m/s
    std::optional<TimeTable> table;                      // its factor; empty: 1
    std::string origin;
  };
  struct Contact {
    std::optional<NodeSelection> nodes;  // empty: the surface
    bool withSurface = false;            // touches the surface `to`, and else obstacles
    std::optional<NodeSelection> to;     // empty: all of the surface
    std::optional<double> edgeAngle;     // radians; empty: edges do not touch edges
    std::vector<std::size_t> obstacles;  // of the scene's
    std::optional<double> penalty;       // N/m; empty for "auto"
    std::optional<double> step;          // s, that "auto" leaves; empty: that of the elements at rest
    double damping = 0;                  // share of the critical damping of a node on its penalty
    double friction = 0;
    std::optional<double> slip;  // m/s; empty for "auto"
    std::string origin, penaltyOrigin;
  };

  /// Pressure on the faces of the surface all of whose corners are selected, along their normals as they are.
  struct Pressure {
    NodeSelection nodes;
    double pressure = 0;             // Pa
    std::optional<TimeTable> table;  // its factor; empty: 1
    std::string origin;
  };

  struct Cut {
    CutSurface surface;
    double time = 0;    // s
    double snap = 0.1;  // edge lengths
    CutPositions positions = CutPositions::deformed;
    bool criticalStep = false;  // of the whole body, before and after, is wanted
    std::string origin;         // "scene.toml:31: [[cut]]", for messages
  };

  /// When an element leaves the run: where one of these holds.
  struct Erosion {
    bool inverted = false;                  // det F <= 0 at a quadrature point
    std::optional<double> stretch;          // largest principal stretch above that
    std::optional<double> vonMises;         // Pa, above that
    std::optional<double> principalStress;  // Pa, largest one above that
    std::optional<double> step;             // s, its own critical step below that
    std::int64_t every = 1;                 // steps between looks
  };

  /// Numbers of some nodes or elements, for a table of their own along the run.
  struct Probe {
    std::string name;
    ProbeQuantity quantity = {};
    ProbeReduction as = ProbeReduction::mean;
    std::optional<NodeSelection> selection;  // nodes, or elements by their centre or an element set; empty: all
    std::optional<int> material;             // of elements: its number
    std::size_t rigid = 0;                   // of rigid bodies: which
    std::string metric = "reduced-1-ring";   // of a step
    std::string origin;                      // "scene.toml:31: [[probe]]", for messages
  };

  Units units = Units::si;
  std::filesystem::path file;
  bool ofModel = false;                       // the file is a deck or a MuJoCo model
  std::vector<std::string> notes;             // what a user may want to know of how the file was read, one line each
  std::string mayBeStable;                    // as DeckScene::mayBeStable
  std::optional<double> ownStep;              // as DeckScene::ownStep
  nlohmann::ordered_json echo;                // every section and key with defaults filled in
  std::map<std::string, std::string> places;  // "scene.toml:31", of the first of each section and key that is given
  /// "scene.toml:31: [[cut]]" or "scene.toml:9: integrator.device", for messages: the file where it is not given.
  std::string where(const std::string& sectionOrKey) const;

  std::filesystem::path meshFile;  // empty when generated
  bool repair = false;             // it is mended first
  std::string generator;
  nlohmann::ordered_json generatorArguments;
  std::string meshOrigin;  // "scene.toml:3: mesh.file", for messages

  std::vector<SceneMaterial> materials;  // at least one
  Lumping lumping = Lumping::rowSum;
  HourglassControl hourglassControl;  // of rules of uniform strain

  std::string method;
  std::optional<double> step;  // s; empty for "auto"
  double end = 0;              // s
  RayleighDamping damping;
  double linearBulkViscosity = 0, quadraticBulkViscosity = 0;
  RunDevice device = RunDevice::cpu;
  std::vector<int> devices{0};  // GPUs, by number; empty: all
  bool holdsStep = false;       // "auto" keeps the step of the first state
  double safety = 0.95;         // share of the safe step that "auto", "reduce-step" and "repeat" take

  std::string metric;  // "" for none
  double margin = 0.1;
  MonitorMode mode = MonitorMode::bracket;
  std::int64_t every = 1;
  std::optional<double> budget;  // MonitorOptions::budget; empty for the usual one
  OnViolation onViolation = OnViolation::stop;
  std::int64_t repeats = 10;  // from one state, with OnViolation::repeat, before the run ends
  double energyTolerance = 0.1;
  bool requireCertified = false;             // a step that is not certified makes the run fail
  std::optional<std::int64_t> certificates;  // observations between files of proofs; empty for none

  std::string handler;  // "" for none
  HandlerOptions handlerOptions;
  std::optional<double> handlerStep;  // s, that "auto" begins with and does not pass; empty: factor of the safe step
  double handlerFactor = 2;
  bool reduceOnFailure = false;  // halve the step when the handler cannot take it

  std::vector<Fix> fixes;
  std::vector<Move> moves;
  std::vector<Force> forces;
  std::vector<Initial> initials;
  std::vector<PointMass> pointMasses;
  std::vector<Rigid> rigids;
  std::vector<MassDamping> massDampings;
  std::vector<SpringSet> springs;
  std::vector<MovingObstacle> obstacles;
  std::vector<Contact> contacts;
  std::vector<Pressure> pressures;
  std::vector<Cut> cuts;  // by time

  std::optional<double> checkpointInterval;  // s; empty for no checkpoints
  std::optional<double> frameInterval;       // s; empty for no frames
  bool exactTimes = false;                   // frames at the very times, between steps too
  std::vector<std::string> fields{"critical_step"};
  std::int64_t historyEvery = 1;
  std::optional<Erosion> erosion;
  std::vector<Probe> probes;
  std::int64_t probeEvery = 1;  // steps
  bool reactions = false;       // of each [[fix]] and [[move]] are wanted
  bool energy = true;
  bool picture = true;

  /// Whether elements damp by more than Rayleigh damping: bulk viscosity, or damping of materials.
  bool hasElementDamping() const {
    return linearBulkViscosity > 0 || quadraticBulkViscosity > 0 ||
           std::any_of(materials.begin(), materials.end(), [](const auto& one) { return one.damping.any(); });
  }
  /// Whether some element has a rule of uniform strain.
  bool hasUniformStrain() const { return std::ranges::any_of(materials, &SceneMaterial::hasUniformStrain); }
  /// Whether a [[fix]] or [[move]] takes a rigid body and leaves it some freedom, so that its nodes are tied.
  template <class Section>
  static bool guides(const Section& section) {
    const std::array<bool, 3>& held = section.components;
    return section.guide && (section.guide->turns || !(held[0] && held[1] && held[2]));
  }
  /// Whether anything but dashpots and contact damps.
  bool damps() const { return damping.any() || hasElementDamping(); }
  /// Whether there are springs, mass damping of nodes or contact.
  bool hasDiscreteForces() const { return !springs.empty() || !massDampings.empty() || !contacts.empty(); }
  /// Whether there is contact with obstacles that move.
  bool movesObstacles() const {
    return !contacts.empty() && std::any_of(obstacles.begin(), obstacles.end(),
                                            [](const MovingObstacle& one) { return !one.velocity.isZero(0); });
  }
  /// Whether the monitor proves anything; a metric does not.
  bool proves() const { return mode != MonitorMode::metric; }
  bool monitored() const { return proves() || !metric.empty(); }
  /// Whether a table of probes is wanted.
  bool probed() const { return !probes.empty() || reactions; }
};

/// What the handlers that are known declare.
std::vector<HandlerInfo> handlerInfos();

/// Whether a file is a model of another program that stands for a scene: a deck, or MuJoCo's.
bool isModelFile(const std::filesystem::path& file);

/// Reads and checks a scene file, or a model of another program. overrides: `section.key=value` each, value as TOML (a
/// bare word is taken for a string); they win over the file. Throws InputError "FILE:LINE: section.key: what is wrong;
/// what would be right".
Scene readScene(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// The scene that a model of another program stands for; see readDeckScene and readMjcfScene.
Scene sceneOfModel(const std::filesystem::path& file, DeckUse use, const std::vector<std::string>& overrides = {});

/// The scene of an echo (Scene::echo). file: of the scene, for messages and what is relative to it.
Scene sceneOfEcho(const std::filesystem::path& file, const nlohmann::ordered_json& echo);
/// The scene of a finished run, from its summary.json. Throws InputError when there is none that can be read.
Scene sceneOfRun(const std::filesystem::path& folder);
/// `hex8=RULE` and so on as element name -> quadrature rule name. Throws InputError "origin: …" for another form, an
/// unknown element or an unknown rule.
ElementRules parseRules(const std::vector<std::string>& texts, const std::string& origin);
/// Gives them to all materials of a scene, in place of rules for the same elements.
void overrideRules(Scene& scene, const std::vector<std::string>& texts, const std::string& origin);
/// Which of x, y, z a text such as "xy" names; nothing unless it names some, each once.
std::optional<std::array<bool, 3>> parseComponents(std::string_view text);
/// A condition or `set:NAME`, and behind a colon the components that are held, e.g. "x < 1e-6:x" for a roller; all of
/// them without. Throws InputError "origin: …".
Scene::Fix parseFix(const std::string& text, const std::string& origin);
/// More steps, or frames, than a run can have: at a microsecond each they would take twelve days.
inline constexpr double mostSteps = 1e12;
/// "" unless there are more than that of an interval (s) to the end (s); then how many of what, for a message.
std::string tooMany(std::string_view what, double interval, double end);

/// What a force of a scene puts on each of its nodes, N.
std::vector<Eigen::Vector3d> nodalForces(const Scene::Force& force, const std::vector<std::int32_t>& nodes,
                                         const Body& body);

/// Threads for a request; 0 asks for as many as the mesh can keep busy: on a small one, waiting for each other would
/// cost more than they share, above all on a machine that has other work too.
int threadsThatPay(int requested, const Mesh& mesh);
/// The mesh of a scene, read or generated. notes: what a reader has to tell.
Mesh sceneMesh(const Scene& scene, std::vector<std::string>& notes);
/// The body of a scene with its materials, point masses, constraints, forces, springs and contact. materials: by the
/// mesh where it is one of an earlier body of the scene. Throws InputError for selections without nodes or elements,
/// and as assignMaterials.
Body sceneBody(const Scene& scene, Mesh mesh, int threads, MaterialsBy materials = MaterialsBy::scene);

}  // namespace ringwatch
