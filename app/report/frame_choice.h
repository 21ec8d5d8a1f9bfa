#pragma once
#include <cstddef>
#include <vector>

namespace ringwatch {

/// At most `count` of so many frames, ascending: first, key and last one, and evenly many between.
std::vector<std::size_t> chosenFrames(std::size_t frames, std::size_t key, std::size_t count);
/// How many frames of a mesh keep page and time within bounds, each with so many fields of elements.
std::size_t framesThatFit(std::size_t elements, std::size_t fields);

}  // namespace ringwatch
