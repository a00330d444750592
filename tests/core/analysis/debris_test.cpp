#include "core/analysis/debris/debris.h"

#include <gtest/gtest.h>

#include "core/pipeline/pipeline.h"
#include "tests/scenes/fe_scenes.h"

namespace rubble {
namespace {

/// Hands a run on to several sinks.
class Fork : public TrajectorySink {
public:
    explicit Fork(std::vector<TrajectorySink*> sinks) : m_sinks(std::move(sinks)) {}
    void begin(const RunDescription& description) override {
        each([&](TrajectorySink& s) { s.begin(description); });
    }
    void addBodies(std::span<const BodyRecord> bodies, std::span<const Carrier> carriers) override {
        each([&](TrajectorySink& s) { s.addBodies(bodies, carriers); });
    }
    void commit(const TrajectoryFrame& frame) override {
        each([&](TrajectorySink& s) { s.commit(frame); });
    }
    void addLedger(const LedgerRow& row) override {
        each([&](TrajectorySink& s) { s.addLedger(row); });
    }
    void finish(const SimulationResult& result) override {
        each([&](TrajectorySink& s) { s.finish(result); });
    }

private:
    template <class Call>
    void each(Call call) {
        for (TrajectorySink* sink : m_sinks) {
            call(*sink);
        }
    }
    std::vector<TrajectorySink*> m_sinks;
};

class DebrisOfARun : public testing::Test {
protected:
    void SetUp() override {
        scenario.simulation.settleTime = 0.5;
        Fork fork({&recorder, &memory});
        results = run(inputs, scenario, Stage::Simulation, {}, &fork, Execution());
    }
    Inputs inputs{scenes::collapsingWall(), {}};
    Scenario scenario;
    DebrisRecorder recorder;
    MemoryTrajectory memory;
    Results results;
};

TEST_F(DebrisOfARun, AtRestItLiesWhereTheRunSaysItEnded) {
    const Debris debris = recorder.debris(DebrisInstant::AtRest);
    EXPECT_EQ(debris.time, results.simulation->endTime);
    ASSERT_EQ(debris.fragments.size(), results.simulation->fragments.size());
    double mass = 0.0;
    for (std::size_t f = 0; f < debris.fragments.size(); ++f) {
        EXPECT_TRUE(debris.fragments[f].present);
        // Frames hold single precision: 5e-7 m at 8 m.
        EXPECT_LT((debris.fragments[f].centre - results.simulation->fragments[f].finalPosition).norm(), 5e-6);
        mass += debris.fragments[f].mass;
        EXPECT_NEAR(debris.fragments[f].volume, 1.0, 1e-9) << "cells of the wall are cubes of 1 m";
    }
    EXPECT_NEAR(mass, 12 * 2000.0, 1e-6);
}

TEST_F(DebrisOfARun, AtTheFeEndItIsTheFrameOfThatState) {
    const Debris debris = recorder.debris(DebrisInstant::AtFeEnd);
    EXPECT_EQ(debris.time, inputs.fe->times().back());
    const Debris read = debrisAt(*results.fragments, *results.components, memory, debris.time);
    ASSERT_EQ(read.fragments.size(), debris.fragments.size());
    for (std::size_t f = 0; f < debris.fragments.size(); ++f) {
        EXPECT_EQ(read.fragments[f].centre, debris.fragments[f].centre);
        EXPECT_EQ(read.fragments[f].box.orientation.coeffs(), debris.fragments[f].box.orientation.coeffs());
    }
    EXPECT_LT(debris.time, results.simulation->endTime);
}

TEST_F(DebrisOfARun, AFragmentIsThereFromItsBirthOn) {
    // The first half of the wall dies at state 2 (0.2 s), the second at state 4.
    const auto present = [&](double time) {
        const Debris debris = debrisAt(*results.fragments, *results.components, memory, time);
        return std::count_if(debris.fragments.begin(), debris.fragments.end(), [](const DebrisFragment& d) { return d.present; });
    };
    EXPECT_EQ(present(0.0), 0);
    EXPECT_EQ(present(0.15), 0) << "the engine carries it, but it is not born";
    EXPECT_EQ(present(0.2), 6);
    EXPECT_EQ(present(0.41), 12);
}

TEST_F(DebrisOfARun, ABoxTurnsAndMovesWithItsFragment) {
    const Debris debris = recorder.debris(DebrisInstant::AtRest);
    for (std::size_t f = 0; f < debris.fragments.size(); ++f) {
        const Fragment& fragment = results.fragments->list[f];
        const DebrisFragment& lies = debris.fragments[f];
        EXPECT_EQ(lies.box.halfExtents, fragment.box.halfExtents);
        const Vec3 before = fragment.box.orientation.conjugate() * (fragment.centre - fragment.box.centre);
        const Vec3 after = lies.box.orientation.conjugate() * (lies.centre - lies.box.centre);
        EXPECT_LT((before - after).norm(), 1e-5) << "the centre of mass keeps its place in the box";
    }
}

TEST(Debris, FollowsItsLatestCarrierAndGoesWithItsBody) {
    const auto fe = scenes::collapsingWall(2, 1);
    const Components components = groupComponents(fe->mesh(), {}, {}, {});
    const FragmentSet fragments = makeFragments(*fe, components, {}, Execution());
    ASSERT_EQ(fragments.size(), 2u);
    // A cluster of both broke up at 0.5 s: the first went on in a body of its own, the second was lost.
    std::vector<Carrier> carriers(3);
    carriers[0] = {idAt<FragmentId>(0), idAt<BodyId>(0), 0.1, std::numeric_limits<double>::infinity(), {}};
    carriers[1] = {idAt<FragmentId>(1), idAt<BodyId>(0), 0.1, std::numeric_limits<double>::infinity(), {}};
    carriers[2] = {idAt<FragmentId>(0), idAt<BodyId>(1), 0.5, std::numeric_limits<double>::infinity(), {}};
    TrajectoryFrame frame;
    frame.time = 0.6;
    frame.positions = {Eigen::Vector3f(5, 0, 0), Eigen::Vector3f(0, 7, 0)};
    frame.orientations.assign(2, Eigen::Quaternionf::Identity());
    frame.speeds.assign(2, 0.0f);
    frame.states = {BodyState::Removed, BodyState::Awake};
    const Debris debris = debrisOf(fragments, components, carriers, frame);
    EXPECT_TRUE(debris.fragments[0].present);
    EXPECT_EQ(debris.fragments[0].centre, Vec3(fragments.list[0].centre + Vec3(0, 7, 0)));
    EXPECT_FALSE(debris.fragments[1].present);
}

TEST(Debris, OfARecorderBeforeAnyFrameIsAbsent) {
    const auto fe = scenes::collapsingWall(2, 1);
    const Inputs inputs{fe, {}};
    const Results results = run(inputs, {}, Stage::Clusters, {}, nullptr, Execution());
    DebrisRecorder recorder;
    recorder.begin(describeRun(inputs, {}, results));
    for (const DebrisFragment& lies : recorder.debris(DebrisInstant::AtRest).fragments) {
        EXPECT_FALSE(lies.present);
    }
}

}  // namespace
}  // namespace rubble
