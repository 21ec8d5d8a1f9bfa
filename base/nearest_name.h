#pragma once
#include <algorithm>
#include <cstddef>
#include <ranges>
#include <string>
#include <string_view>
#include <vector>

namespace ringwatch {

/// Number of single-character insertions, deletions, replacements and swaps of neighbours that turn a into b (optimal
/// string alignment distance).
inline std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), previous(b.size() + 1), current(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) previous[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    current[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      current[j] = std::min({previous[j] + 1, current[j - 1] + 1, previous[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        current[j] = std::min(current[j], before[j - 2] + 1);
    }
    std::swap(before, previous);
    std::swap(previous, current);
  }
  return previous[b.size()];
}

/// The largest edit distance at which a word of that length counts as a misspelt name: one edit, and one more for every
/// four letters. Beyond, words of this length are near each other by chance ("newmark" and "pefrl" are 6 edits apart).
inline std::size_t farthestEdit(std::size_t length) { return 1 + length / 4; }

/// A word of the field and what it is called here.
struct FieldTerm {
  std::string_view word, here;
};
/// For suggestions, where a name of ours is unlike the usual ones; in lower case, blanks and underscores as hyphens.
inline constexpr FieldTerm fieldTerms[] = {
    {"leapfrog", "verlet"},
    {"leap-frog", "verlet"},
    {"central-difference", "verlet"},
    {"central-differences", "verlet"},
    {"velocity-verlet", "verlet"},
    {"newmark", "verlet"},  // explicit: beta = 0, gamma = 1/2
    {"explicit-newmark", "verlet"},
    {"semi-implicit-euler", "symplectic-euler"},
    {"forward-euler", "explicit-euler"},
    {"runge-kutta", "rk4"},
    {"e", "young"},
    {"nu", "poisson"},
    {"rho", "density"},
    {"k", "bulk"},
    {"mises", "von_mises"},
    {"vonmises", "von_mises"},
    {"von-mises-stress", "von_mises"},
    {"saint-venant-kirchhoff", "stvk"},
    {"st-venant-kirchhoff", "stvk"},
    {"hooke", "linear"},
    {"dt", "step"},
    {"time-step", "step"},
    {"timestep", "step"},
    {"duration", "end"},
    {"end-time", "end"},
    {"t-end", "end"},
    {"gravity", "acceleration"},
};

/// The candidate that a word of the field stands for, or else the one with the smallest edit distance to the word, the
/// first one among equals; "" when none is within `farthestEdit` or shares a letter with the word. Hyphens before
/// options do not count. For error messages that name what the user probably meant.
template <std::ranges::input_range Candidates>
std::string nearestName(std::string_view word, Candidates&& candidates) {
  const auto bare = [](std::string_view name) {
    return name.substr(std::min(name.find_first_not_of('-'), name.size()));
  };
  std::string plain(bare(word));
  for (char& c : plain) c = c == ' ' || c == '_' ? '-' : c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  for (const FieldTerm& term : fieldTerms)
    if (term.word == plain)
      for (const auto& candidate : candidates)
        if (bare(std::string_view(candidate)) == term.here) return std::string(std::string_view(candidate));
  std::string best;
  std::size_t bestDistance = farthestEdit(word.size()) + 1;
  for (const auto& candidate : candidates) {
    const std::string_view name = candidate;
    const std::size_t longer = std::max(word.size(), name.size()), shorter = std::min(word.size(), name.size());
    if (longer - shorter >= bestDistance) continue;  // so that a word of any length costs nothing
    const std::size_t distance = editDistance(word, name);
    if (distance < bestDistance && distance < longer) {
      bestDistance = distance;
      best = std::string(name);
    }
  }
  return best;
}

/// `did you mean "NAME"? ` with the nearest name, to stand before a list of all names; "" when none is near.
template <std::ranges::input_range Candidates>
std::string didYouMean(std::string_view word, Candidates&& candidates) {
  const std::string name = nearestName(word, candidates);
  return name.empty() ? "" : "did you mean \"" + name + "\"? ";
}

}  // namespace ringwatch
