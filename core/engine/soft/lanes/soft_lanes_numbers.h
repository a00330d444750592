#pragma once

// Numbers of eight lanes for the passes; included once for each variant (soft_lanes_passes.h).
#ifdef __AVX__
#include <immintrin.h>
#endif

#include "core/engine/soft/lanes/soft_lanes.h"

namespace rubble::RUBBLE_LANE_VARIANT {

namespace {

/// Half of the lanes.
using Quad = double __attribute__((vector_size(32)));
using KeptQuad = float __attribute__((vector_size(16)));
/// All lanes in single precision.
using KeptRow = float __attribute__((vector_size(32)));

inline Quad wide(KeptQuad x) {
#ifdef __AVX__
    return _mm256_cvtps_pd(x);  // the compiler's own conversion goes through the stack
#else
    return __builtin_convertvector(x, Quad);
#endif
}
inline KeptQuad kept(Quad x) {
#ifdef __AVX__
    return _mm256_cvtpd_ps(x);
#else
    return __builtin_convertvector(x, KeptQuad);
#endif
}
inline Quad root(Quad a) {
#ifdef __AVX__
    return _mm256_sqrt_pd(a);
#else
    return Quad{__builtin_sqrt(a[0]), __builtin_sqrt(a[1]), __builtin_sqrt(a[2]), __builtin_sqrt(a[3])};
#endif
}

// a b + c and c - a b with one rounding: every variant has them, those for every processor one number at a time.
inline Quad plusProduct(Quad c, Quad a, Quad b) {
#ifdef __FMA__
    return _mm256_fmadd_pd(a, b, c);
#else
    return Quad{__builtin_fma(a[0], b[0], c[0]), __builtin_fma(a[1], b[1], c[1]), __builtin_fma(a[2], b[2], c[2]),
                __builtin_fma(a[3], b[3], c[3])};
#endif
}
inline Quad minusProduct(Quad c, Quad a, Quad b) {
#ifdef __FMA__
    return _mm256_fnmadd_pd(a, b, c);
#else
    return plusProduct(c, -a, b);
#endif
}
inline KeptRow plusProduct(KeptRow c, KeptRow a, KeptRow b) {
#ifdef __FMA__
    return _mm256_fmadd_ps(a, b, c);
#else
    KeptRow sum;
    for (int i = 0; i < solverLanes; ++i) {
        sum[i] = __builtin_fmaf(a[i], b[i], c[i]);
    }
    return sum;
#endif
}
inline KeptRow minusProduct(KeptRow c, KeptRow a, KeptRow b) {
#ifdef __FMA__
    return _mm256_fnmadd_ps(a, b, c);
#else
    return plusProduct(c, -a, b);
#endif
}

// All lanes: one register where the processor has it, else two halves that keep each other's waits filled.
#ifdef __AVX512F__
using Row = double __attribute__((vector_size(64)));
using Mask = std::int64_t __attribute__((vector_size(64)));

inline Row all(double x) {
    return _mm512_set1_pd(x);
}
inline Row joined(Quad low, Quad high) {
    return _mm512_insertf64x4(_mm512_castpd256_pd512(low), high, 1);
}
inline Quad lowHalf(Row a) {
    return _mm512_castpd512_pd256(a);
}
inline Quad highHalf(Row a) {
    return _mm512_extractf64x4_pd(a, 1);
}
inline Row choose(Mask m, Row a, Row b) {
    return m ? a : b;
}
inline Row root(Row a) {
    return _mm512_sqrt_pd(a);
}
inline Row plusProduct(Row c, Row a, Row b) {
    return _mm512_fmadd_pd(a, b, c);
}
inline Row minusProduct(Row c, Row a, Row b) {
    return _mm512_fnmadd_pd(a, b, c);
}
inline Row wide(KeptRow x) {
    return _mm512_cvtps_pd(x);
}
inline KeptRow kept(Row x) {
    return _mm512_cvtpd_ps(x);
}
inline bool anyAbove(Row a, Row b) {
    return _mm512_cmp_pd_mask(a, b, _CMP_GT_OQ) != 0;
}
#else
struct Row {
    Quad low, high;
};
struct Mask {
    std::int64_t __attribute__((vector_size(32))) low, high;
};

inline Row all(double x) {
    return {Quad{x, x, x, x}, Quad{x, x, x, x}};
}
inline Row joined(Quad low, Quad high) {
    return {low, high};
}
inline Quad lowHalf(Row a) {
    return a.low;
}
inline Quad highHalf(Row a) {
    return a.high;
}
inline Row operator+(Row a, Row b) {
    return {a.low + b.low, a.high + b.high};
}
inline Row operator-(Row a, Row b) {
    return {a.low - b.low, a.high - b.high};
}
inline Row operator*(Row a, Row b) {
    return {a.low * b.low, a.high * b.high};
}
inline Row operator/(Row a, Row b) {
    return {a.low / b.low, a.high / b.high};
}
inline Mask operator>(Row a, Row b) {
    return {a.low > b.low, a.high > b.high};
}
inline Row choose(Mask m, Row a, Row b) {
    return {m.low ? a.low : b.low, m.high ? a.high : b.high};
}
inline Row root(Row a) {
    return {root(a.low), root(a.high)};
}
inline Row plusProduct(Row c, Row a, Row b) {
    return {plusProduct(c.low, a.low, b.low), plusProduct(c.high, a.high, b.high)};
}
inline Row minusProduct(Row c, Row a, Row b) {
    return {minusProduct(c.low, a.low, b.low), minusProduct(c.high, a.high, b.high)};
}
inline Row wide(KeptRow x) {
    return {wide(__builtin_shufflevector(x, x, 0, 1, 2, 3)), wide(__builtin_shufflevector(x, x, 4, 5, 6, 7))};
}
inline KeptRow kept(Row x) {
    return __builtin_shufflevector(kept(x.low), kept(x.high), 0, 1, 2, 3, 4, 5, 6, 7);
}
inline bool anyAbove(Row a, Row b) {
    const auto above = a > b;
    const auto both = above.low | above.high;
    return (both[0] | both[1] | both[2] | both[3]) != 0;
}
#endif

inline Row get(const Lanes& x) {
    Row row;
    __builtin_memcpy(&row, &x, sizeof row);
    return row;
}
inline void put(Lanes& to, Row x) {
    __builtin_memcpy(&to, &x, sizeof x);
}
inline Lanes lanesOf(Row x) {
    Lanes lanes;
    put(lanes, x);
    return lanes;
}
inline KeptRow get(const KeptLanes& x) {
    KeptRow row;
    __builtin_memcpy(&row, &x, sizeof row);
    return row;
}
inline void put(KeptLanes& to, KeptRow x) {
    __builtin_memcpy(&to, &x, sizeof x);
}
inline Row wide(const KeptLanes& x) {
    return wide(get(x));
}
inline KeptRow allKept(float x) {
    return KeptRow{x, x, x, x, x, x, x, x};
}
inline Row larger(Row a, Row b) {
    return choose(a > b, a, b);
}
inline Row smaller(Row a, Row b) {
    return choose(b > a, a, b);
}
inline KeptRow larger(KeptRow a, KeptRow b) {
    return a > b ? a : b;
}

/// A vector of each lane, in either precision.
template <class R>
struct Vector {
    R x, y, z;
};
using RowVector = Vector<Row>;
using KeptRowVector = Vector<KeptRow>;
/// Symmetric.
struct RowTensor {
    Row xx, yy, zz, xy, xz, yz;
};

inline RowVector wide(const KeptLaneVector& v) {
    return {wide(v.x), wide(v.y), wide(v.z)};
}
inline RowTensor wide(const KeptLaneTensor& t) {
    return {wide(t.xx), wide(t.yy), wide(t.zz), wide(t.xy), wide(t.xz), wide(t.yz)};
}
inline RowVector get(const LaneVector& v) {
    return {get(v.x), get(v.y), get(v.z)};
}
inline KeptRowVector get(const KeptLaneVector& v) {
    return {get(v.x), get(v.y), get(v.z)};
}
inline void put(LaneVector& to, const RowVector& v) {
    put(to.x, v.x);
    put(to.y, v.y);
    put(to.z, v.z);
}
inline void put(KeptLaneVector& to, const RowVector& v) {
    put(to.x, kept(v.x));
    put(to.y, kept(v.y));
    put(to.z, kept(v.z));
}

template <class R>
inline Vector<R> operator+(const Vector<R>& a, const Vector<R>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class R>
inline Vector<R> operator-(const Vector<R>& a, const Vector<R>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class R>
inline Vector<R> operator*(R s, const Vector<R>& a) {
    return {s * a.x, s * a.y, s * a.z};
}
template <class R>
inline Vector<R> plusProduct(const Vector<R>& c, R a, const Vector<R>& b) {
    return {plusProduct(c.x, a, b.x), plusProduct(c.y, a, b.y), plusProduct(c.z, a, b.z)};
}
template <class R>
inline Vector<R> minusProduct(const Vector<R>& c, R a, const Vector<R>& b) {
    return {minusProduct(c.x, a, b.x), minusProduct(c.y, a, b.y), minusProduct(c.z, a, b.z)};
}
template <class R>
inline R dot(const Vector<R>& a, const Vector<R>& b) {
    return plusProduct(plusProduct(a.x * b.x, a.y, b.y), a.z, b.z);
}
/// c + a . b
template <class R>
inline R plusDot(R c, const Vector<R>& a, const Vector<R>& b) {
    return plusProduct(plusProduct(plusProduct(c, a.x, b.x), a.y, b.y), a.z, b.z);
}
template <class R>
inline R minusDot(R c, const Vector<R>& a, const Vector<R>& b) {
    return minusProduct(minusProduct(minusProduct(c, a.x, b.x), a.y, b.y), a.z, b.z);
}
inline RowVector cross(const RowVector& a, const RowVector& b) {
    return {minusProduct(a.y * b.z, a.z, b.y), minusProduct(a.z * b.x, a.x, b.z), minusProduct(a.x * b.y, a.y, b.x)};
}
/// c + a x b
inline RowVector plusCross(const RowVector& c, const RowVector& a, const RowVector& b) {
    return {minusProduct(plusProduct(c.x, a.y, b.z), a.z, b.y), minusProduct(plusProduct(c.y, a.z, b.x), a.x, b.z),
            minusProduct(plusProduct(c.z, a.x, b.y), a.y, b.x)};
}
inline RowVector minusCross(const RowVector& c, const RowVector& a, const RowVector& b) {
    return plusCross(c, b, a);
}
inline RowVector operator*(const RowTensor& t, const RowVector& v) {
    return {dot<Row>({t.xx, t.xy, t.xz}, v), dot<Row>({t.xy, t.yy, t.yz}, v), dot<Row>({t.xz, t.yz, t.zz}, v)};
}
/// c + t v
inline RowVector plusProduct(const RowVector& c, const RowTensor& t, const RowVector& v) {
    return {plusDot<Row>(c.x, {t.xx, t.xy, t.xz}, v), plusDot<Row>(c.y, {t.xy, t.yy, t.yz}, v),
            plusDot<Row>(c.z, {t.xz, t.yz, t.zz}, v)};
}
inline RowVector minusProduct(const RowVector& c, const RowTensor& t, const RowVector& v) {
    return {minusDot<Row>(c.x, {t.xx, t.xy, t.xz}, v), minusDot<Row>(c.y, {t.xy, t.yy, t.yz}, v),
            minusDot<Row>(c.z, {t.xz, t.yz, t.zz}, v)};
}

}  // namespace

}  // namespace rubble::RUBBLE_LANE_VARIANT
