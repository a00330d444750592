#include "core/simulation/bodies/pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/archive.h"
#include "core/base/error.h"
#include "core/selftest/element_scene.h"
#include "tests/core/simulation/scripted_world.h"
#include "tests/scenes/fe_scenes.h"

namespace rubble {
namespace {

/// Keeps what it is told of pieces.
class PieceWorld : public test::ScriptedWorld {
public:
    struct Piece {
        CollisionShape shape;
        Pose pose;
        bool there = true;
    };
    std::vector<Piece> pieces;

    PieceId addPiece(const CollisionShape& shape, const Pose& pose, Material, std::span<const std::uint32_t>) override {
        pieces.push_back({shape, pose});
        return idAt<PieceId>(pieces.size() - 1);
    }
    void removePiece(PieceId piece) override { pieces[at(piece)].there = false; }
    void movePiece(PieceId piece, const Pose& pose) override { pieces[at(piece)].pose = pose; }

    /// Boxes of what is there, in world axes, by their lowest x.
    std::vector<Aabb> boxes() const {
        std::vector<Aabb> all;
        for (const Piece& piece : pieces) {
            if (!piece.there) {
                continue;
            }
            for (const ConvexPart& part : piece.shape) {
                const Mat3 axes = (piece.pose.orientation * part.box.orientation).toRotationMatrix();
                const Vec3 reach = axes.cwiseAbs() * part.box.halfExtents;
                const Vec3 centre = piece.pose * part.box.centre;
                all.emplace_back(centre - reach, centre + reach);
            }
        }
        std::ranges::sort(all, {}, [](const Aabb& box) { return box.min().x(); });
        return all;
    }
};

/// A beam of three cubes of a metre whose middle one dies at state 2. From then on the right one goes off at 2 m/s, and the left
/// one has been stretched to 1.5 m since state 1.
class BrokenBeam : public StateSource {
public:
    explicit BrokenBeam(std::shared_ptr<const FeResult> at) : m_rest(std::move(at)) {}
    FeState read(std::size_t k) const override {
        FeState state = *m_rest->state(k);
        for (Vec3& p : state.positions) {
            if (k >= 1 && p.x() < 0.5) {
                p.x() -= 0.5;
            }
            if (k >= 2 && p.x() > 1.5) {
                p.x() += 2.0 * static_cast<double>(k - 1);
            }
        }
        return state;
    }

private:
    std::shared_ptr<const FeResult> m_rest;
};

class PiecesOfABeam : public testing::Test {
protected:
    std::shared_ptr<const FeResult> fe;
    Components components;
    Scenario scenario;
    PieceWorld world;

    void SetUp() override {
        scenes::Block beam;
        beam.size = Vec3(3, 1, 1);
        beam.cells = {3, 1, 1};
        beam.deathState = [](std::size_t i) { return i == 1 ? std::size_t{2} : scenes::never; };
        const std::shared_ptr<const FeResult> rest = scenes::makeScene({beam}, 4, 1.0, false);
        FeResult::Contents contents = rest->contents();
        contents.source = std::make_shared<BrokenBeam>(rest);
        fe = std::make_shared<FeResult>(std::move(contents));
        components = selftest::ElementScene::components(*fe);
        scenario.simulation.pieces = PieceKind::GridBoxes;
        scenario.simulation.pieceSize = 10.0;
    }
};

TEST_F(PiecesOfABeam, GoTheirOwnWaysOnceTheyHaveComeApart) {
    scenario.effects.loose = LooseStructurePolicy::AtOnce;
    Pieces pieces(*fe, components, fe->activity(), scenario);
    pieces.beginInterval(world, 0);
    EXPECT_EQ(pieces.present(), 1u);
    pieces.beginInterval(world, 2);
    EXPECT_EQ(pieces.present(), 2u);
    std::vector<Aabb> boxes = world.boxes();
    ASSERT_EQ(boxes.size(), 2u);
    EXPECT_NEAR(boxes[0].min().x(), -0.5, 1e-9) << "as long as it is now, not as it was at rest";
    EXPECT_NEAR(boxes[0].max().x(), 1.0, 1e-9);
    EXPECT_NEAR(boxes[1].min().x(), 4.0, 1e-9);
    EXPECT_NEAR(boxes[1].max().x(), 5.0, 1e-9);
    EXPECT_EQ(pieces.moving(), 1u);
    pieces.moveTo(world, 0.5);
    boxes = world.boxes();
    EXPECT_NEAR(boxes[0].min().x(), -0.5, 1e-9);
    EXPECT_NEAR(boxes[1].min().x(), 5.0, 1e-9);
}

TEST_F(PiecesOfABeam, AreOneByTheFeAnalysisAsBefore) {
    scenario.effects.loose = LooseStructurePolicy::Fe;
    Pieces pieces(*fe, components, fe->activity(), scenario);
    pieces.beginInterval(world, 0);
    pieces.beginInterval(world, 2);
    EXPECT_EQ(pieces.present(), 1u) << "trajectories with loose_structure = fe stay what they were";
}

TEST_F(PiecesOfABeam, AreTakenOutPartByPart) {
    scenario.effects.loose = LooseStructurePolicy::AtOnce;
    Pieces pieces(*fe, components, fe->activity(), scenario);
    pieces.beginInterval(world, 0);
    // What the engine takes over may leave two parts behind.
    pieces.release(world, {false, true, false}, 1);
    EXPECT_EQ(pieces.present(), 2u);
    pieces.release(world, {true, false, false}, 1);
    EXPECT_EQ(pieces.present(), 1u);
    ASSERT_EQ(world.boxes().size(), 1u);
    EXPECT_NEAR(world.boxes()[0].min().x(), 2.0, 1e-9);
}

TEST_F(PiecesOfABeam, GoOnFromWhereTheyWereKept) {
    scenario.effects.loose = LooseStructurePolicy::AtOnce;
    Pieces pieces(*fe, components, fe->activity(), scenario);
    pieces.beginInterval(world, 0);
    pieces.beginInterval(world, 2);
    Archive out;
    pieces.keep(out);
    const std::string bytes = std::move(out).take();
    Pieces again(*fe, components, fe->activity(), scenario);
    Archive in(bytes);
    again.keep(in);
    EXPECT_TRUE(in.atEnd());
    EXPECT_EQ(again.present(), 2u);
    EXPECT_EQ(again.moving(), 1u);
    again.moveTo(world, 1.0);
    EXPECT_NEAR(world.boxes()[1].min().x(), 6.0, 1e-9);
    again.release(world, {false, false, true}, 3);
    EXPECT_EQ(again.present(), 1u);
    Pieces another(*fe, components, fe->activity(), scenario);
    Archive cut(std::string_view(bytes).substr(0, bytes.size() / 2));
    EXPECT_THROW(another.keep(cut), ParseError);
}

}  // namespace
}  // namespace rubble
