#include <ringwatch/handlers/least_determinant.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <ringwatch/base/infinity.h>
#include <ringwatch/body/domain.h>

namespace ringwatch {

LeastDeterminant::LeastDeterminant(const Body& body, std::span<const ElementRef> elements)
    : body_(&body), places_(body.blocks().size()) {
  for (const ElementRef e : elements)
    places_[e.block].push_back(body.blocks()[e.block]->layout().batchOfElement[e.element]);
  for (auto& places : places_) std::sort(places.begin(), places.end());
}

std::optional<Body::LeastDeterminant> LeastDeterminant::at(NodeVectorsView x) const {
  std::optional<Body::LeastDeterminant> least = here(x);
  Domain& domain = body_->domain();
  if (domain.whole()) return least;
  double most = least ? -least->value : -infinity;
  domain.largest({&most, 1});
  std::optional<ElementRef> found;
  if (least && (std::isnan(most) ? std::isnan(least->value) : most == -least->value)) found = least->element;
  std::string none;
  found = domain.firstFound(found, none);
  if (!found) return std::nullopt;
  return Body::LeastDeterminant{-most, *found};
}

std::optional<Body::LeastDeterminant> LeastDeterminant::here(NodeVectorsView x) const {
  std::optional<Body::LeastDeterminant> least;
  double values[lanes];
  for (std::size_t b = 0; b < places_.size(); ++b) {
    const ElementBlock& block = *body_->blocks()[b];
    std::int32_t batch = -1;
    for (const std::int32_t place : places_[b]) {
      if (place / lanes != batch) {
        batch = place / lanes;
        block.minimumDeterminantBatch(batch, x.data(), values);
      }
      const double value = values[place % lanes];
      if (!least || !(value >= least->value)) least = {value, {b, block.layout().elements[place]}};
      if (std::isnan(value)) return least;
    }
  }
  return least;
}

}  // namespace ringwatch
