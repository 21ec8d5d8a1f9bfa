#include <ringwatch/materials/registry.h>

#include <array>
#include <cmath>
#include <optional>

#include <ringwatch/base/error.h>
#include <ringwatch/base/user_text.h>

namespace ringwatch {
namespace {

template <class... Ls>
std::array<LawInfo, sizeof...(Ls)> describeAll(TypeList<Ls...>) {
  return {LawInfo{Ls::name, Ls::help}...};
}

}  // namespace

std::string_view Material::lawName() const {
  return std::visit([](const auto& l) { return l.name; }, law);
}
Lame Material::lame() const {
  return std::visit([](const auto& l) { return l.constants; }, law);
}

std::span<const LawInfo> allLaws() {
  static const auto table = describeAll(Laws{});
  return table;
}

Material makeMaterial(std::string_view model, double young, double poisson, double density) {
  // The negated comparisons refuse NaN too.
  if (!(young > 0) || !std::isfinite(young))
    throw InputError(joinText("young = ", young, " Pa: must be a finite number > 0"));
  if (!(poisson > -1) || !(poisson < 0.5))
    throw InputError(joinText("poisson = ", poisson, ": must be > -1 and < 0.5"));
  if (!(density > 0) || !std::isfinite(density))
    throw InputError(joinText("density = ", density, " kg/m3: must be a finite number > 0"));
  std::optional<Law> law;
  forEachType(Laws{}, [&](auto tag) {
    using L = typename decltype(tag)::type;
    if (L::name == model) law = L{lameConstants(young, poisson)};
  });
  if (!law) {
    std::string names;
    for (const LawInfo& info : allLaws()) names += (names.empty() ? "" : ", ") + std::string(info.name);
    throw InputError(joinText("model = ", inQuotes(model), ": must be one of ", names));
  }
  return {*law, density};
}

}  // namespace ringwatch
