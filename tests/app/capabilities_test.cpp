// The table of what goes together, against scenes that have each feature and each pair of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ringwatch/app/scene/capabilities.h>
#include <ringwatch/base/error.h>

#include <tests/support/temporary_folder.h>
#include "program.h"

namespace ringwatch {
namespace {

using F = Feature;
using ::testing::HasSubstr;

/// What gives test::tiny a feature: sections, and settings that win over the file.
struct Sample {
  Feature feature;
  std::string sections;
  std::vector<std::string> settings;
};
const std::string spring = "[[spring]]\nwhere = \"x > 0.05\"\nstiffness = 1.0\n",
                  plane = "[[obstacle]]\nkind = \"plane\"\npoint = [0, 0, -1]\nnormal = [0, 0, 1]\n";
const std::vector<Sample> samples = {
    {F::handler, "", {"handler.method=imex"}},
    {F::timed, "[[force]]\nwhere = \"all\"\nacceleration = [0, 0, 1]\nfactor = \"t\"\n", {}},
    {F::pressure, "[[pressure]]\nwhere = \"x > 0\"\npressure = 1\n", {}},
    {F::discrete, spring, {}},
    {F::surfaces, "[[contact]]\nwith = \"surface\"\n", {}},
    {F::movingObstacles, plane + "velocity = [0, 0, 1]\n[[contact]]\n", {}},
    {F::dashpots, spring + "damping = 1\n", {}},
    {F::friction, plane + "[[contact]]\nfriction = 0.1\n", {}},
    {F::elementDamping, "", {"damping.bulk_viscosity=true"}},
    {F::rayleigh, "", {"damping.mass=1"}},
    {F::stiffnessDamping, "", {"damping.stiffness=1e-5"}},
    {F::provenDamping, "", {"damping.mass=1"}},
    {F::rigid, "[[rigid]]\nname = \"r\"\nwhere = \"x > 0.03 and x < 0.07\"\n", {}},
    {F::cuts, "[[cut]]\ntime = 0.01\npoint = [0.05, 0, 0]\nnormal = [1, 0, 0]\n", {}},
    {F::erosion, "[erosion]\ninverted = true\n", {}},
    {F::uniformStrain, "", {"material.rules=[\"hex8=uniform-strain\"]"}},
    {F::otherLaws, "", {}},
    {F::nodalMass, "[[mass]]\nwhere = \"all\"\nnodal_mass = 1\n", {}},
    {F::certificates, "", {"monitor.certificates=1"}},
    {F::mustCertify, "", {"monitor.require_certified=true"}},
    {F::gaps, "", {"monitor.every=2"}},
    {F::savedStates, "", {"output.checkpoint_every=0.01"}},
    {F::repeat, "", {"monitor.on_violation=repeat"}},
    {F::reduceStep, "", {"monitor.on_violation=reduce-step"}},
    {F::hold, "", {"integrator.step=auto", "integrator.hold=true"}},
    {F::checkpoints, "", {"output.checkpoint_every=0.01"}},
    {F::exactTimes, "", {"output.exact_times=true"}},
    {F::probes, "[[probe]]\nwhat = \"displacement\"\n", {}},
    {F::reactions, "", {"output.reactions=true"}},
    {F::metric, "", {"monitor.metric=pressure-wave"}},
    {F::noBracket, "", {"monitor.bracket=false"}},
    {F::budget, "", {"monitor.budget=0.5"}},
    {F::fields, "", {"output.fields=[\"verdict\"]"}},
    {F::handlerAuto, "", {"handler.method=imex", "integrator.step=auto"}},
    {F::handlerSolver, "", {"handler.method=imex", "handler.solver=cg"}},
    {F::handlerDamping, "", {"handler.method=imex", "damping.mass=1"}},
    {F::handlerHandle, "", {"handler.method=imex", "monitor.on_violation=handle"}},
    {F::handlerHalves, "", {"handler.method=imex", "handler.on_failure=reduce-step"}},
    {F::handlerDevices, "", {"handler.method=imex", "integrator.device=auto", "integrator.devices=[]"}},
};

class Capabilities : public testing::Test {
 protected:
  /// The scene that has some features, or why it is refused.
  Scene sceneWith(const std::vector<const Sample*>& with, const std::vector<std::string>& more = {}) {
    std::string text = replaced(test::tiny, "[\"critical_step\", \"verdict\", \"handler\"]", "[\"von_mises\"]");
    std::vector<std::string> settings = more;
    for (const Sample* sample : with) {
      text += sample->sections;
      settings.insert(settings.end(), sample->settings.begin(), sample->settings.end());
      if (sample->feature == F::otherLaws)
        text = replaced(text, "\"stvk\"\nyoung = 30e3\npoisson = 0.3", "\"yeoh\"\nc10 = 1\nc20 = 0\nc30 = 0\nbulk = 9");
    }
    folder_.write("scene.toml", text);
    return readScene(folder_.path() / "scene.toml", settings);
  }
  static std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  }
  /// Whether one of two gives a setting that the other one gives too.
  static bool share(const Sample& one, const Sample& other) {
    const auto key = [](const std::string& setting) { return setting.substr(0, setting.find('=')); };
    for (const std::string& a : one.settings)
      for (const std::string& b : other.settings)
        if (key(a) == key(b) && a != b) return true;
    return false;
  }
  test::TemporaryFolder folder_;
};

TEST_F(Capabilities, KnowEveryFeatureByItsKeys) {
  ASSERT_EQ(samples.size(), sceneFeatures().size());
  for (const Sample& sample : samples) {
    const FeatureInfo& info = sceneFeatures()[static_cast<std::size_t>(sample.feature)];
    EXPECT_EQ(info.feature, sample.feature);
    const Scene scene = sceneWith({&sample});
    EXPECT_TRUE(info.in(scene)) << info.name;
    EXPECT_FALSE(info.in(sceneWith({}))) << info.name;
  }
}

TEST_F(Capabilities, RefuseThePairsOfTheTableAndNoOthers) {
  int refused = 0;
  for (const Sample& one : samples)
    for (const Sample& other : samples) {
      if (!(one.feature < other.feature) || share(one, other)) continue;
      const FeatureInfo &first = sceneFeatures()[static_cast<std::size_t>(one.feature)],
                        &second = sceneFeatures()[static_cast<std::size_t>(other.feature)];
      const Capability entry = capability(one.feature, other.feature);
      EXPECT_EQ(entry.reason, capability(other.feature, one.feature).reason);
      std::string fault;
      try {
        sceneWith({&one, &other});
      } catch (const InputError& error) {
        fault = error.what();
      }
      if (entry.fate == Fate::works) {
        if (first.whole == second.whole) continue;  // one sample of a whole is that of a part
        EXPECT_EQ(fault.find("do not go with"), std::string::npos)
            << first.name << ", " << second.name << ": " << fault;
        continue;
      }
      refused += fault.find(" do not go with ") != std::string::npos;
      EXPECT_NE(fault, "") << first.name << ", " << second.name;
      EXPECT_EQ(fault.find('\n'), std::string::npos) << fault;
    }
  EXPECT_GT(refused, 100);
}

TEST_F(Capabilities, RefuseByIntegratorAndByUse) {
  for (const Sample& sample : samples) {
    const FeatureInfo& info = sceneFeatures()[static_cast<std::size_t>(sample.feature)];
    const Scene scene = sceneWith({&sample});
    for (const SceneUseInfo& use : sceneUses()) {
      const auto refusal = refusalOf(scene, use.use);
      if (capability(sample.feature, use.use).fate != Fate::refused) continue;
      ASSERT_TRUE(refusal) << info.name << ", " << use.name;
      EXPECT_THAT(refusal->what, HasSubstr(std::string(use.name) + " takes no "));
      EXPECT_THAT(refusal->origin, testing::AnyOf(HasSubstr("scene.toml"), HasSubstr("--set"))) << refusal->text();
    }
    if (!info.takes) continue;
    try {
      sceneWith({&sample}, {"integrator.method=cvode-bdf", "monitor.on_violation=warn", "integrator.step=1e-4"});
    } catch (const InputError& fault) {
      EXPECT_THAT(fault.what(), HasSubstr("do not go with \"cvode-bdf\"")) << info.name;
    }
  }
}

TEST_F(Capabilities, TellWhatACommandLeavesOut) {
  const auto notes = [&](Feature feature, SceneUse use) {
    return notesOfOmissions(sceneWith({&samples[static_cast<std::size_t>(feature)]}), use);
  };
  EXPECT_EQ(notes(F::cuts, SceneUse::advise), std::vector<std::string>{"cuts: it is of the body before the first cut"});
  EXPECT_EQ(notes(F::probes, SceneUse::suggest), std::vector<std::string>{});
  EXPECT_EQ(whyNoHandlers(sceneWith({&samples[static_cast<std::size_t>(F::rigid)]})),
            "handlers do not go with rigid bodies");
  EXPECT_EQ(whyNoHandlers(sceneWith({&samples[static_cast<std::size_t>(F::rayleigh)]})), "");
}

}  // namespace
}  // namespace ringwatch
