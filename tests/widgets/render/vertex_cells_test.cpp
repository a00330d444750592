#include "widgets/render/vertex_cells.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace rubble::render {
namespace {

constexpr std::uint32_t none = 0xffffffffu;

TEST(VertexCells, PointsOfOneCellAreTheFirstOfThem) {
    const std::vector<Eigen::Vector3f> points{{0.1f, 0.1f, 0.1f}, {1.1f, 0.1f, 0.1f}, {0.9f, 0.9f, 0.9f}, {-0.1f, 0.1f, 0.1f}};
    EXPECT_EQ(VertexCells(1.0).join(points), (std::vector<std::uint32_t>{0, 1, 0, 3}));
    EXPECT_EQ(VertexCells(0.5).join(points), (std::vector<std::uint32_t>{0, 1, 2, 3}));
}

TEST(VertexCells, WhatIsNoNumberStaysAlone) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<Eigen::Vector3f> points{{0, 0, 0}, {nan, 0, 0}, {nan, 0, 0}, {1e30f, 0, 0}};
    EXPECT_EQ(VertexCells(1.0).join(points), (std::vector<std::uint32_t>{0, 1, 2, 3}));
}

TEST(VertexCells, JoinedPointsLieWithinACell) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> place(-5.0f, 5.0f);
    std::vector<Eigen::Vector3f> points;
    for (int i = 0; i < 2000; ++i) {
        points.emplace_back(place(random), place(random), place(random));
    }
    const std::vector<std::uint32_t> first = VertexCells(0.75).join(points);
    std::size_t joined = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_LE(first[i], i);
        EXPECT_EQ(first[first[i]], first[i]);
        EXPECT_LT((points[i] - points[first[i]]).cwiseAbs().maxCoeff(), 0.75f);
        joined += first[i] != i;
    }
    EXPECT_GT(joined, 400u);
}

TEST(VertexCells, FacesLoseWhatIsRepeated) {
    const auto left = [](std::array<std::uint32_t, 4> corners) {
        return withoutRepeats(corners, none) ? corners : std::array<std::uint32_t, 4>{none, none, none, none};
    };
    const std::array<std::uint32_t, 4> nothing{none, none, none, none};
    EXPECT_EQ(left({1, 2, 3, 4}), (std::array<std::uint32_t, 4>{1, 2, 3, 4}));
    EXPECT_EQ(left({1, 2, 3, none}), (std::array<std::uint32_t, 4>{1, 2, 3, none}));
    EXPECT_EQ(left({1, 1, 3, 4}), (std::array<std::uint32_t, 4>{1, 3, 4, none}));
    EXPECT_EQ(left({1, 2, 3, 1}), (std::array<std::uint32_t, 4>{1, 2, 3, none}));
    EXPECT_EQ(left({1, 2, 2, none}), nothing);
    EXPECT_EQ(left({1, 1, 2, 2}), nothing);
    EXPECT_EQ(left({1, 2, 1, 4}), nothing);
    EXPECT_EQ(left({1, 1, 1, 1}), nothing);
}

}  // namespace
}  // namespace rubble::render
