#pragma once
#include <memory>
#include <vector>

#include <ringwatch/body/damped_elements.h>
#include <ringwatch/body/wrapped_block.h>

namespace ringwatch {

template <class Element>
class UniformStrainGeometry;

/// What damps the elements of a block. With F the deformation gradient, ρ the density and V the volume of an element
/// as it is, ρ₀ and V₀ at rest, c = √(M/ρ₀) the speed of pressure waves at rest (Material::waveSpeed):
///
/// - Bulk viscosity: the stress -q I with the pressure q = ρ L (quadraticBulk² L ε̇² - linearBulk c ε̇) where the
///   element is pressed together, ε̇ = V̇/V < 0, and without the first term where it widens. L = ∛V₀; one rate an
///   element. It is Abaqus/Explicit's (Analysis User's Manual, "Explicit dynamic analysis", *BULK VISCOSITY, 0.06 and
///   1.2 by default); LS-DYNA (Theory Manual, "Bulk viscosity") has both terms under compression alone. An element
///   below a tenth of its volume at rest counts with a tenth of it, in ρ and in ε̇.
/// - Kelvin-Voigt: the second Piola-Kirchhoff stress (volumeViscosity - ⅔ shearViscosity) tr(Ė) I + 2 shearViscosity Ė,
///   E = (FᵀF - I)/2 Green's strain, at the quadrature points: objective.
/// - Mass-proportional: massProportional · m v, m the element's lumped mass.
/// - Hourglass viscosity, of rules of uniform strain: (hourglassViscosity / 4) ρ₀ c V₀^⅔ Σ_α γ_α γ_αᵀ v with the
///   hourglass vectors γ_α at rest (elements/hourglass.h), Flanagan & Belytschko's with the coefficient of LS-DYNA
///   (Theory Manual, "Hourglass control").
///
/// Rules of uniform strain have the mean deformation gradient F̄ for F, and V₀ det F̄ for V.
///
/// The damping forces have a symmetric positive semidefinite derivative C by the velocities, Theorem 57
/// (docs/theory/element_damping.md).
struct DampingConstants {
  double linearBulk = 0, quadraticBulk = 0;        ///< >= 0
  double shearViscosity = 0, volumeViscosity = 0;  ///< Pa s, >= 0
  double massProportional = 0;                     ///< 1/s, >= 0
  double hourglassViscosity = 0;                   ///< >= 0
  bool bulk() const { return linearBulk > 0 || quadraticBulk > 0; }
  bool viscous() const { return shearViscosity > 0 || volumeViscosity > 0; }
  bool besideBulk() const { return viscous() || massProportional > 0 || hourglassViscosity > 0; }
  bool any() const { return bulk() || besideBulk(); }
};

/// A block whose elements damp: forces and energies are those of the elements alone, tangents those of K + f C. Where
/// the damping is quadratic, C depends on the velocities by way of one coefficient an element, of which an upper bound
/// counts (follow()).
class DampedBlock final : public WrappedBlock {
 public:
  /// By how much the counted coefficient of an element exceeds the one at the velocities at hand, at most, relative.
  static constexpr double overcount = 0.05;

  /// inner: of the same mesh block. masses: of the nodes of each element, elements × nodes, kg; read with
  /// massProportional > 0 alone. factor: f, shared by all blocks. whole: a block that these elements, numbered
  /// `elements` there, are part of and whose coefficients count; nullptr for none.
  DampedBlock(const Mesh& mesh, const MeshBlock& block, std::unique_ptr<ElementBlock> inner,
              const DampingConstants& constants, const std::vector<double>& masses,
              std::shared_ptr<const double> factor, const DampedBlock* whole = nullptr,
              const std::vector<std::int32_t>& elements = {});

  const DampingConstants& constants() const { return constants_; }
  /// Whether C depends on velocities.
  bool dependsOnRates() const { return constants_.quadraticBulk > 0; }

  /// Adds the damping forces at x and v of the batches of a patch into its slots. rows, vRows: as gatherRows.
  void addForce(const Patch& patch, const double* rows, const double* vRows, double* slots) const;
  /// Adds factor · C u.
  void addProduct(const Patch& patch, const double* rows, const double* uRows, double factor, double* slots) const;
  /// Lets the coefficients of a patch's elements count that those at x and v need: at least these, and no more than
  /// `overcount` above them. One that does neither too little nor too much stays, so that few elements change.
  void follow(const Patch& patch, const double* rows, const double* vRows);
  /// Counts what elements at rest need.
  void forgetRates();
  /// The coefficients that count, which follow() keeps from step to step.
  template <class Archive>
  void archive(Archive& a) {
    a(coefficients_);
  }
  /// What counts of the element at a place (batch * lanes + lane): C is this times a matrix that depends on x alone,
  /// plus parts that have no coefficient. 0 without bulk viscosity.
  double coefficient(std::size_t place) const {
    if (whole_) return whole_->coefficient(static_cast<std::size_t>(placeInWhole_[place]));
    return coefficients_.empty() ? 0 : coefficients_[place];
  }
  /// Volumes of the elements of a batch at x, m³, and their derivatives by the nodes, m²: gradient[(3a + i) * lanes +
  /// lane].
  void volumeGradient(std::int32_t batch, const double* x, double* volume, double* gradient) const;

  /// With velocities, the inner block adds bulk viscosity to its forces where it can, and all else is added after.
  void evaluateBatches(std::int32_t first, std::int32_t last, const double* rows,
                       const BatchEvaluation& evaluation) const override;
  void tangentProductBatches(std::int32_t first, std::int32_t last, const double* rows, const double* vRows,
                             double* slots) const override;
  void tangentBatch(std::int32_t batch, const double* x, double* K, double* rounding) const override;
  void tangentOf(const std::int32_t* elements, const double* x, double* K, double* rounding) const override;
  void addTangentRounding(const Patch& patch, const double* x, double* slots) const override;
  void laplacianOf(const std::int32_t* elements, double* L, double* rounding) const override {
    inner().laplacianOf(elements, L, rounding);
  }
  bool hourglassOf(const std::int32_t* elements, HourglassVectors& out) const override {
    return inner().hourglassOf(elements, out);
  }
  /// Theorem 58, docs/theory/element_damping.md.
  void deformationOf(const std::int32_t* elements, const double* x, double* F, TangentDrift* drift) const override;

 private:
  using P = NativePack;
  /// Of an element: m c L, kg m²/s; L/c, s; least volume that counts, volume at rest, m³; (Σ |X_a - X_0|²)^½, m.
  struct Sizes {
    P strength, time, leastVolume, restVolume, extent;
  };
  /// Of elements of uniform strain: what their mean gradients are made of.
  using Mean = Hex8::Hourglass::Geometry<P>;
  /// V and ∂V/∂x by the rule. mean: nullptr but of uniform strain.
  template <bool simplex>
  void volumeGradient(const Mean* mean, const P (*edges)[3], P& volume, P (*w)[3]) const;
  void volumeGradient(const std::int32_t* elements, const P (*edges)[3], P& volume, P (*w)[3]) const;
  const Mean* meanOf(std::int32_t batch) const;
  /// Of any elements, one a lane, into `at`.
  const Mean* meanOf(const std::int32_t* elements, Mean& at) const;
  /// Of Kelvin-Voigt stresses: deformation gradient and weight at a point of any elements, and ∂N_a/∂X.
  struct Point;
  Point pointOf(int q, const std::int32_t* elements, const P (*edges)[3], P (*gradient)[3]) const;
  enum class Parts { all, besideBulk };
  template <bool simplex, class Coefficient>
  void add(std::int32_t first, std::int32_t last, const double* rows, const double* vRows, double factor, double* slots,
           Parts parts, const Coefficient& coefficient) const;
  template <class Coefficient>
  void addAny(std::int32_t first, std::int32_t last, const double* rows, const double* vRows, double factor,
              double* slots, Parts parts, const Coefficient& coefficient) const;
  void addForces(std::int32_t first, std::int32_t last, const double* rows, const double* vRows, double* slots,
                 Parts parts) const;
  template <bool simplex>
  void followBatches(const Patch& patch, const double* rows, const double* vRows);
  void fill(const Mesh& mesh, const MeshBlock& meshBlock, const std::vector<double>& masses);
  void fillHourglass();
  bool isSimplex() const { return element().constantGradient; }
  const double* shapeTable(int q, int a) const {
    return shapeGradients_.data() + 3 * (static_cast<std::ptrdiff_t>(q) * nodesPerElement() + a);
  }
  void loadEdges(const double* x, const std::int32_t* elements, P (*edges)[3]) const;
  P gather(const AlignedVector<P>& values, std::size_t stride, std::size_t at, const std::int32_t* elements) const;
  Sizes sizesOf(const std::int32_t* elements) const;
  P coefficientOf(const std::int32_t* elements) const;
  P bulkFactor(const Sizes& sizes, const P& volume, const std::int32_t* elements) const;
  void addTangent(const std::int32_t* elements, const double* x, double* K, double* rounding) const;
  void roundingOf(const std::int32_t* elements, const P (*edges)[3], P* T) const;

  DampingConstants constants_;
  std::shared_ptr<const double> factor_;
  int points_;
  std::vector<double> shapeGradients_;       // ∂N_a/∂ξ, [q][a][3]
  std::vector<double> weights_, tableNorm_;  // [q]
  AlignedVector<P> sizes_;                   // [batch][5], as Sizes
  AlignedVector<P> geometry_;                // J⁻¹ row by row, w det J: [batch][q][10]; with Kelvin-Voigt
  std::shared_ptr<const UniformStrainGeometry<Hex8>> means_;  // of rules of uniform strain with bulk or Kelvin-Voigt
  AlignedVector<P> masses_;                                   // [batch][a], kg; with mass-proportional damping
  AlignedVector<P> hourglass_;                                // γ, then c, kg/s, and c times its rounding: [batch][34]
  AlignedVector<double> coefficients_;  // by place; with bulk viscosity, of a block that is no part
  const DampedBlock* whole_ = nullptr;
  std::vector<std::int32_t> placeInWhole_;
};

/// The damping of the elements of a body.
class ElementDamping final : public DampedElements {
 public:
  ElementDamping() : factor_(std::make_shared<double>(0)) {}
  /// nullptr for a block that does not damp.
  void addBlock(DampedBlock* block) { blocks_.push_back(block); }
  const std::vector<DampedBlock*>& blocks() const { return blocks_; }
  /// Shares the factor of another body's.
  void shareFactor(const ElementDamping& other) { factor_ = other.factor_; }
  std::shared_ptr<const double> sharedFactor() const { return factor_; }

  double factor() const override { return *factor_; }
  void setFactor(double f) { *factor_ = f; }
  bool dependsOnRates() const;
  /// By how much more than C counts, at most, relative.
  double overcount() const { return dependsOnRates() ? DampedBlock::overcount : 0; }
  /// DampedBlock::forgetRates of all.
  void forgetRates();
  template <class Archive>
  void archive(Archive& a) {
    for (DampedBlock* block : blocks_)
      if (block) a(*block);
  }
  void addDampingProduct(std::size_t block, const Patch& patch, const double* x, const double* v, double factor,
                         double* slots) const override;

 private:
  std::shared_ptr<double> factor_;
  std::vector<DampedBlock*> blocks_;
};

}  // namespace ringwatch
