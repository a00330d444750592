#include "tests/io/sample_run.h"

#include <cstring>
#include <limits>

namespace rubble::io {

namespace {

class Dice {
public:
    explicit Dice(std::uint32_t seed) : m_engine(seed) {}
    double number(double low = -1.0, double high = 1.0) { return std::uniform_real_distribution<double>(low, high)(m_engine); }
    std::uint32_t upTo(std::uint32_t limit) { return std::uniform_int_distribution<std::uint32_t>(0, limit)(m_engine); }
    Vec3 vector(double scale = 1.0) { return scale * Vec3(number(), number(), number()); }
    Quat rotation() { return Quat(number(0.1, 1.0), number(), number(), number()).normalized(); }
    Pose pose() { return {vector(100.0), rotation()}; }
    Mat3 tensor() {
        const Mat3 m = Mat3::Random();
        return m * m.transpose();
    }
    Momenta momenta() { return {number(0, 1e6), vector(1e6), vector(1e8), number(0, 1e9)}; }

private:
    std::mt19937 m_engine;
};

Finding finding(const char* id) {
    return {Message{id, "Element {0} of {1} is {2} thin", {std::int64_t{17233}, "deck \xC3\xA4", Argument(0.25, "m")}},
            Message{std::string(id) + ".remedy", "Look at it", {}}, 3, "element 17,233"};
}

Findings findingsWith(const char* id) {
    Findings findings;
    const Finding f = finding(id);
    findings.add(f.what, f.remedy, f.example, f.count);
    return findings;
}

// Hexahedra, wedges, pyramids and tetrahedra in turn, around random places.
void addFragment(FragmentSet& set, Dice& dice, std::size_t index) {
    static constexpr ElementShape shapes[] = {ElementShape::Hexahedron, ElementShape::Wedge, ElementShape::Pyramid,
                                              ElementShape::Tetrahedron};
    static constexpr double cube[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                          {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
    const ElementShape shape = shapes[index % 4];
    Fragment f;
    f.element = idAt<ElementIndex>(index);
    f.component = idAt<ComponentId>(index % 3);
    f.handOverState = static_cast<std::uint32_t>(index % 5);
    f.birthState = f.handOverState + 1;
    f.handOverTime = 0.1 * f.handOverState;
    f.birthTime = 0.1 * f.birthState;
    f.endTime = std::numeric_limits<double>::infinity();
    f.mass = dice.number(100, 5000);
    f.centre = dice.vector(50);
    f.inertia = dice.tensor();
    f.velocity = dice.vector(20);
    f.angularVelocity = dice.vector();
    f.box = {f.centre, dice.rotation(), Vec3(1, 1, 1)};
    f.bounds = Aabb(f.centre - Vec3::Ones(), f.centre + Vec3::Ones());
    f.fe = dice.momenta();
    set.list.push_back(f);
    set.solid.push_back(shape);
    set.vertexOffsets.push_back(static_cast<std::uint32_t>(set.vertices.size()));
    for (int corner = 0; corner < cornerCount(shape); ++corner) {
        set.vertices.push_back(f.centre + Vec3(cube[corner][0], cube[corner][1], cube[corner][2]));
    }
}

void makeScene(SampleRun& run, Dice& dice, std::size_t clusterCount) {
    auto fragments = std::make_shared<FragmentSet>();
    auto clustering = std::make_shared<Clustering>();
    auto components = std::make_shared<Components>();
    for (const char* name : {"deck 1", "arch ring 1, failing strip", "pfeiler \xC3\xBC"}) {
        components->list.emplace_back().name = name;
    }
    for (std::size_t c = 0; c < clusterCount; ++c) {
        Cluster cluster;
        cluster.firstMember = static_cast<std::uint32_t>(clustering->members.size());
        cluster.memberCount = 1 + dice.upTo(3);
        for (std::uint32_t m = 0; m < cluster.memberCount; ++m) {
            clustering->members.push_back(idAt<FragmentId>(fragments->size()));
            clustering->of.push_back(idAt<ClusterId>(c));
            addFragment(*fragments, dice, fragments->size());
        }
        cluster.component = fragments->list.back().component;
        cluster.endTime = std::numeric_limits<double>::infinity();
        cluster.mass = dice.number(0, 1e5);
        cluster.centre = dice.vector(50);
        cluster.inertia = dice.tensor();
        cluster.velocity = dice.vector();
        cluster.angularVelocity = dice.vector();
        clustering->list.push_back(cluster);
    }
    fragments->vertexOffsets.push_back(static_cast<std::uint32_t>(fragments->vertices.size()));
    fragments->findings = findingsWith("test.fragments");
    clustering->productGroups = clusterCount / 2;
    clustering->splitByVelocity = 7;
    clustering->findings = findingsWith("test.clusters");
    auto sizing = std::make_shared<Sizing>();
    sizing->axis[0].meanDistance = 1.0 / 3.0;
    sizing->axis[1].largestFragment = idAt<FragmentId>(2);
    sizing->axis[1].accuracyMax = std::numeric_limits<double>::infinity();
    sizing->axis[2].clampedBy = ClampedBy::ComponentSize;
    sizing->grid = {1.1, 2.2, 3.3};
    sizing->clusters = clusterCount;
    sizing->awake = clusterCount / 2;
    sizing->bodiesMax = 4500;
    sizing->stoppedBy = StoppedBy::FpsUnreachable;
    run.description.fragments = fragments;
    run.description.clustering = clustering;
    run.description.components = components;
    run.description.sizing = sizing;
}

void makeBodies(SampleRun& run, Dice& dice) {
    const Clustering& clustering = *run.description.clustering;
    run.firstBatch = clustering.list.size() / 2;
    for (std::size_t c = 0; c < clustering.list.size(); ++c) {
        const double from = c < run.firstBatch ? 0.0 : 0.05;
        run.bodies.push_back({idAt<BodyId>(c),
                              idAt<ClusterId>(c),
                              from,
                              std::numeric_limits<double>::infinity(),
                              clustering.list[c].mass,
                              dice.pose(),
                              {},
                              false});
        for (const FragmentId f : clustering.membersOf(idAt<ClusterId>(c))) {
            run.carriers.push_back({f, idAt<BodyId>(c), from, std::numeric_limits<double>::infinity(), dice.pose()});
        }
        if (c + 1 == run.firstBatch) {
            run.firstCarriers = run.carriers.size();
        }
    }
}

void makeIslands(SampleRun& run, Dice& dice) {
    if (run.bodies.empty()) {
        return;
    }
    run.islands.push_back(
        {run.bodies.front().body, 2, dice.pose(), {idAt<ElementIndex>(3), idAt<ElementIndex>(5), idAt<ElementIndex>(8)}});
    run.islands.push_back({run.bodies.back().body, atLastState, dice.pose(), {idAt<ElementIndex>(4)}});
    for (std::uint32_t k = 3; k < 6; ++k) {
        run.islandLosses.push_back({0.1 * k, k, dice.momenta(), dice.momenta(), dice.momenta()});
    }
    run.islandLedger.time = 0.05;
    run.islandLedger.fe = dice.momenta();
    run.islandLedger.bodies = dice.momenta();
}

TrajectoryFrame makeFrame(Dice& dice, double time, std::size_t bodies) {
    TrajectoryFrame frame;
    frame.time = time;
    frame.kind = dice.upTo(3) == 0 ? FrameKind::Fe : FrameKind::Simulated;
    for (std::size_t b = 0; b < bodies; ++b) {
        frame.positions.push_back(dice.vector(100).cast<float>());
        frame.orientations.push_back(dice.rotation().cast<float>());
        frame.speeds.push_back(static_cast<float>(dice.number(0, 30)));
        frame.states.push_back(static_cast<BodyState>(1 + dice.upTo(2)));
    }
    return frame;
}

void makeEffects(SimulationResult& result) {
    for (std::size_t i = 0; i < effectCount; ++i) {
        const double number = static_cast<double>(i);
        EffectReport report;
        report.decision = {static_cast<EffectKind>(i),
                           static_cast<EffectSwitch>(i % 3),
                           i % 2 == 0,
                           finding("test.effect").what,
                           17.0 / 3.0 + number,
                           i == 0 ? std::numeric_limits<double>::quiet_NaN() : number};
        report.msPerStep = 0.1 * number;
        report.share = 0.01 * number;
        report.work = -1e6 / 3.0;
        report.events = static_cast<std::int64_t>(i);
        result.effects.push_back(report);
    }
}

void makeHealth(SimulationResult& result, Dice& dice) {
    HealthReport& health = result.health;
    for (std::size_t i = 0; i < healthCheckCount; ++i) {
        HealthBreach breach;
        breach.check = static_cast<HealthCheck>(i);
        breach.from = dice.number(0, 10);
        breach.to = breach.from + 0.1;
        breach.worstAt = breach.from + 0.05;
        breach.worst = i == 5 ? std::numeric_limits<double>::quiet_NaN() : dice.number();
        breach.limit = dice.number();
        breach.bodies = static_cast<std::int64_t>(i);
        if (i % 2 == 0) {
            breach.body = idAt<BodyId>(i);
            breach.place = dice.vector(100.0);
        }
        breach.what = finding("test.breach").what;
        breach.remedy = finding("test.breach").remedy;
        health.breaches.push_back(breach);
    }
    health.remedies = {{1.0 / 3.0, 2.0, 60}, {3.0, 3.5, 30}};
    health.penetrationSustained = dice.number();
    health.penetrationShare = dice.number();
    health.crowdShare = dice.number();
    health.fastestOverLimit = dice.number();
    health.farthest = dice.number();
    health.asleepPeak = dice.number();
    health.contactsPeak = 12345;
    health.bodiesLost = 2;
}

void makeResult(SampleRun& run, Dice& dice) {
    for (std::size_t f = 0; f < run.description.fragments->size(); ++f) {
        run.result.fragments.push_back({dice.vector(50), dice.number(0, 30), dice.vector(50), dice.number(0, 30)});
    }
    run.result.bodiesPeak = static_cast<std::int64_t>(run.bodies.size());
    run.result.steps = 4711;
    run.result.firstTime = 1.0 / 3.0;
    run.result.endTime = 19.68;
    run.result.stepTimes = {1.5, 2.5, 17.25, 0.99, 1.7, 1.6, 0.25, 0.125, 0.0625, 0.03125, 0.5, 0.75};
    run.result.energy = {1e9 / 3, 2e8, 3e5, 9e8, 1e-12};
    run.result.ledger = {1e-16, 2e-16, 3e-16, 4e-16, 5e-16, 6e-16};
    run.result.births = {4500, 900, 410, 0.31, 77, 1e6, -2e3, 12};
    run.result.islands = {3, 41, 1e5, 2, 2, 40, 9e4, 1, 1, 1, 1e3, {1e-15, 2e-15, 3e-15, 4e-15, 5e-15, 6e-15}};
    run.result.carried = {7,
                          900,
                          3e5,
                          1,
                          60,
                          800,
                          2.5e5,
                          1e4,
                          2e3,
                          2,
                          5e4,
                          1,
                          2e3,
                          {1e-15, 2e-15, 3e-15, 4e-15, 5e-15, 6e-15},
                          {0, 0, 0, 7e-15, 8e-15, 9e-15}};
    run.result.penetrationMax = 0.123456789012345;
    run.result.asleepAtEnd = 0.875;
    run.result.stillMoving = 5;
    run.result.maxSpeed = 28.7;
    run.result.bulkingFactor = std::numeric_limits<double>::quiet_NaN();
    run.result.trajectoryHash = Hasher().text("trajectory").finish();
    run.result.findings = findingsWith("test.simulation");
    makeEffects(run.result);
    makeHealth(run.result, dice);
}

}  // namespace

SampleRun makeSampleRun(std::uint32_t seed, std::size_t clusters, std::size_t frames) {
    Dice dice(seed);
    SampleRun run;
    run.origin.fePath = "/somewhere/stone-arch.exo";
    run.origin.feSha256 = std::string(64, 'a');
    run.origin.scenario.simulation.friction = 0.7;
    run.origin.scenario.regrouping.push_back(MergeComponents{{"a", "b"}, "c"});
    run.origin.scenarioName = "As computed";
    run.origin.build = "test build";
    run.origin.fingerprint = Hasher().text("origin").finish();
    run.origin.frame.origin = {100000, -200000, 3};
    makeScene(run, dice, clusters);
    makeBodies(run, dice);
    Dice ofIslands(seed + 1000000);
    makeIslands(run, ofIslands);
    for (std::size_t i = 0; i < frames; ++i) {
        const double time = 0.04 * static_cast<double>(i);
        run.frames.push_back(makeFrame(dice, time, time < 0.05 ? run.firstBatch : run.bodies.size()));
        run.ledger.push_back({time, static_cast<std::uint32_t>(i), dice.momenta(), dice.momenta(), dice.momenta(), dice.momenta(),
                              dice.number(), dice.momenta(), dice.number(), dice.number(), dice.number()});
    }
    makeResult(run, dice);
    return run;
}

void SampleRun::feed(TrajectorySink& sink, std::size_t frameCount) const {
    sink.begin(description);
    sink.addBodies(std::span(bodies).first(firstBatch), std::span(carriers).first(firstCarriers));
    bool second = false;
    for (std::size_t i = 0; i < frameCount; ++i) {
        if (!second && frames[i].bodies() > firstBatch) {
            sink.addBodies(std::span(bodies).subspan(firstBatch), std::span(carriers).subspan(firstCarriers));
            sink.addIslands(islands, islandLedger);
            for (const IslandLoss& loss : islandLosses) {
                sink.addIslandLoss(loss);
            }
            second = true;
        }
        sink.commit(frames[i]);
        sink.addLedger(ledger[i]);
        // Half way what is known of the first breaches, and at each frame after that how the last of these goes on.
        const std::size_t known = std::min<std::size_t>(3, result.health.breaches.size());
        if (i == frames.size() / 2) {
            sink.addBreaches({result.health.breaches.begin(), result.health.breaches.begin() + static_cast<std::ptrdiff_t>(known)});
        } else if (i > frames.size() / 2 && known > 0) {
            HealthBreach longer = result.health.breaches[known - 1];
            longer.to += frames[i].time;
            sink.addBreaches({longer});
        }
    }
    if (frameCount == frames.size()) {
        sink.finish(result);
    }
}

bool sameFrame(const TrajectoryFrame& a, const TrajectoryFrame& b) {
    const auto same = [](const auto& x, const auto& y) {
        return x.size() == y.size() && (x.empty() || std::memcmp(x.data(), y.data(), x.size() * sizeof x[0]) == 0);
    };
    return a.time == b.time && a.kind == b.kind && same(a.positions, b.positions) && same(a.orientations, b.orientations) &&
           same(a.speeds, b.speeds) && same(a.states, b.states);
}

}  // namespace rubble::io
