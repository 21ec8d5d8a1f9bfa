#pragma once
#include <cstdint>
#include <cstring>

#include <ringwatch/base/math.h>
#if defined(__AVX__)
#include <immintrin.h>
#endif

namespace ringwatch {

namespace detail {
// GCC refuses vector_size that depends on a template parameter, hence a table of specialisations.
template <class T, int Width>
struct VectorType;
#define RINGWATCH_VECTOR_TYPE(T, I, Width)                            \
  template <>                                                        \
  struct VectorType<T, Width> {                                      \
    typedef T Values __attribute__((vector_size(sizeof(T) * Width))); \
    typedef I Mask __attribute__((vector_size(sizeof(I) * Width)));   \
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

  RINGWATCH_INLINE friend Pack operator+(Pack a, Pack b) { return Pack(a.v + b.v); }
  RINGWATCH_INLINE friend Pack operator-(Pack a, Pack b) { return Pack(a.v - b.v); }
  RINGWATCH_INLINE friend Pack operator*(Pack a, Pack b) { return Pack(a.v * b.v); }
  RINGWATCH_INLINE friend Pack operator/(Pack a, Pack b) { return Pack(a.v / b.v); }
  RINGWATCH_INLINE friend Pack operator-(Pack a) { return Pack(-a.v); }
  RINGWATCH_INLINE Pack& operator+=(Pack b) { v += b.v; return *this; }
  RINGWATCH_INLINE Pack& operator-=(Pack b) { v -= b.v; return *this; }
  RINGWATCH_INLINE Pack& operator*=(Pack b) { v *= b.v; return *this; }
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

/// True where at least one lane of the mask is set.
template <class Mask>
  requires(sizeof(Mask) > 8)
RINGWATCH_INLINE bool anyOf(Mask mask) {
  bool any = false;
  for (unsigned i = 0; i < sizeof(Mask) / sizeof(mask[0]); ++i) any |= mask[i] != 0;
  return any;
}
template <class Mask>
  requires(sizeof(Mask) > 8)
RINGWATCH_INLINE bool allOf(Mask mask) {
  bool all = true;
  for (unsigned i = 0; i < sizeof(Mask) / sizeof(mask[0]); ++i) all &= mask[i] != 0;
  return all;
}

namespace math {
template <class T, int W>
RINGWATCH_INLINE Pack<T, W> sqrt(Pack<T, W> a) {
#if defined(__AVX512F__)
  if constexpr (W == 8 && sizeof(T) == 8) return Pack<T, W>((typename Pack<T, W>::Values)_mm512_sqrt_pd((__m512d)a.v));
#endif
#if defined(__AVX__)
  if constexpr (W == 4 && sizeof(T) == 8) return Pack<T, W>((typename Pack<T, W>::Values)_mm256_sqrt_pd((__m256d)a.v));
#endif
  Pack<T, W> r;
  for (int i = 0; i < W; ++i) r.v[i] = sqrt(a.v[i]);
  return r;
}
template <class T, int W>
RINGWATCH_INLINE Pack<T, W> log(Pack<T, W> a) {
  Pack<T, W> r;
  for (int i = 0; i < W; ++i) r.v[i] = log(a.v[i]);
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

/// Loads row `row[lane]` of a table of 4-padded rows (x, y, z, unused) for every lane and transposes: c[0] gets all x,
/// c[1] all y, c[2] all z. Loading rows and transposing is 2 to 3 times faster than gathering by lane.
template <class T, int W>
RINGWATCH_INLINE void loadRows(const T* table, const std::uint16_t* row, Pack<T, W> c[3]) {
#if defined(__AVX512F__)
  if constexpr (W == 8 && sizeof(T) == 8) {
    auto quad = [&](int o, __m256d& x, __m256d& y, __m256d& z) {
      __m256d r0 = _mm256_loadu_pd(table + 4 * row[o]), r1 = _mm256_loadu_pd(table + 4 * row[o + 1]);
      __m256d r2 = _mm256_loadu_pd(table + 4 * row[o + 2]), r3 = _mm256_loadu_pd(table + 4 * row[o + 3]);
      __m256d t0 = _mm256_unpacklo_pd(r0, r1), t1 = _mm256_unpackhi_pd(r0, r1);
      __m256d t2 = _mm256_unpacklo_pd(r2, r3), t3 = _mm256_unpackhi_pd(r2, r3);
      x = _mm256_permute2f128_pd(t0, t2, 0x20);
      y = _mm256_permute2f128_pd(t1, t3, 0x20);
      z = _mm256_permute2f128_pd(t0, t2, 0x31);
    };
    __m256d x0, y0, z0, x1, y1, z1;
    quad(0, x0, y0, z0);
    quad(4, x1, y1, z1);
    using V = typename Pack<T, W>::Values;
    c[0].v = (V)_mm512_insertf64x4(_mm512_castpd256_pd512(x0), x1, 1);
    c[1].v = (V)_mm512_insertf64x4(_mm512_castpd256_pd512(y0), y1, 1);
    c[2].v = (V)_mm512_insertf64x4(_mm512_castpd256_pd512(z0), z1, 1);
    return;
  }
#endif
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < W; ++i) c[k].v[i] = table[4 * row[i] + k];
}

/// Adds c to the rows that `loadRows` would read. Lanes are added one after the other, so lanes may share a row.
template <class T, int W>
RINGWATCH_INLINE void addRows(T* table, const std::uint16_t* row, const Pack<T, W> c[3]) {
#if defined(__AVX512F__)
  if constexpr (W == 8 && sizeof(T) == 8) {
    auto quad = [&](int o, __m256d x, __m256d y, __m256d z) {
      const __m256d zero = _mm256_setzero_pd();
      __m256d t0 = _mm256_unpacklo_pd(x, y), t1 = _mm256_unpackhi_pd(x, y);
      __m256d t2 = _mm256_unpacklo_pd(z, zero), t3 = _mm256_unpackhi_pd(z, zero);
      auto add = [&](int lane, __m256d r) {
        T* p = table + 4 * row[lane];
        _mm256_storeu_pd(p, _mm256_add_pd(_mm256_loadu_pd(p), r));
      };
      add(o, _mm256_permute2f128_pd(t0, t2, 0x20));
      add(o + 1, _mm256_permute2f128_pd(t1, t3, 0x20));
      add(o + 2, _mm256_permute2f128_pd(t0, t2, 0x31));
      add(o + 3, _mm256_permute2f128_pd(t1, t3, 0x31));
    };
    quad(0, _mm512_castpd512_pd256((__m512d)c[0].v), _mm512_castpd512_pd256((__m512d)c[1].v),
         _mm512_castpd512_pd256((__m512d)c[2].v));
    quad(4, _mm512_extractf64x4_pd((__m512d)c[0].v, 1), _mm512_extractf64x4_pd((__m512d)c[1].v, 1),
         _mm512_extractf64x4_pd((__m512d)c[2].v, 1));
    return;
  }
#endif
  for (int i = 0; i < W; ++i)
    for (int k = 0; k < 3; ++k) table[4 * row[i] + k] += c[k].v[i];
}

}  // namespace ringwatch
