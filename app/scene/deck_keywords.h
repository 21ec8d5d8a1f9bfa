#pragma once
#include <string>
#include <string_view>

namespace ringwatch {

// The keywords of Abaqus and CalculiX decks, and what is done with each.

/// What is done with a keyword, or with a parameter of one.
enum class DeckRule {
  mesh,         // read with the mesh
  harmless,     // no effect on the motion
  other,        // done in another way, which every command tells
  output,       // asks for results
  taken,        // by the reader of decks
  takenInRun,   // likewise; at rest it does not matter
  temperature,  // strains a body with *EXPANSION, and is harmless without
  expansion,    // harmless without temperatures
  load,         // refused in a run; at rest it does not matter
  procedure,    // likewise
  refused       // changes the body
};
/// Keywords of which the same is done.
struct DeckKeywordRule {
  DeckRule rule;
  std::string_view names;  // without blanks, as CalculiX compares them, one blank between two
  std::string_view why = {};
};
/// A parameter of a keyword, without blanks. The first row whose value is that of the deck counts; "" is any value.
struct DeckParameterRule {
  std::string_view keyword, parameter, value;
  DeckRule rule;
  std::string_view why = {};  // with `harmless`: what is told
};

/// The row that has the keyword; nullptr for one that is not known.
const DeckKeywordRule* findKeywordRule(std::string_view name);
/// nullptr for a parameter that is not known of the keyword. value: in upper case without blanks.
const DeckParameterRule* findParameterRule(std::string_view keyword, std::string_view parameter,
                                           std::string_view value);
/// "A, B" of the parameters of a keyword that are taken.
std::string takenParameters(std::string_view keyword);

/// A solid element of a deck and the quadrature that CalculiX gives it (user's manual, "Element types"); of those that
/// only Abaqus has, the nearest.
struct DeckSolid {
  std::string_view type;
  std::string_view element;  // ours; "" where no element of ours is it
  std::string_view rule;
  std::string_view why = {};  // where there is an element: what is told
};
/// nullptr for a type that is not known.
const DeckSolid* findDeckSolid(std::string_view type);

// Reasons that the reader tells, too.
inline constexpr std::string_view noStructure = "there are solid elements only";
inline constexpr std::string_view noElement = "there is no such element";
inline constexpr std::string_view noTemperature = "there are no temperatures";
inline constexpr std::string_view massOfAll = "mass is added for the step of the whole body; leave the set out";
inline constexpr std::string_view hourglassHere =
    "the hourglass control here is of stiffness, material.hourglass_stiffness, and viscosity, "
    "material.hourglass_viscosity";

/// Every keyword with what is done with it, for the help and the reference.
std::string deckHelp();

}  // namespace ringwatch
