#include <ringwatch/app/report/frame_choice.h>

#include <algorithm>
#include <cmath>

#include <ringwatch/app/report/mesh_pack.h>

namespace ringwatch {

std::vector<std::size_t> chosenFrames(std::size_t frames, std::size_t key, std::size_t count) {
  count = std::min(count, frames);
  std::vector<std::size_t> wanted{key, 0, frames - 1};
  for (std::size_t k = 1; k + 1 < count; ++k) wanted.push_back(k * (frames - 1) / (count - 1));
  std::vector<std::size_t> chosen;
  for (const std::size_t i : wanted)
    if (chosen.size() < count && std::find(chosen.begin(), chosen.end(), i) == chosen.end()) chosen.push_back(i);
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

std::size_t framesThatFit(std::size_t elements, std::size_t fields) {
  // Two numbers of 16 bits a node and element go into the page where all elements do.
  constexpr std::size_t bytesOfPage = 6'000'000, most = 60;
  // Of larger meshes those with the least steps, and the surface, which grows more slowly than the body.
  const double surface = 12 * std::pow(static_cast<double>(elements), 2.0 / 3.0);
  const double shown = elements <= MeshPack::allElements
                           ? static_cast<double>(elements)
                           : std::min(static_cast<double>(elements), surface + 2 * MeshPack::leastElements);
  const double bytes = shown * (6 + 2 * static_cast<double>(std::max<std::size_t>(1, fields)));
  // Reading and packing take about 0.4 µs an element and frame.
  constexpr double elementsRead = 2e6;
  const double fit = std::min(static_cast<double>(bytesOfPage) / bytes, elementsRead / static_cast<double>(elements));
  return std::clamp<std::size_t>(static_cast<std::size_t>(fit), 2, most);
}

}  // namespace ringwatch
