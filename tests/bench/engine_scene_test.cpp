#include "bench/engine_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "bench/engine_run.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::bench {
namespace {

constexpr double dt = 1.0 / 40.0;

NewBody boxAt(const Vec3& place, double side = 1.0) {
    NewBody body;
    body.mass = 2000.0 * side * side * side;
    body.inertia = Vec3::Constant(body.mass * side * side / 6.0);
    body.pose.position = place;
    body.shape.push_back({{Vec3::Zero(), Quat::Identity(), Vec3::Constant(0.5 * side)}, {}, 0.0});
    body.smallestSide = side;
    body.volume = side * side * side;
    return body;
}

std::unique_ptr<RigidWorld> softStep(const WorldSettings& settings) {
    return makeWorld(SolverKind::SoftStep, settings);
}

/// Two boxes that fall on a piece, which sinks away at 0.4 m/s from the first second on; one of them leaves.
EngineScene sinkingPiece() {
    WorldSettings settings;
    settings.gravity = 9.81;
    EngineScene scene;
    SceneRecorder world(softStep(settings), settings, scene);
    ConvexPart plate;
    plate.box.halfExtents = {4.0, 4.0, 0.25};
    const Pose start{{0.0, 0.0, 3.0}, Quat::Identity()};
    const PieceId piece = world.addPiece({plate}, start, Material::Concrete, {});
    NewBody tilted = boxAt({0.3, 0.1, 4.2});
    tilted.pose.orientation = Quat(Eigen::AngleAxisd(0.3, Vec3(1.0, 2.0, 0.5).normalized()));
    tilted.velocity = {0.1, -0.2, 0.3};
    world.addBody(tilted);
    const BodyId second = world.addBody(boxAt({2.0, 1.0, 3.9}));
    for (int i = 1; i <= 80; ++i) {
        if (i > 40) {
            world.movePiece(piece, {{0.0, 0.0, 3.0 - 0.4 * (i - 40) * dt}, Quat::Identity()});
        }
        world.step(dt);
        if (i == 60) {
            world.removeBody(second);
            world.addBody(boxAt({-2.0, 0.0, 3.8}, 0.5));
        }
    }
    return scene;
}

std::vector<std::size_t> kindsOf(const EngineScene& scene) {
    std::vector<std::size_t> kinds;
    for (const EngineScene::Call& call : scene.calls) {
        kinds.push_back(call.index());
    }
    return kinds;
}

TEST(EngineScene, ReadsBackToTheSameBits) {
    const io::TemporaryFolder folder;
    const EngineScene scene = sinkingPiece();
    const std::string file = folder / "a.scene", again = folder / "b.scene";
    writeScene(scene, file);
    const EngineScene read = readScene(file);
    EXPECT_EQ(kindsOf(read), kindsOf(scene));
    EXPECT_EQ(read.settings.pairs, scene.settings.pairs);
    writeScene(read, again);
    EXPECT_EQ(io::wholeFile(file), io::wholeFile(again));
    EXPECT_EQ(measureEngine(read, softStep).end, measureEngine(scene, softStep).end);
}

TEST(EngineScene, RunsAsTheRunThatItNotes) {
    WorldSettings settings;
    EngineScene scene;
    SceneRecorder world(softStep(settings), settings, scene);
    const BodyId body = world.addBody(boxAt({0.0, 0.0, 2.0}));
    for (int i = 0; i < 60; ++i) {
        world.step(dt);
    }
    const EngineMeasure measure = measureEngine(scene, softStep);
    EXPECT_EQ(measure.steps, 60);
    EXPECT_EQ(measure.meanHeight, world.motion(body).pose.position.z());
    EXPECT_NEAR(scene.seconds(), 60 * dt, 1e-12);
}

TEST(EngineScene, TakesOtherSubstepsFromWhereTheRunTookThem) {
    WorldSettings settings;
    settings.substeps = 16;
    EngineScene scene;
    SceneRecorder world(softStep(settings), settings, scene);
    NewBody tilted = boxAt({0.0, 0.0, 0.6});
    tilted.pose.orientation = Quat(Eigen::AngleAxisd(0.3, Vec3(1.0, 2.0, 0.5).normalized()));
    const BodyId body = world.addBody(tilted);
    for (int i = 0; i < 30; ++i) {
        if (i == 10) {
            world.setSubsteps(2);
        }
        world.step(dt);
    }
    const io::TemporaryFolder folder;
    writeScene(scene, folder / "a.scene");
    EngineScene read = readScene(folder / "a.scene");
    const EngineMeasure measure = measureEngine(read, softStep);
    EXPECT_EQ(measure.meanHeight, world.motion(body).pose.position.z());
    EXPECT_NE(measureEngine(read.inSubsteps(16), softStep).end, measure.end);
    EXPECT_EQ(kindsOf(read).size(), kindsOf(read.inSubsteps(16)).size() + 1);
}

TEST(EngineScene, GoesInOtherStepsAndMeetsWhateverEntersOrLeaves) {
    const EngineScene scene = sinkingPiece();
    const EngineScene finer = scene.inSteps(100.0);
    EXPECT_NEAR(finer.seconds(), scene.seconds(), 1e-12);
    double time = 0.0;
    std::vector<double> left;
    double lowest = 3.0;
    for (const EngineScene::Call& call : finer.calls) {
        if (const auto* step = std::get_if<EngineScene::Step>(&call)) {
            EXPECT_LE(step->dt, 0.01 + 1e-12);
            time += step->dt;
        } else if (std::holds_alternative<EngineScene::BodyLeaves>(call)) {
            left.push_back(time);
        } else if (const auto* move = std::get_if<EngineScene::PieceMoves>(&call)) {
            const double end = time + 0.01;
            EXPECT_NEAR(move->pose.position.z(), 3.0 - 0.4 * std::max(0.0, end - 1.0), 1e-9) << end;
            lowest = std::min(lowest, move->pose.position.z());
        }
    }
    ASSERT_EQ(left.size(), 1U);
    EXPECT_NEAR(left[0], 1.5, 1e-12);
    EXPECT_NEAR(lowest, 2.6, 1e-12);
}

TEST(EngineScene, StandsWithoutPieces) {
    const EngineScene bare = sinkingPiece().withoutPieces();
    const EngineMeasure measure = measureEngine(bare, softStep);
    EXPECT_EQ(measure.bodies, 3);
    // Both that stay lie on the ground by then or fall on.
    EXPECT_LT(measure.meanHeight, 1.0);
}

TEST(EngineScene, RefusesWhatItCannotRead) {
    const io::TemporaryFolder folder;
    const std::string file = folder / "broken.scene";
    const auto refusal = [&](const std::string& text) {
        std::ofstream(file) << text;
        try {
            readScene(file);
        } catch (const std::runtime_error& error) {
            return std::string(error.what());
        }
        return std::string("nothing");
    };
    const std::string head = "# rubble engine scene 1.\n";
    EXPECT_THAT(refusal("step 0.1\n"), testing::HasSubstr("line 1: this is no scene"));
    EXPECT_THAT(refusal(head), testing::HasSubstr("nothing for an engine to do"));
    EXPECT_THAT(refusal(head + "step\n"), testing::HasSubstr("line 2: the line ends too early"));
    EXPECT_THAT(refusal(head + "step nan\n"), testing::HasSubstr("\"nan\" is no number"));
    EXPECT_THAT(refusal(head + "step 0.1 0.1\n"), testing::HasSubstr("goes on"));
    EXPECT_THAT(refusal(head + "body-leaves 0\n"), testing::HasSubstr("below 0"));
    EXPECT_THAT(refusal(head + "set gravitas 9\n"), testing::HasSubstr("no setting"));
    EXPECT_THAT(refusal(head + "pair stone cheese 1 1\n"), testing::HasSubstr("\"cheese\" is no material"));
}

TEST(EngineScene, HasNoTerrain) {
    WorldSettings settings;
    settings.terrain = std::make_shared<const TerrainGrid>(0.0, 0.0, 1.0, 2, 2, std::vector<double>(4, 0.0));
    EngineScene scene;
    EXPECT_THROW(SceneRecorder(softStep({}), settings, scene), std::runtime_error);
}

TEST(EngineMeasure, CountsOverlapBetweenBodiesAlone) {
    EngineScene scene;
    NewBody cross = boxAt({0.0, 0.0, 0.5});
    cross.shape.push_back({{Vec3::Zero(), Quat::Identity(), {1.0, 0.2, 0.2}}, {}, 0.0});
    scene.settings.ground = false;
    scene.settings.gravity = 0.0;
    scene.settings.bodyContacts = false;
    scene.calls.emplace_back(EngineScene::BodyEnters{cross});
    scene.calls.emplace_back(EngineScene::Step{dt});
    EXPECT_EQ(measureEngine(scene, softStep).overlap.beyondFive, 0);
    scene.calls.insert(scene.calls.begin(), EngineScene::BodyEnters{boxAt({0.9, 0.0, 0.5})});
    const EngineMeasure two = measureEngine(scene, softStep);
    EXPECT_EQ(two.overlap.beyondFive, 2);
    EXPECT_NEAR(two.overlap.deepest, 0.6, 1e-9);
}

TEST(EngineMeasure, CountsWhatIsThrown) {
    EngineScene scene;
    scene.settings.ground = false;
    scene.calls.emplace_back(EngineScene::BodyEnters{boxAt({0.0, 0.0, 0.0})});
    ConvexPart bat;
    bat.box.halfExtents = {1.0, 1.0, 0.5};
    scene.calls.emplace_back(EngineScene::PieceEnters{{bat}, {{0.0, 0.0, -1.01}, Quat::Identity()}, Material::Steel});
    for (int i = 1; i <= 20; ++i) {
        scene.calls.emplace_back(EngineScene::PieceMoves{PieceId{0}, {{0.0, 0.0, -1.01 + 5.0 * i * dt}, Quat::Identity()}});
        scene.calls.emplace_back(EngineScene::Step{dt});
    }
    const EngineMeasure measure = measureEngine(scene, softStep);
    EXPECT_EQ(measure.thrown, 1);
    EXPECT_EQ(measure.tooFast, 1);
}

}  // namespace
}  // namespace rubble::bench
