#pragma once
#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <ringwatch/app/scene/deck_keywords.h>
#include <ringwatch/app/scene/scene.h>
#include <ringwatch/meshes/formats/file_cursor.h>

#include <tests/monitor/monitor_cases.h>
#include "program.h"

namespace ringwatch::test {

/// Decks, and the scenes that they stand for.
class DeckProgram : public Program {
 protected:
  /// Runs a deck and the scene that it stands for, of its mesh or of another one: masses, frequencies at rest, brackets
  /// and energies are the same.
  void expectSame(const std::string& name, const std::string& deck, const std::string& scene,
                  const std::string& integrator, const std::string& mesh = "") {
    use(name, deck);
    ++heldDecks;
    folder_.write("scene.toml", "[mesh]\n" + (mesh.empty() ? "file = \"" + name + "\"\n" : mesh) + "[integrator]\n" +
                                    integrator + scene);
    const Outcome ofDeck = call("run " + name + " --out d --set output.picture=false"),
                  ofScene = call("run scene.toml --out s --set output.picture=false");
    ASSERT_EQ(ofDeck.status, ofScene.status) << ofDeck.err << ofScene.err;
    ASSERT_LE(ofDeck.status, 1) << ofDeck.err << ofScene.err;
    out_ = ofDeck.out;
    const Json one = json("d/summary.json"), other = json("s/summary.json");
    EXPECT_NEAR(one["mass"].get<double>() / other["mass"].get<double>(), 1, 1e-12);
    mass_ = one["mass"];
    expectFrequencies(sceneOfModel(folder_.path() / name, DeckUse::run), readScene(folder_.path() / "scene.toml"));
    const Table rows = table("d/history.csv"), expected = table("s/history.csv");
    ASSERT_EQ(rows.rows.size(), expected.rows.size());
    for (const std::size_t row : {std::size_t{0}, rows.rows.size() - 1})
      for (const char* column : {"h_s", "safe_s", "optimistic_s", "kinetic_J", "strain_J", "external_work_J"}) {
        if (rows.at(row, column) == expected.at(row, column)) continue;  // infinite where every step is stable
        const double value = expected.number(row, column);
        EXPECT_NEAR(rows.number(row, column), value, 1e-12 * std::abs(value)) << column;
      }
    const Outcome inspected = call("inspect " + name + " --json -");
    ASSERT_EQ(inspected.status, 0) << inspected.err;
    if (one["handler"].is_null()) {
      EXPECT_NEAR(parse(inspected.out)["mass"].get<double>() / mass_, 1, 1e-12);
    }
  }
  /// The lowest frequency of vibration and the highest one.
  static void expectFrequencies(const Scene& ofDeck, const Scene& ofScene) {
    const auto squares = [](const Scene& scene) {
      std::vector<std::string> notes;
      const Body body = sceneBody(scene, sceneMesh(scene, notes), 1);
      return DenseTangent(body, body.mesh().X).eigenvalues();
    };
    const Eigen::VectorXd own = squares(ofDeck), other = squares(ofScene);
    ASSERT_EQ(own.size(), other.size());
    if (other.size() == 0) return;  // all is held
    const double highest = other.tail(1)[0];
    const Eigen::Index lowest = (other.array() < 1e-9 * highest).count();  // above those of rigid motions
    EXPECT_NEAR(std::sqrt(own[lowest] / other[lowest]), 1, 1e-12);
    EXPECT_NEAR(std::sqrt(own.tail(1)[0] / highest), 1, 1e-12);
  }
  /// Writes a deck, or a file that one includes, and remembers its keywords.
  void use(const std::string& name, const std::string& text) {
    folder_.write(name, text);
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with('*') || line.starts_with("**")) continue;
      std::erase(line, ' ');
      usedKeywords.insert(detail::inUpperCase(line.substr(1, line.find(',') - 1)));
    }
  }
  /// Once all tests of a suite have run, decks that were held to scenes have used every keyword that is taken.
  static void expectAllUsed(std::span<const DeckKeywordRule> rules) {
    const auto* suite = ::testing::UnitTest::GetInstance()->current_test_suite();
    const std::set<std::string> used = std::exchange(usedKeywords, {});
    const int decks = std::exchange(heldDecks, 0);
    if (suite->successful_test_count() < suite->total_test_count()) return;
    EXPECT_GE(decks, 20);
    for (const DeckKeywordRule& row : rules) {
      if (row.rule != DeckRule::mesh && row.rule != DeckRule::taken && row.rule != DeckRule::takenInRun) continue;
      std::istringstream names{std::string(row.names)};
      for (std::string name; names >> name;) {
        const bool family = name.ends_with('*');
        if (family) name.pop_back();
        EXPECT_TRUE(std::ranges::any_of(used, [&](const std::string& line) {
          if (!line.starts_with(name)) return false;
          const std::string rest = line.substr(name.size());
          return family || rest.empty() || rest == "_TITLE" || rest == "_ID" ||
                 (rest[0] != '_' && std::ispunct(rest[0]));
        })) << name;
      }
    }
  }
  static inline std::set<std::string> usedKeywords;
  static inline int heldDecks = 0;
  double mass_ = 0;
  std::string out_;
};

}  // namespace ringwatch::test
