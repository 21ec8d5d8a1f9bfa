#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include <ringwatch/app/scene/deck_keywords.h>

namespace ringwatch {

// The keywords of LS-DYNA decks, and what is done with each.

std::span<const DeckKeywordRule> dynaKeywords();

/// What a formulation of *SECTION_SOLID makes of an element: one of ours with a quadrature rule.
struct DynaSolid {
  std::int64_t form;         // ELFORM
  std::string_view element;  // ours; "" where it is refused whatever the element
  std::string_view rule;
  std::string_view why = {};  // what is told, or why it is refused
};
/// The rows of a formulation; empty for one that is not known.
std::span<const DynaSolid> dynaSolids(std::int64_t form);

/// A law of LS-DYNA.
enum class DynaLaw { elastic, blatzKo, mooneyRivlin, hyperelastic, ogden, rigid };
struct DynaLawEntry {
  std::string_view names;  // of *MAT_, one blank between two
  DynaLaw law;
  std::string_view model;  // ours
  std::string_view why;    // what is told of runs; "" for nothing
  std::size_t cards = 0;   // that it has; 0 for any number
};
/// By what stands behind *MAT_; nullptr for a law that is not taken.
const DynaLawEntry* findDynaLaw(std::string_view name);

/// Every keyword with what is done with it.
std::string dynaHelp();

}  // namespace ringwatch
