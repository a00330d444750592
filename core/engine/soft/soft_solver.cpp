#include "core/engine/soft/soft_solver.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <numeric>

#include "core/base/same_bits.h"
#include "core/engine/soft/restitution.h"

namespace rubble {

namespace {

/// A load comes back in the next substep, a blow does not: what is new may grow by this factor from substep to substep. Lower:
/// slow under a pile that is lifted; higher: what was hit flies on.
constexpr double warmGrowth = 3.0;
/// Passes that take the push back. Fewer: piles creep and tremble, since what one contact leaves the others have to take; more:
/// slower.
constexpr int relaxPasses = 3;
/// Passes that bring overlap apart, then such that only keep others from being pressed together for it; both go on from what the
/// step before found. More of the first: it comes apart sooner; fewer of the second: piles are pressed into themselves and tremble.
/// A push has to get through a pile from body to body, so larger ones take more of the first, as the cube root of their contacts.
constexpr int fewestCorrectionPasses = 24, mostCorrectionPasses = 72;
constexpr double contactsOfFewest = 16000;
constexpr int holdPasses = 4;
/// Contacts that one thread takes at a time.
constexpr std::size_t grain = 96;
/// The same, side by side.
constexpr std::size_t laneGrain = 12;
/// Groups ahead of the one at hand that a loop over what contacts come from prefetches.
constexpr std::size_t madeAhead = 3;
/// Contacts that are worth a strip of their own.
constexpr std::size_t stripContacts = 512;
/// Steps on one thread after one in which the threads did not run at the same time.
constexpr int stepsAlone = 32;
/// Bodies that one thread takes at a time.
constexpr std::size_t bodyGrain = 512;
/// N s. No limit.
constexpr KeptNumber unlimited = std::numeric_limits<KeptNumber>::max();
int correctionPassesFor(std::size_t contacts) {
    const double wanted = fewestCorrectionPasses * cubeRootOf(static_cast<double>(contacts) / contactsOfFewest);
    return static_cast<int>(std::clamp<double>(wanted, fewestCorrectionPasses, mostCorrectionPasses));
}

}  // namespace

template <class Pass>
void SoftSolver::forEachWithWork(Pass pass) {
    m_pool.loop(m_withWork.size(), laneGrain, [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            pass(m_scene, m_withWork[i], m_withWork[i] + std::size_t{1});
        }
    });
}

/// Passes one after the other, colour by colour.
template <class Pass>
void SoftSolver::forEachColour(int passes, Pass pass) {
    if (m_strips.size() == 1) {
        for (int i = 0; i < passes; ++i) {
            for (const Colour& colour : m_strips[0].colours) {
                pass(i, m_scene, colour.first, colour.last);
            }
        }
        return;
    }
    for (Strip& strip : m_strips) {
        strip.border.restart();
        strip.done = 0;
    }
    if (!m_givenUp) {
        m_pool.together(m_strips.size(), [&](std::size_t strip) { solveStrip(m_strips[strip], passes, pass); });
    }
    // What is left where the threads gave up, in the order in which they would have done it.
    const std::size_t colours = m_strips[0].colours.size();
    for (std::size_t k = 0; m_givenUp && k < static_cast<std::size_t>(passes) * colours; ++k) {
        for (const Strip& strip : m_strips) {
            if (strip.done <= k) {
                pass(static_cast<int>(k / colours), m_scene, strip.colours[k % colours].first, strip.colours[k % colours].last);
            }
        }
    }
}

/// Passes after each of which the copies of split bodies are joined.
template <class Pass, class Join>
void SoftSolver::forEachPass(int passes, Pass pass, Join join) {
    if (split.empty()) {
        forEachColour(passes, pass);
        return;
    }
    for (int i = 0; i < passes; ++i) {
        forEachColour(1, [&](int, const LaneScene& scene, std::size_t first, std::size_t last) { pass(i, scene, first, last); });
        join();
    }
}

/// Within a colour what lies at the border of a strip goes first: others wait for it with their next colour, and what lies inside
/// gives it time to get there.
template <class Pass>
void SoftSolver::solveStrip(Strip& own, int passes, Pass pass) {
    Patience patience(m_givenUp);
    std::uint32_t met = 0;
    for (int i = 0; i < passes; ++i) {
        for (const Colour& colour : own.colours) {
            const bool atBorder = colour.inside > colour.first;
            const auto isThere = [&](const Strip& other) { return patience.await(other.border, met); };
            if (patience.givenUp() || (atBorder && !std::ranges::all_of(m_strips, isThere))) {
                return;
            }
            pass(i, m_scene, colour.first, colour.inside);
            if (colour.meets) {
                own.border.pass(++met);
            }
            pass(i, m_scene, colour.inside, colour.last);
            ++own.done;
        }
    }
}

/// One for a while, where the threads did not run at the same time: who waits for a thread whose core others have waits in every
/// loop anew, so all loops are this thread's alone as long.
std::size_t SoftSolver::stripCount() {
    m_alone = m_givenUp.exchange(false) ? stepsAlone : std::max(0, m_alone - 1);
    m_pool.workAlone(m_alone > 0);
    return m_alone > 0 ? 1 : std::clamp<std::size_t>(contacts.size() / stripContacts, 1, m_pool.threads());
}

void SoftSolver::layOut(double h, const Source& source, const Shown& made) {
    m_source = source;
    arrange();
    m_scene.contacts = m_lanes.data();
    m_scene.tallies = m_tallies.data();
    m_acts.assign(m_groups.size(), 1);
    m_scene.acts = m_acts.data();
    m_scene.points = m_lanePoints.data();
    m_scene.pointTallies = m_pointTallies.data();
    m_scene.works = m_laneWorks.data();
    m_scene.h = h;
    m_pool.loop(m_lanes.size(), laneGrain, [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            prefetchGroup(i + madeAhead);
            fillLanes(i, made);
            m_passes.prepare(m_scene, i, i + 1);
        }
    });
    m_withWork.clear();
    for (std::uint32_t i = 0; i < m_groups.size(); ++i) {
        if (m_lanes[i].countsWork) {
            m_withWork.push_back(i);
        }
    }
}

void SoftSolver::prefetchGroup(std::size_t group) const {
    if (group < m_groups.size()) {
        std::for_each_n(m_groups[group].found, m_groups[group].count, m_source.prefetch);
    }
}

/// Contacts of a strip after those of the strip before, by colours, at the border before inside, those between two that move before
/// those with what does not, those with as many points side by side; within a colour the order does not matter.
void SoftSolver::arrange() {
    const std::size_t colours = firstOfGroup.size() - 1;
    const std::size_t loose = lastInOrder ? firstOfGroup[colours - 1] : contacts.size();
    const std::size_t strips = stripCount();
    cutIntoStrips(contacts, m_movable, strips, loose, m_cut);
    m_strips = std::vector<Strip>(strips);

    constexpr std::size_t counts = 4, idle = counts, still = 2 * counts, half = 4 * counts, sections = 2 * half;
    std::vector<std::uint32_t> keys(contacts.size());
    std::vector<std::uint32_t> first(strips * colours * sections + 1, 0);
    for (std::size_t colour = 0; colour < colours; ++colour) {
        for (std::size_t i = firstOfGroup[colour]; i < firstOfGroup[colour + 1]; ++i) {
            const SolverContact& c = contacts[i];
            const std::size_t section = (m_cut.border[i] != 0 ? 0 : half) + (c.a >= m_movable || c.b >= m_movable ? still : 0) +
                                        (c.idle ? idle : 0) + counts - c.points;
            keys[i] = static_cast<std::uint32_t>((m_cut.strip[i] * colours + colour) * sections + (i < loose ? section : 0));
            ++first[keys[i] + 1];
        }
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::uint32_t> order(contacts.size());
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    for (std::uint32_t i = 0; i < contacts.size(); ++i) {
        order[next[keys[i]]++] = i;
    }

    m_groups.clear();
    std::vector<char> meets(colours, 0);
    const auto put = [&](std::size_t from, std::size_t to) {
        const std::size_t begin = m_groups.size();
        for (std::size_t k = from; k < to; ++k) {
            const std::uint32_t contact = order[k];
            if (m_groups.size() == begin || m_groups.back().count == solverLanes || contact >= loose) {
                m_groups.emplace_back();
            }
            Group& lanes = m_groups.back();
            lanes.found[lanes.count++] = contact;
            lanes.points = std::max(lanes.points, contacts[contact].points);
        }
    };
    for (std::size_t part = 0; part < strips * colours; ++part) {
        const std::uint32_t* section = &first[part * sections];
        Colour colour{m_groups.size(), 0, 0};
        put(section[0], section[half]);
        colour.inside = m_groups.size();
        put(section[half], section[sections]);
        colour.last = m_groups.size();
        meets[part % colours] |= colour.inside > colour.first;
        m_strips[part / colours].colours.push_back(colour);
    }
    for (Strip& strip : m_strips) {
        for (std::size_t colour = 0; colour < colours; ++colour) {
            strip.colours[colour].meets = meets[colour] != 0;
        }
    }
    std::uint32_t point = 0;
    for (Group& group : m_groups) {
        group.firstPoint = point;
        point += group.points;
    }

    m_lanes.resize(m_groups.size());
    m_tallies.resize(m_groups.size());
    m_lanePoints.resize(point);
    m_pointTallies.resize(point);
    m_laneWorks.resize(point);
    m_correctionPoints.resize(point);
    m_laneCorrections.resize(m_groups.size());
}

namespace {

void setLane(KeptLaneVector& to, std::size_t lane, const Vec3& v) {
    to.x[lane] = static_cast<KeptNumber>(v.x());
    to.y[lane] = static_cast<KeptNumber>(v.y());
    to.z[lane] = static_cast<KeptNumber>(v.z());
}

void setLane(KeptLaneTensor& to, std::size_t lane, const KeptNumber (&t)[6]) {
    to.xx[lane] = t[0];
    to.yy[lane] = t[1];
    to.zz[lane] = t[2];
    to.xy[lane] = t[3];
    to.xz[lane] = t[4];
    to.yz[lane] = t[5];
}

void setLane(LanePoint& to, LanePointTally& tally, std::size_t lane, const SolverPoint& p) {
    setLane(to.fromA, lane, p.fromA);
    setLane(to.fromB, lane, p.fromB);
    tally.separation[lane] = to.now[lane] = static_cast<KeptNumber>(p.separation);
    to.normalMass[lane] = 1;
    to.normalImpulse[lane] = p.impulses.normal;
    tally.before[lane] = static_cast<KeptNumber>(p.impulses.normal);
    for (int t = 0; t < 2; ++t) {
        to.tangentImpulse[t][lane] = p.impulses.tangent[t];
    }
}

}  // namespace

void SoftSolver::fillLanes(std::size_t at, const Shown& made) {
    const Group& group = m_groups[at];
    LaneContacts& lanes = m_lanes[at];
    LaneTally& tally = m_tallies[at];
    const std::uint32_t count = group.count, first = group.firstPoint, most = group.points;
    lanes = LaneContacts{};
    tally = LaneTally{};
    lanes.firstPoint = first;
    lanes.points = most;
    const auto still = static_cast<std::uint32_t>(m_massProperties.size() - 1);
    for (std::uint32_t i = count; i < solverLanes; ++i) {
        lanes.a[i] = lanes.b[i] = still;
    }
    lanes.allMove = count == solverLanes;
    std::fill_n(m_lanePoints.begin() + first, most, LanePoint{});
    std::fill_n(m_pointTallies.begin() + first, most, LanePointTally{});
    for (std::uint32_t k = 0; k < most; ++k) {
        m_correctionPoints[first + k].push = {};
    }
    ContactConstraint c;
    for (std::uint32_t lane = 0; lane < count; ++lane) {
        m_source.make(group.found[lane], c);
        made(group.found[lane], c);
        const auto [copyA, copyB] = endsOf(group.found[lane]);
        const MassProperties& a = m_massProperties[copyA];
        const MassProperties& b = m_massProperties[copyB];
        lanes.a[lane] = copyA;
        lanes.b[lane] = copyB;
        lanes.allMove = lanes.allMove && copyA < m_scene.movable && copyB < m_scene.movable;
        setLane(lanes.normal, lane, c.normal);
        setLane(lanes.tangent, lane, c.tangent[0]);
        setLane(lanes.inverseInertiaA, lane, a.inverseInertia);
        setLane(lanes.inverseInertiaB, lane, b.inverseInertia);
        lanes.friction[lane] = static_cast<KeptNumber>(c.friction);
        lanes.inverseMassA[lane] = a.inverseMass;
        lanes.inverseMassB[lane] = b.inverseMass;
        lanes.impulseLimit[lane] = c.impulseLimit < 0.0 ? unlimited : static_cast<KeptNumber>(c.impulseLimit);
        tally.weight[lane] = static_cast<KeptNumber>(c.weight);
        tally.frequency[lane] = static_cast<KeptNumber>(c.frequency);
        tally.sinkAllowed[lane] = static_cast<KeptNumber>(c.sinkAllowed);
        tally.correction[lane] = static_cast<KeptNumber>(c.correction);
        tally.lift[lane] = static_cast<KeptNumber>(c.lift);
        tally.workShare[lane] = c.countsWork ? 1 : 0;
        tally.drivenByA[lane] = c.driven && a.inverseMass == 0.0 ? 1 : 0;
        tally.drivenByB[lane] = c.driven && a.inverseMass != 0.0 ? 1 : 0;
        lanes.countsWork = lanes.countsWork || c.countsWork || c.driven;
        for (std::uint32_t k = 0; k < contacts[group.found[lane]].points; ++k) {
            setLane(m_lanePoints[first + k], m_pointTallies[first + k], lane, c.points[k]);
            m_correctionPoints[first + k].push[lane] = static_cast<KeptNumber>(c.points[k].impulses.push);
        }
    }
}

void SoftSolver::resizeBodies(std::size_t count) {
    bodies.resize(count);
    m_lanePoses.resize(count, {{}, {0.0, 0.0, 0.0, 1.0}});
}

void SoftSolver::place(std::size_t body, const Pose& pose) {
    for (int k = 0; k < 3; ++k) {
        m_lanePoses[body].position[k] = pose.position[k];
    }
    for (int k = 0; k < 4; ++k) {
        m_lanePoses[body].orientation[k] = pose.orientation.coeffs()[k];
    }
}

std::pair<std::uint32_t, std::uint32_t> SoftSolver::endsOf(std::size_t contact) const {
    return copies.empty() ? std::pair{contacts[contact].a, contacts[contact].b} : copies[contact];
}

void SoftSolver::begin(std::size_t movable) {
    m_movable = movable;
    m_added = 0;
    m_copiesOf.assign(split.empty() ? 0 : movable, 1);
    for (const SplitBody& body : split) {
        m_added += body.copies - 1;
        m_copiesOf[body.slot] = body.copies;
    }
    const std::size_t count = bodies.size() + m_added;
    m_scene.movable = static_cast<std::uint32_t>(movable) + m_added;
    m_massProperties.resize(count);
    m_laneBodies.resize(count);
    m_laneTravel.resize(count);
    m_laneSolids.resize(count);
    m_lanePoses.resize(count, {{}, {0.0, 0.0, 0.0, 1.0}});
    m_scene.bodies = m_laneBodies.data();
    m_scene.travel = m_laneTravel.data();
    m_scene.poses = m_lanePoses.data();
    m_scene.solids = m_laneSolids.data();
    m_pool.loop(bodies.size(), bodyGrain, [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            const SolverBody& body = bodies[i];
            const std::size_t at = i < movable ? i : i + m_added;
            const double share = isSplit(static_cast<std::uint32_t>(i)) ? m_copiesOf[i] : 1.0;
            const Mat3 t = share * body.inverseInertia;
            m_massProperties[at] = {
                share * body.inverseMass,
                {static_cast<KeptNumber>(t(0, 0)), static_cast<KeptNumber>(t(1, 1)), static_cast<KeptNumber>(t(2, 2)),
                 static_cast<KeptNumber>(t(0, 1)), static_cast<KeptNumber>(t(0, 2)), static_cast<KeptNumber>(t(1, 2))}};
            m_laneBodies[at] = {{body.velocity.x(), body.velocity.y(), body.velocity.z(), 0.0},
                                {body.spin.x(), body.spin.y(), body.spin.z(), 0.0}};
            m_laneTravel[at] = {};
            for (int k = 0; k < 3; ++k) {
                m_laneSolids[at].inertia[k] = body.inertia[k];
            }
            m_laneSolids[at].inertia[3] = body.radius;
            m_laneSolids[at].limit[0] = body.fastest;
        }
    });
    forEachCopy(split, [&](std::size_t body, std::size_t copy) {
        m_massProperties[copy] = m_massProperties[body];
        m_laneSolids[copy] = m_laneSolids[body];
    });
    shareOut();
}

/// What moves by itself, or was told to, moves as a whole: copies take it over.
void SoftSolver::shareOut() {
    forEachCopy(split, [&](std::size_t body, std::size_t copy) {
        m_laneBodies[copy] = m_laneBodies[body];
        m_laneTravel[copy] = m_laneTravel[body];
    });
}

void SoftSolver::bound(std::size_t body, double fastest) {
    bodies[body].fastest = m_laneSolids[body].limit[0] = fastest;
}

Pose SoftSolver::poseOf(std::size_t body) const {
    const LanePose& pose = m_lanePoses[body];
    return {Vec3(pose.position), Quat(pose.orientation)};
}

SolverMotion SoftSolver::motion(std::size_t body) const {
    const LaneBody& lane = m_laneBodies[body];
    return {poseOf(body), Vec3(lane.velocity), Vec3(lane.spin)};
}

void SoftSolver::setVelocity(std::size_t body, const Vec3& velocity, const Vec3& spin) {
    for (int k = 0; k < 3; ++k) {
        m_laneBodies[body].velocity[k] = velocity[k];
        m_laneBodies[body].spin[k] = spin[k];
    }
}

void SoftSolver::applyGravity(double speed) {
    m_pool.loop(m_movable, bodyGrain, [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            m_laneBodies[i].velocity[2] -= speed;
            m_laneBodies[i].velocity[3] = 0.0;
        }
    });
    shareOut();
}

std::int64_t SoftSolver::move(double gravity) {
    std::atomic<std::int64_t> held = 0;
    m_pool.loop(m_movable, bodyGrain, [&](std::size_t from, std::size_t to) { held += m_passes.move(m_scene, from, to, gravity); });
    shareOut();
    for (std::size_t i = m_scene.movable; i < m_laneBodies.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
            m_laneTravel[i].moved[k] += m_scene.h * m_laneBodies[i].velocity[k];
            m_laneTravel[i].turned[k] += m_scene.h * m_laneBodies[i].spin[k];
        }
    }
    return held;
}

void SoftSolver::end() {
    m_pool.loop(m_movable, bodyGrain, [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            const LaneBody& lane = m_laneBodies[i];
            SolverBody& body = bodies[i];
            body.velocity = Vec3(lane.velocity);
            body.spin = Vec3(lane.spin);
            body.moved = Vec3(m_laneTravel[i].moved);
            body.turned = Vec3(m_laneTravel[i].turned);
            body.active = m_laneTravel[i].moved[3] > 0.0 || m_laneBodies[i].velocity[3] > 0.0;
        }
    });
}

void SoftSolver::solveSoft(double push) {
    forEachWithWork(m_passes.noteOpening);
    forEachPass(
        2,
        [&](int pass, const LaneScene& scene, std::size_t first, std::size_t last) {
            if (pass == 0) {
                m_passes.warmStart(scene, first, last, warmGrowth);
            } else {
                m_passes.soft(scene, first, last, push);
            }
        },
        [&] { joinVelocities(split, m_laneBodies); });
}

void SoftSolver::relax() {
    forEachPass(
        relaxPasses,
        [&](int pass, const LaneScene& scene, std::size_t first, std::size_t last) {
            m_passes.relax(scene, first, last, pass == 0, pass + 1 == relaxPasses);
        },
        [&] { joinVelocities(split, m_laneBodies); });
}

void SoftSolver::accumulateWork() {
    forEachWithWork(m_passes.accumulateWork);
}

bool SoftSolver::correctPositions() {
    const auto comesApart = [](const LaneTally& tally) {
        return std::any_of(tally.correction.at, tally.correction.at + solverLanes, [](KeptNumber x) { return x > 0; });
    };
    if (std::ranges::none_of(m_tallies, comesApart)) {
        for (LaneCorrectionPoint& point : m_correctionPoints) {
            point.push = {};
        }
        return false;
    }
    m_corrections.assign(m_laneBodies.size(), LaneWay{});
    m_scene.corrected = m_corrections.data();
    m_scene.corrections = m_laneCorrections.data();
    m_scene.correctionPoints = m_correctionPoints.data();
    const int correctionPasses = correctionPassesFor(contacts.size());
    const auto correct = [&](int pass, const LaneScene& scene, std::size_t first, std::size_t last) {
        if (pass == 0) {
            m_passes.startCorrection(scene, first, last);
        } else {
            m_passes.correct(scene, first, last, pass > correctionPasses);
        }
    };
    forEachPass(1 + correctionPasses + holdPasses, correct, [&] { joinWays(split, m_corrections); });
    return true;
}

SolverWay SoftSolver::correctionOf(std::size_t body) const {
    const LaneWay& way = m_corrections[body];
    return {Vec3(way.moved[0], way.moved[1], way.moved[2]), Vec3(way.turned[0], way.turned[1], way.turned[2])};
}

PointImpulses SoftSolver::impulsesOf(std::size_t point, std::size_t lane) const {
    const LanePoint& p = m_lanePoints[point];
    const LanePointTally& tally = m_pointTallies[point];
    return {p.normalImpulse[lane],
            {p.tangentImpulse[0][lane], p.tangentImpulse[1][lane]},
            m_correctionPoints[point].push[lane],
            tally.largestImpulse[lane],
            tally.impulseSum[lane]};
}

void SoftSolver::takeBack(const std::function<void(std::uint32_t contact, const ContactOutcome& outcome)>& take) const {
    m_pool.loop(m_groups.size(), laneGrain, [&](std::size_t from, std::size_t to) {
        ContactOutcome outcome;
        for (std::size_t i = from; i < to; ++i) {
            prefetchGroup(i + madeAhead);
            const Group& group = m_groups[i];
            const LaneTally& tally = m_tallies[i];
            for (std::uint32_t lane = 0; lane < group.count; ++lane) {
                outcome.work = tally.work[lane];
                outcome.corrected = tally.correction[lane] > 0;
                outcome.countsWork = tally.workShare[lane] > 0;
                outcome.driven = tally.drivenByA[lane] > 0 || tally.drivenByB[lane] > 0;
                for (std::uint32_t n = 0; n < contacts[group.found[lane]].points; ++n) {
                    outcome.points[n] = impulsesOf(group.firstPoint + n, lane);
                }
                take(group.found[lane], outcome);
            }
        }
    });
}

void SoftSolver::giveBack(const Hit& hit, double threshold, bool friction) {
    const SolverContact& contact = contacts[hit.contact];
    const std::size_t first = m_groups[hit.group].firstPoint;
    ContactConstraint c;
    m_source.make(hit.contact, c);
    std::array<BouncePoint, 4> points;
    for (std::uint32_t n = 0; n < contact.points; ++n) {
        points[n] = {c.points[n].fromA, c.points[n].fromB, m_lanePoints[first + n].normalMass[hit.lane],
                     m_pointTallies[first + n].approach[hit.lane], impulsesOf(first + n, hit.lane)};
    }
    restituteContact(c, std::span(points).first(contact.points), bodies[contact.a], bodies[contact.b], threshold, friction);
    for (std::uint32_t n = 0; n < contact.points; ++n) {
        m_lanePoints[first + n].normalImpulse[hit.lane] = points[n].impulses.normal;
        m_pointTallies[first + n].impulseSum[hit.lane] = points[n].impulses.sum;
    }
}

void SoftSolver::restitute(double threshold, bool friction) {
    std::vector<Hit> hits;
    for (std::uint32_t group = 0; group < m_groups.size(); ++group) {
        for (std::uint32_t lane = 0; lane < m_groups[group].count; ++lane) {
            if (m_tallies[group].fastest[lane] >= threshold) {
                hits.push_back({m_groups[group].found[lane], group, lane});
            }
        }
    }
    // Contacts lie by colours.
    std::ranges::sort(hits, {}, &Hit::contact);
    const auto give = [&](const Hit& hit) { giveBack(hit, threshold, friction); };
    std::vector<Hit> ofWhole, ofSplit;
    auto next = hits.begin();
    for (std::size_t group = 0; group + 1 < firstOfGroup.size(); ++group) {
        ofWhole.clear();
        ofSplit.clear();
        for (; next != hits.end() && next->contact < firstOfGroup[group + 1]; ++next) {
            const SolverContact& contact = contacts[next->contact];
            (isSplit(contact.a) || isSplit(contact.b) ? ofSplit : ofWhole).push_back(*next);
        }
        const bool inOrder = lastInOrder && group + 2 == firstOfGroup.size();
        m_pool.loop(ofWhole.size(), inOrder ? ofWhole.size() : grain, [&](std::size_t from, std::size_t to) {
            std::for_each(ofWhole.begin() + static_cast<std::ptrdiff_t>(from), ofWhole.begin() + static_cast<std::ptrdiff_t>(to),
                          give);
        });
        // Here a body is one again.
        std::ranges::for_each(ofSplit, give);
    }
}

}  // namespace rubble
