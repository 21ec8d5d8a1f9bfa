#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

#include <ringwatch/base/type_list.h>
#include <ringwatch/materials/corotational.h>
#include <ringwatch/materials/linear_elastic.h>
#include <ringwatch/materials/mooney_rivlin.h>
#include <ringwatch/materials/neo_hookean.h>
#include <ringwatch/materials/st_venant_kirchhoff.h>
#include <ringwatch/materials/stable_neo_hookean.h>
#include <ringwatch/materials/transversely_isotropic.h>
#include <ringwatch/materials/yeoh.h>

namespace ringwatch {

/// Every constitutive law of the library, one line each. Blocks, `--help`, scene validation and generic tests iterate
/// it.
using Laws = TypeList<StVenantKirchhoff, LinearElastic, Corotational, NeoHookean, StableNeoHookean, MooneyRivlin, Yeoh,
                      TransverselyIsotropic>;

namespace detail {
template <class... Ls>
std::variant<Ls...> lawVariant(TypeList<Ls...>);
template <class L, class... Ls>
constexpr bool isOneOf(TypeList<Ls...>) {
  return (std::is_same_v<L, Ls> || ...);
}
}  // namespace detail
/// Any one of `Laws`.
using Law = decltype(detail::lawVariant(Laws{}));

/// Code for all laws is compiled side by side in this many files: file s holds the laws with number % lawShards == s.
/// cmake/RingwatchTargets.cmake has the same number, and each file checks that.
inline constexpr std::size_t lawShards = 8;

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

/// Calls visit(std::integral_constant<std::size_t, s>{}) for every such file s.
template <class Visit>
void forEachLawShard(Visit&& visit) {
  [&]<std::size_t... shard>(std::index_sequence<shard...>) {
    (visit(std::integral_constant<std::size_t, shard>{}), ...);
  }
  (std::make_index_sequence<lawShards>{});
}

/// What a law declares: scenes, command line, help texts, blocks and tests take it from here.
struct LawInfo {
  std::string_view name;
  std::string_view help;
  std::span<const OptionInfo> parameters;  ///< numbers that it is made from
  bool objective;                          ///< energy and stress turn with the body
  bool isotropic;                          ///< has no direction of its own
  bool tangentStiffens;                    ///< ∂P/∂F grows with stretch beyond what rotation and scaling make of it
  bool tangentIsConstant;                  ///< ∂P/∂F is the same at every F
  bool definedInverted;                    ///< energy and stress are numbers where det F <= 0 too
  bool allowsInversion;                    ///< made for states with det F <= 0, which the monitor does not report then
  /// Parameters for which the law has Young's modulus (Pa) and Poisson's ratio at rest.
  Options (*parametersFor)(double young, double poisson);
};
/// What a law as in this folder declares.
template <class L>
constexpr LawInfo lawInfo() {
  return {L::name,
          L::help,
          L::parameters,
          L::objective,
          L::isotropic,
          L::tangentStiffens,
          L::tangentIsConstant,
          L::definedInverted,
          L::allowsInversion,
          L::parametersFor};
}

/// A law that a program has registered (body/register_law.h), with its constants.
struct OutsideLaw {
  LawInfo info;
  Lame rest;           // see Material::restModuli
  double restModulus;  // see Material::restModulus
  std::shared_ptr<const void> law;
  double (*energy)(const void* law, const Matrix3<double>& F);
  Matrix3<double> (*stress)(const void* law, const Matrix3<double>& F);
  Matrix3<double> (*stressDifferential)(const void* law, const Matrix3<double>& F, const Matrix3<double>& dF);
};

/// See Material::restModulus.
template <class L>
double restModulusOf(const L& law) {
  if constexpr (requires { law.stiffestModulus(); })
    return law.stiffestModulus();
  else
    return law.restModuli().lambda + 2 * law.restModuli().mu;
}

/// A law and a density, kg/m³.
struct Material {
  Law law;
  double density;
  std::optional<OutsideLaw> outside = {};  // in place of `law`

  LawInfo info() const;
  std::string_view lawName() const { return info().name; }
  /// λ and μ of the law's linearisation at rest, Pa; of a law that is not isotropic, across its axis.
  Lame restModuli() const;
  /// What stiffness is measured by, Pa: λ + 2μ of these, or what a law that is not isotropic declares, at least ρ c² of
  /// its fastest wave at rest.
  double restModulus() const;
  /// Speed of a pressure wave at rest, m/s: √(restModulus/ρ).
  double waveSpeed() const;
  /// The law itself, whose type must be known.
  template <class L>
  const L& as() const {
    if constexpr (detail::isOneOf<L>(Laws{}))
      return std::get<L>(law);
    else
      return *static_cast<const L*>(outside->law.get());
  }
  /// Energy density, J/m³, and first Piola–Kirchhoff stress, Pa, of a deformation gradient; for a few of them.
  double energy(const Matrix3<double>& F) const;
  Matrix3<double> stress(const Matrix3<double>& F) const;
  /// ∂P/∂F : dF, Pa.
  Matrix3<double> stressDifferential(const Matrix3<double>& F, const Matrix3<double>& dF) const;
};

/// A law that materials can be made of by name.
struct LawEntry {
  LawInfo info;
  /// Sets law or outside; all parameters are given and in their range.
  void (*make)(const Options& parameters, Material& material);
};

/// Every law, and those that were registered.
std::span<const LawInfo> allLaws();
/// nullptr when there is none of that name.
const LawInfo* findLaw(std::string_view name);
/// Throws InputError that lists the names when there is none of that name.
const LawInfo& lawNamed(std::string_view name);
namespace detail {
/// Makes a law known by name; body/register_law.h makes its blocks known too.
void registerLaw(const LawEntry& entry);
}  // namespace detail

/// The material of the law `model` with its parameters, as LawInfo::parameters declares them, and a density (kg/m³, >
/// 0). Throws InputError that names the quantity, the value and its range.
Material makeMaterial(std::string_view model, const Options& parameters, double density);
/// The one that has Young's modulus (Pa, > 0) and Poisson's ratio (-1 < ν < 0.5) at rest.
Material makeMaterial(std::string_view model, double young, double poisson, double density);

}  // namespace ringwatch
