#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include <ringwatch/base/math.h>
#if defined(__AVX__)
#include <immintrin.h>
#endif

namespace ringwatch {

namespace detail {
// GCC refuses vector_size that depends on a template parameter, so there is a table of specialisations.
template <class T, int Width>
struct VectorType;
#define RINGWATCH_VECTOR_TYPE(T, I, Width)                                                \
  template <>                                                                             \
  struct VectorType<T, Width> {                                                           \
    typedef T Values __attribute__((vector_size(sizeof(T) * Width)));                     \
    typedef I Mask __attribute__((vector_size(sizeof(I) * Width)));                       \
    typedef std::make_unsigned_t<I> Bits __attribute__((vector_size(sizeof(I) * Width))); \
  };
RINGWATCH_VECTOR_TYPE(double, std::int64_t, 2)
RINGWATCH_VECTOR_TYPE(double, std::int64_t, 4)
RINGWATCH_VECTOR_TYPE(double, std::int64_t, 8)
RINGWATCH_VECTOR_TYPE(float, std::int32_t, 4)
RINGWATCH_VECTOR_TYPE(float, std::int32_t, 8)
RINGWATCH_VECTOR_TYPE(float, std::int32_t, 16)
#undef RINGWATCH_VECTOR_TYPE
}  // namespace detail

/// `Width` numbers that a kernel handles at once, one lane an element. A real vector type: a loop over a small array is
/// left to the compiler's mood.
template <class T, int Width>
struct Pack {
  using Values = typename detail::VectorType<T, Width>::Values;
  using Mask = typename detail::VectorType<T, Width>::Mask;
  using Bits = typename detail::VectorType<T, Width>::Bits;
  static constexpr int width = Width;
  Values v;

  Pack() = default;
  RINGWATCH_INLINE Pack(T scalar) : v(Values{} + scalar) {}
  RINGWATCH_INLINE explicit Pack(Values values) : v(values) {}
  RINGWATCH_INLINE T operator[](int lane) const { return v[lane]; }
  RINGWATCH_INLINE void set(int lane, T value) { v[lane] = value; }

  RINGWATCH_INLINE static Pack load(const T* p) {
    Pack r;
    std::memcpy(&r.v, p, sizeof(Values));
    return r;
  }
  RINGWATCH_INLINE void store(T* p) const { std::memcpy(p, &v, sizeof(Values)); }
  template <class Archive>
  void archive(Archive& a) {
    a.bytes(&v, sizeof v);
  }

  RINGWATCH_INLINE friend Pack operator+(Pack a, Pack b) { return Pack(a.v + b.v); }
  RINGWATCH_INLINE friend Pack operator-(Pack a, Pack b) { return Pack(a.v - b.v); }
  RINGWATCH_INLINE friend Pack operator*(Pack a, Pack b) { return Pack(a.v * b.v); }
  RINGWATCH_INLINE friend Pack operator/(Pack a, Pack b) { return Pack(a.v / b.v); }
  RINGWATCH_INLINE friend Pack operator-(Pack a) { return Pack(-a.v); }
  RINGWATCH_INLINE Pack& operator+=(Pack b) {
    v += b.v;
    return *this;
  }
  RINGWATCH_INLINE Pack& operator-=(Pack b) {
    v -= b.v;
    return *this;
  }
  RINGWATCH_INLINE Pack& operator*=(Pack b) {
    v *= b.v;
    return *this;
  }
  RINGWATCH_INLINE friend Mask operator<(Pack a, Pack b) { return a.v < b.v; }
  RINGWATCH_INLINE friend Mask operator>(Pack a, Pack b) { return a.v > b.v; }
  RINGWATCH_INLINE friend Mask operator<=(Pack a, Pack b) { return a.v <= b.v; }
  RINGWATCH_INLINE friend Mask operator>=(Pack a, Pack b) { return a.v >= b.v; }
  RINGWATCH_INLINE friend Mask operator==(Pack a, Pack b) { return a.v == b.v; }
};

template <class T, int W>
RINGWATCH_INLINE Pack<T, W> select(typename Pack<T, W>::Mask mask, Pack<T, W> yes, Pack<T, W> no) {
  return Pack<T, W>(mask ? yes.v : no.v);
}

/// Whether at least one lane of the mask is set. One test of the register: lane by lane, compilers take every lane out
/// of it, some 25 instructions in each turn of an iteration.
template <class Mask>
requires(sizeof(Mask) > 8) RINGWATCH_INLINE bool anyOf(Mask mask) {
#if defined(__AVX512F__)
  if constexpr (sizeof(Mask) == 64) return _mm512_test_epi64_mask((__m512i)mask, (__m512i)mask) != 0;
#endif
#if defined(__AVX__)
  if constexpr (sizeof(Mask) == 32) return _mm256_testz_si256((__m256i)mask, (__m256i)mask) == 0;
#endif
  bool any = false;
  for (unsigned i = 0; i < sizeof(Mask) / sizeof(mask[0]); ++i) any |= mask[i] != 0;
  return any;
}
template <class Mask>
requires(sizeof(Mask) > 8) RINGWATCH_INLINE bool allOf(Mask mask) {
#if defined(__AVX512F__)
  if constexpr (sizeof(Mask) == 64) return _mm512_testn_epi32_mask((__m512i)mask, (__m512i)mask) == 0;
#endif
  return !anyOf(Mask(mask == 0));
}

namespace math {
template <class T, int W>
RINGWATCH_INLINE Pack<T, W> sqrt(Pack<T, W> a) {
#if defined(__AVX512F__)
  if constexpr (W == 8 && sizeof(T) == 8)
    return Pack<T, W>((typename Pack<T, W>::Values)_mm512_maskz_sqrt_pd(0xff, (__m512d)a.v));
#endif
#if defined(__AVX__)
  if constexpr (W == 4 && sizeof(T) == 8) return Pack<T, W>((typename Pack<T, W>::Values)_mm256_sqrt_pd((__m256d)a.v));
#endif
  Pack<T, W> r;
  for (int i = 0; i < W; ++i) r.v[i] = sqrt(a.v[i]);
  return r;
}
/// Within a unit in the last place. Through the C library, lane after lane, a force of wedges with a law of ln det F
/// takes twelve times as long.
template <int W>
RINGWATCH_INLINE Pack<double, W> log(Pack<double, W> a) {
  using P = Pack<double, W>;
  using Bits = typename P::Bits;
  constexpr double infinite = std::numeric_limits<double>::infinity(), leastNormal = 0x1p-1022;
  constexpr int raised = 54;  // powers of two, so that what is below the normal numbers is one of them
  // a = 2^k m with m from √½ to √2.
  const auto isTiny = a < P(leastNormal);
  const P normal = select(isTiny, P(0x1p54) * a, a);
  constexpr std::uint64_t bitsOfRoot = 0x3fe6a09e667f3bcd, mantissa = 0x000fffffffffffff, bias = 1024;
  Bits bits;
  std::memcpy(&bits, &normal.v, sizeof bits);
  bits -= bitsOfRoot;
  // k + bias in the last digits of a number from 2^52 on.
  const Bits digits = (((bits + (bias << 52)) >> 52) & 0xfff) | 0x4330000000000000;
  P k, m;
  std::memcpy(&k.v, &digits, sizeof digits);
  k -= P(0x1p52 + bias) + select(isTiny, P(raised), P(0.0));
  const Bits bitsOfM = (bits & mantissa) + bitsOfRoot;
  std::memcpy(&m.v, &bitsOfM, sizeof bitsOfM);
  // ln m = 2 artanh s = 2 s (1 + z p), with z = s² <= 0.0295 and p the series 1/3 + z/5 + z²/7 …, whose next term is
  // below 2^-57. 2 s = f - s f, with f exact, leaves the rounding of s to what is small.
  const P f = m - P(1.0), s = f / (m + P(1.0)), z = s * s;
  P p(1.0 / 21);
  for (int i = 19; i >= 3; i -= 2) p = p * z + P(1.0 / i);
  // The digits of ln 2 in two parts, the first of which times k is exact.
  constexpr double ln2 = 0x1.62e42feep-1, ln2Rest = 0x1.a39ef35793c76p-33;
  const P r = k * P(ln2) + (f - (s * (f - P(2.0) * z * p) - k * P(ln2Rest)));
  const P finite = select(a < P(infinite), r, a);
  return select(a > P(0.0), finite, select(a == P(0.0), P(-infinite), P(std::numeric_limits<double>::quiet_NaN())));
}
template <int W>
RINGWATCH_INLINE Pack<float, W> log(Pack<float, W> a) {
  Pack<float, W> r;
  for (int i = 0; i < W; ++i) r.v[i] = log(a.v[i]);
  return r;
}
/// Within a unit in the last place; like log, not lane after lane.
template <int W>
RINGWATCH_INLINE Pack<double, W> cbrt(Pack<double, W> a) {
  using P = Pack<double, W>;
  using Bits = typename P::Bits;
  const P size(a.v < 0 ? -a.v : a.v);
  // Away from both ends of the range.
  const auto isTiny = size<P(0x1p-1000), isHuge = size> P(0x1p1000);
  const P of = select(isTiny, P(0x1p54), select(isHuge, P(0x1p-54), P(1.0))) * size;
  // The bits of a number are about its base 2 logarithm, 2^52 times, 1023 added. A third of it, less what the straight
  // line between powers of two is above the logarithm on average, is 4 % off.
  constexpr int dropped = 20;  // of the bits, so that the others are a number below 2^52
  constexpr double unit = 1LL << (52 - dropped), third = (1023 * 2.0 / 3 - 0.033) * unit, integers = 0x1p52;
  constexpr std::uint64_t exponentOfIntegers = 0x4330000000000000, belowIntegers = 0x000fffffffffffff;
  Bits bits;
  std::memcpy(&bits, &of.v, sizeof bits);
  bits = ((bits >> dropped) & belowIntegers) | exponentOfIntegers;
  P number;
  std::memcpy(&number.v, &bits, sizeof bits);
  number = P(1.0 / 3) * (number - P(integers)) + P(integers + third);
  std::memcpy(&bits, &number.v, sizeof bits);
  bits = (bits & belowIntegers) << dropped;
  P r;
  std::memcpy(&r.v, &bits, sizeof bits);
  // Halley's iteration leaves 2/3 of an error's cube, Newton's at the end its square and the rounding of r³ alone.
  for (int i = 0; i < 2; ++i) {
    const P cube = r * r * r;
    r = r * ((cube + (of + of)) / (cube + cube + of));
  }
  const P square = r * r;
  r = r - (square * r - of) / (P(3.0) * square);
  r = select(isTiny, P(0x1p-18), select(isHuge, P(0x1p18), P(1.0))) * r;
  r = select(a < P(0.0), -r, r);
  const auto isFinite = size < P(std::numeric_limits<double>::infinity());
  return select(isFinite & (size > P(0.0)), r, a);
}
template <int W>
RINGWATCH_INLINE Pack<float, W> cbrt(Pack<float, W> a) {
  Pack<float, W> r;
  for (int i = 0; i < W; ++i) r.v[i] = cbrt(a.v[i]);
  return r;
}
template <class T, int W>
RINGWATCH_INLINE Pack<T, W> abs(Pack<T, W> a) {
  return Pack<T, W>(a.v < 0 ? -a.v : a.v);
}
template <class T, int W>
RINGWATCH_INLINE Pack<T, W> max(Pack<T, W> a, Pack<T, W> b) {
  return Pack<T, W>(a.v > b.v ? a.v : b.v);
}
template <class T, int W>
RINGWATCH_INLINE Pack<T, W> min(Pack<T, W> a, Pack<T, W> b) {
  return Pack<T, W>(a.v < b.v ? a.v : b.v);
}
}  // namespace math

/// Lanes that suit this machine's registers: 8 with AVX-512, 4 with AVX, 2 else.
#if defined(__AVX512F__)
inline constexpr int nativeWidth = 8;
#elif defined(__AVX__)
inline constexpr int nativeWidth = 4;
#else
inline constexpr int nativeWidth = 2;
#endif
using NativePack = Pack<double, nativeWidth>;

namespace detail {
typedef double Row4 __attribute__((vector_size(32)));
// Rows are written to what the caller has: GCC warns of a function that returns one where AVX is off.
RINGWATCH_INLINE void loadRow(const double* p, Row4& r) { std::memcpy(&r, p, sizeof r); }
/// Four rows (x, y, z, unused) to all x, all y, all z.
RINGWATCH_INLINE void transposeRows(const double* table, const std::uint16_t* row, Row4 c[3]) {
  Row4 r0, r1, r2, r3;
  loadRow(table + 4 * row[0], r0);
  loadRow(table + 4 * row[1], r1);
  loadRow(table + 4 * row[2], r2);
  loadRow(table + 4 * row[3], r3);
  const Row4 t0 = __builtin_shufflevector(r0, r1, 0, 4, 2, 6), t1 = __builtin_shufflevector(r0, r1, 1, 5, 3, 7);
  const Row4 t2 = __builtin_shufflevector(r2, r3, 0, 4, 2, 6), t3 = __builtin_shufflevector(r2, r3, 1, 5, 3, 7);
  c[0] = __builtin_shufflevector(t0, t2, 0, 1, 4, 5);
  c[1] = __builtin_shufflevector(t1, t3, 0, 1, 4, 5);
  c[2] = __builtin_shufflevector(t0, t2, 2, 3, 6, 7);
}
/// The reverse: adds four rows made of x, y, z, one after the other.
RINGWATCH_INLINE void addTransposed(double* table, const std::uint16_t* row, Row4 x, Row4 y, Row4 z) {
  const Row4 zero{};
  const Row4 t0 = __builtin_shufflevector(x, y, 0, 4, 2, 6), t1 = __builtin_shufflevector(x, y, 1, 5, 3, 7);
  const Row4 t2 = __builtin_shufflevector(z, zero, 0, 4, 2, 6), t3 = __builtin_shufflevector(z, zero, 1, 5, 3, 7);
  const Row4 rows[4] = {__builtin_shufflevector(t0, t2, 0, 1, 4, 5), __builtin_shufflevector(t1, t3, 0, 1, 4, 5),
                        __builtin_shufflevector(t0, t2, 2, 3, 6, 7), __builtin_shufflevector(t1, t3, 2, 3, 6, 7)};
  for (int i = 0; i < 4; ++i) {
    Row4 sum;
    loadRow(table + 4 * row[i], sum);
    sum += rows[i];
    std::memcpy(table + 4 * row[i], &sum, sizeof sum);
  }
}
}  // namespace detail

/// Loads row `row[lane]` of a table of 4-padded rows (x, y, z, unused) for every lane and transposes: c[0] gets all x,
/// c[1] all y, c[2] all z. Loading rows and transposing is 2 to 3 times faster than gathering by lane.
template <class T, int W>
RINGWATCH_INLINE void loadRows(const T* table, const std::uint16_t* row, Pack<T, W> c[3]) {
  if constexpr (sizeof(T) == 8 && W == 8) {
    detail::Row4 low[3], high[3];
    detail::transposeRows(table, row, low);
    detail::transposeRows(table, row + 4, high);
    for (int k = 0; k < 3; ++k) c[k].v = __builtin_shufflevector(low[k], high[k], 0, 1, 2, 3, 4, 5, 6, 7);
  } else if constexpr (sizeof(T) == 8 && W == 4) {
    detail::Row4 rows[3];
    detail::transposeRows(table, row, rows);
    for (int k = 0; k < 3; ++k) c[k].v = rows[k];
  } else {
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < W; ++i) c[k].v[i] = table[4 * row[i] + k];
  }
}

/// Adds c to the rows that `loadRows` would read. Lanes are added one after the other, so lanes may share a row.
template <class T, int W>
RINGWATCH_INLINE void addRows(T* table, const std::uint16_t* row, const Pack<T, W> c[3]) {
  if constexpr (sizeof(T) == 8 && W == 8) {
    auto low = [](auto v) { return __builtin_shufflevector(v, v, 0, 1, 2, 3); };
    auto high = [](auto v) { return __builtin_shufflevector(v, v, 4, 5, 6, 7); };
    detail::addTransposed(table, row, low(c[0].v), low(c[1].v), low(c[2].v));
    detail::addTransposed(table, row + 4, high(c[0].v), high(c[1].v), high(c[2].v));
  } else if constexpr (sizeof(T) == 8 && W == 4) {
    detail::addTransposed(table, row, c[0].v, c[1].v, c[2].v);
  } else {
    for (int i = 0; i < W; ++i)
      for (int k = 0; k < 3; ++k) table[4 * row[i] + k] += c[k].v[i];
  }
}

namespace detail {
/// Eight vectors of eight: element j of vector i goes to element i of vector j.
template <class V>
RINGWATCH_INLINE void transpose8(V (&v)[8]) {
  V a[8], b[8];
  for (int i = 0; i < 8; i += 2) {
    a[i] = __builtin_shufflevector(v[i], v[i + 1], 0, 8, 2, 10, 4, 12, 6, 14);
    a[i + 1] = __builtin_shufflevector(v[i], v[i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  }
  for (int i = 0; i < 8; i += 4)
    for (int k = 0; k < 2; ++k) {
      b[i + k] = __builtin_shufflevector(a[i + k], a[i + k + 2], 0, 1, 8, 9, 4, 5, 12, 13);
      b[i + k + 2] = __builtin_shufflevector(a[i + k], a[i + k + 2], 2, 3, 10, 11, 6, 7, 14, 15);
    }
  for (int k = 0; k < 4; ++k) {
    v[k] = __builtin_shufflevector(b[k], b[k + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    v[k + 4] = __builtin_shufflevector(b[k], b[k + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  }
}
}  // namespace detail

/// Adds a 3×3 block of each lane, row r and column c in block[r * stride + c], to block `place[lane]` of two tables:
/// the first eight entries, column by column, to `eight`, the last to `ninth`. Where the place is negative, the
/// transpose to ~place. Lanes are added one after the other, so lanes may share a place. `eight` is aligned to 64
/// bytes.
template <class T, int W>
RINGWATCH_INLINE void addBlocks(T* eight, T* ninth, const std::int32_t* place, const Pack<T, W>* block, int stride) {
  if constexpr (sizeof(T) == 8 && W == 8) {
    using Values = typename Pack<T, W>::Values;
    typename Pack<T, W>::Mask flipped;
    std::int32_t at[W];
    for (int lane = 0; lane < W; ++lane) {
      flipped[lane] = place[lane] < 0 ? -1 : 0;
      at[lane] = place[lane] ^ (place[lane] >> 31);
    }
    Values v[8];
    for (int c = 0; c < 3; ++c)
      for (int r = 0; r < 3 && r + 3 * c < 8; ++r)
        v[r + 3 * c] = flipped ? block[c * stride + r].v : block[r * stride + c].v;
    const Values last = block[2 * stride + 2].v;
    detail::transpose8(v);
    for (int lane = 0; lane < W; ++lane) {
      Values sum;
      std::memcpy(&sum, eight + 8 * static_cast<std::ptrdiff_t>(at[lane]), sizeof sum);
      sum += v[lane];
      std::memcpy(eight + 8 * static_cast<std::ptrdiff_t>(at[lane]), &sum, sizeof sum);
    }
    for (int lane = 0; lane < W; ++lane) ninth[at[lane]] += last[lane];
  } else {
    for (int lane = 0; lane < W; ++lane) {
      const bool flipped = place[lane] < 0;
      const std::ptrdiff_t at = flipped ? ~place[lane] : place[lane];
      for (int i = 0; i < 8; ++i)
        eight[8 * at + i] += block[flipped ? i / 3 * stride + i % 3 : i % 3 * stride + i / 3][lane];
      ninth[at] += block[2 * stride + 2][lane];
    }
  }
}

/// The reverse for one list of blocks of nine numbers, column by column: block `place[lane]` of each lane, entry (r, c)
/// of all of them to block[r * stride + c].
template <class T, int W>
RINGWATCH_INLINE void loadBlocks(const T* blocks, const std::int32_t* place, Pack<T, W>* block, int stride) {
  if constexpr (sizeof(T) == 8 && W == 8) {
    typename Pack<T, W>::Values v[8], last;
    for (int lane = 0; lane < W; ++lane) {
      const T* from = blocks + 9 * static_cast<std::ptrdiff_t>(place[lane]);
      std::memcpy(&v[lane], from, sizeof v[lane]);
      last[lane] = from[8];
    }
    detail::transpose8(v);
    for (int i = 0; i < 8; ++i) block[i % 3 * stride + i / 3].v = v[i];
    block[2 * stride + 2].v = last;
  } else {
    for (int lane = 0; lane < W; ++lane)
      for (int i = 0; i < 9; ++i)
        block[i % 3 * stride + i / 3].set(lane, blocks[9 * static_cast<std::ptrdiff_t>(place[lane]) + i]);
  }
}

/// Writes a 3×3 block, column by column, eight entries and the last, to position `upper` of a list of such blocks, and
/// its transpose to `lower`; of the same place stays what `upper` has.
template <class T>
RINGWATCH_INLINE void storeBlock(T* blocks, std::ptrdiff_t upper, std::ptrdiff_t lower, const T* eight, T ninth) {
  T* to = blocks + 9 * lower;
  for (int i = 0; i < 8; ++i) to[i] = eight[i % 3 * 3 + i / 3];
  to[8] = ninth;
  to = blocks + 9 * upper;
  for (int i = 0; i < 8; ++i) to[i] = eight[i];
  to[8] = ninth;
}

}  // namespace ringwatch
