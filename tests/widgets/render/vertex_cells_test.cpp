#include "widgets/render/shapes/vertex_cells.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
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

TEST(VertexCells, AreThoseOfThePlainDefinition) {
    std::mt19937 random(31);
    std::uniform_real_distribution<float> place(-40.0f, 40.0f);
    std::vector<Eigen::Vector3f> points;
    for (int i = 0; i < 20000; ++i) {
        points.emplace_back(place(random), place(random), place(random));
    }
    for (const double cell : {0.3, 3.0, 100.0}) {
        std::map<std::array<double, 3>, std::uint32_t> firstIn;
        std::vector<std::uint32_t> expected;
        for (std::uint32_t i = 0; i < points.size(); ++i) {
            std::array<double, 3> own{};
            for (int axis = 0; axis < 3; ++axis) {
                own[static_cast<std::size_t>(axis)] = std::floor(static_cast<double>(points[i][axis]) * (1.0 / cell));
            }
            expected.push_back(firstIn.emplace(own, i).first->second);
        }
        EXPECT_EQ(VertexCells(cell).join(points), expected) << cell;
    }
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
