#pragma once
#include <span>
#include <string>
#include <string_view>

namespace ringwatch {

// The keywords of decks, and what is done with each.

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
  /// Without blanks, as CalculiX compares them, one blank between two; "DATABASE_*" is all that begin so and that no
  /// other row has.
  std::string_view names;
  std::string_view why = {};
};
/// A parameter of a keyword, without blanks. The first row whose value is that of the deck counts; "" is any value.
struct DeckParameterRule {
  std::string_view keyword, parameter, value;
  DeckRule rule;
  std::string_view why = {};  // with `harmless`: what is told
};

/// The row that has the keyword; nullptr for one that is not known.
const DeckKeywordRule* findKeywordRule(std::span<const DeckKeywordRule> rules, std::string_view name);
/// The keywords with what is done with each.
std::string keywordListing(std::span<const DeckKeywordRule> rules);
/// Of Abaqus and CalculiX.
std::span<const DeckKeywordRule> abaqusKeywords();
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
/// The type of an element of ours with as many nodes: the one with this quadrature rule, else the first. nullptr where
/// there is none.
const DeckSolid* findDeckSolidOf(std::string_view element, std::string_view rule);

// Reasons that the reader tells, too.
inline constexpr std::string_view noStructure = "there are solid elements only";
inline constexpr std::string_view noElement = "there is no such element";
inline constexpr std::string_view cornersAlone =
    "its middle nodes are left out, with what a run would hold and load there; at rest the linear wedge stands for it";
inline constexpr std::string_view noTemperature = "there are no temperatures";
inline constexpr std::string_view hourglassHere =
    "the hourglass control here is of stiffness, material.hourglass_stiffness, and viscosity, "
    "material.hourglass_viscosity";

inline constexpr std::string_view notAtRest =
    "changes the tangent and with it the critical step, and a body begins without stress here; leave it out, or give "
    "the state by its displacement: ringwatch inspect STATE.vtu --displacement FIELD";
inline constexpr std::string_view movesNodes = "moves nodes before the start; move them in the mesh";
inline constexpr std::string_view noConstraint = "ties degrees of freedom to each other";
inline constexpr std::string_view noLaw = "there is no such law";
inline constexpr std::string_view elsewhere = "takes values from elsewhere";

/// Every keyword of both dialects with what is done with it, for the help and the reference.
std::string deckHelp();

}  // namespace ringwatch
