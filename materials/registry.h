#pragma once
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
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

/// Code for all laws is compiled side by side in this many files: file s holds the laws with number % lawShards == s.
/// cmake/RingwatchTargets.cmake has the same number, and each file checks that.
inline constexpr std::size_t lawShards = 4;

/// Calls visit(TypeTag<L>{}) when law number `law` of `Laws` is in that file.
template <std::size_t shard, class Visit>
void visitLawOfShard(std::size_t law, Visit&& visit) {
  static_assert(shard < lawShards);
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    const auto tryLaw = [&]<std::size_t number>(std::integral_constant<std::size_t, number>) {
      if constexpr (number % lawShards == shard)
        if (number == law) visit(TypeTag<std::variant_alternative_t<number, Law>>{});
    };
    (tryLaw(std::integral_constant<std::size_t, i>{}), ...);
  }
  (std::make_index_sequence<std::variant_size_v<Law>>{});
}

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
