// MuJoCo models: the bracket against MuJoCo's equations, written down here as its engine has them; poses, shapes, and
// what is left out and refused.
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <ringwatch/app/scene/mjcf_model.h>
#include <ringwatch/meshes/mesh_io.h>
#include <tests/support/meshes.h>

#include "program.h"

namespace ringwatch {
namespace {

using test::Json;
using test::Outcome;
using test::Program;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// A flex by MuJoCo's own equations (its documentation, "Deformable objects", and its engine): forces of edges whose
/// squared lengths L² - L0² are coupled by a metric of each tetrahedron; and dashpots along edges.
struct Reference {
  static constexpr std::array<std::array<int, 2>, 6> edges{{{0, 1}, {1, 2}, {2, 0}, {2, 3}, {0, 3}, {1, 3}}};
  struct Element {
    std::array<std::int32_t, 4> vertices;
    Eigen::Matrix<double, 6, 6> metric;
    std::array<double, 6> reference;  // L0²
  };
  std::vector<Eigen::Vector3d> X;
  std::vector<double> masses;
  std::vector<bool> pinned;
  double damping = 0, edgeDamping = 0;
  std::vector<Element> elements;
  std::vector<std::array<std::int32_t, 2>> allEdges;

  Reference(std::vector<Eigen::Vector3d> points, const std::vector<std::array<std::int32_t, 4>>& tetrahedra,
            double young, double poisson, double mass)
      : X(std::move(points)), masses(X.size(), mass / static_cast<double>(X.size())), pinned(X.size(), false) {
    const double mu = young / (2 * (1 + poisson)), lambda = young * poisson / ((1 + poisson) * (1 - 2 * poisson));
    for (const auto& t : tetrahedra) {
      Element element{t, {}, {}};
      const auto at = [&](int k) { return X[static_cast<std::size_t>(t[static_cast<std::size_t>(k)])]; };
      Eigen::Matrix3d sides;
      for (int k = 0; k < 3; ++k) sides.col(k) = at(k + 1) - at(0);
      const double volume = std::abs(sides.determinant()) / 6;
      // Gradients of barycentric coordinates, which MuJoCo makes of the normals of faces.
      Eigen::Matrix<double, 3, 4> gradient;
      gradient.rightCols<3>() = sides.inverse().transpose();
      gradient.col(0) = -gradient.rightCols<3>().rowwise().sum();
      std::array<Eigen::Matrix3d, 6> basis;
      for (std::size_t e = 0; e < 6; ++e) {
        const auto [i, j] = edges[e];
        const Eigen::Matrix3d product = gradient.col(i) * gradient.col(j).transpose();
        basis[e] = -0.5 * (product + product.transpose());
        element.reference[e] = (at(i) - at(j)).squaredNorm();
        const auto one = t[static_cast<std::size_t>(i)], other = t[static_cast<std::size_t>(j)];
        allEdges.push_back({std::min(one, other), std::max(one, other)});
      }
      for (int a = 0; a < 6; ++a)
        for (int b = 0; b < 6; ++b)
          element.metric(a, b) =
              volume *
              (mu * (basis[static_cast<std::size_t>(a)] * basis[static_cast<std::size_t>(b)]).trace() +
               lambda * basis[static_cast<std::size_t>(a)].trace() * basis[static_cast<std::size_t>(b)].trace());
      elements.push_back(element);
    }
    std::sort(allEdges.begin(), allEdges.end());
    allEdges.erase(std::unique(allEdges.begin(), allEdges.end()), allEdges.end());
  }

  /// On each vertex, N.
  std::vector<Eigen::Vector3d> force(const std::vector<Eigen::Vector3d>& x,
                                     const std::vector<Eigen::Vector3d>& v) const {
    std::vector<Eigen::Vector3d> f(x.size(), Eigen::Vector3d::Zero());
    for (const Element& element : elements) {
      Eigen::Matrix<double, 6, 1> elongation;
      std::array<Eigen::Vector3d, 6> d;
      for (std::size_t e = 0; e < 6; ++e) {
        d[e] = x[vertexOf(element, e, 0)] - x[vertexOf(element, e, 1)];
        elongation[static_cast<Eigen::Index>(e)] = d[e].squaredNorm() - element.reference[e];
      }
      const Eigen::Matrix<double, 6, 1> tension = element.metric * elongation;
      for (std::size_t e = 0; e < 6; ++e) {
        f[vertexOf(element, e, 0)] -= tension[static_cast<Eigen::Index>(e)] * d[e];
        f[vertexOf(element, e, 1)] += tension[static_cast<Eigen::Index>(e)] * d[e];
      }
    }
    for (const auto& [i, j] : allEdges) {
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      const Eigen::Vector3d n = (x[a] - x[b]).normalized();
      const Eigen::Vector3d own = edgeDamping * n.dot(v[a] - v[b]) * n;
      f[a] -= own;
      f[b] += own;
    }
    return f;
  }

  /// The largest speed in steps of h with gravity, semi-implicitly, from a small disturbance; infinity where it has no
  /// end.
  double largestSpeed(double h, int steps) const {
    std::vector<Eigen::Vector3d> x = X, v;
    for (std::size_t i = 0; i < X.size(); ++i) v.emplace_back(1e-9 * std::sin(static_cast<double>(i)), 0, 0);
    double largest = 0;
    for (int n = 0; n < steps; ++n) {
      const std::vector<Eigen::Vector3d> f = force(x, v);
      for (std::size_t i = 0; i < x.size(); ++i) {
        v[i] += h * (f[i] / masses[i] + Eigen::Vector3d(0, 0, -9.81));
        x[i] += h * v[i];
        largest = std::max(largest, v[i].norm());
        if (!(largest < 1e4)) return std::numeric_limits<double>::infinity();
      }
    }
    return largest;
  }

  /// The step at which M - (h/2) C - (h²/4) K becomes singular at rest, s, C explicit but for what is implicit.
  double criticalStep(double limit = 2) const {
    const auto n = static_cast<Eigen::Index>(3 * X.size());
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n), C = K, M = K;
    const auto add = [](Eigen::MatrixXd& to, std::size_t i, std::size_t j, const Eigen::Matrix3d& block) {
      to.block<3, 3>(static_cast<Eigen::Index>(3 * i), static_cast<Eigen::Index>(3 * j)) += block;
    };
    for (const Element& element : elements)
      for (std::size_t a = 0; a < 6; ++a)
        for (std::size_t b = 0; b < 6; ++b)
          for (std::size_t p = 0; p < 2; ++p)
            for (std::size_t q = 0; q < 2; ++q) {
              const Eigen::Vector3d da = X[vertexOf(element, a, 0)] - X[vertexOf(element, a, 1)],
                                    db = X[vertexOf(element, b, 0)] - X[vertexOf(element, b, 1)];
              add(K, vertexOf(element, a, p), vertexOf(element, b, q),
                  (p == q ? 2 : -2) * element.metric(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) * da *
                      db.transpose());
            }
    C = damping * K;
    for (const auto& [i, j] : allEdges) {
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      const Eigen::Vector3d d = (X[a] - X[b]).normalized();
      const Eigen::Matrix3d own = edgeDamping * d * d.transpose();
      add(C, a, a, own), add(C, b, b, own), add(C, a, b, -own), add(C, b, a, -own);
    }
    for (Eigen::Index i = 0; i < n; ++i) M(i, i) = masses[static_cast<std::size_t>(i / 3)];
    for (Eigen::Index i = 0; i < n; ++i)
      if (pinned[static_cast<std::size_t>(i / 3)])
        for (Eigen::MatrixXd* matrix : {&K, &C}) matrix->row(i).setZero(), matrix->col(i).setZero();
    double low = 0, high = 1;
    for (int k = 0; k < 60; ++k) {
      const double h = 0.5 * (low + high);
      const bool holds =
          Eigen::LLT<Eigen::MatrixXd>(M - h / 2 * C - h * h / (limit * limit) * K).info() == Eigen::Success;
      (holds ? low : high) = h;
    }
    return low;
  }

 private:
  static std::size_t vertexOf(const Element& element, std::size_t edge, std::size_t end) {
    return static_cast<std::size_t>(element.vertices[static_cast<std::size_t>(edges[edge][end])]);
  }
};

/// A distorted bar of tetrahedra, some of them turned round, which is all the same to MuJoCo.
struct Bar {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::array<std::int32_t, 4>> tetrahedra;
  Bar() {
    const Mesh mesh = test::gridMesh("tet4", {3, 2, 1}, {0.3, 0.2, 0.1}, 0.2, 7);
    for (Eigen::Index i = 0; i < mesh.X.cols(); ++i) points.emplace_back(mesh.X.col(i));
    for (std::size_t e = 0; e < mesh.blocks[0].elementCount(); ++e) {
      auto& own = tetrahedra.emplace_back();
      std::copy_n(mesh.blocks[0].element(e), 4, own.begin());
      if (e % 3 == 0) std::swap(own[0], own[1]);
    }
  }
  std::string pointText() const {
    std::string text;
    for (const Eigen::Vector3d& p : points) text += fmt::format("{} {} {} ", p[0], p[1], p[2]);
    return text;
  }
  std::string elementText() const {
    std::string text;
    for (const auto& t : tetrahedra) text += fmt::format("{} {} {} {} ", t[0], t[1], t[2], t[3]);
    return text;
  }
  std::string flexcomp(const std::string& inside) const {
    return fmt::format(
        "<flexcomp name=\"soft\" type=\"direct\" dim=\"3\" mass=\"2\" point=\"{}\" element=\"{}\">{}"
        "</flexcomp>",
        pointText(), elementText(), inside);
  }
  Reference reference() const { return {points, tetrahedra, 3e4, 0.3, 2}; }
};
constexpr const char* elastic = "<elasticity young=\"3e4\" poisson=\"0.3\"/>";
constexpr const char* documented = R"(<mujoco>
  {}
  <worldbody>
    <flexcomp type="grid" count="24 4 4" spacing=".1 .1 .1" pos=".1 0 1.5" radius=".0" rgba="0 .7 .7 1"
              name="softbody" dim="3" mass="7">
      <contact condim="3" solref="0.01 1" solimp=".95 .99 .0001" selfcollide="none"/>
      <edge damping="1"/>
      <elasticity poisson="0.2" young="5e4"/>
    </flexcomp>
  </worldbody>
</mujoco>
)";

class MujocoModels : public Program {
 protected:
  static std::string model(const std::string& tree, const std::string& more = "") {
    return "<mujoco>\n" + more + "\n<worldbody>\n" + tree + "\n</worldbody>\n</mujoco>\n";
  }
  void write(const std::string& text) { folder_.write("model.xml", text); }
  Json suggested(const std::string& text, const std::string& options = "") {
    write(text);
    const Outcome outcome = call("suggest model.xml --json -" + options);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.status == 0 ? parse(outcome.out) : Json();
  }
  FlexModel read(const std::string& text) {
    write(text);
    return readFlexModel(folder_.path() / "model.xml");
  }
  static void expectBracket(const Json& report, double exact, double width = 1.05) {
    const double safe = report["start"]["safe"], optimistic = report["start"]["optimistic"];
    EXPECT_LE(safe, exact * (1 + 1e-9));
    EXPECT_GE(optimistic, exact * (1 - 1e-9));
    EXPECT_LE(optimistic, width * safe);
  }
};

// The documentation's example diverges at the default step of 0.002 s and runs at 0.001 s (google-deepmind/mujoco,
// issue 1141; the documentation has had timestep=".001" since).
TEST_F(MujocoModels, SayThatTheDocumentedExampleNeedsASmallerStep) {
  folder_.write("default.xml", fmt::format(fmt::runtime(documented), ""));
  folder_.write("halved.xml", fmt::format(fmt::runtime(documented), "<option timestep=\".001\"/>"));
  for (const std::string command : {"inspect", "suggest"}) {
    SCOPED_TRACE(command);
    const Outcome outcome = call(command + " default.xml --json a.json");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.out,
                AllOf(HasSubstr("your timestep 0.002 s is proven unstable, as is every one above 0.0011"),
                      HasSubstr("largest proven stable: 0.0010"), HasSubstr(", so 2 substeps of 0.001 s")));
    Json answer = json("a.json")["timestep"];
    EXPECT_EQ(answer["asked"], 0.002);
    EXPECT_EQ(answer["verdict"], "violated");
    EXPECT_EQ(answer["steps"], 2);
    EXPECT_EQ(answer["step"], 0.001);
    EXPECT_THAT(call(command + " halved.xml --json a.json").out,
                HasSubstr("your timestep 0.001 s is proven stable; largest proven stable: 0.0010"));
    answer = json("a.json")["timestep"];
    EXPECT_EQ(answer["verdict"], "certified");
    EXPECT_EQ(answer["steps"], 1);
  }

  const FlexModel model = readFlexModel(folder_.path() / "default.xml");
  const Flex& flex = model.flexes.at(0);
  Reference reference(flex.points, flex.tetrahedra, 5e4, 0.2, 7);
  reference.edgeDamping = 1;
  constexpr int steps = 100;
  EXPECT_EQ(reference.largestSpeed(0.002, steps), std::numeric_limits<double>::infinity());
  EXPECT_NEAR(reference.largestSpeed(0.001, steps), 9.81 * 0.001 * steps, 1e-6);
}

TEST_F(MujocoModels, HaveTheBracketOfMujocosMatrices) {
  const Bar bar;
  const Reference reference = bar.reference();
  const auto inside = [](double damping, double edgeDamping, const std::string& pin = "") {
    return fmt::format("<elasticity young=\"3e4\" poisson=\"0.3\" damping=\"{}\"/><edge damping=\"{}\"/>{}", damping,
                       edgeDamping, pin);
  };
  expectBracket(suggested(model(bar.flexcomp(elastic))), reference.criticalStep());
  for (const auto& [damping, edgeDamping] : {std::pair{2e-3, 0.0}, std::pair{0.0, 5.0}, std::pair{1e-3, 3.0}}) {
    SCOPED_TRACE(fmt::format("{} {}", damping, edgeDamping));
    Reference damped = reference;
    damped.damping = damping;
    damped.edgeDamping = edgeDamping;
    damped.pinned[0] = damped.pinned[3] = damped.pinned[4] = true;
    EXPECT_LT(damped.criticalStep(), 0.95 * reference.criticalStep());
    expectBracket(suggested(model(bar.flexcomp(inside(damping, edgeDamping, "<pin id=\"0\"/><pin range=\"3 4\"/>")))),
                  damped.criticalStep(), edgeDamping > 0 ? 1.3 : 1.05);
  }
  // The limit of Runge and Kutta's scheme on the imaginary axis is 2 √2.
  expectBracket(suggested(model(bar.flexcomp(elastic), "<option integrator=\"RK4\"/>")),
                reference.criticalStep(2 * std::numbers::sqrt2));
  EXPECT_EQ(suggested(model(bar.flexcomp(elastic)))["damped"], false);
  // Where the bracket leaves the timestep open, inspect --exact decides.
  const Json wide = suggested(model(bar.flexcomp(inside(0, 5))))["start"];
  const double middle = 0.5 * (wide["safe"].get<double>() + wide["optimistic"].get<double>());
  const std::string open = model(bar.flexcomp(inside(0, 5)), fmt::format("<option timestep=\"{}\"/>", middle));
  EXPECT_EQ(suggested(open)["timestep"]["verdict"], "not-certified");
  EXPECT_THAT(call("suggest model.xml").out,
              AllOf(HasSubstr("neither proven stable nor unstable"), HasSubstr("ringwatch inspect model.xml --exact")));
  Reference dashpots = reference;
  dashpots.edgeDamping = 5;
  EXPECT_EQ(parse(call("inspect model.xml --exact --json -").out)["timestep"]["verdict"],
            dashpots.criticalStep() > middle ? "certified" : "violated");
  // The plugin by which older models have their elasticity.
  const Json plugin = suggested(model(bar.flexcomp(
      "<plugin plugin=\"mujoco.elasticity.solid\"><config key=\"young\" value=\"3e4\"/><config key=\"poisson\" "
      "value=\"0.3\"/></plugin>")));
  EXPECT_EQ(plugin["start"], suggested(model(bar.flexcomp(elastic)))["start"]);
}

// Damping along edges is implicit there: what is proven is that of the body without.
TEST_F(MujocoModels, ClaimNoInstabilityWhereImplicitDampingIsLeftOut) {
  const Bar bar;
  const std::string damped = bar.flexcomp(std::string(elastic) + "<edge damping=\"8\"/>");
  for (const char* integrator : {"implicit", "implicitfast"}) {
    const std::string option = fmt::format("<option timestep=\"0.5\" integrator=\"{}\"/>", integrator);
    const Json report = suggested(model(damped, option));
    expectBracket(report, bar.reference().criticalStep());
    EXPECT_EQ(report["timestep"]["verdict"], "not-certified");
    EXPECT_FALSE(report["start"].contains("unstable_steps"));
    EXPECT_THAT(report["notes"].dump(), HasSubstr("<edge> damping is implicit"));
    EXPECT_THAT(
        call("inspect model.xml").out,
        HasSubstr("your timestep 0.5 s is not proven stable (what is left out of the flex may let a larger step "
                  "be stable)"));
    EXPECT_EQ(suggested(model(bar.flexcomp(elastic), option))["timestep"]["verdict"], "violated");
  }
  // So are damping and inertia that the joints of the vertices have by default.
  const Json report = suggested(model(
      bar.flexcomp(elastic), "<option timestep=\"0.5\"/><default><joint damping=\"1\" armature=\"0\"/></default>"));
  EXPECT_EQ(report["timestep"]["verdict"], "not-certified");
  EXPECT_THAT(report["notes"].dump(), HasSubstr("model.xml:2: <joint> damping of the joints of vertices: left out"));
}

// As MuJoCo saves a model: bodies with three slide joints, and a flex of them.
TEST_F(MujocoModels, TakeAFlexOfBodiesAsTheyTakeAFlexcomp) {
  const Bar bar;
  std::string bodies, names;
  Reference reference = bar.reference();
  for (std::size_t i = 0; i < bar.points.size(); ++i) {
    const Eigen::Vector3d& p = bar.points[i];
    if (i == 2) {
      names += "world ";
      reference.pinned[i] = true;
      continue;
    }
    reference.masses[i] = 0.05 + 0.001 * static_cast<double>(i % 5);
    bodies += fmt::format(
        "<body name=\"v{}\" pos=\"{} {} {}\" childclass=\"slides\"><inertial pos=\"0 0 0\" mass=\"{}\" diaginertia=\"1 "
        "1 "
        "1\"/><joint axis=\"1 0 0\"/><joint axis=\"0 1 0\"/><joint/></body>\n",
        i, p[0], p[1], p[2], reference.masses[i]);
    names += fmt::format("v{} ", i);
  }
  const auto flex = [&](const std::string& list) {
    std::string vertices;
    for (std::size_t i = 0; i < bar.points.size(); ++i)
      vertices += i == 2 ? fmt::format("{} {} {} ", bar.points[2][0], bar.points[2][1], bar.points[2][2]) : "0 0 0 ";
    return fmt::format(
        "<deformable><flex name=\"soft\" dim=\"3\" body=\"{}\" vertex=\"{}\" element=\"{}\">{}</flex></deformable>\n"
        "<default><default class=\"slides\"><joint type=\"slide\" axis=\"0 0 1\"/></default></default>",
        list, vertices, bar.elementText(), elastic);
  };
  expectBracket(suggested(model(bodies, flex(names))), reference.criticalStep());
  EXPECT_THAT(call("inspect model.xml").out, Not(HasSubstr("left out, they are no")));

  // What all joints have is told once.
  std::string damped = bodies;
  for (std::size_t at = 0; (at = damped.find("<joint", at)) != std::string::npos; at += 6)
    damped.insert(at + 6, " damping=\"1\" armature=\"0.1\"");
  const Json notes = suggested(model(damped, flex(names)))["notes"];
  int told = 0;
  for (const Json& note : notes)
    told += note.get<std::string>().find("of the joints of vertices") == std::string::npos ? 0 : 1;
  EXPECT_EQ(told, 2) << notes;
  EXPECT_THAT(notes.dump(), HasSubstr(fmt::format("damping of the joints of vertices ({} times): left out",
                                                  3 * (bar.points.size() - 1))));

  write(model(bodies, flex(names) + "<actuator><adhesion body=\"v3\"/></actuator>"));
  expectRefused("inspect model.xml", "<adhesion> body=\"v3\": acts on a vertex of a flex");
  write(model(bodies, flex(names) + "<tendon><spatial stiffness=\"1\"><geom geom=\"v3\"/></spatial></tendon>"));
  expectRefused("inspect model.xml", "<geom> geom=\"v3\": acts on a vertex of a flex");

  expectRefused("inspect none.xml", "none.xml");
  write(model(bodies, flex(names + "v99")));
  expectRefused("inspect model.xml", "model.xml:2: <flex> has 24 vertices and 25 bodies; must be as many");
  write(model(bodies + "<body name=\"v2\"><joint type=\"hinge\"/></body>", flex("v2 " + names.substr(3))));
  expectRefused("inspect model.xml", "<joint> in \"v2\", a vertex of a flex: such a body has three slide joints alone");
}

TEST_F(MujocoModels, AnswerForTheFlexWithTheLeastStep) {
  const std::string grid =
      "<flexcomp name=\"{}\" dim=\"3\" count=\"3 3 2\" spacing=\".1 .1 .1\" mass=\"{}\">{}</flexcomp>";
  const auto one = [&](const char* name, double mass) { return fmt::format(fmt::runtime(grid), name, mass, elastic); };
  const Json light = suggested(model(one("a", 0.5))), heavy = suggested(model(one("b", 2)));
  EXPECT_NEAR(heavy["start"]["safe"].get<double>(), 2 * light["start"]["safe"].get<double>(), 1e-9);
  write(model(one("a", 0.5) + "\n" + one("b", 2)));
  const Outcome outcome = call("inspect model.xml --json a.json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json both = json("a.json");
  EXPECT_NEAR(both["critical_step"]["safe"].get<double>(), light["start"]["safe"].get<double>(), 1e-6);
  EXPECT_NEAR(both["mass"].get<double>(), 2.5, 1e-12);
  EXPECT_EQ(both["mesh"]["node_sets"]["b"], 18);
  EXPECT_EQ(both["controlling_element"]["block"], 0);
  write(model(one("a", 0.5) + "\n" + one("a", 2)));
  expectRefused("inspect model.xml", "model.xml:5: <flexcomp>: \"a\" is the name of another flex, too");
}

TEST_F(MujocoModels, CutCellsAroundTheirDiagonalAndShareTheMass) {
  const FlexModel grid =
      read(model("<flexcomp name=\"g\" dim=\"3\" count=\"3 4 2\" spacing=\".1 .2 .3\" mass=\"6\">" +
                 std::string(elastic) + "<pin grid=\"0 0 0\" gridrange=\"2 0 0 2 3 0\" id=\"5\"/></flexcomp>"));
  const Flex& flex = grid.flexes.at(0);
  ASSERT_EQ(flex.points.size(), 24);
  ASSERT_EQ(flex.tetrahedra.size(), 6 * 2 * 3 * 1);
  EXPECT_TRUE(flex.points[0].isApprox(Eigen::Vector3d(-0.1, -0.3, -0.15)));
  EXPECT_TRUE(flex.points[1].isApprox(Eigen::Vector3d(-0.1, -0.3, 0.15)));  // z runs fastest
  EXPECT_TRUE(flex.points[8].isApprox(Eigen::Vector3d(0, -0.3, -0.15)));
  EXPECT_EQ(flex.pinned, (std::vector<std::int32_t>{0, 5, 16, 18, 20, 22}));
  EXPECT_THAT(flex.masses, ::testing::Each(0.25));
  double volume = 0;
  for (const auto& t : flex.tetrahedra) {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(1), high = -low;
    for (const std::int32_t v : t) {
      low = low.cwiseMin(flex.points[static_cast<std::size_t>(v)]);
      high = high.cwiseMax(flex.points[static_cast<std::size_t>(v)]);
    }
    // With this diagonal, around which there are six, a cell's tetrahedra are known.
    for (const Eigen::Vector3d& end :
         {Eigen::Vector3d(high[0], low[1], low[2]), Eigen::Vector3d(low[0], high[1], high[2])})
      EXPECT_TRUE(std::any_of(t.begin(), t.end(),
                              [&](std::int32_t v) { return flex.points[static_cast<std::size_t>(v)].isApprox(end); }));
    const auto at = [&](std::size_t k) { return flex.points[static_cast<std::size_t>(t[k])]; };
    const double own = (at(1) - at(0)).cross(at(2) - at(0)).dot(at(3) - at(0)) / 6;
    EXPECT_GT(own, 0);
    volume += own;
  }
  EXPECT_NEAR(volume, 0.2 * 0.6 * 0.3, 1e-15);
}

TEST_F(MujocoModels, FillShellsFromTheirMiddle) {
  const auto shell = [&](const char* type) {
    return read(model(fmt::format("<flexcomp name=\"s\" type=\"{}\" dim=\"3\" count=\"5 4 3\" spacing=\".1 .2 .3\">{}"
                                  "</flexcomp>",
                                  type, elastic)))
        .flexes.at(0);
  };
  const auto volumeOf = [](const Flex& flex) {
    double volume = 0;
    for (const auto& t : flex.tetrahedra) {
      const auto at = [&](std::size_t k) { return flex.points[static_cast<std::size_t>(t[k])]; };
      volume += (at(1) - at(0)).cross(at(2) - at(0)).dot(at(3) - at(0)) / 6;
    }
    return volume;
  };
  const Flex box = shell("box"), cylinder = shell("cylinder"), ellipsoid = shell("ellipsoid");
  for (const Flex* flex : {&box, &cylinder, &ellipsoid}) {
    EXPECT_EQ(flex->points.size(), 1 + 5 * 4 * 3 - 3 * 2 * 1);
    EXPECT_EQ(flex->tetrahedra.size(), 4 * (4 * 3 + 4 * 2 + 3 * 2));
    EXPECT_EQ(flex->points[0], Eigen::Vector3d(0, 0, 0));
  }
  EXPECT_NEAR(volumeOf(box), 0.4 * 0.6 * 0.6, 1e-14);
  for (std::size_t i = 1; i < ellipsoid.points.size(); ++i)
    EXPECT_NEAR(ellipsoid.points[i].cwiseQuotient(Eigen::Vector3d(0.2, 0.3, 0.3)).norm(), 1, 1e-14);
  for (std::size_t i = 1; i < box.points.size(); ++i) {
    const Eigen::Vector2d square = box.points[i].head<2>().cwiseQuotient(Eigen::Vector2d(0.2, 0.3)),
                          round = cylinder.points[i].head<2>().cwiseQuotient(Eigen::Vector2d(0.2, 0.3));
    EXPECT_NEAR(round.norm(), square.cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_EQ(cylinder.points[i][2], box.points[i][2]);
  }
  // The order of vertices, by which pins name them: z least, z largest, then y, then x.
  EXPECT_TRUE(box.points[2].isApprox(Eigen::Vector3d(-0.2, -0.1, -0.3)));
  EXPECT_TRUE(box.points[21].isApprox(Eigen::Vector3d(-0.2, -0.3, 0.3)));
  EXPECT_TRUE(box.points[41].isApprox(Eigen::Vector3d(-0.2, -0.3, 0)));
  EXPECT_TRUE(box.points[51].isApprox(Eigen::Vector3d(-0.2, -0.1, 0)));
}

TEST_F(MujocoModels, PlaceFlexesWhereTheirFramesAre) {
  const auto placed = [&](const std::string& attributes, const std::string& before, const std::string& after,
                          const std::string& more = "") {
    return read(model(before +
                          "<flexcomp name=\"f\" type=\"direct\" dim=\"3\" point=\"1 0 0  0 0 0  0 1 0  0 0 1\" "
                          "element=\"0 1 2 3\" " +
                          attributes + ">" + elastic + "</flexcomp>" + after,
                      more))
        .flexes.at(0)
        .points;
  };
  const auto expectNear = [](const Eigen::Vector3d& point, const Eigen::Vector3d& expected) {
    EXPECT_LT((point - expected).norm(), 1e-12) << point.transpose();
  };
  expectNear(placed("axisangle=\"0 0 1 90\" pos=\"1 0 0\"",
                    "<body pos=\"1 2 3\" euler=\"0 0 90\"><frame quat=\"1 1 0 0\">", "</frame></body>")[0],
             {1, 3, 4});
  expectNear(placed("euler=\"90 90 0\"", "", "")[0], {0, 1, 0});
  expectNear(placed("euler=\"90 90 0\"", "", "", "<compiler eulerseq=\"XYZ\"/>")[0], {0, 0, -1});
  expectNear(placed(fmt::format("euler=\"0 0 {}\"", std::numbers::pi / 2), "", "", "<compiler angle=\"radian\"/>")[0],
             {0, 1, 0});
  expectNear(placed("zaxis=\"2 0 0\"", "", "")[3], {1, 0, 0});
  expectNear(placed("zaxis=\"0 0 -3\"", "", "")[2], {0, -1, 0});  // half a turn about x
  expectNear(placed("xyaxes=\"0 2 0 -1 5 0\"", "", "")[0], {0, 1, 0});
  expectNear(placed("scale=\"3 1 1\" pos=\"1 0 0\"", "", "")[0], {4, 0, 0});
}

// A body falls by g (t² + h t)/2 with symplectic Euler, pins hang.
TEST_F(MujocoModels, Run) {
  const Bar bar;
  write(model(bar.flexcomp(elastic), "<option timestep=\"1e-3\" gravity=\"0 0 -2\"/>"));
  const Outcome outcome = call(
      "run model.xml --out r --set integrator.end=0.02 --set output.every=0.02 --set "
      "output.picture=false");
  ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  const auto state = loadVtuState(folder_.path() / "r/frames/frame_000002.vtu", "displacement", nullptr);
  const double t = 0.02, h = 1e-3;
  EXPECT_LT(((state.x - state.mesh.X).colwise() - Eigen::Vector3d(0, 0, -(t * t + h * t))).cwiseAbs().maxCoeff(),
            1e-15);
  EXPECT_EQ(call("inspect r --frame 2").status, 0);
}

TEST_F(MujocoModels, ReadIncludedFilesAndMeshes) {
  ASSERT_EQ(call("mesh generate bar --size 0.3 0.1 0.1 --cells 3 1 1 -o bar.msh").status, 0);
  ASSERT_EQ(shell("mkdir parts meshes && mv bar.msh meshes/bar.msh").status, 0);
  folder_.write("parts/soft.xml",
                "<mujocoinclude>\n<flexcomp name=\"bar\" type=\"gmsh\" file=\"bar.msh\" scale=\"2 2 2\">\n" +
                    std::string(elastic) + "</flexcomp>\n</mujocoinclude>\n");
  write("<?xml version=\"1.0\"?>\n<!-- a comment -->\n" +
        model("<include file=\"parts/soft.xml\"/>", "<compiler meshdir=\"meshes\"/>"));
  const Outcome outcome = call("inspect model.xml --json a.json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NEAR(json("a.json")["mesh"]["volume"].get<double>(), 8 * 0.3 * 0.1 * 0.1, 1e-12);
  EXPECT_EQ(json("a.json")["mesh"]["nodes"], 16);
  folder_.write("parts/soft.xml",
                "<mujocoinclude>\n<flexcomp name=\"bar\" dim=\"3\" spacing=\"1 two 1\"/>\n</mujocoinclude>\n");
  expectRefused("inspect model.xml", "parts/soft.xml:2: <flexcomp> spacing=\"1 two 1\": must be numbers");
}

TEST_F(MujocoModels, NameWhatIsLeftOut) {
  const std::string soft = "<flexcomp name=\"soft\" dim=\"3\" count=\"2 2 2\">" + std::string(elastic) + "</flexcomp>";
  write(
      model("<light/><geom type=\"plane\"/><body><geom/><freejoint/><body><geom/><joint/></body></body>"
            "<flexcomp name=\"cloth\"/><flexcomp name=\"rope\" dim=\"1\"/><flexcomp name=\"stone\" dim=\"3\" "
            "rigid=\"true\"/>" +
                soft,
            "<equality><weld body1=\"a\"/></equality><actuator><motor/><motor/></actuator><asset/><visual/>"));
  const Outcome outcome = call("inspect model.xml");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("model.xml: left out, they are no 3-D flexes: 2 body, 1 flexcomp of dim 1, 1 flexcomp of "
                              "dim 2, 1 freejoint, 3 geom, 1 joint, 1 light, 2 motor, 1 rigid flexcomp, 1 weld"),
                    HasSubstr("MuJoCo counts Lamé's first constant twice, as if young = 31730.8 and poisson = 0.375")));
  EXPECT_THAT(outcome.out, HasSubstr("model.xml: contact is a constraint of MuJoCo's solver, and in no bracket"));
}

TEST_F(MujocoModels, RefuseWhatTheyCannotAnswerFor) {
  const auto refuse = [&](const std::string& text, const std::string& what) {
    write(text);
    expectRefused("suggest model.xml", what);
  };
  const auto flexcomp = [](const std::string& attributes, const std::string& inside = elastic) {
    return model("<flexcomp name=\"soft\" dim=\"3\" count=\"3 3 3\" " + attributes + ">\n" + inside + "\n</flexcomp>");
  };
  refuse("<mujoco>\n<worldbody>\n</body></mujoco>", "model.xml:3: not XML: ");
  refuse("<mujoco>\n<worldbody name=\"\xc0\"/>\n</mujoco>", "model.xml:2: not UTF-8; save the model as UTF-8");
  refuse(model("<geom/>"),
         "model.xml: no <flexcomp dim=\"3\"> or <flex dim=\"3\"> that deforms, whose step could be "
         "told; there are 1 geom");
  refuse(flexcomp("", ""),
         "model.xml:4: <flexcomp> \"soft\" has no elasticity, and no force that would bound its step");
  refuse(flexcomp("dof=\"trilinear\""), "model.xml:4: <flexcomp> dof=\"trilinear\": its vertices do not move freely");
  refuse(flexcomp("dof=\"full\" spacin=\"1 1 1\""),
         "<flexcomp> has no attribute \"spacin\"; did you mean \"spacing\"?");
  refuse(flexcomp("type=\"gird\""), "type=\"gird\": did you mean \"grid\"? known are grid, box,");
  refuse(flexcomp("type=\"mesh\""), "type=\"mesh\": of dim 3 is not read");
  refuse(flexcomp("mass=\"0\""), "mass=\"0\": must be > 0, kg");
  refuse(flexcomp("spacing=\"1 1\""), "spacing=\"1 1\": must be 3 numbers");
  refuse(flexcomp("spacing=\"1 1 0\""), "spacing=\"1 1 0\": must be > 0, m");
  refuse(model("<flexcomp name=\"soft\" dim=\"3\" count=\"3 1 3\"/>"), "count: 1: must be 2 or more");
  refuse(flexcomp("", "<elasticity young=\"3e4\" poisson=\"0.5\"/>"),
         "model.xml:5: <elasticity> poisson=\"0.5\": must be >= 0 and < 0.5");
  refuse(flexcomp("", "<elasticity young=\"inf\"/>"), "young=\"inf\": must be a number");
  refuse(flexcomp("", std::string(elastic) + "\n<pin id=\"27\"/>"),
         "model.xml:6: <pin> id: there is no vertex 27; there are 27, counted from 0");
  refuse(flexcomp("", std::string(elastic) + "<pin grid=\"0 0 3\"/>"),
         "grid=\"0 0 3\": 3 is out of the grid; must be 0 to 2");
  refuse(flexcomp("", std::string(elastic) + "<edge equality=\"true\"/>"),
         "<edge> equality=\"true\": constraints along edges are not in the bracket");
  refuse(flexcomp("", std::string(elastic) + "<contact passive=\"true\"/>"),
         "<contact> passive=\"true\": contact as a force");
  refuse(flexcomp("", "<plugin plugin=\"mujoco.pid\"/>"), "<plugin> is not known");
  refuse(model("<body><joint/><flexcomp name=\"soft\" dim=\"3\">" + std::string(elastic) + "</flexcomp></body>"),
         "<flexcomp> is in a body that moves (");
  refuse(model("<replicate><flexcomp name=\"soft\" dim=\"3\"/></replicate>"),
         "<replicate> has a flexcomp in it; write it out");
  const auto option = [&](const std::string& options, const std::string& inside = elastic) {
    return model("<flexcomp name=\"soft\" dim=\"3\">" + inside + "</flexcomp>", "<option " + options + "/>");
  };
  refuse(option("integrator=\"implicit\" solver=\"CG\""),
         "model.xml:2: <option> integrator=\"implicit\" with solver=\"CG\" integrates the elasticity of flexes "
         "implicitly");
  refuse(option("integrator=\"RK4\"", std::string(elastic) + "<edge damping=\"1\"/>"),
         "model.xml:2: <option>: integrator=\"RK4\": the limit of a damped flex");
  refuse(option("timestep=\"0\""), "model.xml:2: <option> timestep=\"0\": must be > 0, s");
  refuse(option("integrator=\"euler\""),
         "integrator=\"euler\": did you mean \"Euler\"? known are Euler, RK4, implicit, implicitfast");
  refuse(option("viscosity=\"1\""), "<option> viscosity=\"1\": a medium damps the vertices");
  for (const std::string force : {"passive", "spring", "damper"})
    refuse(model("<flexcomp name=\"soft\" dim=\"3\">" + std::string(elastic) + "</flexcomp>",
                 "<option><flag " + force + "=\"disable\"/></option>"),
           "<flag> " + force + "=\"disable\": takes forces of flexes away");
  refuse(model("<flexcomp name=\"soft\" dim=\"3\">" + std::string(elastic) + "</flexcomp>",
               "<equality><flex flex=\"soft\"/></equality>"),
         "<flex> flex=\"soft\": constraints of a flex are not in the bracket");
  refuse(model("<flexcomp name=\"soft\" dim=\"3\">" + std::string(elastic) + "</flexcomp>",
               "<default><joint stiffness=\"3\"/></default>"),
         "<joint> stiffness=\"3\": of the joints of vertices is not here");
  refuse(model("<include file=\"none.xml\"/>"), "model.xml:4: <include> file=\"none.xml\": there is no such file");
  refuse(model("<include file=\"model.xml\"/>"), "model.xml:4: <include> file=\"model.xml\": is included already");
  refuse(flexcomp("type=\"direct\" point=\"0 0 0 1 0 0 0 1 0 1 1 0\" element=\"0 1 2 3\""),
         "<flexcomp> \"soft\": its tetrahedron 0 has no volume");
}

// By a mesh, [[mass]] nodal_mass and [[spring]] edges.
TEST_F(MujocoModels, AreScenesThatOneCouldWrite) {
  const Bar bar;
  const Json ofModel = suggested(model(bar.flexcomp(std::string(elastic) + "<edge damping=\"3\"/>")));
  Mesh mesh;
  mesh.X.resize(3, static_cast<Eigen::Index>(bar.points.size()));
  for (std::size_t i = 0; i < bar.points.size(); ++i) mesh.X.col(static_cast<Eigen::Index>(i)) = bar.points[i];
  mesh.blocks.push_back({elementTypeOf<Tet4>, {}, {}});
  for (auto t : bar.tetrahedra) {
    const auto at = [&](std::size_t k) { return bar.points[static_cast<std::size_t>(t[k])]; };
    if ((at(1) - at(0)).cross(at(2) - at(0)).dot(at(3) - at(0)) < 0) std::swap(t[0], t[1]);
    mesh.blocks[0].connectivity.insert(mesh.blocks[0].connectivity.end(), t.begin(), t.end());
  }
  writeMesh(mesh, folder_.path() / "bar.msh");
  const std::string head = fmt::format(R"([mesh]
file = "bar.msh"
[material]
model = "stvk"
young = {}
poisson = 0.375
density = 10
[integrator]
step = 0.002
end = 1
[[mass]]
where = "all"
)",
                                       3e4 * 1.375 / 1.3);
  const std::string along = "[[spring]]\nwhere = \"all\"\nedges = true\nstiffness = 0\ndamping = 3\n";
  folder_.write("scene.toml", head + fmt::format("nodal_mass = {}\n", 2.0 / 24) + along);
  const Json ofScene = parse(call("suggest scene.toml --json -").out);
  for (const char* side : {"safe", "optimistic"})
    EXPECT_NEAR(ofScene["start"][side].get<double>(), ofModel["start"][side].get<double>(),
                1e-2 * ofModel["start"][side].get<double>());
  EXPECT_EQ(ofScene["timestep"]["steps"], ofModel["timestep"]["steps"]);
}

}  // namespace
}  // namespace ringwatch
