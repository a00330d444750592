#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/case/terrain_reader.h"
#include "io/fe/fe_reader.h"
#include "tests/support/places.h"

namespace rubble::io {
namespace {

const std::string samples = sourcePath("resources/samples/");

/// The formula of river-valley.md.
double valley(double x, double y) {
    const double bank = std::max({0.0, -x, x - 80.0});
    const double shelf = 4.03 * std::clamp(1.0 - std::min(x, 80.0 - x) / 4.0, 0.0, 1.0);
    const double winding = 40.0 + 3.0 * std::sin(2.0 * std::numbers::pi * (y - 4.0) / 80.0);
    const double t = std::clamp((12.0 - std::abs(x - winding)) / 6.0, 0.0, 1.0);
    return bank + shelf - 0.05 - 4.0 * t * t * (3.0 - 2.0 * t);
}

TEST(RiverSample, TheTerrainIsThatOfItsFormula) {
    const TerrainInput terrain = openTerrain(samples + "river-valley.asc", Frame(), Aabb(), Execution());
    const TerrainGrid& grid = *terrain.grid;
    ASSERT_EQ(grid.nx(), 61u);
    ASSERT_EQ(grid.ny(), 41u);
    EXPECT_EQ(grid.x0(), -20.0);
    EXPECT_EQ(grid.y0(), -36.0);
    for (std::size_t j = 0; j < grid.ny(); ++j) {
        for (std::size_t i = 0; i < grid.nx(); ++i) {
            // The file has two decimals.
            EXPECT_NEAR(grid.node(i, j), valley(-20.0 + 2.0 * static_cast<double>(i), -36.0 + 2.0 * static_cast<double>(j)),
                        0.00501);
        }
    }
}

TEST(RiverSample, TheArchStandsOnItsShelves) {
    const std::string path = samples + "river-arch.rubble";
    const Case sample = loadCase(path);
    for (const CaseInput& input : sample.inputs) {
        EXPECT_EQ(sha256OfFile(inputPath(path, input)), input.sha256) << input.path;
    }
    const Scenario& scenario = sample.scenarios.front().scenario;
    const auto fe = openFe(inputPath(path, sample.inputs.front()), scenario.import, sample.frame, Execution());
    const TerrainInput terrain = openTerrainOfCase(sample, path, fe->mesh(), Execution());
    ASSERT_TRUE(terrain.grid);
    EXPECT_EQ(terrain.findings.list().size(), 1u);  // the format has no unit of height
    std::size_t standing = 0;
    for (const Vec3& node : fe->mesh().nodes) {
        const double above = node.z() - terrain.grid->height(node.x(), node.y());
        EXPECT_GT(above, 0.0);
        standing += above < 0.05;
    }
    EXPECT_GT(standing, 20u);
    ASSERT_TRUE(scenario.effects.waterLevel.has_value());
    EXPECT_GT(*scenario.effects.waterLevel, terrain.grid->lowest() + 3.0);
}

}  // namespace
}  // namespace rubble::io
