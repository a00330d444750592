#include "widgets/render/shapes/debris_geometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "tests/scenes/fe_scenes.h"
#include "tests/widgets/scenes/ballistic_run.h"

namespace rubble::render {
namespace {

/// A cube of 2 x 2 x 2 elements that dies as one: one cluster.
SceneData dyingCube() {
    scenes::Block block{.low = Vec3(0, 0, 5), .size = Vec3(2, 2, 2), .cells = {2, 2, 2}};
    block.deathState = [](std::size_t) { return std::size_t{2}; };
    return scenes::withoutRun(scenes::makeScene({block}, 4, 0.1));
}

Pose randomPose(std::mt19937& engine) {
    std::normal_distribution<double> n;
    return {10.0 * Vec3(n(engine), n(engine), n(engine)), Quat(n(engine), n(engine), n(engine), n(engine)).normalized()};
}

TrajectoryFrame frameOf(const std::vector<Pose>& poses) {
    TrajectoryFrame frame;
    for (const Pose& pose : poses) {
        frame.positions.push_back(pose.position.cast<float>());
        frame.orientations.push_back(pose.orientation.cast<float>());
        frame.speeds.push_back(3.0f);
        frame.states.push_back(BodyState::Awake);
    }
    return frame;
}

std::vector<Carrier> carry(const FragmentSet& fragments, const std::vector<std::uint32_t>& body, const std::vector<Pose>& toBody,
                           double from) {
    std::vector<Carrier> carriers;
    for (std::size_t f = 0; f < fragments.size(); ++f) {
        carriers.push_back(
            {idAt<FragmentId>(f), idAt<BodyId>(body[f]), from, std::numeric_limits<double>::infinity(), toBody[body[f]]});
    }
    return carriers;
}

TEST(DebrisGeometry, AClusterKeepsItsOuterFacesOnly) {
    const SceneData data = dyingCube();
    ASSERT_EQ(data.clustering->list.size(), 1u);
    const DebrisGeometry geometry(*data.fragments, data.clustering.get());
    EXPECT_EQ(geometry.faces().size(), 24u);     // of 48
    EXPECT_EQ(geometry.vertices().size(), 26u);  // the middle one is on no face
    EXPECT_EQ(geometry.groups().size(), 1u);
    const DebrisGeometry loose(*data.fragments, nullptr);
    EXPECT_EQ(loose.faces().size(), 48u);
    EXPECT_EQ(loose.vertices().size(), 64u);
    EXPECT_EQ(DebrisGeometry(*data.fragments, data.clustering.get(), false).faces().size(), 48u);
}

/// Volume that faces enclose, m3; negative where they look inwards.
double enclosed(const DebrisGeometry& geometry) {
    double volume = 0.0;
    const auto p = [&](std::uint32_t v) { return geometry.vertices()[v].local.cast<double>(); };
    for (const auto& face : geometry.faces()) {
        volume += p(face.vertices[0]).dot(p(face.vertices[1]).cross(p(face.vertices[2]))) / 6.0;
        if (face.vertices[3] != DebrisGeometry::none) {
            volume += p(face.vertices[0]).dot(p(face.vertices[2]).cross(p(face.vertices[3]))) / 6.0;
        }
    }
    return volume;
}

TEST(DebrisGeometry, FacesLookOutwards) {
    const SceneData data = dyingCube();
    // The closed surface of the cube, in single precision.
    EXPECT_NEAR(enclosed(DebrisGeometry(*data.fragments, data.clustering.get())), 8.0, 1e-5);
}

TEST(DebrisGeometry, WithLessDetailNoGroupVanishes) {
    const SceneData data = dyingCube();
    const DebrisGeometry geometry(*data.fragments, data.clustering.get());
    const DebrisGeometry fine = geometry.simplified(0.01);
    EXPECT_EQ(fine.faces().size(), geometry.faces().size());
    EXPECT_EQ(fine.vertices().size(), geometry.vertices().size());
    const DebrisGeometry box = geometry.simplified(5.0);
    EXPECT_EQ(box.faces().size(), 6u);
    EXPECT_EQ(box.vertices().size(), 8u);
    EXPECT_NEAR(enclosed(box), 8.0, 1e-5);
    EXPECT_EQ(box.groups().size(), 1u);
    // A fragment on its own is no more than a box anyhow.
    const DebrisGeometry loose(*data.fragments, nullptr);
    EXPECT_EQ(loose.simplified(5.0).faces().size(), 48u);
}

TEST(DebrisGeometry, BoxesHoldNoMoreThanTheirFragments) {
    // Every third of the cells dies: clusters fill about a third of their boxes.
    scenes::Block block{.low = Vec3(0, 0, 5), .size = Vec3(2, 2, 2), .cells = {8, 8, 8}};
    block.deathState = [](std::size_t e) { return e % 3 == 0 ? std::size_t{2} : std::size_t{9}; };
    const SceneData data = scenes::withoutRun(scenes::makeScene({block}, 4, 0.1));
    const DebrisGeometry box = DebrisGeometry(*data.fragments, data.clustering.get()).simplified(5.0);
    EXPECT_EQ(box.faces().size(), 6 * data.clustering->list.size());
    EXPECT_NEAR(enclosed(box), std::pow(0.25, 3) * static_cast<double>(data.fragments->size()), 1e-4);
    Eigen::AlignedBox3f drawn;
    for (const auto& vertex : box.vertices()) {
        drawn.extend(vertex.local);
    }
    EXPECT_TRUE(drawn.contains(Eigen::Vector3f::Zero()));
}

TEST(DebrisGeometry, JoinedVerticesKeepWhatIsLargerThanACell) {
    scenes::Block block{.low = Vec3(0, 0, 5), .size = Vec3(2, 2, 2), .cells = {8, 8, 8}};
    block.deathState = [](std::size_t) { return std::size_t{2}; };
    const SceneData data = scenes::withoutRun(scenes::makeScene({block}, 4, 0.1));
    ASSERT_EQ(data.clustering->list.size(), 1u);
    const DebrisGeometry geometry(*data.fragments, data.clustering.get());
    const DebrisGeometry coarse = geometry.simplified(0.6);
    EXPECT_LT(coarse.faces().size(), geometry.faces().size() / 2);
    EXPECT_GT(coarse.faces().size(), 6u);
    // A corner moves by less than a cell.
    EXPECT_GT(enclosed(coarse), std::pow(2.0 - 2 * 0.6, 3));
    EXPECT_LE(enclosed(coarse), 8.0 + 1e-5);
}

TEST(DebrisGeometry, FragmentsLieWhereTheirBodyCarriesThem) {
    std::mt19937 engine(3);
    const SceneData data = dyingCube();
    const std::vector<std::uint32_t> sameBody(8, 0);
    DebrisGeometry geometry(*data.fragments, data.clustering.get());
    const Pose toBody = randomPose(engine), body = randomPose(engine);
    geometry.bind(carry(*data.fragments, sameBody, {toBody}, 0.1));
    std::vector<float> out(3 * geometry.vertices().size());
    geometry.place(frameOf({body}), 0.5, 1, out.data());
    const Vec3 centre = geometry.groups()[0].centre;
    for (std::size_t v = 0; v < geometry.vertices().size(); ++v) {
        const Vec3 expected = body * (toBody * (centre + geometry.vertices()[v].local.cast<double>()));
        EXPECT_LT((expected - Vec3(out[3 * v], out[3 * v + 1], out[3 * v + 2])).norm(), 1e-4);  // single precision at 20 m
    }
    EXPECT_EQ(geometry.speeds(frameOf({body}), 0.5, 1), std::vector<float>{3.0f});
}

TEST(DebrisGeometry, WithoutABodyInTheFrameTheyStandAtTheirHandOver) {
    const SceneData data = dyingCube();
    DebrisGeometry geometry(*data.fragments, data.clustering.get());
    geometry.bind(carry(*data.fragments, std::vector<std::uint32_t>(8, 0), {Pose{}}, 0.1));
    std::vector<float> out(3 * geometry.vertices().size());
    geometry.place({}, 0.5, 1, out.data());
    Aabb box;
    for (std::size_t v = 0; v < geometry.vertices().size(); ++v) {
        box.extend(Vec3(out[3 * v], out[3 * v + 1], out[3 * v + 2]));
    }
    EXPECT_TRUE(box.isApprox(Aabb(Vec3(0, 0, 5), Vec3(2, 2, 7)), 1e-6));
    EXPECT_EQ(geometry.speeds({}, 0.5, 1), std::vector<float>{0.0f});
}

TEST(DebrisGeometry, FragmentsThatPartCompanyGetTheirFacesBack) {
    const SceneData data = dyingCube();
    DebrisGeometry geometry(*data.fragments, data.clustering.get());
    const std::vector<std::uint32_t> halves{0, 0, 0, 0, 1, 1, 1, 1};
    geometry.bind(carry(*data.fragments, halves, {Pose{}, Pose{}}, 0.1));
    EXPECT_EQ(geometry.groups().size(), 2u);
    EXPECT_EQ(geometry.faces().size(), 2u * 16u);
}

TEST(DebrisGeometry, TheBodyOfTheMomentCarries) {
    const SceneData data = dyingCube();
    DebrisGeometry geometry(*data.fragments, data.clustering.get());
    auto carriers = carry(*data.fragments, std::vector<std::uint32_t>(8, 0), {Pose{}, Pose{}}, 0.1);
    for (Carrier& carrier : carriers) {
        carrier.to = 1.0;
    }
    const auto later = carry(*data.fragments, std::vector<std::uint32_t>(8, 1), {Pose{}, Pose{}}, 1.0);
    carriers.insert(carriers.end(), later.begin(), later.end());
    geometry.bind(carriers);
    ASSERT_EQ(geometry.groups().size(), 1u);
    const TrajectoryFrame frame = frameOf({Pose{Vec3(10, 0, 0), Quat::Identity()}, Pose{Vec3(20, 0, 0), Quat::Identity()}});
    std::vector<float> out(3 * geometry.vertices().size());
    const auto middle = [&](double time) {
        geometry.place(frame, time, 1, out.data());
        Aabb box;
        for (std::size_t v = 0; v < geometry.vertices().size(); ++v) {
            box.extend(Vec3(out[3 * v], out[3 * v + 1], out[3 * v + 2]));
        }
        return box.center().x();
    };
    EXPECT_NEAR(middle(0.5), 11.0, 1e-5);
    EXPECT_NEAR(middle(1.0), 21.0, 1e-5);
}

TEST(DebrisGeometry, WhatHasLeftCoversNothing) {
    const SceneData data = dyingCube();
    DebrisGeometry geometry(*data.fragments, data.clustering.get());
    geometry.bind(carry(*data.fragments, std::vector<std::uint32_t>(8, 0), {Pose{}}, 0.1));
    TrajectoryFrame frame = frameOf({Pose{}});
    frame.states[0] = BodyState::Removed;
    std::vector<float> out(3 * geometry.vertices().size(), -1.0f);
    geometry.place(frame, 0.5, 1, out.data());
    for (std::size_t i = 3; i < out.size(); ++i) {
        EXPECT_EQ(out[i], out[i - 3]);
    }
}

}  // namespace
}  // namespace rubble::render
