#include "io/case/mesh_terrain.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

#include "core/base/error.h"
#include "io/case/terrain_reader.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {

namespace {

using testing::HasSubstr;
using Corners = std::array<Vec3, 3>;

/// Ground of 20 x 10 m that rises by half a metre a metre along x, in squares of 1 m.
std::vector<Corners> slope() {
    std::vector<Corners> triangles;
    const auto at = [](int i, int j) { return Vec3(100.0 + i, 50.0 + j, 0.5 * i); };
    for (int i = 0; i < 20; ++i) {
        for (int j = 0; j < 10; ++j) {
            triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    return triangles;
}

class MeshTerrain : public testing::Test {
protected:
    std::string layObj(const std::vector<Corners>& triangles) {
        std::ofstream out(m_folder / "ground.obj");
        for (const Corners& triangle : triangles) {
            for (const Vec3& p : triangle) {
                out << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
            }
        }
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            out << "f " << 3 * t + 1 << ' ' << 3 * t + 2 << ' ' << 3 * t + 3 << '\n';
        }
        return m_folder / "ground.obj";
    }
    std::string layStl(const std::vector<Corners>& triangles, bool binary) {
        std::ofstream out(m_folder / "ground.stl", std::ios::binary);
        if (!binary) {
            out << "solid ground\n";
            for (const Corners& triangle : triangles) {
                out << "facet normal 0 0 1\nouter loop\n";
                for (const Vec3& p : triangle) {
                    out << "vertex " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
                }
                out << "endloop\nendfacet\n";
            }
            out << "endsolid\n";
            return m_folder / "ground.stl";
        }
        // Some programs begin binary files so as well.
        std::array<char, 80> head{};
        std::memcpy(head.data(), "solid", 5);
        out.write(head.data(), head.size());
        const auto count = static_cast<std::uint32_t>(triangles.size());
        out.write(reinterpret_cast<const char*>(&count), 4);
        for (const Corners& triangle : triangles) {
            std::array<float, 12> numbers{};
            for (std::size_t c = 0; c < 3; ++c) {
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    numbers[3 * (c + 1) + axis] = static_cast<float>(triangle[c][static_cast<Eigen::Index>(axis)]);
                }
            }
            out.write(reinterpret_cast<const char*>(numbers.data()), 48);
            out.write("\0\0", 2);
        }
        return m_folder / "ground.stl";
    }
    static TerrainInput open(const std::string& path) {
        return openTerrain(path, Frame(), Aabb(Vec3(105, 52, 5), Vec3(107, 54, 7)), Execution{});
    }

    TemporaryFolder m_folder;
};

TEST_F(MeshTerrain, HeightsAreThoseOfTheTriangles) {
    for (const std::string& path : {layObj(slope()), layStl(slope(), false), layStl(slope(), true)}) {
        const TerrainInput terrain = open(path);
        ASSERT_NE(terrain.grid, nullptr) << path;
        EXPECT_DOUBLE_EQ(terrain.grid->cell(), 0.5);
        for (const auto& [x, y] : {std::pair{103.25, 52.5}, {110.0, 59.0}, {119.9, 50.1}}) {
            EXPECT_NEAR(terrain.grid->height(x, y), 0.5 * (x - 100.0), 1e-6) << path << ' ' << x;
        }
        EXPECT_EQ(terrain.findings.count("terrain.mesh_layers"), 0) << path;
        EXPECT_EQ(terrain.findings.count("terrain.mesh_cells"), 1) << path;
        EXPECT_EQ(terrain.findings.count("surroundings.stl_unit"), path.ends_with(".stl") ? 1 : 0);
    }
}

TEST_F(MeshTerrain, SurfacesAboveEachOtherAreCounted) {
    std::vector<Corners> triangles = slope();
    // A roof of 2 x 2 m, 3 m above the ground there.
    triangles.push_back({Vec3(104, 54, 6), Vec3(106, 54, 6), Vec3(106, 56, 6)});
    triangles.push_back({Vec3(104, 54, 6), Vec3(106, 56, 6), Vec3(104, 56, 6)});
    const TerrainInput terrain = open(layObj(triangles));
    EXPECT_NEAR(terrain.grid->height(105.0, 55.0), 6.0, 1e-6);
    // 5 x 5 nodes on and within its outline, give or take the rounding of an odd cell.
    EXPECT_GE(terrain.findings.count("terrain.mesh_layers"), 16);
    EXPECT_LE(terrain.findings.count("terrain.mesh_layers"), 30);
}

TEST_F(MeshTerrain, WhatIsNoGroundIsRefused) {
    EXPECT_THROW(open(layObj({{Vec3(100, 50, 0), Vec3(110, 50, 0), Vec3(110, 50, 5)}})), ParseError);
    const std::string cut = layStl(slope(), true);
    std::filesystem::resize_file(cut, 84 + 50 * 3 + 7);
    std::fstream(cut, std::ios::in | std::ios::out | std::ios::binary).write("xxxxx", 5);
    try {
        open(cut);
        FAIL();
    } catch (const ParseError& error) {
        EXPECT_THAT(error.what(), testing::AllOf(HasSubstr("400"), HasSubstr("that of 3")));
    }
}

}  // namespace

}  // namespace rubble::io
