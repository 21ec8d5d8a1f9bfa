#include <ringwatch/app/ranks/rank_handler.h>

#include <ringwatch/app/ranks/rank_imex.h>
#include <ringwatch/app/ranks/rank_mass_scaling.h>

namespace ringwatch {

std::vector<ElementRef> elementsOfPart(const RankBody& part, const ElementFlags& chosen) {
  std::vector<ElementRef> elements;
  for (std::size_t b = 0; b < part.body().blocks().size(); ++b)
    for (std::int32_t e = 0; e < part.body().blocks()[b]->elementCount(); ++e) {
      const ElementRef inWhole = part.globalElement({b, e});
      if (chosen[inWhole.block][inWhole.element]) elements.push_back({b, e});
    }
  return elements;
}

std::unique_ptr<RankHandler> makeRankHandler(const Scene& scene, Body& whole, double h) {
  if (scene.handler == Imex::description.name) return std::make_unique<RankImex>(scene, whole, h);
  return std::make_unique<RankMassScaling>(scene, whole, h);
}

}  // namespace ringwatch
