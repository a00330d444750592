#include "core/trajectory/trajectory.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <thread>

#include "core/simulation/run/simulation.h"

namespace rubble {
namespace {

// Bodies that fly with constant velocity and turn at a constant rate: interpolation is exact for them.
struct Flight {
    Vec3 start;
    Vec3 velocity;
    Vec3 axis;
    double rate = 0.0;
    double birth = 0.0;

    Pose at(double time) const {
        const double t = time - birth;
        return {start + t * velocity, Quat(Eigen::AngleAxisd(rate * t, axis))};
    }
};

std::vector<Flight> randomFlights(std::mt19937& engine, std::size_t count) {
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    const auto vector = [&] { return Vec3(number(engine), number(engine), number(engine)); };
    std::vector<Flight> flights;
    for (std::size_t b = 0; b < count; ++b) {
        // Births in order; less than half a turn between frames, beyond which no interpolation can know the way.
        flights.push_back(
            {20.0 * vector(), 10.0 * vector(), vector().normalized(), 20.0 * number(engine), 0.013 * static_cast<double>(b)});
    }
    return flights;
}

TrajectoryFrame frameOf(const std::vector<Flight>& flights, double time) {
    TrajectoryFrame frame;
    frame.time = time;
    for (const Flight& flight : flights) {
        if (flight.birth <= time) {
            const Pose pose = flight.at(time);
            frame.positions.push_back(pose.position.cast<float>());
            frame.orientations.push_back(pose.orientation.cast<float>());
            frame.speeds.push_back(static_cast<float>(flight.velocity.norm()));
            frame.states.push_back(BodyState::Awake);
        }
    }
    return frame;
}

void record(MemoryTrajectory& trajectory, const std::vector<Flight>& flights, double step, int frames) {
    std::vector<BodyRecord> bodies;
    for (std::size_t b = 0; b < flights.size(); ++b) {
        BodyRecord body;
        body.body = idAt<BodyId>(b);
        body.from = flights[b].birth;
        body.atBirth = flights[b].at(flights[b].birth);
        bodies.push_back(body);
    }
    trajectory.begin({});
    trajectory.addBodies(bodies, {});
    for (int i = 0; i < frames; ++i) {
        trajectory.commit(frameOf(flights, 0.04 + step * i));
    }
}

TEST(FrameAtTime, IsExactForBodiesInUniformMotion) {
    std::mt19937 engine(1);
    const std::vector<Flight> flights = randomFlights(engine, 60);
    MemoryTrajectory trajectory;
    record(trajectory, flights, 0.05, 20);
    std::uniform_real_distribution<double> when(0.04, 0.04 + 0.05 * 19);
    for (int i = 0; i < 500; ++i) {
        const double time = when(engine);
        const TrajectoryFrame frame = frameAtTime(trajectory, time);
        const TrajectoryFrame expected = frameOf(flights, time);
        EXPECT_EQ(frame.time, time);
        EXPECT_EQ(frame.kind, FrameKind::Interpolated);
        ASSERT_EQ(frame.bodies(), expected.bodies()) << time;
        ASSERT_EQ(frame.orientations.size(), frame.bodies());
        ASSERT_EQ(frame.speeds.size(), frame.bodies());
        ASSERT_EQ(frame.states.size(), frame.bodies());
        for (std::size_t b = 0; b < frame.bodies(); ++b) {
            // Single precision over some 30 m, and a fraction of a step in single precision.
            EXPECT_LT((frame.positions[b] - expected.positions[b]).norm(), 2e-5f);
            EXPECT_LT(frame.orientations[b].angularDistance(expected.orientations[b]), 2e-3f);
            EXPECT_NEAR(frame.orientations[b].norm(), 1.0f, 1e-6f);
        }
    }
}

TEST(FrameAtTime, GivesFramesThemselvesAtTheirTimes) {
    std::mt19937 engine(2);
    MemoryTrajectory trajectory;
    record(trajectory, randomFlights(engine, 20), 0.05, 8);
    for (std::size_t i = 0; i < trajectory.frameCount(); ++i) {
        const TrajectoryFrame frame = frameAtTime(trajectory, trajectory.frameTime(i));
        EXPECT_EQ(frame.kind, FrameKind::Simulated);
        EXPECT_EQ(frame.positions, trajectory.frame(i)->positions);
    }
}

TEST(FrameAtTime, IsEmptyBeforeTheFirstFrameAndTheLastAfterTheEnd) {
    std::mt19937 engine(3);
    MemoryTrajectory trajectory;
    EXPECT_EQ(frameAtTime(trajectory, 1.0).bodies(), 0u);
    record(trajectory, randomFlights(engine, 5), 0.05, 4);
    EXPECT_EQ(frameAtTime(trajectory, 0.03).bodies(), 0u);
    EXPECT_EQ(frameAtTime(trajectory, -INFINITY).bodies(), 0u);
    EXPECT_EQ(frameAtTime(trajectory, NAN).bodies(), 0u);
    EXPECT_EQ(frameAtTime(trajectory, 1e9).positions, trajectory.frame(3)->positions);
    EXPECT_EQ(frameAtTime(trajectory, INFINITY).positions, trajectory.frame(3)->positions);
}

TEST(FrameAtTime, TakesTheShortWayAround) {
    MemoryTrajectory trajectory;
    trajectory.begin({});
    const std::vector<BodyRecord> bodies(1);
    trajectory.addBodies(bodies, {});
    const Eigen::Quaternionf first(Eigen::AngleAxisf(0.2f, Eigen::Vector3f::UnitZ()));
    Eigen::Quaternionf second(Eigen::AngleAxisf(0.4f, Eigen::Vector3f::UnitZ()));
    second.coeffs() *= -1.0f;  // the same rotation
    trajectory.commit({0.0, FrameKind::Simulated, {{0, 0, 0}}, {first}, {0}, {BodyState::Awake}});
    trajectory.commit({1.0, FrameKind::Simulated, {{1, 0, 0}}, {second}, {1}, {BodyState::Frozen}});
    const TrajectoryFrame middle = frameAtTime(trajectory, 0.5);
    EXPECT_NEAR(middle.orientations[0].angularDistance(Eigen::Quaternionf(Eigen::AngleAxisf(0.3f, Eigen::Vector3f::UnitZ()))), 0,
                1e-3);
    EXPECT_FLOAT_EQ(middle.speeds[0], 0.5f);
    EXPECT_EQ(middle.states[0], BodyState::Awake);
}

TEST(FrameAt, AgreesWithALinearSearch) {
    std::mt19937 engine(4);
    for (int round = 0; round < 50; ++round) {
        MemoryTrajectory trajectory;
        trajectory.begin({});
        std::vector<double> times;
        double time = 0.0;
        for (std::size_t n = engine() % 30; n > 0; --n) {
            time += static_cast<double>(engine() % 3);  // equal times happen
            times.push_back(time);
            TrajectoryFrame frame;
            frame.time = time;
            trajectory.commit(frame);
        }
        for (double at = -1.5; at < time + 2.0; at += 0.5) {
            std::size_t expected = 0;
            for (std::size_t i = 0; i < times.size(); ++i) {
                if (times[i] <= at) {
                    expected = i;
                }
            }
            EXPECT_EQ(trajectory.frameAt(at), expected);
        }
    }
}

TEST(MemoryTrajectory, KeepsWhatItWasGivenAndStartsAnewAtBegin) {
    MemoryTrajectory trajectory;
    trajectory.begin({});
    std::vector<BodyRecord> bodies(3);
    std::vector<Carrier> carriers(5);
    bodies[2].mass = 7.0;
    carriers[4].from = 2.5;
    trajectory.addBodies(bodies, carriers);
    trajectory.addBodies(std::span(bodies).first(1), {});
    LedgerRow row;
    row.pieceWork = 3.0;
    trajectory.addLedger(row);
    EXPECT_EQ(trajectory.bodies().size(), 4u);
    EXPECT_EQ(trajectory.bodies()[2].mass, 7.0);
    EXPECT_EQ(trajectory.carriers()[4].from, 2.5);
    EXPECT_EQ(trajectory.ledger().at(0).pieceWork, 3.0);
    EXPECT_FALSE(trajectory.complete());
    trajectory.finish({});
    EXPECT_TRUE(trajectory.complete());
    trajectory.begin({});
    EXPECT_FALSE(trajectory.complete());
    EXPECT_TRUE(trajectory.bodies().empty() && trajectory.carriers().empty() && trajectory.ledger().empty());
}

TEST(MemoryTrajectory, IsReadByOneThreadWhileAnotherWrites) {
    MemoryTrajectory trajectory;
    trajectory.begin({});
    std::thread writer([&] {
        for (int i = 0; i < 2000; ++i) {
            std::vector<BodyRecord> bodies(1);
            bodies[0].from = i;
            trajectory.addBodies(bodies, {});
            TrajectoryFrame frame;
            frame.time = i;
            frame.positions.assign(static_cast<std::size_t>(i % 50), Eigen::Vector3f::Constant(static_cast<float>(i)));
            frame.orientations.resize(frame.bodies(), Eigen::Quaternionf::Identity());
            frame.speeds.resize(frame.bodies());
            frame.states.resize(frame.bodies(), BodyState::Awake);
            trajectory.commit(frame);
        }
        trajectory.finish({});
    });
    while (!trajectory.complete()) {
        if (const std::size_t count = trajectory.frameCount(); count > 0) {
            const auto frame = trajectory.frame(count - 1);
            EXPECT_EQ(frame->time, static_cast<double>(count - 1));
            for (const Eigen::Vector3f& p : frame->positions) {
                ASSERT_EQ(p.x(), static_cast<float>(count - 1));
            }
            EXPECT_GE(trajectory.bodies().size(), count);
        }
    }
    writer.join();
    EXPECT_EQ(trajectory.frameCount(), 2000u);
}

}  // namespace
}  // namespace rubble
