// What runs leave in their folders is what `ringwatch help outputs` explains, no more and no less.
#include <algorithm>
#include <filesystem>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ringwatch/app/output/output_fields.h>
#include <ringwatch/base/error.h>
#include <ringwatch/body/element_stress.h>

#include "program.h"

namespace ringwatch {
namespace {

using test::Json;
using test::Outcome;
using test::Program;
using test::tiny;

/// The keys of a value as OutputField names them; of what is null or empty, the key itself.
void addKeys(const Json& value, const std::string& path, std::set<std::string>& keys) {
  if (value.is_object() && !value.empty()) {
    for (const auto& [key, inner] : value.items()) addKeys(inner, path.empty() ? key : path + "." + key, keys);
  } else if (value.is_array() && !value.empty()) {
    for (const Json& inner : value) addKeys(inner, path + "[]", keys);
  } else {
    keys.insert(path);
  }
}

bool isExplained(const std::string& key) {
  return std::ranges::any_of(summaryKeys(), [&](const OutputField& field) {
    if (field.name.ends_with(".*")) return key.starts_with(field.name.substr(0, field.name.size() - 1));
    // A null or an empty list stands for all that would be in it.
    return field.name == key || field.name.starts_with(key + ".") || field.name.starts_with(key + "[");
  });
}

class Outputs : public Program {
 protected:
  Json summaryOf(const std::string& arguments, int status) {
    const std::string folder = "r" + std::to_string(runs_++);
    const Outcome outcome = call("run " + arguments + " --out " + folder);
    EXPECT_EQ(outcome.status, status) << arguments << "\n" << outcome.out << outcome.err;
    last_ = folder;
    return json(folder + "/summary.json");
  }
  std::string last_;  // folder of the last run

 private:
  int runs_ = 0;
};

TEST_F(Outputs, SummariesHaveTheKeysThatHelpExplains) {
  folder_.write("tiny.toml", tiny);
  std::set<std::string> seen;
  addKeys(summaryOf("tiny.toml", 0), "", seen);
  addKeys(summaryOf("tiny.toml --set integrator.step=0.02 --set integrator.end=10 --set monitor.on_violation=warn "
                    "--set output.every=1 --quiet",
                    1),
          "", seen);
  addKeys(summaryOf("tiny.toml --set monitor.on_violation=repeat", 0), "", seen);
  addKeys(summaryOf("'" RINGWATCH_EXAMPLES "/two_material_bar.toml' --set integrator.end=2e-3 --set "
                    "integrator.step=5e-4 --set monitor.on_violation=warn",
                    1),
          "", seen);
  addKeys(
      summaryOf("'" RINGWATCH_EXAMPLES "/four_cuts.toml' --set integrator.end=0.22 --set cut.0.critical_step=true", 0),
      "", seen);
  addKeys(summaryOf("'" RINGWATCH_EXAMPLES "/rubber_block.toml' --set contact.0.penalty=3e6", 1), "", seen);
  const std::string scene(tiny), one = "model = \"stvk\"\nyoung = 30e3\npoisson = 0.3\ndensity = 1000\n";
  std::string two = scene;
  two.replace(two.find("[material]\n" + one), 11 + one.size(),
              "[[material]]\nwhere = \"x < 0.05\"\n" + one + "[[material]]\nwhere = \"x >= 0.05\"\n" + one);
  folder_.write("eroding.toml", two +
                                    "[[rigid]]\nwhere = \"abs(x - 0.04) < 1e-6\"\n[erosion]\nmax_stretch = 1.02\n"
                                    "[[probe]]\nwhat = \"velocity\"\n");
  addKeys(summaryOf("eroding.toml", 0), "", seen);
  for (const std::string& key : seen) EXPECT_TRUE(isExplained(key)) << key;
  for (const OutputField& field : summaryKeys())
    if (field.name.ends_with(".*")) {
      EXPECT_TRUE(std::ranges::any_of(seen, [&](const std::string& key) {
        return key.starts_with(field.name.substr(0, field.name.size() - 1));
      })) << field.name;
    } else {
      // An object that is null nowhere is seen by its keys.
      const std::string name(field.name);
      if (name.starts_with("traffic.")) continue;  // of runs on ranks: tests/ranks/ranks_test.cpp
      EXPECT_TRUE(seen.contains(name) ||
                  (field.type == FieldType::object &&
                   std::ranges::any_of(seen, [&](const std::string& key) { return key.starts_with(name + "."); })))
          << name;
    }
}

TEST_F(Outputs, FramesHaveTheFieldsThatHelpExplains) {
  folder_.write("tiny.toml", tiny);
  std::string wanted = "\"reduced-1-ring\",\"nodal-bound\",\"verdict\",\"handler\"";
  for (const StressMeasure& measure : allStressMeasures()) wanted += joinText(",\"", measure.name, "\"");
  summaryOf("tiny.toml --set 'output.fields=[" + wanted + "]'", 0);
  const std::string frame = folder_.read(last_ + "/frames/frame_000001.vtu");
  std::set<std::string> fields;
  for (std::size_t at = frame.find("Name=\""); at != std::string::npos; at = frame.find("Name=\"", at + 1)) {
    const std::size_t begin = at + 6;
    fields.insert(frame.substr(begin, frame.find('"', begin) - begin));
  }
  EXPECT_FALSE(fields.empty());
  for (const OutputField& field : frameFields()) {
    std::string name(field.name);
    if (name == "material" || name.starts_with("step estimate")) continue;  // not of this run
    if (const std::size_t metric = name.find("METRIC"); metric != std::string::npos) name = name.substr(0, metric);
    EXPECT_TRUE(std::ranges::any_of(fields, [&](const std::string& found) { return found.starts_with(name); })) << name;
  }
}

}  // namespace
}  // namespace ringwatch
