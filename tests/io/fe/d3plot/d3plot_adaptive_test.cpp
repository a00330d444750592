#include "io/fe/d3plot/d3plot_adaptive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "core/base/unknown.h"
#include "io/fe/fe_reader.h"
#include "io/fe/series/series_result.h"
#include "tests/io/fe/d3plot/d3plot_builder.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

using ::testing::ElementsAre;

std::vector<std::size_t> deadOf(const Activity& activity) {
    std::vector<std::size_t> counts;
    for (std::size_t k = 0; k < activity.states(); ++k) {
        counts.push_back(activity.elements() - activity.activeCount(k));
    }
    return counts;
}

TEST(D3plotAdaptive, LaterMeshesOfARunAreOneResult) {
    TemporaryFolder folder;
    D3plotBuilder builder;
    builder.cubes = 3;
    builder.times = {0.0, 1.0, 2.5};
    builder.write(folder / "d3plot");
    builder.cubes = 4;
    builder.times = {2.0, 3.0};
    builder.deaths = {{1, 0}};
    builder.write(folder / "d3plotaa");
    builder.times = {4.0};
    builder.write(folder / "d3plotab");
    for (const char* given : {"/d3plot", "/d3plotaa", "/d3plotaa01", "/d3plotab", ""}) {
        const auto fe = openFe(folder.path() + given, {}, {}, Execution{});
        // The state at 2.5 s was given up for the new mesh.
        EXPECT_THAT(fe->times(), ElementsAre(0.0, 1.0, 2.0, 3.0, 4.0)) << given;
        EXPECT_EQ(fe->mesh().elementCount(), 4u);
        EXPECT_THAT(deadOf(fe->activity()), ElementsAre(1, 1, 1, 1, 1)) << given;
        EXPECT_FALSE(fe->activity().active(2, idAt<ElementIndex>(1)));
        EXPECT_TRUE(fe->activity().active(2, idAt<ElementIndex>(3)));
        EXPECT_FALSE(fe->activity().active(1, idAt<ElementIndex>(3)));
        EXPECT_NEAR(fe->state(3)->positions[0].x() - fe->mesh().nodes[0].x(), 3.0, 1e-5);
        EXPECT_EQ(fe->contents().findings.count("d3plot.adaptive"), 3);
        EXPECT_EQ(fe->contents().findings.count("d3plot.left_behind"), 0);
    }
}

// The table of deaths of each state counts, from the first state of a new mesh on.
TEST(D3plotAdaptive, DeathsOfALaterMeshCountFromTheirState) {
    for (const std::size_t firstDead : {std::size_t{0}, std::size_t{1}}) {
        TemporaryFolder folder;
        D3plotBuilder builder;
        builder.cubes = 4;
        builder.statesPerFile = 1;
        builder.times = {0.0, 0.1};
        builder.write(folder / "d3plot");
        builder.cubes = 5;
        builder.times = {0.2, 0.3};
        builder.deaths = {{1, firstDead}};
        builder.write(folder / "d3plotaa");
        const auto fe = openFe(folder.path(), {}, {}, Execution{});
        ASSERT_EQ(fe->stateCount(), 4u);
        EXPECT_NEAR(fe->times()[2], 0.2, 1e-6);
        EXPECT_EQ(fe->contents().files.size(), 6u);
        for (std::size_t k = 0; k < 4; ++k) {
            EXPECT_EQ(fe->activity().active(k, idAt<ElementIndex>(1)), k < 2 + firstDead) << k << " of " << firstDead;
        }
    }
}

/// Places that never move.
class Still : public StateSource {
public:
    explicit Still(std::shared_ptr<const Mesh> mesh) : m_mesh(std::move(mesh)) {}
    FeState read(std::size_t) const override { return {0.0, m_mesh->nodes, {}}; }

private:
    std::shared_ptr<const Mesh> m_mesh;
};

// Shells in the plane. @param active  a digit an element, a text a state
FeResult::Contents shells(const std::vector<Vec3>& nodes, const std::vector<std::array<std::uint32_t, 4>>& corners,
                          const std::vector<std::int64_t>& numbers, double time, const std::vector<std::string>& active) {
    auto mesh = std::make_shared<Mesh>();
    mesh->nodes = nodes;
    mesh->offsets.push_back(0);
    mesh->parts.push_back({"slab", 1});
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        mesh->nodeIds.push_back(static_cast<std::int64_t>(n) + 1);
    }
    for (std::size_t e = 0; e < corners.size(); ++e) {
        mesh->elementIds.push_back(numbers[e]);
        mesh->shapes.push_back(ElementShape::Quadrilateral);
        mesh->part.push_back(0);
        mesh->corners.insert(mesh->corners.end(), corners[e].begin(), corners[e].end());
        mesh->offsets.push_back(static_cast<std::uint32_t>(mesh->corners.size()));
        mesh->density.push_back(unknown);
        mesh->section.push_back(0.1);
    }
    FeResult::Contents contents;
    contents.activity = Activity(active.size(), corners.size());
    for (std::size_t k = 0; k < active.size(); ++k) {
        contents.times.push_back(time + static_cast<double>(k));
        for (std::size_t e = 0; e < corners.size(); ++e) {
            contents.activity.set(k, idAt<ElementIndex>(e), active[k][e] == '1');
        }
    }
    contents.activityFrom = "table";
    contents.source = std::make_shared<const Still>(mesh);
    contents.mesh = mesh;
    return contents;
}

// A refined element is neither dead nor twice there: it lives as long as one of the four in its place.
TEST(D3plotAdaptive, RefinedElementsStayUntilAllPartsOfThemDie) {
    const std::vector<Vec3> coarse{{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {0, 2, 0}, {2, 2, 0}, {4, 2, 0}};
    std::vector<Vec3> fine = coarse;
    for (const Vec3& node : {Vec3(1, 0, 0), Vec3(2, 1, 0), Vec3(1, 2, 0), Vec3(0, 1, 0), Vec3(1, 1, 0)}) {
        fine.push_back(node);
    }
    std::vector<FeResult::Contents> families;
    families.push_back(shells(coarse, {{0, 1, 4, 3}, {1, 2, 5, 4}}, {1, 2}, 0.0, {"11", "11"}));
    families.push_back(shells(fine, {{1, 2, 5, 4}, {0, 6, 10, 9}, {6, 1, 7, 10}, {10, 7, 4, 8}, {9, 10, 8, 3}}, {2, 3, 4, 5, 6},
                              2.0, {"11111", "10011", "10000"}));
    ASSERT_TRUE(AdaptiveSeries::joinable(families));
    const auto read = readSeries("d3plot", std::make_shared<AdaptiveSeries>(std::move(families)), {}, Execution{});
    EXPECT_EQ(read.mesh->elementIds, (std::vector<std::int64_t>{1, 2}));
    EXPECT_THAT(deadOf(read.activity), ElementsAre(0, 0, 0, 0, 1));
    EXPECT_FALSE(read.activity.active(4, idAt<ElementIndex>(0)));
    EXPECT_EQ(read.source->read(3).positions.size(), 11u);
}

}  // namespace
}  // namespace rubble::io
