#include "core/clusters/grid_outline.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/core/clusters/fragment_blocks.h"

namespace rubble {
namespace {

/// A solid row of unit cubes along each axis.
FragmentBlocks brick(int nx, int ny, int nz) {
    FragmentBlocks blocks;
    const ComponentId all = blocks.component("all", Vec3::Zero(), Vec3(nx, ny, nz));
    for (int x = 0; x < nx; ++x) {
        for (int y = 0; y < ny; ++y) {
            for (int z = 0; z < nz; ++z) {
                blocks.add(Vec3(x, y, z) + Vec3(3.0, -2.0, 7.0), Vec3::Ones(), all);
            }
        }
    }
    return blocks;
}

/// Lines that a brick of cells has on its surface: on every face the lines of its grid, those on the rims once.
std::size_t surfaceLines(std::size_t nx, std::size_t ny, std::size_t nz) {
    const auto along = [](std::size_t n, std::size_t a, std::size_t b) { return n * ((a + 1) * (b + 1) - (a - 1) * (b - 1)); };
    return along(nx, ny, nz) + along(ny, nx, nz) + along(nz, nx, ny);
}

}  // namespace

TEST(GridOutline, ABrickShowsItsSurfaceAndNothingInside) {
    const FragmentBlocks blocks = brick(6, 4, 4);
    EXPECT_EQ(gridOutline(blocks.set, {1.0, 1.0, 1.0}).size(), 2 * surfaceLines(6, 4, 4));
    const auto lines = gridOutline(blocks.set, {2.0, 4.0, 1.0});
    EXPECT_EQ(lines.size(), 2 * surfaceLines(3, 1, 4));
    Eigen::AlignedBox3f box;
    for (std::size_t i = 0; i < lines.size(); i += 2) {
        box.extend(lines[i]);
        box.extend(lines[i + 1]);
        const Eigen::Vector3f along = lines[i + 1] - lines[i];
        // Exact: all places are whole numbers below 2^24.
        EXPECT_EQ(along.minCoeff(), 0.0f);
        EXPECT_TRUE(along.sum() == 2.0f || along.sum() == 4.0f || along.sum() == 1.0f);
    }
    EXPECT_EQ(box.min(), Eigen::Vector3f(3, -2, 7));
    EXPECT_EQ(box.max(), Eigen::Vector3f(9, 2, 11));
}

TEST(GridOutline, CellsWithoutFragmentsAreNotDrawn) {
    FragmentBlocks blocks = brick(1, 1, 1);
    blocks.add(Vec3(100.0, -2.0, 7.0), Vec3::Ones());
    EXPECT_EQ(gridOutline(blocks.set, {1.0, 1.0, 1.0}).size(), 2u * 12u * 2u);
}

TEST(GridOutline, SizesThatAreNoneDrawNothing) {
    const FragmentBlocks blocks = brick(2, 2, 2);
    const double none = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(gridOutline(blocks.set, {0.0, 1.0, 1.0}).empty());
    EXPECT_TRUE(gridOutline(blocks.set, {1.0, -1.0, 1.0}).empty());
    EXPECT_TRUE(gridOutline(blocks.set, {1.0, 1.0, none}).empty());
    EXPECT_TRUE(gridOutline(blocks.set, {1e-9, 1.0, 1.0}).empty());
    EXPECT_TRUE(gridOutline(FragmentSet(), {1.0, 1.0, 1.0}).empty());
}

}  // namespace rubble
