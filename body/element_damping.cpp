#include <ringwatch/body/element_damping.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <type_traits>

#include <ringwatch/base/infinity.h>
#include <ringwatch/base/matrix3.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/body/uniform_strain_geometry.h>
#include <ringwatch/elements/registry.h>

namespace ringwatch {
namespace {

using P = NativePack;
constexpr int stride = 10;  // numbers stored for a point: J⁻¹, w det J
constexpr int sizeCount = BulkViscosity::sizeCount;
/// Numbers stored of an element with Kelvin-Voigt: its points, then (Σ |X_a - X_0|²)^½.
std::size_t numbersOf(int points) { return static_cast<std::size_t>(points) * stride + 1; }
/// Numbers stored of an element with hourglass viscosity: γ, c and c times γ's rounding.
constexpr std::size_t gammas = HourglassVectors::count * HourglassVectors::nodes, hourglassCount = gammas + 2;
constexpr double leastVolumeShare = BulkViscosity::leastVolumeShare;
/// By which the rounding of an element's stiffness grows where damping is added to it: far more than the sum rounds.
constexpr double sumOfTangentsRounding = 1 + 1.0 / 64;

P norm(const Matrix3<P>& A) { return math::sqrt(innerProduct(A, A)); }

RINGWATCH_INLINE void subtractFirst(int n, P (*x)[3]) {
  for (int a = 1; a < n; ++a)
    for (int i = 0; i < 3; ++i) x[a][i] -= x[0][i];
  for (int i = 0; i < 3; ++i) x[0][i] = P(0.0);
}

RINGWATCH_INLINE P dot(const P (&a)[3], const P (&b)[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// The first n rows of an array.
template <int n, class Entry>
RINGWATCH_INLINE Entry (&rowsOf(Entry (*rows)[3]))[n][3] {
  return *reinterpret_cast<Entry(*)[n][3]>(rows);
}

using Means = UniformStrainGeometry<Hex8>;

/// Σ_a x_a ⊗ ∂N_a/∂ξ of edges, by the row of a point in a table of ∂N_a/∂ξ.
RINGWATCH_INLINE Matrix3<P> naturalGradient(int n, const P (*edges)[3], const double* dN) {
  Matrix3<P> D = Matrix3<P>::zero();
  for (int a = 1; a < n; ++a)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) D(i, j) += edges[a][i] * P(dN[3 * a + j]);
  return D;
}

/// F̄ of edges.
RINGWATCH_INLINE Matrix3<P> meanDeformation(const Means::Stored& at, const P (*edges)[3]) {
  P q[Means::vectors][3];
  return Means::deformation(at, rowsOf<8>(edges), q);
}
/// V T g_a at the nodes: the forces of a first Piola-Kirchhoff stress T.
RINGWATCH_INLINE void meanForces(const Means::Stored& at, const Matrix3<P>& T, P (*force)[3]) {
  P none[Means::vectors][3];
  for (auto& row : none)
    for (P& entry : row) entry = P(0.0);
  Means::forces(at, T, none, rowsOf<8>(force));
}

/// Whether volumes and their derivatives go by modes (volumeGradientOfHexahedron).
bool goesByModes(const ElementInfo& element) { return element.type == elementTypeOf<Hex8>; }

/// s of the forces s w of bulk viscosity, by the sizes of the elements, V and V̇. coefficient(ε̇). BulkViscosity::factor
/// has the coefficient that forces have.
template <class Coefficient>
RINGWATCH_INLINE P bulkFactorOf(const P* sizes, const P& impedance, const P& volume, const P& volumeRate,
                                const Coefficient& coefficient) {
  const P inverse = P(1.0) / math::max(volume, P(leastVolumeShare) * sizes[0]), rate = volumeRate * inverse;
  return impedance * sizes[0] * sizes[1] * inverse * rate * coefficient(rate);
}

/// Bulk viscosity alone of tetrahedra and hexahedra: the number of nodes is known, and velocities and forces stay in
/// registers. coefficient(rate, length, batch).
template <int n, class Coefficient>
RINGWATCH_INLINE void addBulkAlone(std::int32_t first, std::int32_t last, const std::uint16_t* localNodes,
                                   const P* sizes, double strength, const double* rows, const double* vRows,
                                   double* slots, const Coefficient& coefficient) {
  const P impedance(strength);
  for (std::int32_t batch = first; batch < last; ++batch) {
    const std::uint16_t* local = localNodes + static_cast<std::ptrdiff_t>(batch) * n * lanes;
    P x[n][3], w[n][3], volume, rate(0.0), v0[3], v[3];
    RINGWATCH_UNROLL
    for (int a = 0; a < n; ++a) loadRows(rows, local + a * lanes, x[a]);
    subtractFirst(n, x);
    if constexpr (n == 4)
      volumeGradientOfTetrahedron(x, volume, w);
    else
      volumeGradientOfHexahedron(x, volume, w);
    loadRows(vRows, local, v0);
    RINGWATCH_UNROLL
    for (int a = 1; a < n; ++a) {
      loadRows(vRows, local + a * lanes, v);
      RINGWATCH_UNROLL
      for (int i = 0; i < 3; ++i) rate += w[a][i] * (v[i] - v0[i]);
    }
    const P* own = sizes + static_cast<std::ptrdiff_t>(batch) * sizeCount;
    const P s = bulkFactorOf(own, impedance, volume, rate,
                             [&](const P& relative) { return coefficient(relative, own[1], batch); });
    RINGWATCH_UNROLL
    for (int a = 0; a < n; ++a) {
      const P force[3] = {s * w[a][0], s * w[a][1], s * w[a][2]};
      addRows(slots, local + a * lanes, force);
    }
  }
}

}  // namespace

struct DampedBlock::Point {
  Matrix3<P> inverseJacobian, F;  // the first not of rules of uniform strain
  P weight;
};

DampedBlock::DampedBlock(const Mesh& mesh, const MeshBlock& block, std::unique_ptr<ElementBlock> inner,
                         const DampingConstants& constants, const std::vector<double>& masses,
                         std::shared_ptr<const double> factor, const DampedBlock* whole,
                         const std::vector<std::int32_t>& elements)
    : WrappedBlock(block, std::move(inner)),
      constants_(constants),
      factor_(std::move(factor)),
      points_(static_cast<int>(rule().points.size())),
      whole_(whole) {
  fill(mesh, block, masses);
  if (!constants_.bulk()) {
    whole_ = nullptr;
    return;
  }
  if (!whole_) {
    coefficients_.resize(layout().elements.size());
    forgetRates();
    return;
  }
  placeInWhole_.resize(layout().elements.size());
  for (std::size_t place = 0; place < placeInWhole_.size(); ++place)
    placeInWhole_[place] =
        layout().elements[place] < 0 ? 0 : whole_->layout().batchOfElement[elements[layout().elements[place]]];
}

void DampedBlock::fill(const Mesh& mesh, const MeshBlock& meshBlock, const std::vector<double>& masses) {
  const int n = nodesPerElement();
  const std::size_t batches = layout().batchCount();
  for (const QuadraturePoint& point : rule().points) {
    double dN[maxElementNodes][3], square = 0;
    element().shapeGradient(point.xi, dN);
    for (int a = 0; a < n; ++a)
      for (const double entry : dN[a]) {
        shapeGradients_.push_back(entry);
        square += entry * entry;
      }
    weights_.push_back(point.weight);
    tableNorm_.push_back(std::sqrt(square));
  }
  sizes_.resize(batches * sizeCount);
  if (rule().uniformStrain && (constants_.bulk() || constants_.viscous()))
    means_ = std::make_shared<const Means>(inner(), mesh, meshBlock, 0);
  else if (constants_.viscous())
    geometry_.resize(batches * numbersOf(points_));
  if (constants_.massProportional > 0) masses_.resize(batches * static_cast<std::size_t>(n));
  if (constants_.hourglassViscosity > 0) fillHourglass();
  for (std::size_t batch = 0; batch < batches; ++batch) {
    const std::int32_t* elements = layout().elements.data() + batch * lanes;
    P edges[maxElementNodes][3], w[maxElementNodes][3], volume, extent(0.0);
    loadEdges(mesh.X.data(), elements, edges);
    volumeGradient(elements, edges, volume, w);
    for (int a = 1; a < n; ++a) extent += dot(edges[a], edges[a]);
    P* sizes = sizes_.data() + batch * sizeCount;
    for (int lane = 0; lane < lanes; ++lane) {
      const bool none = elements[lane] < 0;
      sizes[0].set(lane, none ? 1 : volume[lane]);  // no division by zero
      sizes[1].set(lane, none ? 0 : std::cbrt(volume[lane]));
      if (!masses_.empty())
        for (int a = 0; a < n; ++a)
          masses_[batch * static_cast<std::size_t>(n) + static_cast<std::size_t>(a)].set(
              lane, none ? 0
                         : masses[static_cast<std::size_t>(elements[lane]) * static_cast<std::size_t>(n) +
                                  static_cast<std::size_t>(a)]);
    }
    if (geometry_.empty()) continue;
    geometry_[(batch + 1) * numbersOf(points_) - 1] = math::sqrt(extent);
    for (int q = 0; q < points_; ++q) {
      const Matrix3<P> J = naturalGradient(n, edges, shapeTable(q, 0));
      const P det = determinant(J);
      const Matrix3<P> inverse = (P(1.0) / det) * transpose(cofactor(J));
      P* point = geometry_.data() + batch * numbersOf(points_) + static_cast<std::size_t>(q) * stride;
      for (int i = 0; i < 9; ++i) point[i] = inverse.m[i];
      point[9] = P(weights_[q]) * det;
      for (int lane = 0; lane < lanes; ++lane)
        if (elements[lane] < 0) point[9].set(lane, 0);
    }
  }
}

void DampedBlock::fillHourglass() {
  const double impedance = material().density * material().waveSpeed();
  for (std::int32_t batch = 0; batch < layout().batchCount(); ++batch) {
    HourglassVectors own;
    inner().hourglassOf(layout().elements.data() + static_cast<std::ptrdiff_t>(batch) * lanes, own);
    for (const auto& gamma : own.gamma) hourglass_.insert(hourglass_.end(), std::begin(gamma), std::end(gamma));
    P c;
    for (int lane = 0; lane < lanes; ++lane) {
      const double length = std::cbrt(own.volume[lane]);
      c.set(lane, 0.25 * constants_.hourglassViscosity * impedance * length * length);
    }
    hourglass_.push_back(c);
    hourglass_.push_back(c * own.rounding);
  }
}

void DampedBlock::forgetRates() { std::fill(coefficients_.begin(), coefficients_.end(), constants_.linearBulk); }

const DampedBlock::Mean* DampedBlock::meanOf(std::int32_t batch) const { return means_ ? &means_->of(batch) : nullptr; }
const DampedBlock::Mean* DampedBlock::meanOf(const std::int32_t* elements, Mean& at) const {
  if (!means_) return nullptr;
  means_->gather(elements, at);
  return &at;
}

template <bool simplex>
RINGWATCH_INLINE void DampedBlock::volumeGradient(const Mean* mean, const P (*edges)[3], P& volume, P (*w)[3]) const {
  if constexpr (simplex) {
    volumeGradientOfTetrahedron(rowsOf<4>(edges), volume, rowsOf<4>(w));
  } else {
    if (mean) {  // V₀ det F̄
      const Matrix3<P> F = meanDeformation(*mean, edges), C = cofactor(F);
      volume = mean->volume * (C(0, 0) * F(0, 0) + C(0, 1) * F(0, 1) + C(0, 2) * F(0, 2));
      return meanForces(*mean, C, w);
    }
    if (goesByModes(element())) return volumeGradientOfHexahedron(rowsOf<8>(edges), volume, rowsOf<8>(w));
    const int n = nodesPerElement();
    volume = P(0.0);
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < 3; ++i) w[a][i] = P(0.0);
    for (int q = 0; q < points_; ++q) {
      const Matrix3<P> D = naturalGradient(n, edges, shapeTable(q, 0));
      const Matrix3<P> own = P(weights_[q]) * cofactor(D);
      volume += own(0, 0) * D(0, 0) + own(0, 1) * D(0, 1) + own(0, 2) * D(0, 2);
      for (int a = 0; a < n; ++a) {
        const double* dN = shapeTable(q, a);
        for (int i = 0; i < 3; ++i) w[a][i] += own(i, 0) * P(dN[0]) + own(i, 1) * P(dN[1]) + own(i, 2) * P(dN[2]);
      }
    }
  }
}

void DampedBlock::volumeGradient(const std::int32_t* elements, const P (*edges)[3], P& volume, P (*w)[3]) const {
  Mean at;
  if (isSimplex())
    volumeGradient<true>(nullptr, edges, volume, w);
  else
    volumeGradient<false>(meanOf(elements, at), edges, volume, w);
}

void DampedBlock::volumeGradient(std::int32_t batch, const double* x, double* volume, double* gradient) const {
  P edges[maxElementNodes][3], w[maxElementNodes][3], V;
  const std::int32_t* elements = layout().elements.data() + static_cast<std::ptrdiff_t>(batch) * lanes;
  loadEdges(x, elements, edges);
  volumeGradient(elements, edges, V, w);
  V.store(volume);
  for (int a = 0; a < nodesPerElement(); ++a)
    for (int i = 0; i < 3; ++i) w[a][i].store(gradient + (3 * a + i) * lanes);
}

/// coefficient(sizes, rate, place): of the bulk viscosity, by ε̇ and the first place of the batch.
template <bool simplex, class Coefficient>
void DampedBlock::add(std::int32_t first, std::int32_t last, const double* rows, const double* vRows, double factor,
                      double* slots, Parts parts, const Coefficient& coefficient) const {
  constexpr int most = simplex ? 4 : maxElementNodes;
  const int n = simplex ? 4 : nodesPerElement();
  const double speed = material().waveSpeed(), impedance = material().density * speed, slowness = 1 / speed;
  const bool bulk = constants_.bulk() && parts == Parts::all, viscous = constants_.viscous(),
             byMass = constants_.massProportional > 0;
  const P eta(factor * constants_.shearViscosity),
      lambda(factor * (constants_.volumeViscosity - 2.0 / 3 * constants_.shearViscosity));
  const auto viscousStress = [&](const Matrix3<P>& F, const Matrix3<P>& dF) {  // F S
    const Matrix3<P> half = transposeTimes(F, dF);
    // 2 η Ė = η (FᵀḞ + ḞᵀF), λ tr(Ė) = λ tr(FᵀḞ).
    Matrix3<P> S = eta * (half + transpose(half));
    const P mean = lambda * trace(half);
    for (int i = 0; i < 3; ++i) S(i, i) += mean;
    return F * S;
  };
  for (std::int32_t batch = first; batch < last; ++batch) {
    const std::uint16_t* local = layout().localNodes.data() + static_cast<std::ptrdiff_t>(batch) * n * lanes;
    P x[most][3], v[most][3], force[most][3];
    if (bulk || viscous) {
      for (int a = 0; a < n; ++a) loadRows(rows, local + a * lanes, x[a]);
      subtractFirst(n, x);
    }
    for (int a = 0; a < n; ++a) loadRows(vRows, local + a * lanes, v[a]);
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < 3; ++i) force[a][i] = P(0.0);
    if (byMass) {
      const P* masses = masses_.data() + static_cast<std::ptrdiff_t>(batch) * n;
      const P alpha(factor * constants_.massProportional);
      for (int a = 0; a < n; ++a)
        for (int i = 0; i < 3; ++i) force[a][i] = alpha * masses[a] * v[a][i];
    }
    subtractFirst(n, v);
    if constexpr (!simplex)
      if (!hourglass_.empty()) {
        const P* gamma = hourglass_.data() + static_cast<std::size_t>(batch) * hourglassCount;
        const P c = P(factor) * gamma[gammas];
        for (std::size_t h = 0; h < HourglassVectors::count; ++h, gamma += HourglassVectors::nodes)
          for (int i = 0; i < 3; ++i) {
            P rate(0.0);
            for (int a = 1; a < n; ++a) rate += gamma[a] * v[a][i];
            const P own = c * rate;
            for (int a = 0; a < n; ++a) force[a][i] += gamma[a] * own;
          }
      }
    if (bulk) {
      const P* sizes = sizes_.data() + static_cast<std::ptrdiff_t>(batch) * sizeCount;
      P w[most][3], volume;
      volumeGradient<simplex>(meanOf(batch), x, volume, w);
      P rate = dot(w[1], v[1]);
      for (int a = 2; a < n; ++a) rate += dot(w[a], v[a]);
      const P s = bulkFactorOf(sizes, P(factor * impedance), volume, rate, [&](const P& relative) {
        return coefficient(P(slowness) * sizes[1], relative, static_cast<std::size_t>(batch) * lanes);
      });
      for (int a = 0; a < n; ++a)
        for (int i = 0; i < 3; ++i) force[a][i] += s * w[a][i];
    }
    if (viscous && means_) {
      const Mean& at = *meanOf(batch);
      const Matrix3<P> F = meanDeformation(at, x);
      P stressed[most][3];
      meanForces(at, viscousStress(F, meanDeformation(at, v)), stressed);
      for (int a = 0; a < n; ++a)
        for (int i = 0; i < 3; ++i) force[a][i] += stressed[a][i];
    } else if (viscous) {
      const P* point = geometry_.data() + static_cast<std::size_t>(batch) * numbersOf(points_);
      for (int q = 0; q < points_; ++q, point += stride) {
        Matrix3<P> J1;
        for (int i = 0; i < 9; ++i) J1.m[i] = point[i];
        const Matrix3<P> F = naturalGradient(n, x, shapeTable(q, 0)) * J1,
                         dF = naturalGradient(n, v, shapeTable(q, 0)) * J1;
        const Matrix3<P> T = timesTranspose(point[9] * viscousStress(F, dF), J1);
        for (int a = 0; a < n; ++a) {
          const double* dN = shapeTable(q, a);
          for (int i = 0; i < 3; ++i) force[a][i] += T(i, 0) * P(dN[0]) + T(i, 1) * P(dN[1]) + T(i, 2) * P(dN[2]);
        }
      }
    }
    for (int a = 0; a < n; ++a) addRows(slots, local + a * lanes, force[a]);
  }
}

template <class Coefficient>
void DampedBlock::addAny(std::int32_t first, std::int32_t last, const double* rows, const double* vRows, double factor,
                         double* slots, Parts parts, const Coefficient& coefficient) const {
  if (!constants_.besideBulk() && (isSimplex() || (goesByModes(element()) && !means_))) {
    const double speed = material().waveSpeed();
    const P slowness(1 / speed);
    const auto alone = [&]<int n>(std::integral_constant<int, n>) {
      return addBulkAlone<n>(first, last, layout().localNodes.data(), sizes_.data(),
                             factor * material().density * speed, rows, vRows, slots,
                             [&](const P& rate, const P& length, std::int32_t batch) {
                               return coefficient(slowness * length, rate, static_cast<std::size_t>(batch) * lanes);
                             });
    };
    return isSimplex() ? alone(std::integral_constant<int, 4>()) : alone(std::integral_constant<int, 8>());
  }
  if (isSimplex()) return add<true>(first, last, rows, vRows, factor, slots, parts, coefficient);
  return add<false>(first, last, rows, vRows, factor, slots, parts, coefficient);
}

void DampedBlock::addForces(std::int32_t first, std::int32_t last, const double* rows, const double* vRows,
                            double* slots, Parts parts) const {
  const P linear(constants_.linearBulk), quadratic(constants_.quadraticBulk * constants_.quadraticBulk);
  addAny(first, last, rows, vRows, 1, slots, parts, [=](const P& time, const P& rate, std::size_t) {
    return linear + quadratic * time * math::max(-rate, P(0.0));
  });
}

void DampedBlock::addForce(const Patch& patch, const double* rows, const double* vRows, double* slots) const {
  addForces(patch.batchBegin, patch.batchEnd, rows, vRows, slots, Parts::all);
}

void DampedBlock::evaluateBatches(std::int32_t first, std::int32_t last, const double* rows,
                                  const BatchEvaluation& evaluation) const {
  if (!evaluation.slots || !evaluation.velocities) return inner().evaluateBatches(first, last, rows, evaluation);
  const bool together = constants_.bulk() && inner().addsBulkViscosity();
  BatchEvaluation own = evaluation;
  BulkViscosity bulk{};
  if (together) {
    const double speed = material().waveSpeed();
    bulk = {sizes_.data(),
            material().density * speed,
            1 / speed,
            constants_.linearBulk,
            constants_.quadraticBulk * constants_.quadraticBulk,
            evaluation.velocities};
    own.bulk = &bulk;
  }
  inner().evaluateBatches(first, last, rows, own);
  if (together && !constants_.besideBulk()) return;
  addForces(first, last, rows, evaluation.velocities, evaluation.slots, together ? Parts::besideBulk : Parts::all);
}

void DampedBlock::addProduct(const Patch& patch, const double* rows, const double* uRows, double factor,
                             double* slots) const {
  const auto counted = [this](const P&, const P&, std::size_t place) {
    if (!whole_) return P::load(coefficients_.data() + place);
    P own;
    for (int lane = 0; lane < lanes; ++lane) own.set(lane, coefficient(place + static_cast<std::size_t>(lane)));
    return own;
  };
  addAny(patch.batchBegin, patch.batchEnd, rows, uRows, factor, slots, Parts::all, counted);
}

void DampedBlock::follow(const Patch& patch, const double* rows, const double* vRows) {
  if (!dependsOnRates() || whole_) return;
  if (isSimplex())
    followBatches<true>(patch, rows, vRows);
  else
    followBatches<false>(patch, rows, vRows);
}

template <bool simplex>
void DampedBlock::followBatches(const Patch& patch, const double* rows, const double* vRows) {
  constexpr int most = simplex ? 4 : maxElementNodes;
  const int n = simplex ? 4 : nodesPerElement();
  const P linear(constants_.linearBulk), quadratic(2 * constants_.quadraticBulk * constants_.quadraticBulk);
  const double slowness = 1 / material().waveSpeed();
  for (std::int32_t batch = patch.batchBegin; batch < patch.batchEnd; ++batch) {
    const std::uint16_t* local = layout().localNodes.data() + static_cast<std::ptrdiff_t>(batch) * n * lanes;
    const P* sizes = sizes_.data() + static_cast<std::ptrdiff_t>(batch) * sizeCount;
    P x[most][3], v[most][3], w[most][3], volume;
    for (int a = 0; a < n; ++a) loadRows(rows, local + a * lanes, x[a]);
    for (int a = 0; a < n; ++a) loadRows(vRows, local + a * lanes, v[a]);
    subtractFirst(n, x);
    subtractFirst(n, v);
    volumeGradient<simplex>(meanOf(batch), x, volume, w);
    P rate = dot(w[1], v[1]);
    for (int a = 2; a < n; ++a) rate += dot(w[a], v[a]);
    rate = rate / math::max(volume, P(leastVolumeShare) * sizes[0]);
    // The rounding of the rate is far below what a coefficient that is set anew has in reserve.
    const P needed = linear + quadratic * P(slowness) * sizes[1] * math::max(-rate, P(0.0));
    double* at = coefficients_.data() + static_cast<std::ptrdiff_t>(batch) * lanes;
    const P now = P::load(at);
    const auto keeps = (needed * P(1 + directionRounding) <= now) & (now <= P(1 + overcount) * needed);
    const auto atRest = (needed == linear) & (now == linear);
    const P fresh = select(needed == linear, linear, P(1 + 0.5 * overcount) * needed);
    select(keeps | atRest, now, fresh).store(at);
  }
}

void DampedBlock::tangentProductBatches(std::int32_t first, std::int32_t last, const double* rows, const double* vRows,
                                        double* slots) const {
  inner().tangentProductBatches(first, last, rows, vRows, slots);
  if (*factor_ > 0) addProduct({first, last, 0, 0}, rows, vRows, *factor_, slots);
}

void DampedBlock::loadEdges(const double* x, const std::int32_t* elements, P (*edges)[3]) const {
  const int n = nodesPerElement();
  const std::int32_t* nodes[lanes];
  for (int lane = 0; lane < lanes; ++lane)
    nodes[lane] = nodesOf(elements[lane] < 0 ? elements[0] : elements[lane]).data();
  for (int a = 0; a < n; ++a)
    for (int i = 0; i < 3; ++i)
      for (int lane = 0; lane < lanes; ++lane)
        edges[a][i].set(lane, x[3 * static_cast<std::ptrdiff_t>(nodes[lane][a]) + i] -
                                  x[3 * static_cast<std::ptrdiff_t>(nodes[lane][0]) + i]);
}

/// Of values stored as [batch][at], `stride` a batch; zero in lanes without an element.
DampedBlock::P DampedBlock::gather(const AlignedVector<P>& values, std::size_t perBatch, std::size_t at,
                                   const std::int32_t* elements) const {
  P r(0.0);
  for (int lane = 0; lane < lanes; ++lane) {
    if (elements[lane] < 0) continue;
    const std::size_t place = layout().batchOfElement[elements[lane]];
    r.set(lane, values[place / lanes * perBatch + at][static_cast<int>(place % lanes)]);
  }
  return r;
}

DampedBlock::Sizes DampedBlock::sizesOf(const std::int32_t* elements) const {
  P volume = gather(sizes_, sizeCount, 0, elements), extent(1.0);
  const P length = gather(sizes_, sizeCount, 1, elements);
  if (!geometry_.empty()) extent = gather(geometry_, numbersOf(points_), numbersOf(points_) - 1, elements);
  for (int lane = 0; lane < lanes; ++lane)  // no division by zero where there is nothing
    if (elements[lane] < 0) {
      volume.set(lane, 1);
      extent.set(lane, 1);
    }
  const double speed = material().waveSpeed();
  return {P(material().density * speed) * volume * length, P(1 / speed) * length, P(leastVolumeShare) * volume, volume,
          extent};
}

DampedBlock::P DampedBlock::coefficientOf(const std::int32_t* elements) const {
  P r(0.0);
  for (int lane = 0; lane < lanes; ++lane)
    if (elements[lane] >= 0) r.set(lane, coefficient(layout().batchOfElement[elements[lane]]));
  return r;
}

DampedBlock::Point DampedBlock::pointOf(int q, const std::int32_t* elements, const P (*edges)[3],
                                        P (*gradient)[3]) const {
  const int n = nodesPerElement();
  Point point;
  Mean at;
  if (meanOf(elements, at)) {
    const Means::Vectors own = Means::vectorsOf(at);
    for (int a = 0; a < n; ++a) std::copy_n(own.g[a], 3, gradient[a]);
    point.F = meanDeformation(at, edges);
    point.weight = at.volume;
    return point;
  }
  const std::size_t first = static_cast<std::size_t>(q) * stride, perBatch = numbersOf(points_);
  for (std::size_t i = 0; i < 9; ++i) point.inverseJacobian.m[i] = gather(geometry_, perBatch, first + i, elements);
  point.weight = gather(geometry_, perBatch, first + 9, elements);
  point.F = naturalGradient(n, edges, shapeTable(q, 0)) * point.inverseJacobian;
  for (int a = 0; a < n; ++a) {
    const double* dN = shapeTable(q, a);
    for (int j = 0; j < 3; ++j)
      gradient[a][j] = P(dN[0]) * point.inverseJacobian(0, j) + P(dN[1]) * point.inverseJacobian(1, j) +
                       P(dN[2]) * point.inverseJacobian(2, j);
  }
  return point;
}

/// s of f C = s w wᵀ, N/m⁵.
DampedBlock::P DampedBlock::bulkFactor(const Sizes& sizes, const P& volume, const std::int32_t* elements) const {
  const P inverse = P(1.0) / math::max(volume, sizes.leastVolume);
  return P(*factor_) * sizes.strength * coefficientOf(elements) * inverse * inverse;
}

void DampedBlock::addTangent(const std::int32_t* elements, const double* x, double* K, double* rounding) const {
  if (!(*factor_ > 0)) return;
  const int n = nodesPerElement(), size = 3 * n;
  P* k = reinterpret_cast<P*>(K);
  P edges[maxElementNodes][3];
  loadEdges(x, elements, edges);
  if (constants_.bulk()) {
    P w[maxElementNodes][3], volume;
    volumeGradient(elements, edges, volume, w);
    const P s = bulkFactor(sizesOf(elements), volume, elements);
    for (int i = 0; i < size; ++i) {
      const P row = s * w[i / 3][i % 3];
      for (int j = i; j < size; ++j) k[i * size + j] += row * w[j / 3][j % 3];
    }
  }
  if (constants_.viscous()) {
    const double eta = *factor_ * constants_.shearViscosity,
                 lambda = *factor_ * (constants_.volumeViscosity - 2.0 / 3 * constants_.shearViscosity);
    for (int q = 0; q < points_; ++q) {
      P g[maxElementNodes][3], h[maxElementNodes][3];  // ∂N_a/∂X and F ∂N_a/∂X
      const Point point = pointOf(q, elements, edges, g);
      const Matrix3<P>& F = point.F;
      const Matrix3<P> B = timesTranspose(F, F);
      for (int a = 0; a < n; ++a)
        for (int i = 0; i < 3; ++i) h[a][i] = F(i, 0) * g[a][0] + F(i, 1) * g[a][1] + F(i, 2) * g[a][2];
      const P ofEta = P(eta) * point.weight, ofLambda = P(lambda) * point.weight;
      for (int a = 0; a < n; ++a)
        for (int b = a; b < n; ++b) {
          const P product = dot(g[a], g[b]);
          for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
              k[(3 * a + i) * size + 3 * b + j] +=
                  ofLambda * h[a][i] * h[b][j] + ofEta * (product * B(i, j) + h[b][i] * h[a][j]);
        }
    }
  }
  if (constants_.massProportional > 0)
    for (int a = 0; a < n; ++a) {
      const P own = P(*factor_ * constants_.massProportional) * gather(masses_, n, a, elements);
      for (int i = 0; i < 3; ++i) k[(3 * a + i) * size + 3 * a + i] += own;
    }
  if (!hourglass_.empty()) {
    const P c = P(*factor_) * gather(hourglass_, hourglassCount, gammas, elements);
    for (std::size_t h = 0; h < HourglassVectors::count; ++h) {
      P gamma[HourglassVectors::nodes];
      for (std::size_t a = 0; a < HourglassVectors::nodes; ++a)
        gamma[a] = gather(hourglass_, hourglassCount, h * HourglassVectors::nodes + a, elements);
      for (int a = 0; a < n; ++a)
        for (int b = a; b < n; ++b)
          for (int i = 0; i < 3; ++i) k[(3 * a + i) * size + 3 * b + i] += c * gamma[a] * gamma[b];
    }
  }
  for (int i = 1; i < size; ++i)
    for (int j = 0; j < i; ++j) k[i * size + j] = k[j * size + i];
  if (!rounding) return;
  P T[maxElementNodes];
  roundingOf(elements, edges, T);
  for (int a = 0; a < n; ++a)
    (P(sumOfTangentsRounding) * P::load(rounding + a * lanes) + T[a]).store(rounding + a * lanes);
}

/// T_a of f C: Theorem 60, docs/theory/element_damping.md.
void DampedBlock::roundingOf(const std::int32_t* elements, const P (*edges)[3], P* T) const {
  const int n = nodesPerElement();
  const double u = unitRoundoff;
  const Sizes sizes = sizesOf(elements);
  P square(0.0);
  for (int a = 1; a < n; ++a) square += dot(edges[a], edges[a]);
  const P edge = math::sqrt(square);
  Mean at;
  const bool mean = meanOf(elements, at) != nullptr;
  Means::Vectors vectors;
  if (mean) vectors = Means::vectorsOf(at);
  for (int a = 0; a < n; ++a) T[a] = P(0.0);
  if (constants_.bulk()) {
    P w[maxElementNodes][3], volume;
    volumeGradient(elements, edges, volume, w);
    // What ∂V/∂x_a and V err by.
    P ofGradient(0.0), ofVolume(0.0);
    if (mean) {  // Theorem 92
      const P F = norm(meanDeformation(at, edges)), error = Means::gradientError(vectors, edge);
      ofGradient = at.volume * vectors.norm * (P(3.0) * F * error + P(32 * u) * F * F);
      ofVolume = at.volume * F * F * (P(2.0) * error + P(16 * u) * F);
    } else if (goesByModes(element())) {
      ofGradient = P(8 * u) * square;
      ofVolume = P(16 * u) * square * edge;
    }
    for (int q = 0; !goesByModes(element()) && q < points_; ++q) {
      const Matrix3<P> D = naturalGradient(n, edges, shapeTable(q, 0));
      double largest = 0;
      for (int a = 0; a < n; ++a) {
        const double* dN = shapeTable(q, a);
        largest = std::max(largest, std::hypot(dN[0], dN[1], dN[2]));
      }
      const P d = norm(D), error = P(u * (n + 4) * tableNorm_[q]) * edge;
      ofGradient += P(weights_[q] * largest) * (P(2.0) * error + P(u * (12 + points_)) * d) * d;
      ofVolume += P(weights_[q]) * (error + P(u * (12 + points_)) * d) * d * d;
    }
    ofVolume = ofVolume / math::max(volume, sizes.leastVolume);
    P largest2(0.0);
    for (int a = 0; a < n; ++a) largest2 = math::max(largest2, dot(w[a], w[a]));
    const P largest = math::sqrt(largest2) + ofGradient;
    const P all = P(2.0) * bulkFactor(sizes, volume, elements) * largest *
                  (P(2.0) * ofGradient + (P(16 * u) + P(2.0) * ofVolume) * largest);
    const P known = select(ofVolume < P(0.1), all, P(infinity));
    for (int a = 0; a < n; ++a) T[a] += select(sizes.strength > P(0.0), known, P(0.0));
  }
  if (constants_.viscous()) {
    const double lambda = constants_.volumeViscosity - 2.0 / 3 * constants_.shearViscosity;
    const P modulus(*factor_ * (std::max(lambda, 0.0) + 2 * constants_.shearViscosity + std::max(-3 * lambda, 0.0)));
    if (mean) {  // as of a law with this modulus
      const P F = norm(meanDeformation(at, edges)), error = Means::gradientError(vectors, edge);
      const P law = modulus * (P(2.0) * F * error + error * error + P(40 * u) * F * F);
      const P all = Means::tangentError(at, vectors, {modulus * F * F, law});
      for (int a = 0; a < n; ++a) T[a] += all;
    }
    for (int q = 0; !mean && q < points_; ++q) {
      P g[maxElementNodes][3];
      const Point point = pointOf(q, elements, edges, g);
      const P F = norm(point.F), inverse = norm(point.inverseJacobian),
              condition = P(tableNorm_[q]) * inverse * sizes.extent;
      const P error =
          P(u * tableNorm_[q]) * inverse * (P(gradientRounding + n) * edge + P(gradientRounding) * sizes.extent * F);
      const P law = modulus * (P(2.0) * F * error + error * error + P(40 * u) * F * F);
      const P all = law + (P(shapeRounding * u) * condition + P(productRounding * u)) * modulus * F * F;
      for (int a = 0; a < n; ++a) {
        const P g2 = dot(g[a], g[a]);
        const P own = P(2.0) * point.weight * all * (g2 + g2 + P(1.0) / (sizes.extent * sizes.extent));
        T[a] += select(point.weight > P(0.0), own, P(0.0));
      }
    }
  }
  if (constants_.massProportional > 0)
    for (int a = 0; a < n; ++a)
      T[a] += P(4 * u * *factor_ * constants_.massProportional) * gather(masses_, n, a, elements);
  if (!hourglass_.empty())
    for (int a = 0; a < n; ++a) T[a] += P(*factor_) * gather(hourglass_, hourglassCount, gammas + 1, elements);
}

void DampedBlock::tangentBatch(std::int32_t batch, const double* x, double* K, double* rounding) const {
  inner().tangentBatch(batch, x, K, rounding);
  addTangent(layout().elements.data() + static_cast<std::ptrdiff_t>(batch) * lanes, x, K, rounding);
}

void DampedBlock::tangentOf(const std::int32_t* elements, const double* x, double* K, double* rounding) const {
  inner().tangentOf(elements, x, K, rounding);
  addTangent(elements, x, K, rounding);
}

void DampedBlock::addTangentRounding(const Patch& patch, const double* x, double* slots) const {
  if (!(*factor_ > 0)) return inner().addTangentRounding(patch, x, slots);
  const int n = nodesPerElement();
  // Into slots of their own: what is there may not be scaled.
  std::vector<double> own(4 * static_cast<std::size_t>(patch.nodeEnd - patch.nodeBegin), 0.0);
  inner().addTangentRounding(patch, x, own.data());
  for (double& value : own) value *= sumOfTangentsRounding;
  for (std::int32_t batch = patch.batchBegin; batch < patch.batchEnd; ++batch) {
    const std::int32_t* elements = layout().elements.data() + static_cast<std::ptrdiff_t>(batch) * lanes;
    const std::uint16_t* local = layout().localNodes.data() + static_cast<std::ptrdiff_t>(batch) * n * lanes;
    P edges[maxElementNodes][3], T[maxElementNodes], row[3] = {P(0.0), P(0.0), P(0.0)};
    loadEdges(x, elements, edges);
    roundingOf(elements, edges, T);
    for (int a = 0; a < n; ++a) {
      row[0] = T[a];
      addRows(own.data(), local + a * lanes, row);
    }
  }
  for (std::size_t i = 0; i < own.size(); ++i) slots[i] += own[i];
}

void DampedBlock::deformationOf(const std::int32_t* elements, const double* x, double* F, TangentDrift* drift) const {
  inner().deformationOf(elements, x, F, drift);
  const double f = *factor_;
  if (!(f > 0)) return;
  const double lambda = constants_.volumeViscosity - 2.0 / 3 * constants_.shearViscosity;
  const double viscous = f * (std::max(lambda, 0.0) + 2 * constants_.shearViscosity);
  P s(0.0), volume(1.0);
  Sizes sizes{};
  if (constants_.bulk()) {
    P edges[maxElementNodes][3], w[maxElementNodes][3];
    loadEdges(x, elements, edges);
    volumeGradient(elements, edges, volume, w);
    sizes = sizesOf(elements);
    s = bulkFactor(sizes, volume, elements);
  }
  constexpr double up = 1 + 1e-9;
  for (int lane = 0; lane < lanes; ++lane) {
    if (elements[lane] < 0) continue;
    auto& law = drift[lane].law;
    law.kappa += up * viscous;
    if (!constants_.bulk()) continue;
    double e = 0, stretch = 0;  // largest |cof F| and |F| of the points
    for (int q = 0; q < points_; ++q) {
      Matrix3<double> own;
      for (int i = 0; i < 9; ++i) own.m[i] = F[(9 * q + i) * lanes + lane];
      const Matrix3<double> cof = cofactor(own);
      e = std::max(e, innerProduct(cof, cof));
      stretch = std::max(stretch, innerProduct(own, own));
    }
    e = up * std::sqrt(e);
    stretch = up * std::sqrt(stretch);
    constexpr double most = 0.1, share = 0.1;
    const double counted = std::max(volume[lane], sizes.leastVolume[lane]), rest = sizes.restVolume[lane];
    const double slope = up * (e + most * stretch + most * most / 5);
    const double radius = std::min(most, share * counted / (rest * slope)), d = up * (2 * stretch + 0.6 * radius);
    const double modulus = up * s[lane] * rest, grown = e + d * radius;
    law.kappa += modulus * d * d;
    law.linear += 2.35 * rest * slope / counted * modulus * grown * grown;
    law.radius = std::min(law.radius, radius);
  }
}

bool ElementDamping::dependsOnRates() const {
  return std::any_of(blocks_.begin(), blocks_.end(),
                     [](const DampedBlock* block) { return block && block->dependsOnRates(); });
}

void ElementDamping::forgetRates() {
  for (DampedBlock* block : blocks_)
    if (block) block->forgetRates();
}

void ElementDamping::addDampingProduct(std::size_t block, const Patch& patch, const double* x, const double* v,
                                       double factor, double* slots) const {
  const DampedBlock* own = blocks_[block];
  if (!own) return;
  alignas(64) double rows[4 * PatchLayout::maxPatchNodes], vRows[4 * PatchLayout::maxPatchNodes];
  own->gatherRows(patch, x, rows);
  own->gatherRows(patch, v, vRows);
  own->addProduct(patch, rows, vRows, factor, slots);
}

}  // namespace ringwatch
