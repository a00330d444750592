#include <gtest/gtest.h>

#include "core/clusters/sizing.h"
#include "core/simulation/effects/decisions.h"
#include "tests/samples/arches.h"

namespace rubble {
namespace {

using Manifest = std::array<std::string, effectCount>;

/// "on: reason", in the order of the effects.
Manifest manifestOf(const arches::Arch& arch, LooseStructurePolicy loose) {
    Scenario scenario;
    scenario.effects.loose = loose;
    scenario.fragments.birthWindow = 0.0;
    const Sizing sizing = sizeBasicGrid(arch.fragments, arch.mesh(), arch.components, scenario.grid, Execution());
    const Clustering clusters = makeClusters(arch.fragments, arch.mesh(), sizing.grid, scenario.grid, Execution());
    Manifest lines;
    for (const EffectDecision& decision : decideEffects({*arch.fe, arch.components, arch.fragments, clusters, nullptr, scenario})) {
        lines[static_cast<std::size_t>(decision.kind)] =
            std::string(effectName(decision.kind)) + (decision.on ? " on: " : " off: ") + englishText(decision.reason);
    }
    return lines;
}

// Numbers are printed to four digits, so that only a change of the tests or of what they look at shows.
TEST(ArchEffects, TheManifestOfTheStoneArch) {
    EXPECT_EQ(
        manifestOf(arches::mergedStoneArch(), LooseStructurePolicy::Fe),
        (Manifest{"ground on: level ground at 0 m carries the debris; there is no terrain", "terrain off: the case has no terrain",
                  "structure_contact on: element 28,641 (spandrel walls 1) is active within the ballistic reach of the fragment of "
                  "element 60,229 (arch ring 1)",
                  "fragment_contact on: bodies can meet: the fall columns of element 60,229 (arch ring 1) and element 29,834 "
                  "(spandrel walls 1) overlap by 33.01 m",
                  "water off: no level of water is given (water_level)",
                  "air_drag on: at 29.73 m/s, the highest speed that the fragment of element 19,493 (arch ring 2) can have, its "
                  "weight is "
                  "only 14.05 times its drag, below 17",
                  "ties off: no component is marked as reinforced (component[NAME].reinforced)",
                  "break_up off: no cluster of two or more fragments is of stone or masonry without reinforcement"}));
}

TEST(ArchEffects, TheManifestOfTheConcreteArch) {
    EXPECT_EQ(
        manifestOf(arches::rcArch(), LooseStructurePolicy::Fe),
        (Manifest{
            "ground on: level ground at 0 m carries the debris; there is no terrain", "terrain off: the case has no terrain",
            "structure_contact on: element 8,946 (spandrel columns 1) is active within the ballistic reach of the fragment "
            "of element 17,101 (west skewback hinge)",
            "fragment_contact on: bodies can meet: the fall columns of element 17,101 (west skewback hinge) and element 10,321 "
            "(spandrel columns 2) overlap by 6.777 m",
            "water off: no level of water is given (water_level)",
            "air_drag on: at 21.47 m/s, the highest speed that the fragment of element 17,435 (deck slab) can have, its weight is "
            "only "
            "13.81 times its drag, below 17",
            "ties off: no component is marked as reinforced (component[NAME].reinforced)",
            "break_up off: no cluster of two or more fragments is of stone or masonry without reinforcement"}));
}

TEST(ArchEffects, SpansThatTheEngineMovesMeetDebrisAndWhatStands) {
    for (const arches::Arch* arch : {&arches::mergedStoneArch(), &arches::rcArch()}) {
        const Manifest fe = manifestOf(*arch, LooseStructurePolicy::Fe);
        const Manifest carried = manifestOf(*arch, LooseStructurePolicy::AtOnce);
        for (const EffectKind kind : {EffectKind::StructureContact, EffectKind::FragmentContact}) {
            const std::string& line = carried[static_cast<std::size_t>(kind)];
            EXPECT_NE(line.find(" on: the engine moves loose structure"), std::string::npos) << line;
        }
        for (const EffectKind kind : {EffectKind::Ground, EffectKind::Terrain, EffectKind::Water, EffectKind::Ties}) {
            EXPECT_EQ(carried[static_cast<std::size_t>(kind)], fe[static_cast<std::size_t>(kind)]);
        }
    }
}

}  // namespace
}  // namespace rubble
