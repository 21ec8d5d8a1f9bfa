#include <ringwatch/handlers/imex/cluster_pcg.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <type_traits>
#if defined(__AVX512F__)
#include <immintrin.h>
#endif

#include <ringwatch/base/matrix3.h>
#include <ringwatch/base/parallel.h>

namespace ringwatch {
namespace {

// Vectors are rows of four numbers, the fourth zero; blocks three columns of four, the fourth zero.
typedef float Float4 __attribute__((vector_size(16)));
typedef double Double4 __attribute__((vector_size(32)));
typedef float Float8 __attribute__((vector_size(32)));
typedef double Double8 __attribute__((vector_size(64)));

template <class V, class T>
RINGWATCH_INLINE V loadAs(const T* from) {
  V v;
  std::memcpy(&v, from, sizeof v);
  return v;
}

/// A sum of blocks times rows.
template <class S>
struct RowSum {
  using Row = std::conditional_t<sizeof(S) == sizeof(float), Float4, Double4>;
  Row sum{};
  RINGWATCH_INLINE void add(const S* block, const S* p) {
    for (int c = 0; c < 3; ++c) sum += loadAs<Row>(block + 4 * c) * p[c];
  }
  RINGWATCH_INLINE void add(const RowSum& other) { sum += other.sum; }
  RINGWATCH_INLINE Row value() const { return sum; }
};
#if defined(__AVX512F__)
/// All three columns at once; what is read beyond the block is multiplied by zero.
template <>
struct RowSum<float> {
  using Row = Float4;
  typedef float Float16 __attribute__((vector_size(64)));
  Float16 sum{};
  RINGWATCH_INLINE void add(const float* block, const float* p) {
    const __m512i component = _mm512_set_epi32(3, 3, 3, 3, 2, 2, 2, 2, 1, 1, 1, 1, 0, 0, 0, 0);
    const __m512 row = _mm512_maskz_broadcast_f32x4(0xffff, _mm_loadu_ps(p));
    sum += loadAs<Float16>(block) * (Float16)_mm512_maskz_permutevar_ps(0xffff, row, component);
  }
  RINGWATCH_INLINE void add(const RowSum& other) { sum += other.sum; }
  RINGWATCH_INLINE Row value() const {
    return __builtin_shufflevector(sum, sum, 0, 1, 2, 3) + __builtin_shufflevector(sum, sum, 4, 5, 6, 7) +
           __builtin_shufflevector(sum, sum, 8, 9, 10, 11);
  }
};
#endif

/// A row of blocks, from place `begin` to `end`, times v.
template <class S>
RINGWATCH_INLINE auto rowTimes(const S* blocks, const std::int32_t* columns, std::int32_t begin, std::int32_t last,
                               const AlignedVector<S>& v) {
  constexpr std::size_t stride = 12;
  RowSum<S> even, odd;
  const std::int32_t *column = columns + begin, *end = columns + last;
  const S* block = blocks + stride * static_cast<std::size_t>(begin);
  for (; column + 1 < end; column += 2, block += 2 * stride) {
    even.add(block, v.data() + column[0]);
    odd.add(block + stride, v.data() + column[1]);
  }
  if (column < end) even.add(block, v.data() + column[0]);
  even.add(odd);
  return even.value();
}

/// Rows that are worth another thread, at least: some 50 µs of a product.
constexpr std::int64_t rowsOfAThread = 1024;

template <class Row>
RINGWATCH_INLINE auto total(Row r) {
  return r[0] + r[1] + r[2];
}

}  // namespace

template <class S>
ClusterPcg<S>::ClusterPcg(const UpperBlocks& A, std::vector<std::uint8_t> constrained, double mass, int threads)
    : scale_(1 / mass), threads_(threads), constrained_(std::move(constrained)) {
  const std::size_t rows = A.rows();
  std::vector<std::vector<std::int32_t>> above(rows);  // upper blocks whose transpose is in the row
  for (std::size_t i = 0; i < rows; ++i)
    for (std::int32_t k = A.rowBegin[i] + 1; k < A.rowBegin[i + 1]; ++k) above[A.column[k]].push_back(k);
  std::vector<std::int32_t> rowOf(A.column.size());
  for (std::size_t i = 0; i < rows; ++i) std::fill(rowOf.begin() + A.rowBegin[i], rowOf.begin() + A.rowBegin[i + 1], i);
  // Rows of equal length follow one another: their ends are then foreseen.
  const auto lengthOf = [&](std::size_t i) {
    return static_cast<std::size_t>(A.rowBegin[i + 1] - A.rowBegin[i]) + above[i].size();
  };
  order_.resize(rows);
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::stable_sort(order_.begin(), order_.end(),
                   [&](std::size_t i, std::size_t j) { return lengthOf(i) < lengthOf(j); });
  ownPlace_.resize(A.column.size());
  mirrored_.resize(A.column.size());
  rowBegin_.assign(1, 0);
  for (const std::size_t i : order_) {
    for (const std::int32_t k : above[i]) {
      mirrored_[k] = static_cast<std::int32_t>(column_.size());
      column_.push_back(4 * rowOf[k]);
    }
    for (std::int32_t k = A.rowBegin[i]; k < A.rowBegin[i + 1]; ++k) {
      const std::size_t at = k;
      ownPlace_[at] = static_cast<std::int32_t>(column_.size());
      if (k == A.rowBegin[i]) mirrored_[at] = ownPlace_[at];
      column_.push_back(4 * A.column[at]);
    }
    rowBegin_.push_back(column_.size());
  }
  blocks_.resize(stride * column_.size() + 4);
  inverses_.resize(stride * rows + 4);
  for (auto* v : {&u_, &r_, &z_, &p_, &q_}) v->resize(4 * rows);
}

template <class S>
void ClusterPcg<S>::refresh(const UpperBlocks& A, std::vector<std::uint8_t>& changed) {
  using Eights = std::conditional_t<sizeof(S) == sizeof(float), Float8, Double8>;
  // A block belongs to the row that has it in the upper half, so that each place has one writer.
  const auto copyRow = [&](std::size_t i) {
    if (!changed[i]) return;
    changed[i] = 0;
    for (std::int32_t k = A.rowBegin[i]; k < A.rowBegin[i + 1]; ++k) {
      const std::size_t at = k;
      const Eights eight = __builtin_convertvector(scale_ * loadAs<Double8>(A.eight.data() + 8 * at), Eights);
      const Eights ninth{static_cast<S>(scale_ * A.ninth[at])};  // and zeros
      const auto store = [&](std::int32_t place, Eights firstTwo, Eights third) {
        S* to = blocks_.data() + stride * static_cast<std::size_t>(place);
        std::memcpy(to, &firstTwo, sizeof firstTwo);
        std::memcpy(to + 8, &third, sizeof third / 2);
      };
      store(mirrored_[at], __builtin_shufflevector(eight, ninth, 0, 3, 6, 9, 1, 4, 7, 9),
            __builtin_shufflevector(eight, ninth, 2, 5, 8, 9, 9, 9, 9, 9));
      store(ownPlace_[at], __builtin_shufflevector(eight, ninth, 0, 1, 2, 9, 3, 4, 5, 9),
            __builtin_shufflevector(eight, ninth, 6, 7, 8, 9, 9, 9, 9, 9));
    }
    invert(A, i);
  };
  parallelFor(0, changed.size(), threads_, copyRow, rowsOfAThread);
}

template <class S>
void ClusterPcg<S>::invert(const UpperBlocks& A, std::int32_t row) {
  const auto at = static_cast<std::size_t>(row), k = static_cast<std::size_t>(A.rowBegin[at]);
  Matrix3<double> D;
  for (int i = 0; i < 8; ++i) D.m[i] = scale_ * A.eight[8 * k + static_cast<std::size_t>(i)];
  D.m[8] = scale_ * A.ninth[k];
  const auto held = [&](int c) { return constrained_[3 * at + static_cast<std::size_t>(c)] != 0; };
  for (int c = 0; c < 3; ++c)
    if (held(c))
      for (int d = 0; d < 3; ++d) D(c, d) = D(d, c) = c == d ? 1 : 0;
  const Matrix3<double> inverted = inverse(D);
  // Zero for what is held: directions then have no such components, and residuals there count for nothing.
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r)
      inverses_[stride * at + static_cast<std::size_t>(4 * c + r)] = held(c) ? S(0) : static_cast<S>(inverted(r, c));
}

template <class S>
typename ClusterPcg<S>::Result ClusterPcg<S>::solve(const Eigen::VectorXd& right, Eigen::VectorXd& u, double tolerance,
                                                    int mostIterations) {
  using Row = typename RowSum<S>::Row;
  const std::size_t rows = order_.size();
  const auto rowOf = [](AlignedVector<S>& v, std::size_t i) -> Row& { return reinterpret_cast<Row&>(v[4 * i]); };
  const auto timesBlocks = [&](const AlignedVector<S>& v, std::size_t t) {  // row order_[t]
    return rowTimes<S>(blocks_.data(), column_.data(), rowBegin_[t], rowBegin_[t + 1], v);
  };
  const auto precondition = [&](std::size_t i, const AlignedVector<S>& r) {
    RowSum<S> sum;
    sum.add(inverses_.data() + stride * i, r.data() + 4 * i);
    return sum.value();
  };

  const double largest = right.cwiseAbs().maxCoeff();
  const double start = u.cwiseAbs().maxCoeff();
  if (!std::isfinite(largest)) return {false, 0};
  if (largest == 0) {
    u.setZero();
    return {true, 0};
  }
  // In units in which the largest component of the right-hand side is one.
  const double unit = largest * scale_;
  const bool guessed = start > 0 && std::isfinite(start);
  if (!guessed) u.setZero();
  const auto forRows = [&](const auto& visit) { parallelFor(0, rows, threads_, visit, rowsOfAThread); };
  const auto sumOfRows = [&](const auto& visit) {  // visit adds to a row and returns what is to be summed
    return total(parallelSum(rows, threads_, Row{}, [&](std::int64_t begin, std::int64_t end) {
      Row sum{};
      for (std::int64_t i = begin; i < end; ++i) sum += visit(static_cast<std::size_t>(i));
      return sum;
    }));
  };
  forRows([&](std::size_t i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Eigen::Index d = 3 * i + c;
      r_[4 * i + c] = static_cast<S>(right[d] / largest);
      p_[4 * i + c] = static_cast<S>(u[d] / unit);
    }
  });
  const auto norm = sumOfRows([&](std::size_t t) -> Row { return rowOf(r_, order_[t]) * precondition(order_[t], r_); });
  S gamma = sumOfRows([&](std::size_t t) -> Row {
    const std::size_t i = order_[t];
    Row& r = rowOf(r_, i);
    if (guessed) r -= timesBlocks(p_, t);
    const Row z = precondition(i, r_);
    rowOf(z_, i) = z;
    rowOf(u_, i) = Row{};
    return r * z;
  });
  const auto goal = static_cast<S>(tolerance * tolerance) * norm;
  S beta = 0;
  // Nothing is gained by Fierz 2013's form with one synchronisation an iteration (Chronopoulos & Gear 1989), which
  // needs one product more.
  int iteration = 0;
  for (; gamma > goal; ++iteration) {
    if (iteration == mostIterations) return {false, iteration};
    forRows([&](std::size_t i) { rowOf(p_, i) = rowOf(z_, i) + beta * rowOf(p_, i); });
    const S alpha = gamma / sumOfRows([&](std::size_t t) -> Row {
                      const Row q = timesBlocks(p_, t);
                      rowOf(q_, order_[t]) = q;
                      return q * rowOf(p_, order_[t]);
                    });
    const S before = gamma;
    gamma = sumOfRows([&](std::size_t i) -> Row {
      rowOf(u_, i) += alpha * rowOf(p_, i);
      rowOf(r_, i) -= alpha * rowOf(q_, i);
      const Row z = precondition(i, r_);
      rowOf(z_, i) = z;
      return rowOf(r_, i) * z;
    });
    beta = gamma / before;
  }
  if (!(gamma <= goal)) return {false, iteration};  // not a number
  forRows([&](std::size_t i) {
    for (std::size_t c = 0; c < 3; ++c) u[3 * i + c] += unit * static_cast<double>(u_[4 * i + c]);
  });
  return {true, iteration};
}

template <class S>
void ClusterPcg<S>::multiply(const Eigen::VectorXd& u, Eigen::VectorXd& product) {
  const double largest = u.cwiseAbs().maxCoeff(), unit = largest > 0 ? largest : 1;
  const auto forRows = [&](const auto& visit) { parallelFor(0, order_.size(), threads_, visit, rowsOfAThread); };
  forRows([&](std::size_t i) {
    for (std::size_t c = 0; c < 3; ++c) p_[4 * i + c] = static_cast<S>(u[3 * i + c] / unit);
  });
  product.resize(u.size());
  forRows([&](std::size_t t) {
    const auto row = rowTimes<S>(blocks_.data(), column_.data(), rowBegin_[t], rowBegin_[t + 1], p_);
    for (int c = 0; c < 3; ++c)
      product[3 * order_[t] + static_cast<std::size_t>(c)] = unit / scale_ * static_cast<double>(row[c]);
  });
}

template class ClusterPcg<float>;
template class ClusterPcg<double>;

}  // namespace ringwatch
