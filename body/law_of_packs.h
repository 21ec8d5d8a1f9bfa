#pragma once
#include <memory>
#include <optional>
#include <string_view>

#include <ringwatch/base/pack.h>
#include <ringwatch/elements/quadrature.h>
#include <ringwatch/materials/modulus_blocks.h>
#include <ringwatch/materials/modulus_rounding.h>
#include <ringwatch/materials/registry.h>

namespace ringwatch {

/// The law with a share of each of Lamé's constants; nothing for a law that is not linear in them.
template <class L>
std::optional<L> withShares(const L& law, double lambda, double mu) {
  if constexpr (requires { law.withShares(lambda, mu); }) {
    return law.withShares(lambda, mu);
  } else if constexpr (requires { law.constants.lambda* law.constants.mu; }) {
    L share = law;
    share.constants.lambda *= lambda;
    share.constants.mu *= mu;
    return share;
  } else {
    return {};
  }
}

/// Whether the law of a material has the shares that a quadrature rule asks for: all of it or nothing, or parts of a
/// law that is linear in Lamé's constants.
bool hasShares(const Material& material, const LameShares& shares);

/// A law that is known when the program runs and not when an element's kernels are compiled: a law and an element that
/// are both registered meet in it. Each call goes through a pointer, for a pack of elements at one quadrature point.
class LawOfPacks {
 public:
  using P = NativePack;
  /// The functions of a law, which is the first argument of each.
  struct Functions {
    P (*energy)(const void* law, const Matrix3<P>& F);
    Matrix3<P> (*stress)(const void* law, const Matrix3<P>& F);
    Matrix3<P> (*stressDifferential)(const void* law, const Matrix3<P>& F, const Matrix3<P>& dF);
    ModulusBlocks<P> (*nodeBlocks)(const void* law, const Matrix3<P>& F, const P& weight);
    ModulusRounding<P> (*rounding)(const void* law, const Matrix3<P>& F, const P& error);
    TangentDriftCoefficients<P> (*drift)(const void* law, const Matrix3<P>& F);
    std::shared_ptr<const void> (*share)(const void* law, double lambda, double mu);  // as withShares, nullptr for none
  };
  template <class L>
  static Functions functionsOf() {
    return {[](const void* law, const Matrix3<P>& F) { return own<L>(law).energy(F); },
            [](const void* law, const Matrix3<P>& F) { return own<L>(law).stress(F); },
            [](const void* law, const Matrix3<P>& F, const Matrix3<P>& dF) { return own<L>(law).linearize(F)(dF); },
            [](const void* law, const Matrix3<P>& F, const P& weight) {
              return ModulusBlocks<P>(own<L>(law).linearize(F), weight);
            },
            [](const void* law, const Matrix3<P>& F, const P& error) {
              return own<L>(law).linearize(F).rounding(F, error);
            },
            [](const void* law, const Matrix3<P>& F) { return own<L>(law).drift(F); },
            [](const void* law, double lambda, double mu) -> std::shared_ptr<const void> {
              const std::optional<L> share = ringwatch::withShares(own<L>(law), lambda, mu);
              return share ? std::make_shared<const L>(*share) : nullptr;
            }};
  }
  /// That of a material of a registered law.
  static LawOfPacks of(const Material& material);

  RINGWATCH_INLINE P energy(const Matrix3<P>& F) const { return functions_.energy(law_.get(), F); }
  RINGWATCH_INLINE Matrix3<P> stress(const Matrix3<P>& F) const { return functions_.stress(law_.get(), F); }
  struct Linearization {
    const LawOfPacks& law;
    Matrix3<P> F;
    RINGWATCH_INLINE Matrix3<P> operator()(const Matrix3<P>& dF) const {
      return law.functions_.stressDifferential(law.law_.get(), F, dF);
    }
    RINGWATCH_INLINE ModulusBlocks<P> nodeBlocks(const P& weight) const {
      return law.functions_.nodeBlocks(law.law_.get(), F, weight);
    }
    RINGWATCH_INLINE ModulusRounding<P> rounding(const Matrix3<P>& F0, const P& error) const {
      return law.functions_.rounding(law.law_.get(), F0, error);
    }
  };
  RINGWATCH_INLINE Linearization linearize(const Matrix3<P>& F) const { return {*this, F}; }
  RINGWATCH_INLINE TangentDriftCoefficients<P> drift(const Matrix3<P>& F) const {
    return functions_.drift(law_.get(), F);
  }
  std::optional<LawOfPacks> withShares(double lambda, double mu) const {
    std::shared_ptr<const void> share = functions_.share(law_.get(), lambda, mu);
    if (!share) return {};
    return LawOfPacks(functions_, std::move(share));
  }

 private:
  LawOfPacks(const Functions& functions, std::shared_ptr<const void> law)
      : functions_(functions), law_(std::move(law)) {}
  template <class L>
  static const L& own(const void* law) {
    return *static_cast<const L*>(law);
  }

  Functions functions_;
  std::shared_ptr<const void> law_;
};

/// The law of a material as kernels of LawType take it.
template <class LawType>
LawType lawOf(const Material& material) {
  if constexpr (std::is_same_v<LawType, LawOfPacks>)
    return LawOfPacks::of(material);
  else
    return material.as<LawType>();
}

}  // namespace ringwatch
