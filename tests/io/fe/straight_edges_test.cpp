#include "io/fe/straight_edges.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <variant>

#include "core/fe/components.h"

namespace rubble::io {
namespace {

using enum ElementShape;

std::vector<Vec3> cornersOf(ElementShape shape) {
    const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    switch (shape) {
        case Hexahedron:
            return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
        case Wedge:
            return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
        case Pyramid:
            return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}};
        case Tetrahedron:
            return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        case Quadrilateral:
            return square;
        case Triangle:
            return {square[0], square[1], square[3]};
        case Beam:
            break;
    }
    return {square[0], square[1]};
}

Vec3 middleOf(const std::vector<Vec3>& places) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& place : places) {
        sum += place;
    }
    return sum / static_cast<double>(places.size());
}

std::vector<Vec3> faceMiddles(ElementShape shape) {
    const std::vector<Vec3> corners = cornersOf(shape);
    std::vector<Vec3> middles;
    for (const auto& face : facesOf(shape)) {
        std::vector<Vec3> places;
        for (std::size_t c = 0; c < (face[3] < 0 ? 3U : 4U); ++c) {
            places.push_back(corners[static_cast<std::uint8_t>(face[c])]);
        }
        middles.push_back(middleOf(places));
    }
    return middles;
}

Findings findingsOf(ElementShape shape, const std::vector<Vec3>& nodes) {
    StraightEdges edges;
    edges.add(shape, EdgeOrder::TopBeforeSides, nodes, "element 1");
    Findings findings;
    edges.note(findings);
    return findings;
}

// HEX9, HEX14, HEX15, TET5, TET8, TET9, QUAD5, TRI4 and so on: their edges are those between corners.
TEST(StraightEdges, NodesInTheMiddleOfFacesAndOfTheWholeSayNothingOfEdges) {
    for (const ElementShape shape : {Hexahedron, Wedge, Pyramid, Tetrahedron, Quadrilateral, Triangle}) {
        const std::vector<Vec3> corners = cornersOf(shape), middles = faceMiddles(shape);
        std::vector<Vec3> nodes = corners;
        nodes.push_back(middleOf(corners));
        EXPECT_TRUE(findingsOf(shape, nodes).empty()) << shapeName(shape) << ": in the middle";
        nodes = corners;
        nodes.insert(nodes.end(), middles.begin(), middles.end());
        EXPECT_TRUE(findingsOf(shape, nodes).empty()) << shapeName(shape) << ": in the middle of faces";
        nodes.push_back(middleOf(corners));
        EXPECT_TRUE(findingsOf(shape, nodes).empty()) << shapeName(shape) << ": in all middles";
        nodes[corners.size()] *= 1.3;
        nodes[corners.size()].z() -= 0.1;
        EXPECT_EQ(findingsOf(shape, nodes).count("fe.straight_unknown"), 1) << shapeName(shape) << ": a face that bulges";
    }
}

TEST(StraightEdges, NodesThatStandElsewhereLeaveItUnknown) {
    std::vector<Vec3> mixed = cornersOf(Hexahedron);
    mixed.emplace_back(0.5, 0.0, 0.0);
    EXPECT_EQ(findingsOf(Hexahedron, mixed).count("fe.straight_unknown"), 1) << "one edge has a node";
    std::vector<Vec3> cubic = cornersOf(Beam);
    cubic.emplace_back(1.0 / 3.0, 0.1, 0.0);
    cubic.emplace_back(2.0 / 3.0, 0.1, 0.0);
    EXPECT_EQ(findingsOf(Beam, cubic).count("fe.straight_unknown"), 1);
}

// A quarter of a ring, radii 9 and 10, width 1: whatever lies in its middles behind the twenty nodes changes nothing.
TEST(StraightEdges, WhatLiesInMiddlesBehindTheEdgesChangesNothing) {
    constexpr double quarter = 1.5707963267948966;
    const auto place = [](double radius, double share, double y) {
        return Vec3(radius * std::cos(share * quarter), y, radius * std::sin(share * quarter));
    };
    const std::array<std::array<double, 2>, 4> ring{{{9, 0}, {10, 0}, {10, 1}, {9, 1}}};
    const std::array<std::array<double, 2>, 4> middles{{{9.5, 0}, {10, 0.5}, {9.5, 1}, {9, 0.5}}};
    std::vector<Vec3> nodes;
    for (const auto& [list, y] : {std::pair{&ring, 0.0}, {&ring, 1.0}, {&middles, 0.0}, {&middles, 1.0}, {&ring, 0.5}}) {
        for (const std::array<double, 2>& at : *list) {
            nodes.push_back(place(at[0], at[1], y));
        }
    }
    for (std::size_t count = 20; count <= 27; ++count) {
        nodes.resize(count, place(9.5, 0.5, 0.5));
        const Findings findings = findingsOf(Hexahedron, nodes);
        ASSERT_EQ(findings.count("fe.straight_solids"), 1) << count;
        EXPECT_EQ(findings.count("fe.straight_unknown"), 0) << count;
        EXPECT_NEAR(std::get<double>(findings.list().front().what.arguments.at(0).value), -35.58, 0.01) << count;
    }
}

}  // namespace
}  // namespace rubble::io
