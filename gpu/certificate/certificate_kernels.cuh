#pragma once
#include <cuda_fp16.h>

#include <type_traits>

#include <ringwatch/base/rounding.h>
#include <ringwatch/gpu/certificate/certificate_operations.h>
#include <ringwatch/monitor/bounds/nodal_weights.h>
#include <ringwatch/monitor/incremental/rebuild_policy.h>
#include <ringwatch/monitor/incremental/tangent_growth.h>
#include <ringwatch/gpu/body/patch_kernels.cuh>
#include <ringwatch/gpu/certificate/thread_teams.cuh>
#include <ringwatch/gpu/certificate/warp_tridiagonal.cuh>

/// The block nodal bound and its balls on the device: the arithmetic of monitor/bounds/nodal_weights.h, an element a
/// thread, but where a step waits for few elements.
namespace ringwatch::detail {

/// RoundedDown (base/short_floats.h) of the device, in half precision; infinity stays.
class HalfRoundedDown {
 public:
  // Not an initialiser: the host's compiler would see it.
  __device__ __forceinline__ explicit HalfRoundedDown(double number) {
    stored_ = __float2half_rd(__double2float_rd(number));
  }
  __device__ __forceinline__ __half stored() const { return stored_; }

 private:
  __half stored_;
};

/// The ball test of the patch kernel.
struct BallCheck {
  static constexpr bool on = true;
  CertificateView view;

  /// A centre of gradients, and a radius: ten numbers in half precision.
  struct Ball {
    __half2 pair[5];
    __device__ __forceinline__ float radius() const { return __high2float(pair[4]); }
    __device__ __forceinline__ bool left(const Matrix3<double>& F, float radius) const {
      float distance2 = 0;
#pragma unroll
      for (int i = 0; i < 9; ++i) {
        const float d =
            static_cast<float>(F.m[i]) - (i % 2 == 0 ? __low2float(pair[i / 2]) : __high2float(pair[i / 2]));
        distance2 += d * d;
      }
      return !(radius >= 0 && distance2 <= radius * radius);  // NaN has left
    }
  };
  /// F0 at a point, and, with the first point, the radius.
  __device__ __forceinline__ Ball own(int q, int points, int threads) const {
    return load(view.balls, static_cast<std::size_t>(blockIdx.x) * points + q, threads);
  }
  /// The one ball for all points: gradients inside are in their own.
  __device__ __forceinline__ Ball ofElement(int threads) const { return load(view.centres, blockIdx.x, threads); }
  static __device__ __forceinline__ Ball load(const std::uint32_t* balls, std::size_t row, int threads) {
    const auto* from = reinterpret_cast<const __half2*>(balls) + row * 5 * threads + threadIdx.x;
    Ball ball;
#pragma unroll
    for (int i = 0; i < 5; ++i) ball.pair[i] = from[i * threads];
    return ball;
  }
  /// Where the element's deformation gradients go; nullptr when the list is full.
  __device__ double* note(int points, int threads) const {
    const unsigned at = atomicAdd(view.outsideCount, 1U);
    if (at >= static_cast<unsigned>(view.capacity)) return nullptr;
    view.outsidePlace[at] = static_cast<std::int32_t>(blockIdx.x) * threads + static_cast<std::int32_t>(threadIdx.x);
    return view.outsideF + static_cast<std::size_t>(at) * 9 * points;
  }
};

/// Displacements of a patch's nodes in device memory.
struct MeshDisplacements {
  const Row4<double>* u;
  const std::int32_t* own;
  __device__ double operator()(int component, int local) const { return (&u[own[local]].x)[component]; }
};

/// Where the balls of an element lie, ten halves each: F0 row by row and the radius, in pairs some halves apart.
struct BallPlace {
  struct Ball {
    __half* first;
    std::size_t toNext;  // from pair to pair
    __device__ __forceinline__ __half& operator[](int i) const { return first[i / 2 * toNext + i % 2]; }
  };
  __half *points, *centre;
  std::size_t toNextPoint, toNextPair;

  __device__ __forceinline__ Ball ofPoint(int q) const { return {points + q * toNextPoint, toNextPair}; }
  /// That of the point where there is one.
  __device__ __forceinline__ Ball ofElement() const { return {centre, toNextPair}; }

  /// What steps read.
  static __device__ BallPlace inPlace(const CertificateView& view, std::size_t place, int points, int threads) {
    const std::size_t patch = place / threads, thread = place % threads;
    const auto at = [&](std::uint32_t* balls, std::size_t row) {
      return reinterpret_cast<__half*>(balls + row * 5 * threads + thread);
    };
    return {at(view.balls, patch * static_cast<std::size_t>(points)), at(view.centres, patch),
            static_cast<std::size_t>(10 * threads), static_cast<std::size_t>(2 * threads)};
  }
  /// Of an element on the list, until steps no longer read its old ones.
  static __device__ BallPlace apart(const CertificateView& view, unsigned listed, int points) {
    const int balls = ballsOfPoints(points);
    auto* first = reinterpret_cast<__half*>(view.newBalls) + static_cast<std::size_t>(listed) * 10 * balls;
    return {first, first + 10 * (balls - 1), 10, 2};
  }
};

/// One element's part of the bound.
template <class Element, class Law>
struct ElementBound {
  static constexpr int n = Element::nodes, size = 3 * n, threads = patchThreads(n);
  using Table = ShapeTable<Element, double>;

  using Operators = ElementOperators<Element, double>;
  /// The lower triangle of K += w g ⊗ (∂P/∂F) g.
  static __device__ __forceinline__ void addTangent(const Law& law, const Matrix3<double>& F, double weight,
                                                    const double (&g)[n][3], double* K) {
    Operators::addTangent(law.linearize(F), weight, g,
                          [K](int row, int column, double value) { K[column * size + row] += value; });
  }
  static __device__ __forceinline__ void clear(double* K) {
#pragma unroll
    for (int i = 0; i < size * size; ++i) K[i] = 0;
  }
  /// The lower triangle of the element's tangent at the displacements of its nodes.
  static __device__ __forceinline__ void tangentAt(const ElementView<Element, double>& element,
                                                   const NodeView<double>& nodes, const std::int32_t* own,
                                                   const Law& law, const Table& table, int points, double* K) {
    clear(K);
    forEachPoint(element, points, [&](int q, const Matrix3<double>& J1, double weight) {
      const Matrix3<double> F = deformationGradient<Element>(element, MeshDisplacements{nodes.u, own}, table, q, J1);
      double g[n][3];
      Operators::shapeGradients(J1, table.dN[q], g);
      addTangent(law, F, weight, g, K);
    });
  }
  static __device__ __forceinline__ void loadWeights(const CertificateView& view, std::size_t patch, int thread,
                                                     Symmetric3<double> (&weights)[n]) {
    const double* from = view.weights + patch * 6 * n * threads + thread;
#pragma unroll
    for (int a = 0; a < n; ++a)
#pragma unroll
      for (int c = 0; c < 6; ++c) weights[a].m[c] = from[(6 * a + c) * threads];
  }
  static __device__ __forceinline__ void storeWeights(const CertificateView& view, std::size_t patch, int thread,
                                                      const Symmetric3<double> (&weights)[n]) {
    double* to = view.weights + patch * 6 * n * threads + thread;
#pragma unroll
    for (int a = 0; a < n; ++a)
#pragma unroll
      for (int c = 0; c < 6; ++c) to[(6 * a + c) * threads] = weights[a].m[c];
  }
  /// Constrained components of the element's nodes, three bits each.
  static __device__ __forceinline__ unsigned constrainedOf(const NodeView<double>& nodes, const std::int32_t* own,
                                                           const Corners<n>& corners) {
    unsigned bits = 0;
    if (nodes.constrained != nullptr)
#pragma unroll
      for (int a = 0; a < n; ++a) bits |= static_cast<unsigned>(nodes.constrained[own[corners.node[a]]]) << (3 * a);
    return bits;
  }
  /// Makes constrained rows and columns of K's lower triangle zero.
  static __device__ __forceinline__ void constrain(double* K, unsigned constrained) {
    if (constrained == 0) return;
#pragma unroll
    for (int i = 0; i < size; ++i)
#pragma unroll
      for (int j = 0; j <= i; ++j)
        if ((constrained >> i & 1U) != 0 || (constrained >> j & 1U) != 0) K[i * size + j] = 0;
  }
  /// max(0, lambda_max(D⁻¹ K)) without constrained rows and columns, rounded up; K's lower triangle is destroyed.
  static __device__ __forceinline__ double largest(double* K, const Symmetric3<double> (&weights)[n],
                                                   unsigned constrained) {
    constrain(K, constrained);
    double w[n][6], work[4 * size];
#pragma unroll
    for (int a = 0; a < n; ++a) invertFactor(factorOf(weights[a]), w[a]);
    scaleByFactors(w, n, K);
    const auto extremes = extremeEigenvaluesOf < size == 12 ? 12 : 0 > (K, size, work, false);
    const double l = extremes.largest + eigenvalueRounding * extremes.scale;
    return l < 0 ? 0 : l;
  }
  /// The lower triangle of K += w L ⊗ I, L_ab = g_a·g_b.
  static __device__ __forceinline__ void addLaplacian(double weight, const double (&g)[n][3], double* K) {
    Operators::addLaplacian(weight, g, [K](int a, int b, double value) {
#pragma unroll
      for (int i = 0; i < 3; ++i) K[(3 * a + i) * size + 3 * b + i] += value;
    });
  }

  /// Puts a ball around the gradients F(q): its radius, reference gradients and what both lose by rounding; and one
  /// around their mean; where `balls` says. The threads of the team share the points.
  template <class Team, class Gradients>
  static __device__ void setBall(const Law& law, const BallPlace& balls, int points, const Gradients& F, double value,
                                 double allowance, double strainNorm) {
    TangentDrift drift;
    double rounding2 = 0, size2 = 0;
    Matrix3<double> mean = Matrix3<double>::zero();
    for (int q = Team::first(); q < points; q += Team::size) {
      const Matrix3<double> own = F(q);
      drift.addPoint(law, own);
      mean = mean + own;
      rounding2 = fmax(rounding2, distance2(own, storeCentre(own, balls.ofPoint(q))));
      size2 = fmax(size2, innerProduct(own, own));
    }
    drift.law.kappa = Team::largest(drift.law.kappa);
    drift.law.linear = Team::largest(drift.law.linear);
    drift.law.quadratic = Team::largest(drift.law.quadratic);
    drift.law.negative = Team::largest(drift.law.negative);
    drift.law.radius = Team::least(drift.law.radius);
    drift.inversionDistance = Team::least(drift.inversionDistance);
    rounding2 = Team::largest(rounding2);
    size2 = Team::largest(size2);
    const double radius = validityRadius(growthOf(drift.law, value, strainNorm), drift.inversionDistance, allowance);
    // The test is in single precision: its own rounding comes off too.
    const auto around = [&](double off2) {
      const double own =
          radius < 1e30 ? (radius - sqrt(off2)) * (1 - deviceBallRounding) - deviceGradientRounding * (1 + sqrt(size2))
                        : radius;
      return HalfRoundedDown(own >= 0 ? own : -1.0);
    };
    if (Team::first() == 0) setRadius(balls.ofPoint(0), around(rounding2));
    if (points == 1) return;
#pragma unroll
    for (double& entry : mean.m) entry = Team::sum(entry) * (1.0 / points);
    const Matrix3<double> centre = rounded(mean);
    double off2 = 0;
    for (int q = Team::first(); q < points; q += Team::size) off2 = fmax(off2, distance2(F(q), centre));
    off2 = Team::largest(off2);
    if (Team::first() != 0) return;
    storeCentre(mean, balls.ofElement());
    setRadius(balls.ofElement(), around(off2));
  }
  /// What is stored of a centre.
  static __device__ Matrix3<double> rounded(const Matrix3<double>& centre) {
    Matrix3<double> stored;
#pragma unroll
    for (int i = 0; i < 9; ++i) stored.m[i] = static_cast<double>(__half2float(__double2half(centre.m[i])));
    return stored;
  }
  static __device__ Matrix3<double> storeCentre(const Matrix3<double>& centre, const BallPlace::Ball& ball) {
#pragma unroll
    for (int i = 0; i < 9; ++i) ball[i] = __double2half(centre.m[i]);
    return rounded(centre);
  }
  static __device__ double distance2(const Matrix3<double>& a, const Matrix3<double>& b) {
    return innerProduct(a - b, a - b);
  }
  static __device__ __forceinline__ void setRadius(const BallPlace::Ball& ball, HalfRoundedDown radius) {
    ball[9] = radius.stored();
  }
};

template <class Element, class Law>
__global__ void __launch_bounds__(patchThreads(Element::nodes))
    startWeightsKernel(const BlockView<double> block, const NodeView<double> nodes, const __grid_constant__ Law law,
                       const __grid_constant__ ShapeTable<Element, double> table, const CertificateView view) {
  using Bound = ElementBound<Element, Law>;
  constexpr int n = Bound::n;
  if (static_cast<int>(threadIdx.x) >= block.patches[blockIdx.x].elementCount) return;
  const std::int32_t* own = block.nodes + static_cast<std::size_t>(blockIdx.x) * block.nodeCapacity;
  const ElementView<Element, double> element(block);
  double K[Bound::size * Bound::size];
  Bound::tangentAt(element, nodes, own, law, table, block.pointCount, K);
  Bound::constrain(K, Bound::constrainedOf(nodes, own, element.corners));
#pragma unroll 1
  for (int i = 0; i < Bound::size; ++i)
    for (int j = 0; j < i; ++j) K[j * Bound::size + i] = K[i * Bound::size + j];
  Symmetric3<double> weights[n];
#pragma unroll 1
  for (int a = 0; a < n; ++a) weights[a] = sizeOfRows(K, Bound::size, a);
  normaliseWeights(weights, n);
  Bound::storeWeights(view, blockIdx.x, static_cast<int>(threadIdx.x), weights);
}

template <class Element, class Law>
__global__ void __launch_bounds__(patchThreads(Element::nodes))
    evaluateKernel(const BlockView<double> block, const NodeView<double> nodes, const __grid_constant__ Law law,
                   const __grid_constant__ ShapeTable<Element, double> table, const CertificateView view) {
  using Bound = ElementBound<Element, Law>;
  constexpr int n = Bound::n;
  const std::size_t place = static_cast<std::size_t>(blockIdx.x) * Bound::threads + threadIdx.x;
  if (static_cast<int>(threadIdx.x) >= block.patches[blockIdx.x].elementCount) {
    view.value[place] = 0;
    return;
  }
  const std::int32_t* own = block.nodes + static_cast<std::size_t>(blockIdx.x) * block.nodeCapacity;
  const ElementView<Element, double> element(block);
  double K[Bound::size * Bound::size];
  Bound::tangentAt(element, nodes, own, law, table, block.pointCount, K);
  Symmetric3<double> weights[n];
  Bound::loadWeights(view, blockIdx.x, static_cast<int>(threadIdx.x), weights);
  view.value[place] = Bound::largest(K, weights, Bound::constrainedOf(nodes, own, element.corners));
}

template <class Element>
__global__ void __launch_bounds__(patchThreads(Element::nodes))
    sweepKernel(const BlockView<double> block, const CertificateView view, const NodalSums sums) {
  constexpr int n = Element::nodes, threads = patchThreads(n);
  if (static_cast<int>(threadIdx.x) >= block.patches[blockIdx.x].elementCount) return;
  const std::int32_t* own = block.nodes + static_cast<std::size_t>(blockIdx.x) * block.nodeCapacity;
  const auto corners =
      reinterpret_cast<const Corners<n>*>(block.corners)[static_cast<std::size_t>(blockIdx.x) * threads + threadIdx.x];
  using Bound = ElementBound<Element, LinearElastic>;  // weights do not know the law
  Symmetric3<double> weights[n];
  Bound::loadWeights(view, blockIdx.x, static_cast<int>(threadIdx.x), weights);
#pragma unroll
  for (int a = 0; a < n; ++a) {
    Symmetric3<double> R;
    const double* from = sums.factors + static_cast<std::size_t>(own[corners.node[a]]) * 6;
#pragma unroll
    for (int c = 0; c < 6; ++c) R.m[c] = from[c];
    weights[a] = congruence(R, weights[a]);
  }
  normaliseWeights(weights, n);
  Bound::storeWeights(view, blockIdx.x, static_cast<int>(threadIdx.x), weights);
}

template <class Element, class Law>
__global__ void __launch_bounds__(patchThreads(Element::nodes))
    distributeKernel(const BlockView<double> block, const NodeView<double> nodes, const __grid_constant__ Law law,
                     const __grid_constant__ ShapeTable<Element, double> table, const CertificateView view,
                     const NodalSums sums, double sigma) {
  using Bound = ElementBound<Element, Law>;
  constexpr int n = Bound::n;
  const std::size_t place = static_cast<std::size_t>(blockIdx.x) * Bound::threads + threadIdx.x;
  if (static_cast<int>(threadIdx.x) >= block.patches[blockIdx.x].elementCount) return;
  const std::int32_t* own = block.nodes + static_cast<std::size_t>(blockIdx.x) * block.nodeCapacity;
  const ElementView<Element, double> element(block);
  const unsigned constrained = Bound::constrainedOf(nodes, own, element.corners);
  double scaling = std::numeric_limits<double>::infinity();
#pragma unroll
  for (int a = 0; a < n; ++a) {
    const double nodal = sums.nodal[own[element.corners.node[a]]];
    if (nodal > 0) scaling = fmin(scaling, sigma / nodal);
  }
  const double value = view.value[place];
  const double allowance = value > 0 ? value * scaling * (1 - allowanceRounding) : 0;
  double L[Bound::size * Bound::size];
  Bound::clear(L);
  forEachPoint(element, block.pointCount, [&](int q, const Matrix3<double>& J1, double weight) {
    double g[n][3];
    Bound::Operators::shapeGradients(J1, table.dN[q], g);
    Bound::addLaplacian(weight, g, L);
  });
  Symmetric3<double> weights[n];
  Bound::loadWeights(view, blockIdx.x, static_cast<int>(threadIdx.x), weights);
  const double strainNorm = Bound::largest(L, weights, constrained);
  view.allowance[place] = allowance;
  view.strainNorm[place] = strainNorm;
  const auto gradientAt = [&](int q) {
    PointGeometry<Element, double> geometry;
    geometry.load(element.geometry +
                  static_cast<std::size_t>(q) * ElementView<Element, double>::entries * Bound::threads);
    return deformationGradient<Element>(element, MeshDisplacements{nodes.u, own}, table, q, geometry.J1);
  };
  const int points = Element::constantGradient ? 1 : block.pointCount;
  const BallPlace balls = BallPlace::inPlace(view, place, points, Bound::threads);
  Bound::template setBall<SingleThread>(law, balls, points, gradientAt, value, allowance, strainNorm);
  // Nothing of a wholly constrained element is left in the problem.
  if (constrained != 0 && value == 0 && strainNorm <= 1e-200)
    Bound::setRadius(balls.ofElement(), HalfRoundedDown(std::numeric_limits<double>::infinity()));
}

/// max(0, lambda_max(D⁻¹ K)), K = Σ over points of w g (∂P/∂F) g at the gradients F(q) that an element had; pointAt(q):
/// the point's geometry. By one thread: for tetrahedra, whose matrices fit its registers, the fastest way.
template <class Element, class Law>
struct ThreadEvaluation {
  using Team = SingleThread;
  using Bound = ElementBound<Element, Law>;

  template <class PointAt, class Gradients>
  __device__ double largest(const Law& law, const ShapeTable<Element, double>& table, int points,
                            const CertificateView& view, std::size_t patch, int thread, unsigned constrained,
                            const PointAt& pointAt, const Gradients& F) {
    double K[Bound::size * Bound::size];
    Bound::clear(K);
#pragma unroll 1
    for (int q = 0; q < points; ++q) {
      const PointGeometry<Element, double> at = pointAt(q);
      double g[Bound::n][3];
      Bound::Operators::shapeGradients(at.J1, table.dN[q], g);
      Bound::addTangent(law, F(q), at.weight, g, K);
    }
    Symmetric3<double> weights[Bound::n];
    Bound::loadWeights(view, patch, thread, weights);
    return Bound::largest(K, weights, constrained);
  }
};
/// The same by a warp, whose threads share the 3×3 blocks of the tangent and the rows of its reduction, so that a step
/// which waits for few elements does not wait long. In memory that the warp shares.
template <class Element, class Law>
struct WarpEvaluation {
  using Team = Warp;
  using Bound = ElementBound<Element, Law>;
  static constexpr int n = Bound::n, size = Bound::size, pairs = n * (n + 1) / 2,
                       rounds = (pairs + Warp::size - 1) / Warp::size;
  WarpTridiagonal<size> matrix;
  double factors[n][6];  // L⁻¹ of the weights

  template <class PointAt, class Gradients>
  __device__ double largest(const Law& law, const ShapeTable<Element, double>& table, int points,
                            const CertificateView& view, std::size_t patch, int thread, unsigned constrained,
                            const PointAt& pointAt, const Gradients& F) {
    const int lane = Warp::first();
    if (lane < n) {
      Symmetric3<double> weight;
      const double* from = view.weights + (patch * 6 * n + 6 * lane) * Bound::threads + thread;
#pragma unroll
      for (int c = 0; c < 6; ++c) weight.m[c] = from[c * Bound::threads];
      invertFactor(factorOf(weight), factors[lane]);
    }
    __syncwarp();
    int first[rounds], second[rounds];  // nodes of this thread's blocks, first <= second
    Matrix3<double> block[rounds];
#pragma unroll
    for (int r = 0; r < rounds; ++r) {
      int pair = lane + r * Warp::size, a = 0;
      for (; a < n && pair >= n - a; ++a) pair -= n - a;
      first[r] = a;  // n: there is none
      second[r] = a + pair;
      block[r] = Matrix3<double>::zero();
    }
    PointGeometry<Element, double> next = pointAt(0);  // on its way while the one before is computed
    Matrix3<double> nextF = F(0);
#pragma unroll 1
    for (int q = 0; q < points; ++q) {
      const PointGeometry<Element, double> at = next;
      const auto linearization = law.linearize(nextF);
      if (q + 1 < points) {
        next = pointAt(q + 1);
        nextF = F(q + 1);
      }
      double g[n][3];
      Bound::Operators::shapeGradients(at.J1, table.dN[q], g);
      const auto blocks = nodeBlocksOf(linearization, at.weight);
#pragma unroll
      for (int r = 0; r < rounds; ++r) {
        double own[2][3] = {};
#pragma unroll
        for (int a = 0; a < n; ++a)
#pragma unroll
          for (int j = 0; j < 3; ++j) {
            if (a == first[r]) own[0][j] = g[a][j];
            if (a == second[r]) own[1][j] = g[a][j];
          }
        block[r] = block[r] + blocks(blocks.node(own[0]), blocks.node(own[1]));
      }
    }
#pragma unroll
    for (int r = 0; r < rounds; ++r)
      if (first[r] < n) store(first[r], second[r], block[r], constrained);
    matrix.reduce();
    double d[size], e2[size];
#pragma unroll
    for (int k = 0; k < size; ++k) {
      d[k] = matrix.d[k];
      e2[k] = k + 1 < size ? matrix.e2[k] : 0;
    }
    __syncwarp();  // all have read what the next element overwrites
    const auto extremes = extremesOfTridiagonal<size>(d, e2, size, false);
    const double l = extremes.largest + eigenvalueRounding * extremes.scale;
    return l < 0 ? 0 : l;
  }

 private:
  /// L_a⁻¹ K_ab L_b⁻ᵀ, without constrained rows and columns, into both triangles.
  __device__ __forceinline__ void store(int a, int b, Matrix3<double> K, unsigned constrained) {
    const double *u = factors[a], *w = factors[b];
#pragma unroll
    for (int i = 0; i < 3; ++i)
#pragma unroll
      for (int j = 0; j < 3; ++j)
        if ((constrained >> (3 * a + i) & 1U) != 0 || (constrained >> (3 * b + j) & 1U) != 0) K(i, j) = 0;
#pragma unroll
    for (int j = 0; j < 3; ++j) {
      K(2, j) = u[3] * K(0, j) + u[4] * K(1, j) + u[5] * K(2, j);
      K(1, j) = u[1] * K(0, j) + u[2] * K(1, j);
      K(0, j) = u[0] * K(0, j);
    }
#pragma unroll
    for (int i = 0; i < 3; ++i) {
      K(i, 2) = w[3] * K(i, 0) + w[4] * K(i, 1) + w[5] * K(i, 2);
      K(i, 1) = w[1] * K(i, 0) + w[2] * K(i, 1);
      K(i, 0) = w[0] * K(i, 0);
    }
#pragma unroll
    for (int i = 0; i < 3; ++i)
#pragma unroll
      for (int j = 0; j < 3; ++j)
        if (a < b || i <= j) {
          matrix.A[(3 * a + i) * size + 3 * b + j] = K(i, j);
          matrix.A[(3 * b + j) * size + 3 * a + i] = K(i, j);
        }
  }
};

/// Threads of a block of the next kernel.
constexpr int refreshThreads = 128;
/// Elements that have left their balls are evaluated at the gradients that they noted. Where steps may read the balls
/// meanwhile new ones lie apart, and are put in place later; else the last block clears the list.
template <class Element, class Law>
__global__ void __launch_bounds__(refreshThreads)
    refreshKernel(const BlockView<double> block, const NodeView<double> nodes, const __grid_constant__ Law law,
                  const __grid_constant__ ShapeTable<Element, double> table, const CertificateView view) {
  using Bound = ElementBound<Element, Law>;
  constexpr int n = Bound::n, threads = Bound::threads;
  using Evaluation =
      std::conditional_t<Element::constantGradient, ThreadEvaluation<Element, Law>, WarpEvaluation<Element, Law>>;
  using Team = typename Evaluation::Team;
  constexpr int teams = refreshThreads / Team::size;
  __shared__ Evaluation evaluations[teams];
  const int points = Element::constantGradient ? 1 : block.pointCount;
  const unsigned left = *static_cast<volatile unsigned*>(view.outsideCount);
  const unsigned listed = min(left, static_cast<unsigned>(view.capacity));
  const std::int64_t step = *static_cast<volatile std::int64_t*>(&view.flags->checked);
  bool lost = left > listed, near = false;
  constexpr double nearlyLost = RebuildPolicy{}.nearlyLost;
  const unsigned team = threadIdx.x / Team::size;
  const bool apart = view.newBalls != nullptr;
  // The first team of each block, then the second: few elements are spread over all processors.
  for (unsigned i = team * gridDim.x + blockIdx.x; i < listed; i += teams * gridDim.x) {
    const std::size_t place = view.outsidePlace[i];
    const std::size_t patch = place / threads;
    const auto thread = static_cast<int>(place % threads);
    const std::int32_t* own = block.nodes + patch * static_cast<std::size_t>(block.nodeCapacity);
    const Corners<n> corners = reinterpret_cast<const Corners<n>*>(block.corners)[place];
    const double* geometry = block.geometry + patch * points * ElementView<Element, double>::entries * threads + thread;
    const double* noted = view.outsideF + static_cast<std::size_t>(i) * 9 * points;
    const auto gradientAt = [&](int q) {
      Matrix3<double> F;
#pragma unroll
      for (int k = 0; k < 9; ++k) F.m[k] = noted[9 * q + k];
      return F;
    };
    const auto pointAt = [&](int q) {
      PointGeometry<Element, double> at;
      at.load(geometry + static_cast<std::size_t>(q) * ElementView<Element, double>::entries * threads);
      if constexpr (Element::constantGradient) at.weight = Element::referenceVolume / determinant(at.J1);
      return at;
    };
    const double value = evaluations[team].largest(law, table, points, view, patch, thread,
                                                   Bound::constrainedOf(nodes, own, corners), pointAt, gradientAt);
    const double allowance = view.allowance[place];
    lost = lost || !(value <= allowance);
    near = near || !(value <= nearlyLost * allowance);
    if (Team::first() == 0) view.value[place] = value;
    const BallPlace balls =
        apart ? BallPlace::apart(view, i, points) : BallPlace::inPlace(view, place, points, Bound::threads);
    Bound::template setBall<Team>(law, balls, points, gradientAt, value, allowance, view.strainNorm[place]);
  }
  if (lost) {
    // -1 is the largest of all as an unsigned number: the least step stays.
    atomicMin(reinterpret_cast<unsigned long long*>(&view.flags->lostAt), static_cast<unsigned long long>(step));
  }
  if (near || lost) view.flags->nearlyLost = 1;
  __syncthreads();
  if (threadIdx.x == 0) {
    __threadfence();
    if (atomicAdd(view.done, 1U) == gridDim.x - 1) {
      view.flags->evaluated += listed;
      if (!apart) *view.outsideCount = 0;
      *view.done = 0;
      if (view.countsSteps) view.flags->checked = step + 1;
    }
  }
}

/// Launches the certificate's kernels of one element and law.
template <class Element, class Law>
struct CertificateLauncher {
  using Patches = PatchLauncher<Element, Law, double>;
  static constexpr int threads = patchThreads(Element::nodes), refreshBlocks = 264;

  static void start(const CertificateArguments& at) {
    startWeightsKernel<Element, Law><<<at.block.patchCount, threads, 0, at.stream>>>(
        at.block, at.nodes, std::get<Law>(at.law.law), Patches::tableOf(*at.law.rule), at.view);
    checkLaunch("start of the weights");
  }
  static void evaluate(const CertificateArguments& at) {
    evaluateKernel<Element, Law><<<at.block.patchCount, threads, 0, at.stream>>>(
        at.block, at.nodes, std::get<Law>(at.law.law), Patches::tableOf(*at.law.rule), at.view);
    checkLaunch("element values");
  }
  static void sweep(const CertificateArguments& at) {
    sweepKernel<Element><<<at.block.patchCount, threads, 0, at.stream>>>(at.block, at.view, at.sums);
    checkLaunch("sweep of the weights");
  }
  static void distribute(const CertificateArguments& at) {
    distributeKernel<Element, Law><<<at.block.patchCount, threads, 0, at.stream>>>(
        at.block, at.nodes, std::get<Law>(at.law.law), Patches::tableOf(*at.law.rule), at.view, at.sums, at.sigma);
    checkLaunch("allowances and balls");
  }
  static void step(const CertificateArguments& at) {
    Patches::template launchWith<false, Use::step>(at.block, at.nodes, at.law, nullptr, nullptr, BallCheck{at.view},
                                                   at.stream);
  }
  static void refresh(const CertificateArguments& at) {
    refreshKernel<Element, Law><<<refreshBlocks, refreshThreads, 0, at.stream>>>(
        at.block, at.nodes, std::get<Law>(at.law.law), Patches::tableOf(*at.law.rule), at.view);
    checkLaunch("refresh of the balls");
  }
};

/// Sets the certificate of an element type with law number `law` when the law is in this shard. Instantiated in a
/// generated file a shard.
template <std::size_t shard>
void certificateOperationsOfShard(ElementType type, std::size_t law, CertificateOperations& result) {
  visitLawOfShard<shard>(law, [&]<class LawType>(TypeTag<LawType>) {
    visitElement(type, [&](auto tag) {
      using Element = typename decltype(tag)::type;
      if constexpr (Element::order == 1) {
        using Launcher = CertificateLauncher<Element, LawType>;
        result = {&Launcher::start,      &Launcher::evaluate, &Launcher::sweep,
                  &Launcher::distribute, &Launcher::step,     &Launcher::refresh};
      }
    });
  });
}

}  // namespace ringwatch::detail
