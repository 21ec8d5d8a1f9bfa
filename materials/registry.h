#pragma once
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include <ringwatch/base/type_list.h>
#include <ringwatch/materials/corotational.h>
#include <ringwatch/materials/linear_elastic.h>
#include <ringwatch/materials/neo_hookean.h>
#include <ringwatch/materials/st_venant_kirchhoff.h>

namespace ringwatch {

/// Every constitutive law of the library, one line each. Blocks, `--help`, scene validation and generic tests iterate
/// it.
using Laws = TypeList<StVenantKirchhoff, LinearElastic, Corotational, NeoHookean>;

namespace detail {
template <class... Ls>
std::variant<Ls...> lawVariant(TypeList<Ls...>);
}
/// Any one of `Laws`.
using Law = decltype(detail::lawVariant(Laws{}));

/// A law and a density, kg/m³.
struct Material {
  Law law;
  double density;

  std::string_view lawName() const;
  Lame lame() const;
  /// Speed of a pressure wave at rest, m/s.
  double waveSpeed() const { return pressureWaveSpeed(lame(), density); }
};

/// A law for lists and help texts.
struct LawInfo {
  std::string_view name;
  std::string_view help;
};
std::span<const LawInfo> allLaws();

/// The material of the law `model` with Young's modulus (Pa, > 0), Poisson's ratio (-1 < ν < 0.5) and density (kg/m³, >
/// 0). Throws InputError that names the quantity, the value and its range.
Material makeMaterial(std::string_view model, double young, double poisson, double density);

}  // namespace ringwatch
