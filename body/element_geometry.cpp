#include <ringwatch/body/element_geometry_functions.h>

#include <memory>
#include <tuple>

namespace ringwatch {
namespace {
/// Makes the functions above for every element of the registry: taking their addresses instantiates them here.
template <class Element>
std::unique_ptr<ElementGeometry<Element>> make(const ElementBlock& block, const Mesh& mesh,
                                               const MeshBlock& meshBlock) {
  return std::make_unique<ElementGeometry<Element>>(block, mesh, meshBlock);
}
template <class... Es>
constexpr auto everyFunction(TypeList<Es...>) {
  return std::tuple_cat(std::make_tuple(
      &make<Es>, &ElementGeometry<Es>::meanGradients, &ElementGeometry<Es>::loadEdgesFromMesh,
      &ElementGeometry<Es>::gatherPoints, &ElementGeometry<Es>::laplacianOf, &ElementGeometry<Es>::gradientNormBatch,
      &ElementGeometry<Es>::minimumDeterminantBatch, &ElementGeometry<Es>::volumeBatch)...);
}
[[gnu::used]] constexpr auto instances = everyFunction(Elements{});
}  // namespace

}  // namespace ringwatch
