#include <ringwatch/body/element_geometry_functions.h>

#include <tuple>

namespace ringwatch {
namespace {
/// Makes the functions above for every element of the registry: taking their addresses instantiates them here.
template <class... Es>
constexpr auto everyFunction(TypeList<Es...>) {
  return std::tuple_cat(std::make_tuple(
      &ElementGeometry<Es>::fill, &ElementGeometry<Es>::meanGradients, &ElementGeometry<Es>::gatherPoints,
      &ElementGeometry<Es>::gatherExtents, &ElementGeometry<Es>::laplacianOf,
      &ElementGeometry<Es>::minimumDeterminantBatch, &ElementGeometry<Es>::volumeBatch)...);
}
[[gnu::used]] constexpr auto instances = everyFunction(Elements{});
}  // namespace

}  // namespace ringwatch
