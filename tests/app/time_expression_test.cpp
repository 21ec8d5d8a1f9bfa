// Expressions of time: values, derivatives, integrals, and the motions and loads of runs that follow them.
#include <cmath>
#include <numbers>
#include <string>

#include <ringwatch/app/scene/time_table.h>
#include <ringwatch/base/error.h>
#include <ringwatch/meshes/mesh_io.h>

#include "program.h"

namespace ringwatch {
namespace {

using test::Outcome;
using test::Program;
using ::testing::HasSubstr;

using std::numbers::pi;

std::string faultOfTime(const std::string& text, double end = 1) {
  try {
    const TimeTable table(TimeExpression(text), end);
  } catch (const InputError& fault) {
    return fault.what();
  }
  return "no fault";
}

TEST(TimeExpression, HasValuesAndDerivatives) {
  const struct {
    const char* text;
    double (*value)(double);
    double (*slope)(double);
  } cases[] = {
      {"sin(2*pi*50*t)", [](double t) { return std::sin(100 * pi * t); },
       [](double t) { return 100 * pi * std::cos(100 * pi * t); }},
      {"t^2*(3 - 2*t)", [](double t) { return t * t * (3 - 2 * t); }, [](double t) { return 6 * t * (1 - t); }},
      {"exp(-3*t)*cos(t)", [](double t) { return std::exp(-3 * t) * std::cos(t); },
       [](double t) { return std::exp(-3 * t) * (-3 * std::cos(t) - std::sin(t)); }},
      {"tanh(t)/(1 + t) - -t", [](double t) { return std::tanh(t) / (1 + t) + t; },
       [](double t) {
         const double c = std::cosh(t);
         return 1 / (c * c * (1 + t)) - std::tanh(t) / ((1 + t) * (1 + t)) + 1;
       }},
      {"sqrt(1 + t) + log(2 + t) + tan(t/3)",
       [](double t) { return std::sqrt(1 + t) + std::log(2 + t) + std::tan(t / 3); },
       [](double t) { return 0.5 / std::sqrt(1 + t) + 1 / (2 + t) + 1 / (3 * std::cos(t / 3) * std::cos(t / 3)); }},
      {"2^t", [](double t) { return std::exp2(t); }, [](double t) { return std::numbers::ln2 * std::exp2(t); }},
      {"min(1, t/0.25, 7)", [](double t) { return std::min(1.0, 4 * t); }, [](double t) { return t < 0.25 ? 4.0 : 0; }},
      {"max(abs(t - 0.5), 0.1)", [](double t) { return std::max(std::abs(t - 0.5), 0.1); },
       [](double t) { return std::abs(t - 0.5) < 0.1 ? 0
                             : t < 0.5               ? -1.0
                                                     : 1; }},
  };
  for (const auto& one : cases) {
    const TimeExpression expression(one.text);
    for (const double t : {0.0, 0.13, 0.27, 0.55, 0.9}) {
      EXPECT_NEAR(expression.at(t).value, one.value(t), 1e-13) << one.text << " at " << t;
      EXPECT_NEAR(expression.at(t).slope, one.slope(t), 1e-10) << one.text << " at " << t;
    }
  }
}

TEST(TimeExpression, IsIntegratedToRounding) {
  const TimeTable wave(TimeExpression("sin(2*pi*50*t)"), 1), kink(TimeExpression("min(1, abs(t - 0.3)/0.21)"), 1),
      constant(TimeExpression("-2"), 1);
  const double w = 100 * pi, h = 1e-3;
  for (double t = 0; t < 1; t += 0.0137) {
    EXPECT_NEAR(wave.mean(t, h), (std::cos(w * t) - std::cos(w * (t + h))) / (w * h), 5e-13) << t;
    EXPECT_NEAR(constant.mean(t, h), -2, 5.3e-15) << t;
  }
  EXPECT_NEAR(kink.mean(0, 1), 0.5 * 0.21 * 2 + 0.09 + 0.49, 1.6e-15);
  EXPECT_NEAR(kink.mean(0, 0.3), (0.5 * 0.21 + 0.09) / 0.3, 1.6e-15);
  EXPECT_NEAR(wave.largest(), 1, 3e-16);
  EXPECT_NEAR(wave.steepest() / w, 1, 3e-16);
  EXPECT_EQ(wave, TimeTable(TimeExpression("sin(2*pi*50*t)"), 1));
  EXPECT_FALSE(wave == kink);
}

TEST(TimeExpression, SaysWhatIsWrong) {
  EXPECT_THAT(faultOfTime("sin(2*pi*f*t)"), HasSubstr("column 10: unknown name \"f\""));
  EXPECT_THAT(faultOfTime("sn(t)"), HasSubstr("did you mean \"sin\"?"));
  EXPECT_THAT(faultOfTime("t < 1"), HasSubstr("is a condition, not a number"));
  EXPECT_THAT(faultOfTime("t +"), HasSubstr("found the end, expected a number, t, pi"));
  EXPECT_THAT(faultOfTime("x + t"), HasSubstr("unknown name \"x\""));
  EXPECT_THAT(faultOfTime("(t < 1)*t"), HasSubstr("a condition where a number is needed"));
  EXPECT_THAT(faultOfTime("1/t"), HasSubstr("\"1/t\" has no value at t = 0 s"));
  EXPECT_THAT(faultOfTime("sqrt(0.5 - t)"), HasSubstr("has no value at t = 0.5"));
  EXPECT_THAT(faultOfTime("sin(1e9*t)"), HasSubstr("changes too often before the end"));
  // Sooner for a long text, which takes longer at each time.
  const std::string wave = "sin(1.2e5*t)";
  std::string many = wave;
  while (many.size() < 1900) many += "+" + wave;
  EXPECT_THAT(faultOfTime(wave), HasSubstr("no fault"));
  EXPECT_THAT(faultOfTime(many), HasSubstr("changes too often before the end"));
}

constexpr const char* pulled =
    R"(mesh = {generate = "bar", size = [0.2, 0.04, 0.04], cells = [6, 1, 1], element = "hex8"}
material = {model = "stvk", young = 30e3, poisson = 0.3, density = 1000}
integrator = {method = "verlet", step = 1e-3, end = 0.05}
output = {every = 0.05, picture = false}
[[fix]]
where = "x < 1e-6"
)";

class Expressions : public Program {
 protected:
  void run(const std::string& more, const std::string& options = "") {
    folder_.write("scene.toml", std::string(pulled) + more);
    const Outcome outcome = call("run scene.toml --out r " + options);
    ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  }
  /// Of the last node of the mesh, m.
  Eigen::Vector3d endOfBar() {
    const auto frames = json("r/summary.json")["frames"].get<int>();
    const auto state =
        loadVtuState(folder_.path() / joinText("r/frames/frame_00000", frames, ".vtu"), "displacement", nullptr);
    Eigen::Index last = 0;
    state.mesh.X.row(0).maxCoeff(&last);
    return state.x.col(last) - state.mesh.X.col(last);
  }
};

TEST_F(Expressions, PrescribeADisplacementThatIsExactAtTheEndsOfSteps) {
  const std::string end = "[[move]]\nwhere = \"x > 0.2 - 1e-6\"\n";
  const double w = 2 * pi * 17, t = 0.05;
  for (const char* method : {"", "--set integrator.method=symplectic-euler --set integrator.step=0.7e-3"}) {
    run(end + "displacement = [0.01, 0.002, 0]\nfactor = \"sin(2*pi*17*t)\"\n", method);
    const double reached = json("r/summary.json")["end_time"].get<double>();
    EXPECT_NEAR(reached, t, 1e-3);
    const Eigen::Vector3d exact = Eigen::Vector3d(0.01, 0.002, 0) * std::sin(w * reached);
    EXPECT_LT((endOfBar() - exact).norm(), 1e-16) << method;
    // A velocity: its displacement is the integral.
    run(end + "velocity = [0.3, 0, -0.1]\nfactor = \"sin(2*pi*17*t)\"\n", method);
    const Eigen::Vector3d moved = Eigen::Vector3d(0.3, 0, -0.1) * (1 - std::cos(w * reached)) / w;
    EXPECT_LT((endOfBar() - moved).norm(), 1.7e-16) << method;
  }
}

TEST_F(Expressions, SayWhatATableSays) {
  const auto history = [&](const std::string& more) {
    run(more);
    return table("r/history.csv");
  };
  const struct {
    const char *load, *table, *expression;
  } cases[] = {
      {"[[move]]\nwhere = \"x > 0.2 - 1e-6\"\nvelocity = [0.2, 0, 0]\n", "times = [0, 0.02]\nfactors = [0, 1]\n",
       "factor = \"min(1, t/0.02)\"\n"},
      {"[[move]]\nwhere = \"x > 0.2 - 1e-6\"\ndisplacement = [0.02, 0, 0]\n",
       "times = [0, 0.05]\nfactors = [0, 1]\nramp = \"smooth\"\n", "factor = \"(t/0.05)^2*(3 - 2*t/0.05)\"\n"},
      {"[[force]]\nwhere = \"x > 0.1\"\nforce = [0, 0.05, 0]\n", "times = [0, 0.02, 0.03]\nfactors = [0, 1, 0]\n",
       "factor = \"max(0, min(t/0.02, 3 - t/0.01))\"\n"},
      {"[[pressure]]\nwhere = \"x > 0.2 - 1e-6\"\npressure = 50\n", "times = [0, 0.05]\nfactors = [1, 0]\n",
       "factor = \"1 - t/0.05\"\n"},
  };
  for (const auto& one : cases) {
    SCOPED_TRACE(one.load);
    const Table a = history(std::string(one.load) + one.table), b = history(std::string(one.load) + one.expression);
    ASSERT_EQ(a.rows.size(), b.rows.size());
    double largest = 0, difference = 0;
    for (std::size_t i = 0; i < a.rows.size(); ++i)
      for (const char* column : {"kinetic_J", "strain_J", "external_work_J"}) {
        largest = std::max(largest, std::abs(a.number(i, column)));
        difference = std::max(difference, std::abs(a.number(i, column) - b.number(i, column)));
      }
    EXPECT_GT(largest, 0);
    EXPECT_LT(difference, 1e-13 * largest);
  }
}

TEST_F(Expressions, MoveObstaclesAndKeepTheBalance) {
  run(R"scene([[obstacle]]
kind = "plane"
point = [0.2001, 0, 0]
normal = [-1, 0, 0]
velocity = [-0.4, 0, 0]
factor = "sin(pi*t/0.05)"
[[contact]]
)scene");
  const Table history = table("r/history.csv");
  double error = 0, strain = 0;
  for (std::size_t i = 0; i < history.rows.size(); ++i) {
    error = std::max(error, std::abs(history.number(i, "balance_error_J")));
    strain = std::max(strain, history.number(i, "strain_J"));
  }
  EXPECT_GT(strain, 1e-3);
  EXPECT_LT(error, 8.4e-4 * strain);
}

TEST_F(Expressions, AreRefusedInOneLine) {
  const auto refused = [&](const std::string& more, const std::string& what) {
    folder_.write("scene.toml", std::string(pulled) + "[[move]]\nwhere = \"x > 0.2 - 1e-6\"\n" + more);
    expectRefused("run scene.toml --out bad", what);
    EXPECT_FALSE(exists("bad"));
  };
  refused("velocity = [1, 0, 0]\nfactor = \"sin(w*t)\"\n", "move.factor: \"sin(w*t)\": column 5: unknown name \"w\"");
  refused("velocity = [1, 0, 0]\nfactor = \"1/t\"\n", "move.factor: \"1/t\" has no value at t = 0 s");
  refused("velocity = [1, 0, 0]\nfactor = \"t\"\ntimes = [0, 1]\nfactors = [0, 1]\n",
          "move.factor: both factor and times are given");
  refused("displacement = [1, 0, 0]\n", "it needs a factor that begins at 0");
  refused("displacement = [1, 0, 0]\nfactor = \"cos(t)\"\n", "its factor is 1 at t = 0");
  refused("displacement = [1, 0, 0]\nfactor = \"sqrt(t)\"\n", "begins with no finite velocity");
  refused("displacement = [1, 0, 0]\nvelocity = [1, 0, 0]\nfactor = \"t\"\n",
          "both displacement and velocity are given");
  refused("displacement = [1, 0, 0]\ntimes = [0, 1]\nfactors = [0, 1]\nramp = \"hold\"\n",
          "would make a displacement jump");
  refused("displacement = [1, 0, 0]\nfactor = \"t\"\n[[fix]]\nwhere = \"x > 0.2 - 1e-6\"\n", "prescribe the motion");
}

}  // namespace
}  // namespace ringwatch
