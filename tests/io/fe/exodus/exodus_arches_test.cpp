#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "core/fe/audit.h"
#include "io/fe/fe_reader.h"
#include "tests/support/places.h"

namespace rubble::io {
namespace {

using ::testing::ElementsAre;

struct Opened {
    explicit Opened(const std::string& name)
        : fe(openFe(sourcePath("resources/samples/") + name, {}, {}, Execution{})),
          components(groupComponents(fe->mesh(), {}, {}, {})),
          audit(auditDeaths(*fe, components, Execution{})) {
        for (const ComponentAudit& component : audit.components) {
            counts[component.name] = {component.elements, component.dead};
        }
        for (const Anomaly& anomaly : audit.anomalies) {
            anomalies[anomaly.kind] = anomaly.count;
        }
    }

    std::vector<std::int64_t> everyTenthState() const {
        std::vector<std::int64_t> result;
        for (std::size_t k = 10; k < audit.deadPerState.size(); k += 10) {
            result.push_back(audit.deadPerState[k]);
        }
        return result;
    }

    std::shared_ptr<const FeResult> fe;
    Components components;
    Audit audit;
    std::map<std::string, std::pair<std::int64_t, std::int64_t>> counts;
    std::map<std::string, std::int64_t> anomalies;
};

using StateCounts = std::pair<std::int64_t, std::int64_t>;

// StateCounts are exact. Masses are those that the description of the data gives in whole tonnes.
constexpr double tonne = 1000.0;

TEST(Arches, StoneArch) {
    const Opened arch("stone-arch.exo");
    const FeResult& fe = *arch.fe;
    EXPECT_EQ(fe.mesh().nodeCount(), 80'066u);
    EXPECT_EQ(fe.mesh().elementCount(), 60'660u);
    EXPECT_EQ(fe.stateCount(), 122u);
    EXPECT_EQ(fe.times().front(), 0.0);
    EXPECT_NEAR(fe.times().back(), 9.6803, 5e-5);
    EXPECT_FALSE(fe.contents().hasVelocity);
    EXPECT_EQ(fe.contents().deathTime.size(), 60'660u);
    EXPECT_EQ(fe.contents().activityFrom, "STATUS, 1 is active (by its name; 60,660 of 60,660 active at the first state)");
    EXPECT_TRUE(fe.contents().findings.empty());
    EXPECT_TRUE(arch.components.findings.empty());

    EXPECT_THAT(arch.everyTenthState(), ElementsAre(812, 1384, 2191, 4992, 11740, 20527, 27070, 42643, 46410, 49298, 49561, 49561));
    EXPECT_EQ(arch.audit.deadPerState[1], 0);
    EXPECT_EQ(arch.audit.deadPerState[2], 216);
    EXPECT_EQ(arch.audit.deadTotal, 49'561);
    EXPECT_NEAR(arch.audit.deadMass, 65'869 * tonne, 0.5 * tonne);
    EXPECT_NEAR(arch.audit.mass, 111'254 * tonne, 0.5 * tonne);
    EXPECT_EQ(arch.audit.components.size(), 24u);
    EXPECT_EQ(arch.counts.at("abutment west"), StateCounts(5040, 0));
    EXPECT_EQ(arch.counts.at("arch ring 1"), StateCounts(4320, 4320));
    EXPECT_EQ(arch.counts.at("arch ring 2"), StateCounts(4536, 4536));
    EXPECT_EQ(arch.counts.at("deck 4"), StateCounts(3024, 2858));
    EXPECT_EQ(arch.counts.at("pier 1"), StateCounts(3780, 3777));
    EXPECT_EQ(arch.counts.at("pier 2"), StateCounts(3780, 3769));
    EXPECT_EQ(arch.counts.at("pier 3"), StateCounts(3780, 3517));
    EXPECT_EQ(arch.counts.at("deck over pier 3"), StateCounts(216, 216));
    // Every exact death time lies in its bracket, nothing comes back, no dying shape is bad (volume ratio 0.94 to 1.01).
    EXPECT_TRUE(arch.anomalies.empty());
}

TEST(Arches, StoneArchWithItsStripsMergedAsInTheSampleCase) {
    const Opened arch("stone-arch.exo");
    const Components merged = groupComponents(arch.fe->mesh(),
                                              {MergeComponents{{"arch ring 1", "arch ring 1, failing strip"}, "arch ring 1"},
                                               MergeComponents{{"arch ring 4", "arch ring 4, failing strip"}, "arch ring 4"}},
                                              {}, {});
    EXPECT_EQ(merged.list.size(), 22u);
    double smallest = 1e9;
    for (const Component& component : merged.list) {
        smallest = std::min(smallest, component.bounds.sizes().x());
    }
    // The piers, 7.00 m to the rounding of coordinates to 1 mm; before, the strips with 3.10 m.
    EXPECT_NEAR(smallest, 7.00, 0.005);
    EXPECT_NEAR(arch.components.list.back().bounds.sizes().x(), 3.10, 0.005);
}

TEST(Arches, RcArch) {
    const Opened arch("rc-arch.exo");
    const FeResult& fe = *arch.fe;
    EXPECT_EQ(fe.mesh().nodeCount(), 32'632u);
    EXPECT_EQ(fe.mesh().elementCount(), 21'994u);
    EXPECT_EQ(fe.stateCount(), 112u);
    EXPECT_NEAR(fe.times().back(), 5.5499, 5e-5);
    EXPECT_THAT(arch.everyTenthState(), ElementsAre(144, 243, 409, 1814, 6264, 9139, 9253, 9367, 9437, 9445, 9643));
    EXPECT_EQ(arch.audit.deadPerState[2], 144);
    EXPECT_EQ(arch.audit.deadTotal, 9'643);
    EXPECT_NEAR(arch.audit.deadMass, 1'245 * tonne, 0.5 * tonne);
    EXPECT_NEAR(arch.audit.mass, 2'826 * tonne, 0.6 * tonne);
    EXPECT_EQ(arch.counts.at("arch rib 1"), StateCounts(2952, 1583));
    EXPECT_EQ(arch.counts.at("arch rib 2"), StateCounts(2952, 1560));
    EXPECT_EQ(arch.counts.at("arch rib 3"), StateCounts(2952, 1524));
    EXPECT_EQ(arch.counts.at("spandrel columns 3"), StateCounts(1008, 641));
    EXPECT_EQ(arch.counts.at("girder 3"), StateCounts(1500, 609));
    EXPECT_EQ(arch.counts.at("cross beams"), StateCounts(720, 469));
    EXPECT_EQ(arch.counts.at("west skewback hinge"), StateCounts(144, 144));
    EXPECT_EQ(arch.counts.at("deck slab"), StateCounts(4246, 172));
    EXPECT_EQ(arch.counts.at("deck slab under trucks"), StateCounts(504, 19));
    EXPECT_EQ(arch.audit.components.back().kind, "shell");
    EXPECT_NEAR(arch.audit.components.back().density, 10'780.0, 0.01);
    // Slabs die without an exact time; the two elements are those with 0.48 and 3.0 times their first volume.
    EXPECT_EQ(arch.anomalies, (std::map<std::string, std::int64_t>{{"no_death_time", 191}, {"large_distortion", 2}}));
    // The slab's thickness of 0.25 m is the smallest size of a component but for its camber.
    EXPECT_NEAR(arch.components.list.back().bounds.sizes().z(), 0.25, 0.02);
}

}  // namespace
}  // namespace rubble::io
