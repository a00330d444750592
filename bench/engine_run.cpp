#include "bench/engine_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <numeric>

#include "core/engine/soft/lanes/soft_lanes.h"
#include "core/engine/soft/soft_contact.h"
#include "core/engine/soft/soft_solver.h"

namespace rubble::bench {

namespace {

constexpr double fasterAllowed = 1.03;
constexpr double risingAllowed = 3.0;  // m/s
constexpr double spreadShare = 0.95;

double processorSeconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double wallSeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// What a body was born with, and what it has done since.
struct Watched {
    double energy = 0.0;  ///< J/kg, v^2 / 2 + g z when it entered
    double rising = 0.0;  ///< m/s, upwards, when it entered
    bool tooFast = false;
    bool thrown = false;
};

/// Performs the calls of a scene and watches what comes of them.
class Player {
public:
    Player(const EngineScene& scene, RigidWorld& world) : m_scene(scene), m_world(world) {
        for (const EngineScene::Call& call : scene.calls) {
            m_bodiesToCome += std::holds_alternative<EngineScene::BodyEnters>(call);
        }
    }

    void play() {
        for (const EngineScene::Call& call : m_scene.calls) {
            std::visit([this](const auto& c) { perform(c); }, call);
        }
        if (m_stepsWatched > 0) {
            m_measure.pointsMean /= static_cast<double>(m_stepsWatched);
        }
        judge();
    }
    const EngineMeasure& measure() const { return m_measure; }

private:
    void perform(const EngineScene::BodyEnters& call) {
        m_world.addBody(call.body);
        m_bodies.push_back(&call.body);
        const double z = call.body.pose.position.z();
        m_watched.push_back({0.5 * call.body.velocity.squaredNorm() + m_scene.settings.gravity * z,
                             std::max(0.0, call.body.velocity.z()), false, false});
    }
    void perform(const EngineScene::BodyLeaves& call) { m_world.removeBody(call.body); }
    void perform(const EngineScene::PieceEnters& call) { m_world.addPiece(call.shape, call.pose, call.material); }
    void perform(const EngineScene::PieceLeaves& call) { m_world.removePiece(call.piece); }
    void perform(const EngineScene::PieceMoves& call) { m_world.movePiece(call.piece, call.pose); }
    void perform(const EngineScene::Substeps& call) { m_world.setSubsteps(call.count); }
    void perform(const EngineScene::Step& call) {
        const double processors = processorSeconds(), wall = wallSeconds();
        m_world.step(call.dt);
        const double took = processorSeconds() - processors;
        m_measure.processorSeconds += took;
        ++m_measure.steps;
        const ContactReport& contacts = m_world.contacts();
        if (!m_bodies.empty() && m_bodies.size() < m_bodiesToCome) {
            m_measure.birthSeconds += call.dt;
            m_measure.birthWallSeconds += wallSeconds() - wall;
            m_measure.birthProcessorSeconds += took;
            ++m_measure.birthSteps;
            m_measure.pointsMean += static_cast<double>(contacts.points);
            ++m_stepsWatched;
        }
        m_measure.pairsPeak = std::max(m_measure.pairsPeak, contacts.pairs);
        m_measure.pointsPeak = std::max(m_measure.pointsPeak, contacts.points);
        watch();
    }

    void watch() {
        for (std::size_t i = 0; i < m_bodies.size(); ++i) {
            const BodyId id = idAt<BodyId>(i);
            if (m_world.state(id) != BodyState::Awake) {
                continue;
            }
            const BodyMotion motion = m_world.motion(id);
            Watched& body = m_watched[i];
            const double allowed = 2.0 * (body.energy - m_scene.settings.gravity * motion.pose.position.z());
            body.tooFast |= motion.velocity.norm() > fasterAllowed * std::sqrt(std::max(0.0, allowed)) + 0.01;
            body.thrown |= motion.velocity.z() > risingAllowed && motion.velocity.z() > body.rising;
        }
    }

    void judge() {
        std::vector<OrientedBox> boxes;
        std::vector<std::size_t> owners;
        std::vector<std::pair<double, double>> ways;  // from the centre across, mass
        Vec3 centre = Vec3::Zero();
        double mass = 0.0;
        Hasher hasher;
        std::int64_t present = 0, resting = 0;
        for (std::size_t i = 0; i < m_bodies.size(); ++i) {
            const BodyId id = idAt<BodyId>(i);
            m_measure.tooFast += m_watched[i].tooFast;
            m_measure.thrown += m_watched[i].thrown;
            if (m_world.state(id) == BodyState::Removed) {
                continue;
            }
            ++present;
            resting += m_world.state(id) != BodyState::Awake;
            const Pose pose = m_world.motion(id).pose;
            for (const ConvexPart& part : m_bodies[i]->shape) {
                boxes.push_back({pose * part.box.centre, pose.orientation * part.box.orientation, part.box.halfExtents});
                owners.push_back(i);
            }
            centre += m_bodies[i]->mass * pose.position;
            mass += m_bodies[i]->mass;
            hasher.bytes(pose.position.data(), 3 * sizeof(double)).bytes(pose.orientation.coeffs().data(), 4 * sizeof(double));
        }
        m_measure.bodies = static_cast<std::int64_t>(m_bodies.size());
        m_measure.end = hasher.finish();
        if (present == 0) {
            return;
        }
        centre /= mass;
        for (std::size_t i = 0; i < m_bodies.size(); ++i) {
            if (const BodyId id = idAt<BodyId>(i); m_world.state(id) != BodyState::Removed) {
                ways.emplace_back((m_world.motion(id).pose.position - centre).head<2>().norm(), m_bodies[i]->mass);
            }
        }
        std::ranges::sort(ways);
        double within = 0.0;
        for (const auto& [way, weight] : ways) {
            within += weight;
            m_measure.spread = way;
            if (within >= spreadShare * mass) {
                break;
            }
        }
        m_measure.meanHeight = centre.z() - m_scene.settings.groundHeight;
        m_measure.asleep = static_cast<double>(resting) / static_cast<double>(present);
        m_measure.overlap = measureOverlap(boxes, owners);
    }

    const EngineScene& m_scene;
    RigidWorld& m_world;
    EngineMeasure m_measure;
    std::size_t m_bodiesToCome = 0;
    std::int64_t m_stepsWatched = 0;
    std::vector<const NewBody*> m_bodies;
    std::vector<Watched> m_watched;
};

}  // namespace

EngineMeasure measureEngine(const EngineScene& scene, const EngineFactory& makeEngine) {
    const std::unique_ptr<RigidWorld> world = makeEngine(scene.settings);
    Player player(scene, *world);
    player.play();
    return player.measure();
}

ContactBytes contactBytes() {
    constexpr std::size_t points = 4, lanes = solverLanes;
    ContactBytes bytes;
    bytes.found = sizeof(FoundContact);
    bytes.kept = 2 * SoftContact::bytes(points);
    bytes.record = sizeof(SolverContact);
    bytes.solving = (sizeof(LaneContacts) + points * sizeof(LanePoint)) / lanes;
    bytes.tally = (sizeof(LaneTally) + points * sizeof(LanePointTally)) / lanes;
    bytes.correction = (sizeof(LaneCorrection) + points * sizeof(LaneCorrectionPoint)) / lanes;
    return bytes;
}

}  // namespace rubble::bench
