#pragma once
#include <cmath>
#include <string>

#include "program.h"

namespace ringwatch::test {

/// Decks, and the scenes that they stand for.
class DeckProgram : public Program {
 protected:
  /// Runs a deck and the scene of its mesh: masses, brackets and energies are the same.
  void expectSame(const std::string& name, const std::string& deck, const std::string& scene,
                  const std::string& integrator) {
    folder_.write(name, deck);
    folder_.write("scene.toml", "[mesh]\nfile = \"" + name + "\"\n[integrator]\n" + integrator + scene);
    const Outcome ofDeck = call("run " + name + " --out d --set output.picture=false"),
                  ofScene = call("run scene.toml --out s --set output.picture=false");
    ASSERT_EQ(ofDeck.status, ofScene.status) << ofDeck.err << ofScene.err;
    ASSERT_LE(ofDeck.status, 1) << ofDeck.err << ofScene.err;
    out_ = ofDeck.out;
    const Json one = json("d/summary.json"), other = json("s/summary.json");
    EXPECT_NEAR(one["mass"].get<double>() / other["mass"].get<double>(), 1, 1e-12);
    mass_ = one["mass"];
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
  double mass_ = 0;
  std::string out_;
};

}  // namespace ringwatch::test
