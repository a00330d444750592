#pragma once

// Bodies of eight lanes for the passes: in and out, and how they move by themselves; included once for each variant
// (soft_lanes_passes.h).
#include "core/engine/soft/lanes/soft_lanes_numbers.h"

namespace rubble::RUBBLE_LANE_VARIANT {

namespace {

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

}  // namespace

}  // namespace rubble::RUBBLE_LANE_VARIANT
