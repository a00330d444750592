#pragma once

// The passes themselves; included once for each make, with RUBBLE_LANE_MAKE as the name of its namespace. Nothing with external
// linkage may be used here: the linker would keep one of two versions, made for the wrong processor.
#ifdef __AVX__
#include <immintrin.h>
#endif

#include "core/simulation/soft_lanes.h"

namespace rubble::RUBBLE_LANE_MAKE {

namespace {

using Mask = std::int64_t __attribute__((vector_size(8 * solverLanes)));

inline Lanes all(double x) {
    return Lanes{x, x, x, x};
}
/// In double precision.
inline Lanes wide(KeptLanes x) {
#ifdef __AVX__
    return _mm256_cvtps_pd(x);  // the compiler's own conversion goes through the stack
#else
    return __builtin_convertvector(x, Lanes);
#endif
}
inline KeptLanes kept(Lanes x) {
#ifdef __AVX__
    return _mm256_cvtpd_ps(x);
#else
    return __builtin_convertvector(x, KeptLanes);
#endif
}
inline LaneVector wide(const KeptLaneVector& v) {
    return {wide(v.x), wide(v.y), wide(v.z)};
}
inline KeptLaneVector kept(const LaneVector& v) {
    return {kept(v.x), kept(v.y), kept(v.z)};
}
inline LaneTensor wide(const KeptLaneTensor& t) {
    return {wide(t.xx), wide(t.yy), wide(t.zz), wide(t.xy), wide(t.xz), wide(t.yz)};
}
inline Lanes larger(Lanes a, Lanes b) {
    return a > b ? a : b;
}
inline Lanes smaller(Lanes a, Lanes b) {
    return a < b ? a : b;
}
inline Lanes root(Lanes a) {
#ifdef __AVX__
    return _mm256_sqrt_pd(a);
#else
    Lanes r;
    for (int i = 0; i < solverLanes; ++i) {
        r[i] = __builtin_sqrt(a[i]);
    }
    return r;
#endif
}
inline bool any(Mask m) {
    std::int64_t r = 0;
    for (int i = 0; i < solverLanes; ++i) {
        r |= m[i];
    }
    return r != 0;
}

inline LaneVector operator+(const LaneVector& a, const LaneVector& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline LaneVector operator-(const LaneVector& a, const LaneVector& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline LaneVector operator*(Lanes s, const LaneVector& a) {
    return {s * a.x, s * a.y, s * a.z};
}
inline Lanes dot(const LaneVector& a, const LaneVector& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline LaneVector cross(const LaneVector& a, const LaneVector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline LaneVector operator*(const LaneTensor& t, const LaneVector& v) {
    return {t.xx * v.x + t.xy * v.y + t.xz * v.z, t.xy * v.x + t.yy * v.y + t.yz * v.z, t.xz * v.x + t.yz * v.y + t.zz * v.z};
}

/// Rows to columns and back.
inline void transpose(Lanes (&r)[4]) {
    const Lanes a0 = __builtin_shufflevector(r[0], r[1], 0, 4, 2, 6);
    const Lanes a1 = __builtin_shufflevector(r[0], r[1], 1, 5, 3, 7);
    const Lanes a2 = __builtin_shufflevector(r[2], r[3], 0, 4, 2, 6);
    const Lanes a3 = __builtin_shufflevector(r[2], r[3], 1, 5, 3, 7);
    r[0] = __builtin_shufflevector(a0, a2, 0, 1, 4, 5);
    r[1] = __builtin_shufflevector(a1, a3, 0, 1, 4, 5);
    r[2] = __builtin_shufflevector(a0, a2, 2, 3, 6, 7);
    r[3] = __builtin_shufflevector(a1, a3, 2, 3, 6, 7);
}

/// Four numbers of each lane's record.
template <class Record>
inline void gather(const Record* records, double (Record::*member)[4], const std::uint32_t (&which)[solverLanes],
                   Lanes (&columns)[4]) {
    for (int i = 0; i < solverLanes; ++i) {
        columns[i] = *reinterpret_cast<const Lanes*>(records[which[i]].*member);
    }
    transpose(columns);
}

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
    LaneVector velocity, spin;
    Lanes touched;
};

inline End load(const LaneBody* bodies, const std::uint32_t (&which)[solverLanes]) {
    Lanes v[4], w[4];
    gather(bodies, &LaneBody::velocity, which, v);
    gather(bodies, &LaneBody::spin, which, w);
    return {{v[0], v[1], v[2]}, {w[0], w[1], w[2]}, v[3]};
}

inline void store(const End& end, LaneBody* bodies, const std::uint32_t (&which)[solverLanes], std::uint32_t movable) {
    Lanes v[4] = {end.velocity.x, end.velocity.y, end.velocity.z, end.touched};
    Lanes w[4] = {end.spin.x, end.spin.y, end.spin.z, all(0.0)};
    transpose(v);
    transpose(w);
    for (int i = 0; i < solverLanes; ++i) {
        // Threads may share an immovable body, so nothing is written to it.
        if (which[i] < movable) {
            *reinterpret_cast<Lanes*>(bodies[which[i]].velocity) = v[i];
            *reinterpret_cast<Lanes*>(bodies[which[i]].spin) = w[i];
        }
    }
}

/// The arms of a point.
struct Arms {
    explicit Arms(const LanePoint& p) : a(wide(p.fromA)), b(wide(p.fromB)) {}
    LaneVector a, b;
};

/// Directions and masses of contacts.
struct Pair {
    explicit Pair(const LaneContacts& c)
        : normal(wide(c.normal)),
          tangent{wide(c.tangent[0]), wide(c.tangent[1])},
          inverseMassA(c.inverseMassA),
          inverseMassB(c.inverseMassB),
          inverseInertiaA(wide(c.inverseInertiaA)),
          inverseInertiaB(wide(c.inverseInertiaB)),
          friction(wide(c.friction)) {}
    LaneVector normal, tangent[2];
    Lanes inverseMassA, inverseMassB;
    LaneTensor inverseInertiaA, inverseInertiaB;
    Lanes friction;
};

inline LaneVector relativeVelocity(const End& a, const End& b, const Arms& arms) {
    return b.velocity + cross(b.spin, arms.b) - a.velocity - cross(a.spin, arms.a);
}

inline void apply(const Pair& c, End& a, End& b, const Arms& arms, const LaneVector& impulse) {
    a.velocity = a.velocity - c.inverseMassA * impulse;
    a.spin = a.spin - c.inverseInertiaA * cross(arms.a, impulse);
    b.velocity = b.velocity + c.inverseMassB * impulse;
    b.spin = b.spin + c.inverseInertiaB * cross(arms.b, impulse);
}

inline LaneVector impulseOf(const Pair& c, const LanePoint& p) {
    return p.normalImpulse * c.normal + p.tangentImpulse[0] * c.tangent[0] + p.tangentImpulse[1] * c.tangent[1];
}

inline void applyFriction(const Pair& c, End& a, End& b, LanePoint& p) {
    const Arms arms(p);
    const LaneVector relative = relativeVelocity(a, b, arms);
    Lanes t0 = p.tangentImpulse[0] - wide(p.tangentMass[0]) * dot(c.tangent[0], relative);
    Lanes t1 = p.tangentImpulse[1] - wide(p.tangentMass[1]) * dot(c.tangent[1], relative);
    const Lanes limit = c.friction * p.normalImpulse;
    const Lanes length = t0 * t0 + t1 * t1;
    const Mask beyond = length > limit * limit;
    const Lanes scale = beyond ? limit / root(beyond ? length : all(1.0)) : all(1.0);
    t0 = t0 * scale;
    t1 = t1 * scale;
    const LaneVector impulse = (t0 - p.tangentImpulse[0]) * c.tangent[0] + (t1 - p.tangentImpulse[1]) * c.tangent[1];
    p.tangentImpulse[0] = t0;
    p.tangentImpulse[1] = t1;
    apply(c, a, b, arms, impulse);
}

/// One pass over the points of contacts. Push: overlap is pushed apart at `push` [m/s] at most. Moved: the bodies have moved since
/// the pass before.
template <bool Push, bool Moved>
inline void solve(const LaneScene& scene, LaneContacts& c, double push, bool last) {
    End a = load(scene.bodies, c.a);
    End b = load(scene.bodies, c.b);
    LanePoint* points = scene.points + c.firstPoint;
    const Pair pair(c);
    const Lanes zero = all(0.0);
    const Lanes perSubstep = all(1.0 / scene.h);
    LaneVector moved{}, turnedA{}, turnedB{};
    if (Moved) {
        Lanes ma[4], mb[4], ta[4], tb[4];
        gather(scene.travel, &LaneTravel::moved, c.a, ma);
        gather(scene.travel, &LaneTravel::moved, c.b, mb);
        gather(scene.travel, &LaneTravel::turned, c.a, ta);
        gather(scene.travel, &LaneTravel::turned, c.b, tb);
        moved = LaneVector{mb[0], mb[1], mb[2]} - LaneVector{ma[0], ma[1], ma[2]};
        turnedA = {ta[0], ta[1], ta[2]};
        turnedB = {tb[0], tb[1], tb[2]};
    }
    Lanes acted = zero;
    for (std::uint32_t k = 0; k < c.points; ++k) {
        LanePoint& p = points[k];
        const Arms arms(p);
        Lanes now = p.now;
        if (Moved) {
            now = p.separation + dot(pair.normal, moved + cross(turnedB, arms.b) - cross(turnedA, arms.a));
            p.now = now;
        }
        const Lanes mass = wide(p.normalMass);
        const Mask apart = now > zero;
        const Lanes ahead = now * perSubstep;
        const Lanes speed = dot(pair.normal, relativeVelocity(a, b, arms));
        Lanes wanted;
        if (Push) {
            const Lanes bias = apart ? ahead : larger(wide(c.biasRate) * now, all(-push));
            const Lanes massScale = apart ? all(1.0) : wide(c.massScale);
            const Lanes impulseScale = apart ? zero : wide(c.impulseScale);
            wanted = p.normalImpulse - mass * massScale * (speed + bias) - impulseScale * p.normalImpulse;
        } else {
            wanted = p.normalImpulse - mass * (speed + (apart ? ahead : zero));
        }
        const Lanes total = smaller(larger(wanted, zero), wide(c.impulseLimit));
        const Lanes change = total - p.normalImpulse;
        p.normalImpulse = total;
        p.largestImpulse = kept(larger(wide(p.largestImpulse), total));
        acted = total > zero ? all(1.0) : acted;
        apply(pair, a, b, arms, change * pair.normal);
    }
    for (std::uint32_t k = 0; k < c.points; ++k) {
        applyFriction(pair, a, b, points[k]);
        if (Push && c.booked) {
            scene.works[c.firstPoint + k].raised = impulseOf(pair, points[k]).z;
        } else if (!Push && last) {
            points[k].impulseSum += points[k].normalImpulse;
        }
    }
    a.touched = larger(a.touched, acted);
    b.touched = larger(b.touched, acted);
    store(a, scene.bodies, c.a, scene.movable);
    store(b, scene.bodies, c.b, scene.movable);
}

void warmStart(const LaneScene& scene, std::size_t first, std::size_t last, double growth) {
    for (std::size_t i = first; i < last; ++i) {
        const LaneContacts& c = scene.contacts[i];
        LanePoint* points = scene.points + c.firstPoint;
        Lanes largest = all(0.0);
        for (std::uint32_t k = 0; k < c.points; ++k) {
            LanePoint& p = points[k];
            const Lanes most = all(growth) * larger(wide(p.before), wide(c.weight));
            p.before = kept(p.normalImpulse);
            const Mask over = p.normalImpulse > most;
            // Friction that has lost its load is none, whatever the contacts beside this one carry.
            const Lanes loaded = p.normalImpulse > all(0.0) ? all(1.0) : all(0.0);
            const Lanes scale = over ? most / (over ? p.normalImpulse : all(1.0)) : loaded;
            p.tangentImpulse[0] = p.tangentImpulse[0] * scale;
            p.tangentImpulse[1] = p.tangentImpulse[1] * scale;
            p.normalImpulse = over ? most : p.normalImpulse;
            largest = larger(largest, p.normalImpulse);
        }
        if (!any(largest > all(0.0))) {
            continue;
        }
        const Pair pair(c);
        End a = load(scene.bodies, c.a);
        End b = load(scene.bodies, c.b);
        for (std::uint32_t k = 0; k < c.points; ++k) {
            apply(pair, a, b, Arms(points[k]), impulseOf(pair, points[k]));
        }
        store(a, scene.bodies, c.a, scene.movable);
        store(b, scene.bodies, c.b, scene.movable);
    }
}

void soft(const LaneScene& scene, std::size_t first, std::size_t last, double push) {
    for (std::size_t i = first; i < last; ++i) {
        solve<true, false>(scene, scene.contacts[i], push, false);
    }
}

void relax(const LaneScene& scene, std::size_t first, std::size_t last, bool moved, bool final) {
    for (std::size_t i = first; i < last; ++i) {
        moved ? solve<false, true>(scene, scene.contacts[i], 0.0, final)
              : solve<false, false>(scene, scene.contacts[i], 0.0, final);
    }
}

/// Applies a push along the normal.
inline void partBy(const LaneParting& c, const LaneVector& normal, const LanePart& p, Lanes push, End& a, End& b) {
    a.velocity = a.velocity - (wide(c.inverseMassA) * push) * normal;
    a.spin = a.spin - push * wide(p.swingA);
    b.velocity = b.velocity + (wide(c.inverseMassB) * push) * normal;
    b.spin = b.spin + push * wide(p.swingB);
}

void startParting(const LaneScene& scene, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
        const LaneContacts& from = scene.contacts[i];
        LaneParting& c = scene.partings[i];
        __builtin_memcpy(c.a, from.a, sizeof c.a);
        __builtin_memcpy(c.b, from.b, sizeof c.b);
        c.inverseMassA = kept(from.inverseMassA);
        c.inverseMassB = kept(from.inverseMassB);
        c.normal = from.normal;
        c.parting = from.parting;
        c.firstPoint = from.firstPoint;
        c.points = from.points;
        End a = load(scene.parted, c.a);
        End b = load(scene.parted, c.b);
        const Pair pair(from);
        for (std::uint32_t k = 0; k < c.points; ++k) {
            const LanePoint& point = scene.points[c.firstPoint + k];
            LanePart& p = scene.parts[c.firstPoint + k];
            const Arms arms(point);
            const LaneVector turnA = cross(arms.a, pair.normal), turnB = cross(arms.b, pair.normal);
            p.turnA = kept(turnA);
            p.turnB = kept(turnB);
            p.swingA = kept(pair.inverseInertiaA * turnA);
            p.swingB = kept(pair.inverseInertiaB * turnB);
            p.mass = point.normalMass;
            p.gap = kept(larger(point.now, all(0.0)));
            partBy(c, pair.normal, p, p.push, a, b);
        }
        store(a, scene.parted, c.a, scene.movable);
        store(b, scene.parted, c.b, scene.movable);
    }
}

void part(const LaneScene& scene, std::size_t first, std::size_t last, bool hold) {
    const Lanes zero = all(0.0);
    for (std::size_t i = first; i < last; ++i) {
        ask(scene.parted, scene.partings, i + asked, last);
        const LaneParting& c = scene.partings[i];
        End a = load(scene.parted, c.a);
        End b = load(scene.parted, c.b);
        const LaneVector normal = wide(c.normal);
        const Lanes parting = wide(c.parting);
        for (std::uint32_t k = 0; k < c.points; ++k) {
            LanePart& p = scene.parts[c.firstPoint + k];
            const Lanes push = p.push;
            const Lanes mass = wide(p.mass);
            const Lanes way = dot(normal, b.velocity - a.velocity) + dot(wide(p.turnB), b.spin) - dot(wide(p.turnA), a.spin);
            // What touches stays apart, what is open may close, what overlaps comes apart.
            const Lanes wanted = larger(push + mass * (parting - wide(p.gap) - way), zero);
            const Lanes held = larger(push, push - mass * way);
            p.push = hold ? (parting > zero ? held : wanted) : wanted;
            partBy(c, normal, p, p.push - push, a, b);
        }
        store(a, scene.parted, c.a, scene.movable);
        store(b, scene.parted, c.b, scene.movable);
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
            scene.works[c.firstPoint + k].opening = relativeVelocity(a, b, Arms(scene.points[c.firstPoint + k]));
        }
    }
}

/// Impulse times the mean of the relative velocities before and after is what a contact adds to the kinetic energy. Bodies move
/// with the velocities of the soft pass; between two that move this leaves their centre of mass in place, next to an immovable one
/// it lifts.
void book(const LaneScene& scene, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
        LaneContacts& c = scene.contacts[i];
        if (!c.booked) {
            continue;
        }
        const Pair pair(c);
        const End a = load(scene.bodies, c.a);
        const End b = load(scene.bodies, c.b);
        for (std::uint32_t k = 0; k < c.points; ++k) {
            const LanePoint& p = scene.points[c.firstPoint + k];
            const LanePointWork& work = scene.works[c.firstPoint + k];
            const Arms arms(p);
            const LaneVector impulse = impulseOf(pair, p);
            const Lanes input = all(0.5) * dot(impulse, work.opening + relativeVelocity(a, b, arms)) + wide(c.lift) * work.raised;
            c.work += wide(c.drivenByA) * dot(impulse, a.velocity + cross(a.spin, arms.a)) -
                      wide(c.drivenByB) * dot(impulse, b.velocity + cross(b.spin, arms.b)) +
                      wide(c.bookedShare) * larger(input, all(0.0));
        }
    }
}

}  // namespace

extern const LanePasses passes;
const LanePasses passes{warmStart, soft, relax, startParting, part, noteOpening, book};

}  // namespace rubble::RUBBLE_LANE_MAKE
