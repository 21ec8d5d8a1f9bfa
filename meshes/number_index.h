#pragma once
#include <cstdint>
#include <optional>
#include <unordered_map>

#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// Finds nodes and elements by their numbers in the file (Mesh::nodeId, MeshBlock::id). Of those with the same number
/// the first one is found. Each index is made when it is first asked for.
class NumberIndex {
 public:
  /// By reference.
  explicit NumberIndex(const Mesh& mesh) : mesh_(mesh) {}

  std::optional<std::int32_t> node(std::int64_t number) {
    if (nodes_.empty())
      for (std::int32_t i = 0; i < static_cast<std::int32_t>(mesh_.nodeCount()); ++i)
        nodes_.try_emplace(mesh_.nodeId(i), i);
    return found(nodes_, number);
  }
  std::optional<ElementRef> element(std::int64_t number) {
    if (elements_.empty())
      for (std::size_t b = 0; b < mesh_.blocks.size(); ++b)
        for (std::size_t e = 0; e < mesh_.blocks[b].elementCount(); ++e)
          elements_.try_emplace(mesh_.blocks[b].id(e), ElementRef{b, e});
    return found(elements_, number);
  }

 private:
  template <class What>
  static std::optional<What> found(const std::unordered_map<std::int64_t, What>& index, std::int64_t number) {
    const auto at = index.find(number);
    return at == index.end() ? std::nullopt : std::optional(at->second);
  }

  const Mesh& mesh_;
  std::unordered_map<std::int64_t, std::int32_t> nodes_;
  std::unordered_map<std::int64_t, ElementRef> elements_;
};

}  // namespace ringwatch
