#pragma once

#include "core/clusters/clustering.h"
#include "core/clusters/sizing.h"
#include "core/fragments/fragment_set.h"
#include "core/simulation/run/simulation.h"
#include "core/trajectory/trajectory.h"
#include "io/run/run_layout.h"

namespace rubble::io {

/// The members of what a run file keeps, each type listed once: packing, unpacking, column names and JSON all walk these lists.
/// `each(visitor, value)` calls visitor(name, member) in file order; the value may be const or not. A member that came after the
/// first version of the file is visited by visitor.added(name, member): JSON text of an older file lacks it, and it keeps its
/// default. Columns of tables cannot be added to.
template <class T>
struct Members;

template <>
struct Members<Momenta> {
    template <class Visitor, class Value>
    static void each(Visitor& visit, Value& m) {
        visit("mass", m.mass);
        visit("linear", m.linear);
        visit("angular", m.angular);
        visit("kinetic_energy", m.kineticEnergy);
    }
};

template <>
struct Members<Pose> {
    template <class Visitor, class Value>
    static void each(Visitor& visit, Value& p) {
        visit("position", p.position);
        visit("orientation", p.orientation);
    }
};

template <>
struct Members<OrientedBox> {
    template <class Visitor, class Value>
    static void each(Visitor& visit, Value& b) {
        visit("centre", b.centre);
        visit("orientation", b.orientation);
        visit("half_extents", b.halfExtents);
    }
};

template <>
struct Members<Aabb> {
    template <class Visitor, class Value>
    static void each(Visitor& visit, Value& b) {
        visit("low", b.min());
        visit("high", b.max());
    }
};

template <>
struct Members<Fragment> {
    template <class Visitor, class Value>
    static void each(Visitor& visit, Value& f) {
        visit("element", f.element);
        visit("component", f.component);
        visit("hand_over_state", f.handOverState);
        visit("birth_state", f.birthState);
        visit("hand_over_time", f.handOverTime);
        visit("birth_time", f.birthTime);
        visit("end_time", f.endTime);
        visit("mass", f.mass);
        visit("centre", f.centre);
        visit("inertia", f.inertia);
        visit("velocity", f.velocity);
        visit("angular_velocity", f.angularVelocity);
        visit("box", f.box);
        visit("bounds", f.bounds);
        visit("fe", f.fe);
    }
};

template <>
struct Members<Cluster> {
    template <class Visitor, class Value>
    static void each(Visitor& visit, Value& c) {
        visit("first_member", c.firstMember);
        visit("member_count", c.memberCount);
        visit("component", c.component);
        visit("hand_over_state", c.handOverState);
        visit("hand_over_time", c.handOverTime);
        visit("end_time", c.endTime);
        visit("mass", c.mass);
        visit("centre", c.centre);
        visit("inertia", c.inertia);
        visit("velocity", c.velocity);
        visit("angular_velocity", c.angularVelocity);
    }
};

template <>
struct Members<BodyRecord> {
    template <class Visitor, class Value>
    static void each(Visitor& visit, Value& b) {
        visit("body", b.body);
        visit("cluster", b.cluster);
        visit("from", b.from);
        visit("to", b.to);
        visit("mass", b.mass);
        visit("at_birth", b.atBirth);
    }
};

template <>
struct Members<IslandRow> {
    template <class Visitor, class Value>
    static void each(Visitor& visit, Value& i) {
        visit("body", i.body);
        visit("first_element", i.firstElement);
        visit("element_count", i.elementCount);
    }
};

template <>
struct Members<IslandPlaceRow> {
    template <class Visitor, class Value>
    static void each(Visitor& visit, Value& i) {
        visit("state", i.state);
        visit("in_fe", i.inFe);
    }
};

template <>
struct Members<IslandLoss> {
    template <class Visitor, class Value>
    static void each(Visitor& visit, Value& l) {
        visit("time", l.time);
        visit("state", l.state);
        visit("before", l.before);
        visit("born", l.born);
        visit("left", l.left);
    }
};

template <>
struct Members<Carrier> {
    template <class Visitor, class Value>
    static void each(Visitor& visit, Value& c) {
        visit("fragment", c.fragment);
        visit("body", c.body);
        visit("from", c.from);
        visit("to", c.to);
        visit("hand_over_to_body", c.handOverToBody);
    }
};

template <>
struct Members<LedgerRow> {
    template <class Visitor, class Value>
    static void each(Visitor& visit, Value& r) {
        visit("time", r.time);
        visit("state", r.state);
        visit("fe", r.fe);
        visit("fragments", r.fragments);
        visit("clusters", r.clusters);
        visit("bodies", r.bodies);
        visit("dropped_kinetic_energy", r.droppedKineticEnergy);
        visit("all", r.all);
        visit("potential_energy", r.potentialEnergy);
        visit("piece_work", r.pieceWork);
        visit("overlap_work", r.overlapWork);
    }
};

template <>
struct Members<FragmentOutcome> {
    template <class Visitor, class Value>
    static void each(Visitor& visit, Value& o) {
        visit("birth_position", o.birthPosition);
        visit("birth_speed", o.birthSpeed);
        visit("final_position", o.finalPosition);
        visit("impact_speed", o.impactSpeed);
    }
};

template <>
struct Members<LedgerErrors> {
    template <class Visitor, class Value>
    static void each(Visitor& visit, Value& e) {
        visit("mass", e.mass);
        visit("momentum", e.momentum);
        visit("angular_momentum", e.angularMomentum);
        visit("body_mass", e.bodyMass);
        visit("body_momentum", e.bodyMomentum);
        visit("body_angular_momentum", e.bodyAngularMomentum);
    }
};

template <>
struct Members<OccupiedBirths> {
    template <class Visitor, class Value>
    static void each(Visitor& visit, Value& b) {
        visit("births", b.births);
        visit("occupied", b.occupied);
        visit("median_depth", b.medianDepth);
        visit.added("joined", b.joined);
        visit.added("left", b.left);
        visit("work", b.work);
        visit("piece_push_work", b.piecePushWork);
        visit("pieces_yielded", b.piecesYielded);
    }
};

template <>
struct Members<LiveIslands> {
    template <class Visitor, class Value>
    static void each(Visitor& visit, Value& i) {
        visit("islands", i.islands);
        visit("elements", i.elements);
        visit("mass", i.mass);
        visit("moving", i.moving);
        visit.added("released", i.released);
        visit.added("released_elements", i.releasedElements);
        visit.added("released_mass", i.releasedMass);
        visit.added("refused", i.refused);
        visit.added("occupied", i.occupied);
        visit.added("still_moving", i.stillMoving);
        visit.added("dropped_kinetic_energy", i.droppedKineticEnergy);
        visit.added("ledger", i.ledger);
    }
};

template <>
struct Members<CarriedStructure> {
    template <class Visitor, class Value>
    static void each(Visitor& visit, Value& c) {
        visit("islands", c.islands);
        visit("elements", c.elements);
        visit("mass", c.mass);
        visit("refused", c.refused);
        visit("bodies", c.bodies);
        visit("born", c.born);
        visit("born_mass", c.bornMass);
        visit("born_at_rest_mass", c.bornAtRestMass);
        visit.added("born_softer_mass", c.bornSofterMass);
        visit("left", c.left);
        visit("left_mass", c.leftMass);
        visit("still_moving", c.stillMoving);
        visit("dropped_kinetic_energy", c.droppedKineticEnergy);
        visit("hand_overs", c.handOvers);
        visit("losses", c.losses);
    }
};

template <>
struct Members<StepTimes> {
    template <class Visitor, class Value>
    static void each(Visitor& visit, Value& t) {
        visit("mean_ms", t.meanMs);
        visit("p95_ms", t.p95Ms);
        visit("worst_ms", t.worstMs);
        visit("share_in_time", t.shareInTime);
        visit("real_time_factor", t.realTimeFactor);
        visit.added("all_ms", t.allMs);
        visit.added("motion_ms", t.motionMs);
        visit.added("hook_ms", t.hookMs);
        visit.added("bookkeeping_ms", t.bookkeepingMs);
        visit.added("health_ms", t.healthMs);
        visit.added("recording_ms", t.recordingMs);
        visit.added("births_ms", t.birthsMs);
    }
};

template <>
struct Members<EnergyBalance> {
    template <class Visitor, class Value>
    static void each(Visitor& visit, Value& e) {
        visit("gravity_work", e.gravityWork);
        visit("kinetic_in", e.kineticIn);
        visit("kinetic_now", e.kineticNow);
        visit("dissipated", e.dissipated);
        visit("drift", e.drift);
        visit.added("effect_work", e.effectWork);
    }
};

template <>
struct Members<EffectReport> {
    template <class Visitor, class Value>
    static void each(Visitor& visit, Value& e) {
        visit("kind", e.decision.kind);
        visit("asked", e.decision.asked);
        visit("on", e.decision.on);
        visit("reason", e.decision.reason);
        visit("measure", e.decision.measure);
        visit("threshold", e.decision.threshold);
        visit("ms_per_step", e.msPerStep);
        visit("share", e.share);
        visit("work", e.work);
        visit("events", e.events);
    }
};

template <>
struct Members<HealthBreach> {
    template <class Visitor, class Value>
    static void each(Visitor& visit, Value& b) {
        visit("check", b.check);
        visit("from", b.from);
        visit("to", b.to);
        visit.added("worst_at", b.worstAt);
        visit("body", b.body);
        visit("place", b.place);
        visit("worst", b.worst);
        visit("limit", b.limit);
        visit("bodies", b.bodies);
        visit("what", b.what);
        visit("remedy", b.remedy);
    }
};

template <>
struct Members<HealthRemedy> {
    template <class Visitor, class Value>
    static void each(Visitor& visit, Value& r) {
        visit("from", r.from);
        visit("to", r.to);
        visit("steps", r.steps);
    }
};

template <>
struct Members<HealthReport> {
    template <class Visitor, class Value>
    static void each(Visitor& visit, Value& h) {
        visit("breaches", h.breaches);
        visit("remedies", h.remedies);
        visit("penetration_sustained", h.penetrationSustained);
        visit("penetration_share", h.penetrationShare);
        visit("crowd_share", h.crowdShare);
        visit("fastest_over_limit", h.fastestOverLimit);
        visit("farthest", h.farthest);
        visit("asleep_peak", h.asleepPeak);
        visit("contacts_peak", h.contactsPeak);
        visit("bodies_lost", h.bodiesLost);
    }
};

/// All but the outcomes of the fragments, which are a table.
template <>
struct Members<SimulationResult> {
    template <class Visitor, class Value>
    static void each(Visitor& visit, Value& r) {
        visit("bodies_peak", r.bodiesPeak);
        visit.added("awake_peak", r.awakePeak);
        visit("steps", r.steps);
        visit.added("substeps", r.substeps);
        visit("first_time", r.firstTime);
        visit("fe_end_time", r.feEndTime);
        visit("end_time", r.endTime);
        visit("step_times", r.stepTimes);
        visit("energy", r.energy);
        visit("ledger", r.ledger);
        visit("births", r.births);
        visit("islands", r.islands);
        visit.added("carried", r.carried);
        visit("penetration_max", r.penetrationMax);
        visit("asleep_at_end", r.asleepAtEnd);
        visit("still_moving", r.stillMoving);
        visit("max_speed", r.maxSpeed);
        visit("bulking_factor", r.bulkingFactor);
        visit("trajectory_hash", r.trajectoryHash);
        visit("findings", r.findings);
        visit.added("effects", r.effects);
        visit.added("health", r.health);
    }
};

template <>
struct Members<BasicGrid> {
    template <class Visitor, class Value>
    static void each(Visitor& visit, Value& g) {
        visit("l", g.l);
        visit("w", g.w);
        visit("h", g.h);
    }
};

template <>
struct Members<AxisSizing> {
    template <class Visitor, class Value>
    static void each(Visitor& visit, Value& a) {
        visit("mean_distance", a.meanDistance);
        visit("efficiency_min", a.efficiencyMin);
        visit("accuracy_min", a.accuracyMin);
        visit("accuracy_max", a.accuracyMax);
        visit("largest_fragment", a.largestFragment);
        visit("smallest_component", a.smallestComponent);
        visit("size", a.size);
        visit("multiple", a.multiple);
        visit("clamped_by", a.clampedBy);
    }
};

template <>
struct Members<Sizing> {
    template <class Visitor, class Value>
    static void each(Visitor& visit, Value& s) {
        visit("x", s.axis[0]);
        visit("y", s.axis[1]);
        visit("z", s.axis[2]);
        visit("grid", s.grid);
        visit("common_multiple", s.commonMultiple);
        visit("fragments", s.fragments);
        visit("bodies_max", s.bodiesMax);
        visit("fps_target", s.fpsTarget);
        visit("clusters", s.clusters);
        visit.added("awake_at_once", s.awake);
        visit("stopped_by", s.stoppedBy);
        visit("reachable_fps", s.reachableFps);
        visit("findings", s.findings);
    }
};

/// All but the clusters and their members, which are tables.
template <>
struct Members<Clustering> {
    template <class Visitor, class Value>
    static void each(Visitor& visit, Value& c) {
        visit("product_groups", c.productGroups);
        visit("split_by_component", c.splitByComponent);
        visit("split_by_velocity", c.splitByVelocity);
        visit("findings", c.findings);
    }
};

}  // namespace rubble::io
