#include "core/simulation/effects/ties.h"

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

/// Pa, of steel.
constexpr double youngsModulus = 200e9;
/// Passes over the taut ties in a substep at most. Fewer: chains bounce and give; more: slower.
constexpr int passes = 12;
/// m/s. No more passes once none changes the speed of a pair by more.
constexpr double settledSpeed = 1e-4;
/// Substeps in which the elastic stretch relaxes. Fewer: ties ring; more: they creep.
constexpr double relaxation = 4.0;
/// A frozen body is woken by a force above this share of its weight: less than the friction of any pair of materials holds.
constexpr double wakeShare = 0.3;
/// m. Ends closer than this have no direction.
constexpr double leastGap = 1e-9;

}  // namespace

/// A tie that pulls in this substep.
struct Ties::Taut {
    std::size_t tie = 0;
    MovingBody* a = nullptr;  ///< null: immovable
    MovingBody* b = nullptr;
    Vec3 armA = Vec3::Zero(), armB = Vec3::Zero();  ///< m, from the centres
    Vec3 velocityA = Vec3::Zero();                  ///< m/s, of what is immovable
    Vec3 velocityB = Vec3::Zero();
    Vec3 along = Vec3::Zero();  ///< from a to b
    double yielding = 0.0;      ///< 1/kg, velocity per impulse
    double softness = 0.0;      ///< 1/kg
    double bias = 0.0;          ///< m/s, at which the stretch is taken back
    double most = 0.0;          ///< N s
    double impulse = 0.0;

    Vec3 endVelocityA() const { return a != nullptr ? Vec3(a->velocity + a->spin.cross(armA)) : velocityA; }
    Vec3 endVelocityB() const { return b != nullptr ? Vec3(b->velocity + b->spin.cross(armB)) : velocityB; }
    double opening() const { return along.dot(endVelocityB() - endVelocityA()); }
    /// Pulls by an impulse and says what work that did, J.
    double apply(double change) {
        const double before = opening();
        if (a != nullptr) {
            a->velocity += a->inverseMass * change * along;
            a->spin += a->inverseInertia * armA.cross(change * along);
        }
        if (b != nullptr) {
            b->velocity -= b->inverseMass * change * along;
            b->spin -= b->inverseInertia * armB.cross(change * along);
        }
        return -change * before + 0.5 * change * change * yielding;
    }
};

Ties::Ties(const RunDescription& description, RigidWorld& world)
    : m_description(description),
      m_world(world),
      m_strength(description.scenario.effects.tieStrength),
      m_ratio(description.scenario.effects.tieRatio),
      m_elongation(description.scenario.effects.tieElongation),
      m_gravity(description.scenario.simulation.gravity),
      m_sites(findTieSites(description)),
      m_ends(m_sites.size()),
      m_sitesOf(description.clustering->list.size()) {
    for (std::size_t s = 0; s < m_sites.size(); ++s) {
        m_sitesOf[at(m_sites[s].first)].push_back(static_cast<std::uint32_t>(s));
        m_sitesOf[at(m_sites[s].second)].push_back(static_cast<std::uint32_t>(s));
    }
}

Ties::~Ties() = default;

void Ties::entered(std::span<const BodyRecord> bodies, RigidWorld& world) {
    for (const BodyRecord& record : bodies) {
        if (record.isIsland() || record.part || m_sitesOf[at(record.cluster)].empty()) {
            continue;
        }
        const Cluster& cluster = m_description.clustering->list[at(record.cluster)];
        const auto state = m_description.fe->state(cluster.handOverState);
        for (const std::uint32_t s : m_sitesOf[at(record.cluster)]) {
            const TieSite& site = m_sites[s];
            const Vec3 centre = site.centre(state->positions);
            const Vec3 inBody = record.inFe.orientation.conjugate() * (centre - record.inFe.position);
            Ends& ends = m_ends[s];
            const bool first = site.first == record.cluster;
            (first ? ends.first : ends.second) = static_cast<std::int64_t>(at(record.body));
            (first ? ends.onFirst : ends.onSecond) = inBody;
            if (ends.first >= 0 && ends.second >= 0) {
                form(site, ends, world);
            }
        }
    }
}

void Ties::form(const TieSite& site, const Ends& ends, const RigidWorld& world) {
    Tie tie;
    tie.a = idAt<BodyId>(static_cast<std::size_t>(ends.first));
    tie.b = idAt<BodyId>(static_cast<std::size_t>(ends.second));
    tie.onA = ends.onFirst;
    tie.onB = ends.onSecond;
    tie.yieldForce = m_ratio * site.area * m_strength;
    tie.stiffness = youngsModulus * m_ratio * site.area / site.length;
    tie.breakGap = m_elongation * site.length;
    tie.slackGap = (world.motion(tie.b).pose * tie.onB - world.motion(tie.a).pose * tie.onA).norm();
    // Whatever is no number is no tie either.
    if (tie.slackGap < tie.breakGap && tie.yieldForce > 0.0) {
        m_ties.push_back(tie);
    }
}

void Ties::leaving(BodyId body) {
    std::erase_if(m_ties, [&](const Tie& tie) { return tie.a == body || tie.b == body; });
    for (Ends& ends : m_ends) {
        for (std::int64_t* end : {&ends.first, &ends.second}) {
            if (*end == static_cast<std::int64_t>(at(body))) {
                *end = -1;
            }
        }
    }
}

bool Ties::stretch(Tie& tie, std::size_t index, const SubstepBodies& bodies, double h) {
    Taut taut;
    taut.tie = index;
    taut.a = bodies.find(tie.a);
    taut.b = bodies.find(tie.b);
    if (taut.a == nullptr && taut.b == nullptr) {
        tie.pull = Vec3::Zero();
        return true;
    }
    const auto place = [&](MovingBody* body, BodyId id, const Vec3& end, Vec3& arm, Vec3& velocity) {
        if (body != nullptr) {
            arm = body->orientation * end;
            return Vec3(body->position + arm);
        }
        const BodyMotion motion = m_world.motion(id);
        arm = motion.pose.orientation * end;
        velocity = motion.velocity + motion.angularVelocity.cross(arm);
        return Vec3(motion.pose.position + arm);
    };
    const Vec3 from = place(taut.a, tie.a, tie.onA, taut.armA, taut.velocityA);
    const Vec3 to = place(taut.b, tie.b, tie.onB, taut.armB, taut.velocityB);
    const double gap = (to - from).norm();
    if (!(gap <= tie.breakGap)) {
        return false;
    }
    // What the elastic stretch cannot be has yielded.
    tie.slackGap = std::max(tie.slackGap, gap - tie.yieldForce / tie.stiffness);
    // Ends that lie on each other are pulled against the way they would go.
    const Vec3 ahead = to - from + h * (taut.endVelocityB() - taut.endVelocityA());
    if (std::max(gap, ahead.norm()) <= std::max(tie.slackGap, leastGap)) {
        tie.pull = Vec3::Zero();
        return true;
    }
    taut.along = gap > leastGap ? Vec3((to - from) / gap) : ahead.normalized();
    for (const auto& [body, arm] : {std::pair{taut.a, &taut.armA}, std::pair{taut.b, &taut.armB}}) {
        if (body != nullptr) {
            const Vec3 lever = arm->cross(taut.along);
            taut.yielding += body->inverseMass + lever.dot(body->inverseInertia * lever);
        }
    }
    // Spring k and damper c, implicit: c = max(critical, relaxation h k).
    const double k = tie.stiffness;
    const double c = std::max(2.0 * std::sqrt(k / taut.yielding), relaxation * h * k);
    taut.softness = 1.0 / (h * (c + h * k));
    // What is still slack may open first.
    taut.bias = gap > tie.slackGap ? k / (c + h * k) * (gap - tie.slackGap) : (gap - tie.slackGap) / h;
    taut.most = tie.yieldForce * h;
    taut.impulse = std::clamp(tie.pull.dot(taut.along), 0.0, taut.most);
    m_work += taut.apply(taut.impulse);
    m_taut.push_back(taut);
    return true;
}

double Ties::pull(Taut& taut) {
    const double change = (taut.opening() + taut.bias - taut.softness * taut.impulse) / (taut.yielding + taut.softness);
    const double total = std::clamp(taut.impulse + change, 0.0, taut.most);
    const double given = total - taut.impulse;
    m_work += taut.apply(given);
    taut.impulse = total;
    return std::abs(given) * taut.yielding;
}

void Ties::beforeSubstep(const SubstepBodies& bodies, double h) {
    m_taut.clear();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < m_ties.size(); ++i) {
        if (stretch(m_ties[i], kept, bodies, h)) {
            m_ties[kept++] = m_ties[i];
        } else {
            ++m_broken;
        }
    }
    m_ties.resize(kept);
    // To and fro, so that a pull runs along a chain in one pass whichever way it was built.
    double changed = 1.0;
    for (int pass = 0; pass < passes && changed > settledSpeed; ++pass) {
        changed = 0.0;
        for (std::size_t i = 0; i < m_taut.size(); ++i) {
            changed = std::max(changed, pull(m_taut[pass % 2 == 0 ? i : m_taut.size() - 1 - i]));
        }
    }
    for (const Taut& taut : m_taut) {
        Tie& tie = m_ties[taut.tie];
        tie.pull = taut.impulse * taut.along;
        for (const auto& [body, id] : {std::pair{taut.a, tie.a}, std::pair{taut.b, tie.b}}) {
            if (body == nullptr && taut.impulse > wakeShare * m_world.mass(id) * m_gravity * h) {
                m_wake.push_back(id);
            }
        }
    }
}

void Ties::keep(Archive& archive) {
    archive(m_ends, m_ties, m_broken, m_work);
    if (m_ends.size() != m_sites.size()) {
        Archive::fail();
    }
}

void Ties::afterStep(RigidWorld& world, double) {
    std::sort(m_wake.begin(), m_wake.end());
    m_wake.erase(std::unique(m_wake.begin(), m_wake.end()), m_wake.end());
    for (const BodyId id : m_wake) {
        if (world.state(id) == BodyState::Frozen) {
            world.wake(id);
        }
    }
    m_wake.clear();
}

}  // namespace rubble
