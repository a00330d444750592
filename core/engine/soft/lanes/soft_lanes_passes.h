#pragma once

// The passes themselves; included once for each variant, with RUBBLE_LANE_VARIANT as the name of its namespace. Nothing with
// external linkage may be used here: the linker would keep one of the versions, made for the wrong processor.
#include "core/engine/soft/lanes/soft_lanes_bodies.h"

namespace rubble::RUBBLE_LANE_VARIANT {

namespace {

/// By how much more than it asks for a contact is brought apart in each pass: what others take back is made up for ahead. Lower:
/// more passes; higher: they swing.
constexpr float overRelaxation = 1.3f;
/// Contacts ahead of the one at hand whose bodies are asked for: they lie anywhere, and the passes wait for little else.
constexpr std::size_t groupsAhead = 2;

/// Asks for the records of the bodies of a contact.
template <class Record, class Contacts>
inline void prefetch(const Record* records, const Contacts* contacts, std::size_t contact, std::size_t last) {
    if (contact < last) {
        for (int i = 0; i < solverLanes; ++i) {
            __builtin_prefetch(&records[contacts[contact].a[i]], 1);
            __builtin_prefetch(&records[contacts[contact].b[i]], 1);
        }
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
    return plusProduct(plusProduct(get(p.normalImpulse) * c.normal, get(p.tangentImpulse[0]), c.tangent[0]),
                       get(p.tangentImpulse[1]), c.tangent[1]);
}

/// Keeps an impulse; returns by how much it has changed.
inline Row keep(Lanes& impulse, Row total) {
    const Row before = get(impulse);
    put(impulse, total);
    return total - before;
}

inline void applyFriction(const Pair& c, End& a, End& b, LanePoint& p) {
    const Arms arms(p);
    const RowVector relative = relativeVelocity(a, b, arms);
    const Row t0 = minusProduct(get(p.tangentImpulse[0]), wide(p.tangentMass[0]), dot(c.tangent[0], relative));
    const Row t1 = minusProduct(get(p.tangentImpulse[1]), wide(p.tangentMass[1]), dot(c.tangent[1], relative));
    const Row limit = c.friction * get(p.normalImpulse);
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
        const Row before = get(p.normalImpulse);
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
        if (Push) {
            scene.acts[contact] = 0;
        }
        for (std::uint32_t k = 0; Push && c.countsWork && k < c.points; ++k) {
            put(scene.works[c.firstPoint + k].raised, zero);
        }
        return;
    }
    scene.acts[contact] = 1;
    acted = choose(acted > zero, all(1.0), zero);
    for (std::uint32_t k = 0; k < c.points; ++k) {
        applyFriction(pair, a, b, points[k]);
        if (Push && c.countsWork) {
            put(scene.works[c.firstPoint + k].raised, impulseOf(pair, points[k]).z);
        }
        if (Push || Last) {
            put(tallies[k].largestImpulse, larger(get(tallies[k].largestImpulse), kept(get(points[k].normalImpulse))));
        }
        if (Last) {
            put(tallies[k].impulseSum, get(tallies[k].impulseSum) + get(points[k].normalImpulse));
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
            const Row load = get(p.normalImpulse) * all(1.0 / scene.h);
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
        if (scene.acts[i] == 0) {
            continue;
        }
        const LaneContacts& c = scene.contacts[i];
        LanePoint* points = scene.points + c.firstPoint;
        const Row weight = wide(scene.tallies[i].weight);
        Row largest = all(0.0);
        for (std::uint32_t k = 0; k < c.points; ++k) {
            LanePoint& p = points[k];
            LanePointTally& tally = scene.pointTallies[c.firstPoint + k];
            const Row impulse = get(p.normalImpulse);
            const Row most = all(growth) * larger(wide(tally.before), weight);
            put(tally.before, kept(impulse));
            const Mask over = impulse > most;
            // Friction that has lost its load is none, whatever the contacts beside this one carry.
            const Row loaded = choose(impulse > all(0.0), all(1.0), all(0.0));
            const Row scale = choose(over, most / choose(over, impulse, all(1.0)), loaded);
            put(p.tangentImpulse[0], get(p.tangentImpulse[0]) * scale);
            put(p.tangentImpulse[1], get(p.tangentImpulse[1]) * scale);
            const Row carried = choose(over, most, impulse);
            put(p.normalImpulse, carried);
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
inline void store(const Way& a, const Way& b, const LaneScene& scene, const LaneCorrection& c) {
    if (c.allMove) {
        store(a, scene.corrected, c.a, true, 0);
        store(b, scene.corrected, c.b, true, 0);
    } else {
        store(a, scene.corrected, c.a, false, scene.movable);
        store(b, scene.corrected, c.b, false, scene.movable);
    }
}

/// Applies a push along the normal.
inline void correctBy(const LaneCorrection& c, const KeptRowVector& normal, const LaneCorrectionPoint& p, KeptRow push, Way& a,
                      Way& b) {
    a.moved = minusProduct(a.moved, get(c.inverseMassA) * push, normal);
    a.turned = minusProduct(a.turned, push, get(p.swingA));
    b.moved = plusProduct(b.moved, get(c.inverseMassB) * push, normal);
    b.turned = plusProduct(b.turned, push, get(p.swingB));
}

void startCorrection(const LaneScene& scene, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
        const LaneContacts& from = scene.contacts[i];
        LaneCorrection& c = scene.corrections[i];
        __builtin_memcpy(c.a, from.a, sizeof c.a);
        __builtin_memcpy(c.b, from.b, sizeof c.b);
        put(c.inverseMassA, kept(get(from.inverseMassA)));
        put(c.inverseMassB, kept(get(from.inverseMassB)));
        c.normal = from.normal;
        c.correction = scene.tallies[i].correction;
        c.allMove = from.allMove;
        c.firstPoint = from.firstPoint;
        c.points = from.points;
        Way a = load(scene.corrected, c.a);
        Way b = load(scene.corrected, c.b);
        const Pair pair(from);
        for (std::uint32_t k = 0; k < c.points; ++k) {
            const LanePoint& point = scene.points[c.firstPoint + k];
            LaneCorrectionPoint& p = scene.correctionPoints[c.firstPoint + k];
            const Arms arms(point);
            const RowVector turnA = cross(arms.a, pair.normal), turnB = cross(arms.b, pair.normal);
            put(p.turnA, turnA);
            put(p.turnB, turnB);
            put(p.swingA, pair.inverseInertiaA * turnA);
            put(p.swingB, pair.inverseInertiaB * turnB);
            p.mass = point.normalMass;
            put(p.gap, larger(get(point.now), allKept(0.0f)));
            correctBy(c, get(c.normal), p, get(p.push), a, b);
        }
        store(a, b, scene, c);
    }
}

void correct(const LaneScene& scene, std::size_t first, std::size_t last, bool hold) {
    const KeptRow zero = allKept(0.0f);
    for (std::size_t i = first; i < last; ++i) {
        prefetch(scene.corrected, scene.corrections, i + groupsAhead, last);
        const LaneCorrection& c = scene.corrections[i];
        Way a = load(scene.corrected, c.a);
        Way b = load(scene.corrected, c.b);
        const KeptRowVector normal = get(c.normal);
        const KeptRow correction = get(c.correction);
        for (std::uint32_t k = 0; k < c.points; ++k) {
            LaneCorrectionPoint& p = scene.correctionPoints[c.firstPoint + k];
            const KeptRow push = get(p.push);
            const KeptRow mass = get(p.mass);
            const KeptRow way = dot(normal, b.moved - a.moved) + (dot(get(p.turnB), b.turned) - dot(get(p.turnA), a.turned));
            // What touches stays apart, what is open may close, what overlaps comes apart.
            const KeptRow wanted = larger(plusProduct(push, allKept(overRelaxation) * mass, correction - get(p.gap) - way), zero);
            const KeptRow held = larger(push, minusProduct(push, mass, way));
            const KeptRow total = hold ? (correction > zero ? held : wanted) : wanted;
            put(p.push, total);
            correctBy(c, normal, p, total - push, a, b);
        }
        store(a, b, scene, c);
    }
}

void noteOpening(const LaneScene& scene, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
        const LaneContacts& c = scene.contacts[i];
        if (!c.countsWork) {
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
void accumulateWork(const LaneScene& scene, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
        const LaneContacts& c = scene.contacts[i];
        if (!c.countsWork || scene.acts[i] == 0) {
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
                           wide(tally.workShare) * larger(input, all(0.0)));
        }
        put(tally.work, done);
    }
}

}  // namespace

extern const LanePasses passes;
const LanePasses passes{prepare, warmStart, soft, relax, move, startCorrection, correct, noteOpening, accumulateWork};

}  // namespace rubble::RUBBLE_LANE_VARIANT
