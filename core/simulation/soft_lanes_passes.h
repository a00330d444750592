#pragma once

// The passes themselves; included once for each make, with RUBBLE_LANE_MAKE as the name of its namespace. Nothing with external
// linkage may be used here: the linker would keep one of the versions, made for the wrong processor.
#ifdef __AVX__
#include <immintrin.h>
#endif

#include "core/simulation/soft_lanes.h"

namespace rubble::RUBBLE_LANE_MAKE {

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

// a b + c and c - a b with one rounding: every make has them, those for every processor one number at a time.
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

/// Rows to columns and back, in each half.
inline void transpose(Quad (&r)[4]) {
    const Quad a0 = __builtin_shufflevector(r[0], r[1], 0, 4, 2, 6);
    const Quad a1 = __builtin_shufflevector(r[0], r[1], 1, 5, 3, 7);
    const Quad a2 = __builtin_shufflevector(r[2], r[3], 0, 4, 2, 6);
    const Quad a3 = __builtin_shufflevector(r[2], r[3], 1, 5, 3, 7);
    r[0] = __builtin_shufflevector(a0, a2, 0, 1, 4, 5);
    r[1] = __builtin_shufflevector(a1, a3, 0, 1, 4, 5);
    r[2] = __builtin_shufflevector(a0, a2, 2, 3, 6, 7);
    r[3] = __builtin_shufflevector(a1, a3, 2, 3, 6, 7);
}
inline void transpose(Row (&r)[4]) {
#ifdef __AVX512F__
    const Row a0 = _mm512_unpacklo_pd(r[0], r[1]), a1 = _mm512_unpackhi_pd(r[0], r[1]);
    const Row a2 = _mm512_unpacklo_pd(r[2], r[3]), a3 = _mm512_unpackhi_pd(r[2], r[3]);
    r[0] = _mm512_mask_permutex_pd(a0, 0xcc, a2, 0x44);
    r[1] = _mm512_mask_permutex_pd(a1, 0xcc, a3, 0x44);
    r[2] = _mm512_mask_permutex_pd(a2, 0x33, a0, 0xee);
    r[3] = _mm512_mask_permutex_pd(a3, 0x33, a1, 0xee);
#else
    Quad low[4] = {r[0].low, r[1].low, r[2].low, r[3].low};
    Quad high[4] = {r[0].high, r[1].high, r[2].high, r[3].high};
    transpose(low);
    transpose(high);
    for (int i = 0; i < 4; ++i) {
        r[i] = {low[i], high[i]};
    }
#endif
}
inline void transpose(KeptRow (&r)[4]) {
    const KeptRow a0 = __builtin_shufflevector(r[0], r[1], 0, 8, 1, 9, 4, 12, 5, 13);
    const KeptRow a1 = __builtin_shufflevector(r[0], r[1], 2, 10, 3, 11, 6, 14, 7, 15);
    const KeptRow a2 = __builtin_shufflevector(r[2], r[3], 0, 8, 1, 9, 4, 12, 5, 13);
    const KeptRow a3 = __builtin_shufflevector(r[2], r[3], 2, 10, 3, 11, 6, 14, 7, 15);
    r[0] = __builtin_shufflevector(a0, a2, 0, 1, 8, 9, 4, 5, 12, 13);
    r[1] = __builtin_shufflevector(a0, a2, 2, 3, 10, 11, 6, 7, 14, 15);
    r[2] = __builtin_shufflevector(a1, a3, 0, 1, 8, 9, 4, 5, 12, 13);
    r[3] = __builtin_shufflevector(a1, a3, 2, 3, 10, 11, 6, 7, 14, 15);
}

inline Quad four(const double (&numbers)[4]) {
    Quad quad;
    __builtin_memcpy(&quad, numbers, sizeof quad);
    return quad;
}
inline KeptQuad four(const float (&numbers)[4]) {
    KeptQuad quad;
    __builtin_memcpy(&quad, numbers, sizeof quad);
    return quad;
}
inline KeptRow joined(KeptQuad low, KeptQuad high) {
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}
inline KeptQuad lowHalf(KeptRow a) {
    return __builtin_shufflevector(a, a, 0, 1, 2, 3);
}
inline KeptQuad highHalf(KeptRow a) {
    return __builtin_shufflevector(a, a, 4, 5, 6, 7);
}

/// Four numbers of each lane's record.
template <class Record, class Number, class R>
inline void gather(const Record* records, Number (Record::*member)[4], const std::uint32_t (&which)[solverLanes], R (&columns)[4]) {
    constexpr int half = solverLanes / 2;
    for (int i = 0; i < half; ++i) {
        columns[i] = joined(four(records[which[i]].*member), four(records[which[half + i]].*member));
    }
    transpose(columns);
}
/// Back into those of the bodies below `movable`: threads may share an immovable one, so nothing is written to it.
template <class Record, class Number, class R>
inline void scatter(R (&columns)[4], Record* records, Number (Record::*member)[4], const std::uint32_t (&which)[solverLanes],
                    bool allMove, std::uint32_t movable) {
    constexpr int half = solverLanes / 2;
    transpose(columns);
    for (int i = 0; i < half; ++i) {
        const auto low = lowHalf(columns[i]);
        const auto high = highHalf(columns[i]);
        if (allMove || which[i] < movable) {
            __builtin_memcpy(records[which[i]].*member, &low, sizeof low);
        }
        if (allMove || which[half + i] < movable) {
            __builtin_memcpy(records[which[half + i]].*member, &high, sizeof high);
        }
    }
}

/// By how much more than it asks for a contact is brought apart in each pass: what others take back is made up for ahead. Lower:
/// more passes; higher: they swing.
constexpr float overRelaxation = 1.3f;
/// Contacts ahead of the one at hand whose bodies are asked for: they lie anywhere, and the passes wait for little else.
constexpr std::size_t asked = 2;

/// Asks for the records of the bodies of a contact.
template <class Record, class Contacts>
inline void ask(const Record* records, const Contacts* contacts, std::size_t contact, std::size_t last) {
    if (contact < last) {
        for (int i = 0; i < solverLanes; ++i) {
            __builtin_prefetch(&records[contacts[contact].a[i]], 1);
            __builtin_prefetch(&records[contacts[contact].b[i]], 1);
        }
    }
}

/// The bodies at one end of the contacts.
struct End {
    RowVector velocity, spin;
    Row touched;
};

inline End load(const LaneBody* bodies, const std::uint32_t (&which)[solverLanes]) {
    Row v[4], w[4];
    gather(bodies, &LaneBody::velocity, which, v);
    gather(bodies, &LaneBody::spin, which, w);
    return {{v[0], v[1], v[2]}, {w[0], w[1], w[2]}, v[3]};
}

/// @param allMove  none of the bodies is immovable
inline void store(const End& end, LaneBody* bodies, const std::uint32_t (&which)[solverLanes], bool allMove,
                  std::uint32_t movable) {
    Row v[4] = {end.velocity.x, end.velocity.y, end.velocity.z, end.touched};
    Row w[4] = {end.spin.x, end.spin.y, end.spin.z, all(0.0)};
    scatter(v, bodies, &LaneBody::velocity, which, allMove, movable);
    scatter(w, bodies, &LaneBody::spin, which, allMove, movable);
}
inline void store(const End& a, const End& b, const LaneScene& scene, const LaneContacts& c) {
    if (c.allMove) {
        store(a, scene.bodies, c.a, true, 0);
        store(b, scene.bodies, c.b, true, 0);
    } else {
        store(a, scene.bodies, c.a, false, scene.movable);
        store(b, scene.bodies, c.b, false, scene.movable);
    }
}

/// The arms of a point.
struct Arms {
    explicit Arms(const LanePoint& p) : a(wide(p.fromA)), b(wide(p.fromB)) {}
    RowVector a, b;
};

/// Directions and masses of contacts.
struct Pair {
    explicit Pair(const LaneContacts& c)
        : normal(wide(c.normal)),
          tangent{wide(c.tangent), cross(normal, tangent[0])},
          inverseMassA(get(c.inverseMassA)),
          inverseMassB(get(c.inverseMassB)),
          inverseInertiaA(wide(c.inverseInertiaA)),
          inverseInertiaB(wide(c.inverseInertiaB)),
          friction(wide(c.friction)) {}
    RowVector normal, tangent[2];
    Row inverseMassA, inverseMassB;
    RowTensor inverseInertiaA, inverseInertiaB;
    Row friction;
};

inline RowVector relativeVelocity(const End& a, const End& b, const Arms& arms) {
    return minusCross(plusCross(b.velocity - a.velocity, b.spin, arms.b), a.spin, arms.a);
}

inline void apply(const Pair& c, End& a, End& b, const Arms& arms, const RowVector& impulse) {
    a.velocity = minusProduct(a.velocity, c.inverseMassA, impulse);
    a.spin = minusProduct(a.spin, c.inverseInertiaA, cross(arms.a, impulse));
    b.velocity = plusProduct(b.velocity, c.inverseMassB, impulse);
    b.spin = plusProduct(b.spin, c.inverseInertiaB, cross(arms.b, impulse));
}

inline RowVector impulseOf(const Pair& c, const LanePoint& p) {
    return plusProduct(plusProduct(wide(p.normalImpulse) * c.normal, wide(p.tangentImpulse[0]), c.tangent[0]),
                       wide(p.tangentImpulse[1]), c.tangent[1]);
}

/// Keeps an impulse; returns by how much it has changed.
inline Row keep(KeptLanes& impulse, Row total) {
    const KeptRow rounded = kept(total);
    const Row before = wide(impulse);
    put(impulse, rounded);
    return total - before;
}

inline void applyFriction(const Pair& c, End& a, End& b, LanePoint& p) {
    const Arms arms(p);
    const RowVector relative = relativeVelocity(a, b, arms);
    const Row t0 = minusProduct(wide(p.tangentImpulse[0]), wide(p.tangentMass[0]), dot(c.tangent[0], relative));
    const Row t1 = minusProduct(wide(p.tangentImpulse[1]), wide(p.tangentMass[1]), dot(c.tangent[1], relative));
    const Row limit = c.friction * wide(p.normalImpulse);
    const Row length = plusProduct(t0 * t0, t1, t1);
    const Mask beyond = length > limit * limit;
    const Row scale = choose(beyond, limit / root(choose(beyond, length, all(1.0))), all(1.0));
    const Row change0 = keep(p.tangentImpulse[0], t0 * scale);
    const Row change1 = keep(p.tangentImpulse[1], t1 * scale);
    apply(c, a, b, arms, plusProduct(change0 * c.tangent[0], change1, c.tangent[1]));
}

/// One pass over the points of contacts. Push: overlap is pushed apart at `push` [m/s] at most. Moved: the bodies have moved since
/// the pass before. Last: the last pass of the substep.
template <bool Push, bool Moved, bool Last>
inline void solve(const LaneScene& scene, std::size_t contact, double push) {
    const LaneContacts& c = scene.contacts[contact];
    const LaneTally& tally = scene.tallies[contact];
    End a = load(scene.bodies, c.a);
    End b = load(scene.bodies, c.b);
    LanePoint* points = scene.points + c.firstPoint;
    LanePointTally* tallies = scene.pointTallies + c.firstPoint;
    const Pair pair(c);
    const Row zero = all(0.0);
    const Row perSubstep = all(1.0 / scene.h);
    RowVector moved{}, turnedA{}, turnedB{};
    if (Moved) {
        Row ma[4], mb[4], ta[4], tb[4];
        gather(scene.travel, &LaneTravel::moved, c.a, ma);
        gather(scene.travel, &LaneTravel::moved, c.b, mb);
        gather(scene.travel, &LaneTravel::turned, c.a, ta);
        gather(scene.travel, &LaneTravel::turned, c.b, tb);
        moved = RowVector{mb[0], mb[1], mb[2]} - RowVector{ma[0], ma[1], ma[2]};
        turnedA = {ta[0], ta[1], ta[2]};
        turnedB = {tb[0], tb[1], tb[2]};
    }
    Row carried = zero, acted = zero;
    for (std::uint32_t k = 0; k < c.points; ++k) {
        LanePoint& p = points[k];
        const Arms arms(p);
        Row now;
        if (Moved) {
            now = plusDot(wide(tallies[k].separation), pair.normal, minusCross(plusCross(moved, turnedB, arms.b), turnedA, arms.a));
            put(p.now, kept(now));
        } else {
            now = wide(p.now);
        }
        const Row mass = wide(p.normalMass);
        const Row before = wide(p.normalImpulse);
        const Mask apart = now > zero;
        const Row ahead = now * perSubstep;
        const Row speed = dot(pair.normal, relativeVelocity(a, b, arms));
        Row wanted;
        if (Push) {
            const Row bias = choose(apart, ahead, larger(wide(tally.biasRate) * now, all(-push)));
            const Row massScale = choose(apart, all(1.0), wide(tally.massScale));
            const Row impulseScale = choose(apart, zero, wide(tally.impulseScale));
            wanted = minusProduct(minusProduct(before, mass * massScale, speed + bias), impulseScale, before);
        } else {
            wanted = minusProduct(before, mass, speed + choose(apart, ahead, zero));
        }
        const Row total = smaller(larger(wanted, zero), wide(c.impulseLimit));
        const Row change = keep(p.normalImpulse, total);
        carried = larger(carried, before);
        acted = larger(acted, total);
        apply(pair, a, b, arms, change * pair.normal);
    }
    if (!anyAbove(larger(carried, acted), zero)) {
        // Without load there is no friction either, and nothing has changed.
        for (std::uint32_t k = 0; Push && c.booked && k < c.points; ++k) {
            put(scene.works[c.firstPoint + k].raised, zero);
        }
        return;
    }
    acted = choose(acted > zero, all(1.0), zero);
    for (std::uint32_t k = 0; k < c.points; ++k) {
        applyFriction(pair, a, b, points[k]);
        if (Push && c.booked) {
            put(scene.works[c.firstPoint + k].raised, impulseOf(pair, points[k]).z);
        }
        if (Push || Last) {
            put(tallies[k].largestImpulse, larger(get(tallies[k].largestImpulse), get(points[k].normalImpulse)));
        }
        if (Last) {
            put(tallies[k].impulseSum, get(tallies[k].impulseSum) + wide(points[k].normalImpulse));
        }
    }
    a.touched = larger(a.touched, acted);
    b.touched = larger(b.touched, acted);
    store(a, b, scene, c);
}

/// kg that a push at a point along a direction moves, where there is one.
inline Row massAlong(const Pair& c, const Arms& arms, const RowVector& direction, Row present) {
    const RowVector a = cross(arms.a, direction), b = cross(arms.b, direction);
    const Row inverse = plusDot(plusDot(c.inverseMassA + c.inverseMassB, a, c.inverseInertiaA * a), b, c.inverseInertiaB * b);
    const Mask moves = inverse > all(0.0);
    return choose(moves, present / choose(moves, inverse, all(1.0)), all(0.0));
}

void prepare(const LaneScene& scene, std::size_t first, std::size_t last) {
    const Row zero = all(0.0), one = all(1.0);
    for (std::size_t i = first; i < last; ++i) {
        const LaneContacts& c = scene.contacts[i];
        LaneTally& tally = scene.tallies[i];
        const End a = load(scene.bodies, c.a);
        const End b = load(scene.bodies, c.b);
        const Pair pair(c);
        constexpr double turn = 2.0 * 3.14159265358979323846;
        const Row soft = all(turn) * wide(tally.frequency);
        const Row sink = wide(tally.sinkAllowed);
        Row squared = soft * soft, fastest = zero;
        for (std::uint32_t k = 0; k < c.points; ++k) {
            LanePoint& p = scene.points[c.firstPoint + k];
            const Arms arms(p);
            const Row present = wide(p.normalMass);
            const Row mass = massAlong(pair, arms, pair.normal, present);
            put(p.normalMass, kept(mass));
            put(p.tangentMass[0], kept(massAlong(pair, arms, pair.tangent[0], present)));
            put(p.tangentMass[1], kept(massAlong(pair, arms, pair.tangent[1], present)));
            const Row approach = zero - present * dot(pair.normal, relativeVelocity(a, b, arms));
            put(scene.pointTallies[c.firstPoint + k].approach, kept(approach));
            fastest = larger(fastest, approach);
            // At rest a contact sinks by load / (mass omega^2).
            const Row carried = mass * sink;
            const Row load = wide(p.normalImpulse) * all(1.0 / scene.h);
            squared = larger(squared, choose(carried > zero, load / choose(carried > zero, carried, one), zero));
        }
        put(tally.fastest, kept(fastest));
        // Stiffness as rates for one substep (Catto 2024, Solver2D).
        const Row omega = smaller(root(squared), all(stiffestContact / scene.h));
        const Row a1 = plusProduct(all(2.0 * contactDamping), all(scene.h), omega);
        const Row a2 = all(scene.h) * omega * a1;
        const Row a3 = one / (one + a2);
        put(tally.biasRate, kept(omega / a1));
        put(tally.massScale, kept(a2 * a3));
        put(tally.impulseScale, kept(a3));
    }
}

void warmStart(const LaneScene& scene, std::size_t first, std::size_t last, double growth) {
    for (std::size_t i = first; i < last; ++i) {
        const LaneContacts& c = scene.contacts[i];
        LanePoint* points = scene.points + c.firstPoint;
        const Row weight = wide(scene.tallies[i].weight);
        Row largest = all(0.0);
        for (std::uint32_t k = 0; k < c.points; ++k) {
            LanePoint& p = points[k];
            LanePointTally& tally = scene.pointTallies[c.firstPoint + k];
            const Row impulse = wide(p.normalImpulse);
            const Row most = all(growth) * larger(wide(tally.before), weight);
            put(tally.before, get(p.normalImpulse));
            const Mask over = impulse > most;
            // Friction that has lost its load is none, whatever the contacts beside this one carry.
            const Row loaded = choose(impulse > all(0.0), all(1.0), all(0.0));
            const Row scale = choose(over, most / choose(over, impulse, all(1.0)), loaded);
            put(p.tangentImpulse[0], kept(wide(p.tangentImpulse[0]) * scale));
            put(p.tangentImpulse[1], kept(wide(p.tangentImpulse[1]) * scale));
            const Row carried = choose(over, most, impulse);
            put(p.normalImpulse, kept(carried));
            largest = larger(largest, carried);
        }
        if (!anyAbove(largest, all(0.0))) {
            continue;
        }
        const Pair pair(c);
        End a = load(scene.bodies, c.a);
        End b = load(scene.bodies, c.b);
        for (std::uint32_t k = 0; k < c.points; ++k) {
            apply(pair, a, b, Arms(points[k]), impulseOf(pair, points[k]));
        }
        store(a, b, scene, c);
    }
}

void soft(const LaneScene& scene, std::size_t first, std::size_t last, double push) {
    for (std::size_t i = first; i < last; ++i) {
        solve<true, false, false>(scene, i, push);
    }
}

void relax(const LaneScene& scene, std::size_t first, std::size_t last, bool moved, bool final) {
    for (std::size_t i = first; i < last; ++i) {
        if (moved) {
            solve<false, true, false>(scene, i, 0.0);
        } else if (final) {
            solve<false, false, true>(scene, i, 0.0);
        } else {
            solve<false, false, false>(scene, i, 0.0);
        }
    }
}

struct RowQuaternion {
    RowVector v;
    Row w;
};

inline RowQuaternion operator*(const RowQuaternion& a, const RowQuaternion& b) {
    return {plusProduct(plusProduct(cross(a.v, b.v), a.w, b.v), b.w, a.v), minusDot(a.w * b.w, a.v, b.v)};
}

/// Turned by a spin [rad/s] for a time [s].
inline RowQuaternion turnedBy(const RowQuaternion& q, const RowVector& spin, double time) {
    const RowQuaternion turned = RowQuaternion{all(0.5 * time) * spin, all(1.0)} * q;
    const Row scale = all(1.0) / root(plusDot(turned.w * turned.w, turned.v, turned.v));
    return {scale * turned.v, scale * turned.w};
}

/// Columns are the axes of a body.
struct RowAxes {
    RowVector x, y, z;

    explicit RowAxes(const RowQuaternion& q) {
        const Row two = all(2.0), one = all(1.0);
        const RowVector t = two * q.v;
        const RowVector w = q.w * t;
        const Row xx = t.x * q.v.x, xy = t.x * q.v.y, xz = t.x * q.v.z, yy = t.y * q.v.y, yz = t.y * q.v.z, zz = t.z * q.v.z;
        x = {one - (yy + zz), xy + w.z, xz - w.y};
        y = {xy - w.z, one - (xx + zz), yz + w.x};
        z = {xz + w.y, yz - w.x, one - (xx + yy)};
    }
    RowVector toWorld(const RowVector& v) const { return plusProduct(plusProduct(v.x * x, v.y, y), v.z, z); }
    RowVector toBody(const RowVector& v) const { return {dot(x, v), dot(y, v), dot(z, v)}; }
};

/// Largest energy of spin after a free turn over that before.
constexpr double energyTolerance = 1.001;

/// Turns by the spin with the angular momentum kept: a quarter turn with the present spin gives the axes at which the mean spin is
/// taken (midpoint rule about a conserved momentum).
inline void turn(RowQuaternion& orientation, RowVector& spin, const RowVector& inertia, double h, RowVector& turned) {
    const RowVector inverse{all(1.0) / inertia.x, all(1.0) / inertia.y, all(1.0) / inertia.z};
    const auto times = [](const RowVector& a, const RowVector& b) { return RowVector{a.x * b.x, a.y * b.y, a.z * b.z}; };
    const RowAxes axes(orientation);
    const RowVector before = axes.toBody(spin);
    const RowVector momentum = axes.toWorld(times(inertia, before));
    const RowAxes between(turnedBy(orientation, spin, 0.5 * h));
    const RowVector middle = between.toWorld(times(inverse, between.toBody(momentum)));
    const RowQuaternion next = turnedBy(orientation, middle, h);
    const RowAxes end(next);
    const RowVector after = times(inverse, end.toBody(momentum));
    const auto energy = [&](const RowVector& local) { return dot(times(local, inertia), local); };
    // A needle that turns far in one substep: its momentum cannot be followed; its spin stays what it is in the body's own axes.
    const Mask lost = energy(after) > all(energyTolerance) * energy(before);
    const auto either = [&](const RowVector& a, const RowVector& b) {
        return RowVector{choose(lost, a.x, b.x), choose(lost, a.y, b.y), choose(lost, a.z, b.z)};
    };
    const RowQuaternion rigid = turnedBy(orientation, spin, h);
    turned = plusProduct(turned, all(h), either(spin, middle));
    spin = either(RowAxes(rigid).toWorld(before), end.toWorld(after));
    orientation = {either(rigid.v, next.v), choose(lost, rigid.w, next.w)};
}

std::int64_t move(const LaneScene& scene, std::size_t first, std::size_t last, double gravity) {
    std::int64_t held = 0;
    const auto h = all(scene.h), zero = all(0.0), one = all(1.0);
    for (std::size_t i = first; i < last; i += solverLanes) {
        const bool whole = last - i >= solverLanes;
        std::uint32_t which[solverLanes];
        for (std::size_t lane = 0; lane < solverLanes; ++lane) {
            which[lane] = static_cast<std::uint32_t>(whole || i + lane < last ? i + lane : last - 1);
        }
        Row v[4], w[4], m[4], t[4], x[4], q[4], inertia[4], limit[4];
        gather(scene.bodies, &LaneBody::velocity, which, v);
        gather(scene.bodies, &LaneBody::spin, which, w);
        gather(scene.travel, &LaneTravel::moved, which, m);
        gather(scene.travel, &LaneTravel::turned, which, t);
        gather(scene.poses, &LanePose::position, which, x);
        gather(scene.poses, &LanePose::orientation, which, q);
        gather(scene.solids, &LaneSolid::inertia, which, inertia);
        gather(scene.solids, &LaneSolid::limit, which, limit);
        RowVector velocity{v[0], v[1], v[2]}, spin{w[0], w[1], w[2]}, turned{t[0], t[1], t[2]};

        const Mask acted = v[3] > zero;
        m[3] = larger(m[3], v[3]);
        const Row most = limit[0];
        const Row speed = root(dot(velocity, velocity)), turning = root(dot(spin, spin)) * inertia[3];
        const Row slower = choose(m[3] > zero, choose(speed > most, most / choose(speed > most, speed, one), one), one);
        const Row calmer = choose(m[3] > zero, choose(turning > most, most / choose(turning > most, turning, one), one), one);
        if (anyAbove(one, smaller(slower, calmer))) {
            velocity = slower * velocity;
            spin = calmer * spin;
            const Lanes both = lanesOf(smaller(slower, calmer));
            for (std::size_t lane = 0; lane < solverLanes && i + lane < last; ++lane) {
                held += both[lane] < 1.0;
            }
        }

        RowVector way = h * velocity;
        // Free flight moves with the mean of old and new velocity.
        way.z = way.z + choose(acted, zero, all(0.5 * gravity * scene.h * scene.h));
        RowQuaternion orientation{{q[0], q[1], q[2]}, q[3]};
        turn(orientation, spin, {inertia[0], inertia[1], inertia[2]}, scene.h, turned);
        const auto write = [&](auto* records, auto member, Row a, Row b, Row c, Row d) {
            Row columns[4] = {a, b, c, d};
            scatter(columns, records, member, which, true, 0);
        };
        write(scene.bodies, &LaneBody::velocity, velocity.x, velocity.y, velocity.z, zero);
        write(scene.bodies, &LaneBody::spin, spin.x, spin.y, spin.z, zero);
        write(scene.travel, &LaneTravel::moved, m[0] + way.x, m[1] + way.y, m[2] + way.z, m[3]);
        write(scene.travel, &LaneTravel::turned, turned.x, turned.y, turned.z, zero);
        write(scene.poses, &LanePose::position, x[0] + way.x, x[1] + way.y, x[2] + way.z, zero);
        write(scene.poses, &LanePose::orientation, orientation.v.x, orientation.v.y, orientation.v.z, orientation.w);
    }
    return held;
}

/// What brings overlap apart does to the bodies at one end.
struct Way {
    KeptRowVector moved, turned;
};

inline Way load(const LaneWay* bodies, const std::uint32_t (&which)[solverLanes]) {
    KeptRow m[4], t[4];
    gather(bodies, &LaneWay::moved, which, m);
    gather(bodies, &LaneWay::turned, which, t);
    return {{m[0], m[1], m[2]}, {t[0], t[1], t[2]}};
}

inline void store(const Way& way, LaneWay* bodies, const std::uint32_t (&which)[solverLanes], bool allMove, std::uint32_t movable) {
    KeptRow m[4] = {way.moved.x, way.moved.y, way.moved.z, allKept(0.0f)};
    KeptRow t[4] = {way.turned.x, way.turned.y, way.turned.z, allKept(0.0f)};
    scatter(m, bodies, &LaneWay::moved, which, allMove, movable);
    scatter(t, bodies, &LaneWay::turned, which, allMove, movable);
}
inline void store(const Way& a, const Way& b, const LaneScene& scene, const LaneParting& c) {
    if (c.allMove) {
        store(a, scene.parted, c.a, true, 0);
        store(b, scene.parted, c.b, true, 0);
    } else {
        store(a, scene.parted, c.a, false, scene.movable);
        store(b, scene.parted, c.b, false, scene.movable);
    }
}

/// Applies a push along the normal.
inline void partBy(const LaneParting& c, const KeptRowVector& normal, const LanePart& p, KeptRow push, Way& a, Way& b) {
    a.moved = minusProduct(a.moved, get(c.inverseMassA) * push, normal);
    a.turned = minusProduct(a.turned, push, get(p.swingA));
    b.moved = plusProduct(b.moved, get(c.inverseMassB) * push, normal);
    b.turned = plusProduct(b.turned, push, get(p.swingB));
}

void startParting(const LaneScene& scene, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
        const LaneContacts& from = scene.contacts[i];
        LaneParting& c = scene.partings[i];
        __builtin_memcpy(c.a, from.a, sizeof c.a);
        __builtin_memcpy(c.b, from.b, sizeof c.b);
        put(c.inverseMassA, kept(get(from.inverseMassA)));
        put(c.inverseMassB, kept(get(from.inverseMassB)));
        c.normal = from.normal;
        c.parting = scene.tallies[i].parting;
        c.allMove = from.allMove;
        c.firstPoint = from.firstPoint;
        c.points = from.points;
        Way a = load(scene.parted, c.a);
        Way b = load(scene.parted, c.b);
        const Pair pair(from);
        for (std::uint32_t k = 0; k < c.points; ++k) {
            const LanePoint& point = scene.points[c.firstPoint + k];
            LanePart& p = scene.parts[c.firstPoint + k];
            const Arms arms(point);
            const RowVector turnA = cross(arms.a, pair.normal), turnB = cross(arms.b, pair.normal);
            put(p.turnA, turnA);
            put(p.turnB, turnB);
            put(p.swingA, pair.inverseInertiaA * turnA);
            put(p.swingB, pair.inverseInertiaB * turnB);
            p.mass = point.normalMass;
            put(p.gap, larger(get(point.now), allKept(0.0f)));
            partBy(c, get(c.normal), p, get(p.push), a, b);
        }
        store(a, b, scene, c);
    }
}

void part(const LaneScene& scene, std::size_t first, std::size_t last, bool hold) {
    const KeptRow zero = allKept(0.0f);
    for (std::size_t i = first; i < last; ++i) {
        ask(scene.parted, scene.partings, i + asked, last);
        const LaneParting& c = scene.partings[i];
        Way a = load(scene.parted, c.a);
        Way b = load(scene.parted, c.b);
        const KeptRowVector normal = get(c.normal);
        const KeptRow parting = get(c.parting);
        for (std::uint32_t k = 0; k < c.points; ++k) {
            LanePart& p = scene.parts[c.firstPoint + k];
            const KeptRow push = get(p.push);
            const KeptRow mass = get(p.mass);
            const KeptRow way = dot(normal, b.moved - a.moved) + (dot(get(p.turnB), b.turned) - dot(get(p.turnA), a.turned));
            // What touches stays apart, what is open may close, what overlaps comes apart.
            const KeptRow wanted = larger(plusProduct(push, allKept(overRelaxation) * mass, parting - get(p.gap) - way), zero);
            const KeptRow held = larger(push, minusProduct(push, mass, way));
            const KeptRow total = hold ? (parting > zero ? held : wanted) : wanted;
            put(p.push, total);
            partBy(c, normal, p, total - push, a, b);
        }
        store(a, b, scene, c);
    }
}

void noteOpening(const LaneScene& scene, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
        const LaneContacts& c = scene.contacts[i];
        if (!c.booked) {
            continue;
        }
        const End a = load(scene.bodies, c.a);
        const End b = load(scene.bodies, c.b);
        for (std::uint32_t k = 0; k < c.points; ++k) {
            put(scene.works[c.firstPoint + k].opening, relativeVelocity(a, b, Arms(scene.points[c.firstPoint + k])));
        }
    }
}

/// Impulse times the mean of the relative velocities before and after is what a contact adds to the kinetic energy. Bodies move
/// with the velocities of the soft pass; between two that move this leaves their centre of mass in place, next to an immovable one
/// it lifts.
void book(const LaneScene& scene, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
        const LaneContacts& c = scene.contacts[i];
        if (!c.booked) {
            continue;
        }
        const Pair pair(c);
        const End a = load(scene.bodies, c.a);
        const End b = load(scene.bodies, c.b);
        LaneTally& tally = scene.tallies[i];
        Row done = get(tally.work);
        for (std::uint32_t k = 0; k < c.points; ++k) {
            const LanePoint& p = scene.points[c.firstPoint + k];
            const LanePointWork& work = scene.works[c.firstPoint + k];
            const Arms arms(p);
            const RowVector impulse = impulseOf(pair, p);
            const Row input =
                all(0.5) * dot(impulse, get(work.opening) + relativeVelocity(a, b, arms)) + wide(tally.lift) * get(work.raised);
            done = done + (wide(tally.drivenByA) * dot(impulse, a.velocity + cross(a.spin, arms.a)) -
                           wide(tally.drivenByB) * dot(impulse, b.velocity + cross(b.spin, arms.b)) +
                           wide(tally.bookedShare) * larger(input, all(0.0)));
        }
        put(tally.work, done);
    }
}

}  // namespace

extern const LanePasses passes;
const LanePasses passes{prepare, warmStart, soft, relax, move, startParting, part, noteOpening, book};

}  // namespace rubble::RUBBLE_LANE_MAKE
