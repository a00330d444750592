#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/fragments/fragment_set.h"
#include "io/fe/fe_reader.h"
#include "tests/support/places.h"

// The two sample results through reader, components and fragments, against what is known of them from independent scripts.

namespace rubble {
namespace {

struct Arch {
    std::shared_ptr<const FeResult> fe;
    Components components;
    FragmentSet fragments;
};

/// Read once for all tests.
const Arch& arch(const std::string& name) {
    static std::map<std::string, Arch> arches;
    Arch& arch = arches[name];
    if (!arch.fe) {
        arch.fe = io::openFe(sourcePath("resources/samples/") + name + ".exo", {}, {}, Execution());
        arch.components = groupComponents(arch.fe->mesh(), {}, {}, {});
        // Each state by itself, as the independent scripts count them.
        FragmentSettings byState;
        byState.birthWindow = 0.0;
        arch.fragments = makeFragments(*arch.fe, arch.components, byState, Execution());
    }
    return arch;
}

std::vector<std::size_t> deadAt(const Arch& arch, const std::vector<std::uint32_t>& states) {
    std::vector<std::size_t> counts;
    for (const std::uint32_t state : states) {
        counts.push_back(static_cast<std::size_t>(
            std::ranges::count_if(arch.fragments.list, [&](const Fragment& f) { return f.birthState <= state; })));
    }
    return counts;
}

double total(const FragmentSet& set, double (*of)(const Fragment&)) {
    double sum = 0.0;
    for (const Fragment& f : set.list) {
        sum += of(f);
    }
    return sum;
}

struct Distribution {
    double median, high, most;
};

Distribution distributionOf(std::vector<double> values) {
    std::ranges::sort(values);
    return {values[values.size() / 2], values[values.size() * 95 / 100], values.back()};
}

Distribution speeds(const Arch& arch) {
    std::vector<double> values;
    for (const Fragment& f : arch.fragments.list) {
        values.push_back(f.velocity.norm());
    }
    return distributionOf(values);
}

/// Plain differences of the mean of an element's nodes over its last interval: another way to the speed, half an interval late.
Distribution centroidSpeeds(const Arch& arch) {
    std::vector<double> values;
    for (const Fragment& f : arch.fragments.list) {
        const auto now = arch.fe->state(f.handOverState);
        const auto before = arch.fe->state(f.handOverState - 1);
        Vec3 path = Vec3::Zero();
        const auto corners = arch.fe->mesh().cornersOf(f.element);
        for (const std::uint32_t node : corners) {
            path += (now->positions[node] - before->positions[node]) / static_cast<double>(corners.size());
        }
        values.push_back(path.norm() / (now->time - before->time));
    }
    return distributionOf(values);
}

/// Sums over the fragments of each hand-over state: the element side and the rigid side.
std::map<std::uint32_t, std::pair<Momenta, Momenta>> ledger(const FragmentSet& set) {
    std::map<std::uint32_t, std::pair<Momenta, Momenta>> sums;
    for (const Fragment& f : set.list) {
        sums[f.handOverState].first += f.fe;
        sums[f.handOverState].second += rigidMomenta(f.mass, f.centre, f.inertia, f.velocity, f.angularVelocity);
    }
    return sums;
}

void expectLedgerCloses(const FragmentSet& set) {
    for (const auto& [state, sides] : ledger(set)) {
        const auto& [fe, rigid] = sides;
        // The issue asks for 1e-9; nothing but rounding is left.
        EXPECT_NEAR(rigid.mass, fe.mass, 1e-12 * fe.mass) << state;
        EXPECT_LE((rigid.linear - fe.linear).norm(), 1e-12 * fe.linear.norm()) << state;
        EXPECT_LE((rigid.angular - fe.angular).norm(), 1e-12 * fe.angular.norm()) << state;
        EXPECT_LE(rigid.kineticEnergy, fe.kineticEnergy * (1.0 + 1e-12)) << state;
    }
}

std::map<std::string, std::int64_t> deadByComponent(const Arch& arch) {
    std::map<std::string, std::int64_t> dead;
    for (const Fragment& f : arch.fragments.list) {
        ++dead[arch.components.list[at(f.component)].name];
    }
    return dead;
}

TEST(FragmentsOfTheStoneArch, CountsAndMassAreThoseOfTheFile) {
    const Arch& a = arch("stone-arch");
    EXPECT_EQ(a.fragments.size(), 49561u);
    EXPECT_EQ(deadAt(a, {1, 2, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 110}),
              (std::vector<std::size_t>{0, 216, 812, 1384, 2191, 4992, 11740, 20527, 27070, 42643, 46410, 49298, 49561}));
    EXPECT_NEAR(total(a.fragments, [](const Fragment& f) { return f.mass; }), 65'869e3, 500.0);
    std::set<std::uint32_t> births;
    for (const Fragment& f : a.fragments.list) {
        births.insert(f.birthState);
        EXPECT_EQ(f.birthState, f.handOverState + 1);
    }
    EXPECT_EQ(births.size(), 101u);
    const auto dead = deadByComponent(a);
    EXPECT_EQ(dead.size(), 20u);
    EXPECT_EQ(dead.at("pier 3"), 3517);
    EXPECT_EQ(dead.at("deck 4"), 2858);
    EXPECT_EQ(dead.at("arch ring 2"), 4536);
    EXPECT_TRUE(a.fragments.findings.empty());
}

TEST(FragmentsOfTheStoneArch, SpeedsAreThoseOfTheFall) {
    const Arch& a = arch("stone-arch");
    const Distribution plain = centroidSpeeds(a);
    EXPECT_NEAR(plain.median, 24.0, 0.5);  // known to two digits only
    EXPECT_NEAR(plain.high, 26.6, 0.1);
    EXPECT_NEAR(plain.most, 28.7, 0.05);
    // Velocities are of the end of the interval, not of its middle: up to g dt / 2 = 0.39 m/s more for what falls freely.
    const Distribution ours = speeds(a);
    EXPECT_NEAR(ours.median - plain.median, 0.2, 0.2);
    EXPECT_NEAR(ours.high - plain.high, 0.3, 0.1);
    EXPECT_NEAR(ours.most - plain.most, 0.4, 0.1);
}

TEST(FragmentsOfTheStoneArch, LedgerClosesAtEveryHandOver) {
    expectLedgerCloses(arch("stone-arch").fragments);
}

TEST(FragmentsOfTheStoneArch, BoxesAreLean) {
    const Arch& a = arch("stone-arch");
    double boxes = 0.0, axisBoxes = 0.0, material = 0.0;
    for (const Fragment& f : a.fragments.list) {
        boxes += f.box.volume();
        axisBoxes += f.bounds.volume();
        material += a.components.volume[at(f.element)];
    }
    // Measured by an independent script: 1.64 along the axes; its oriented boxes 1.15, ours may only be leaner.
    EXPECT_NEAR(axisBoxes / material, 1.64, 0.005);
    EXPECT_LT(boxes / material, 1.1);
    EXPECT_GT(boxes / material, 1.0);
}

TEST(FragmentsOfTheStoneArch, ExactBirthsLeaveThreeFragmentsToABirth) {
    const Arch& a = arch("stone-arch");
    FragmentSettings settings;
    settings.birthTime = BirthTime::Exact;
    const FragmentSet exact = makeFragments(*a.fe, a.components, settings, Execution());
    std::map<double, int> births;
    for (const Fragment& f : exact.list) {
        ++births[f.birthTime];
        EXPECT_GE(f.birthTime, f.handOverTime);
        EXPECT_LE(f.birthTime, a.fe->times()[f.birthState]);
    }
    std::vector<int> together;
    for (const auto& [time, count] : births) {
        together.push_back(count);
    }
    std::ranges::sort(together);
    EXPECT_EQ(together[together.size() / 2], 3);
    EXPECT_TRUE(exact.findings.empty());
}

TEST(FragmentsOfTheRcArch, CountsAndMassAreThoseOfTheFile) {
    const Arch& a = arch("rc-arch");
    EXPECT_EQ(a.fragments.size(), 9643u);
    EXPECT_EQ(deadAt(a, {1, 2, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 110}),
              (std::vector<std::size_t>{0, 144, 144, 243, 409, 1814, 6264, 9139, 9253, 9367, 9437, 9445, 9643}));
    EXPECT_NEAR(total(a.fragments, [](const Fragment& f) { return f.mass; }), 1'245e3, 500.0);
    const auto dead = deadByComponent(a);
    EXPECT_EQ(dead.at("arch rib 1"), 1583);
    EXPECT_EQ(dead.at("deck slab"), 172);
    EXPECT_EQ(dead.at("deck slab under trucks"), 19);
    EXPECT_EQ(a.fragments.findings.list().size(), 1U);
    EXPECT_EQ(a.fragments.findings.count("fragments.far_from_rest"), 2) << "those that the audit finds distorted";
    // Shells become solids of their thickness.
    for (std::size_t i = 0; i < a.fragments.size(); ++i) {
        if (a.fe->mesh().shapes[at(a.fragments.list[i].element)] == ElementShape::Quadrilateral) {
            EXPECT_EQ(a.fragments.solid[i], ElementShape::Hexahedron);
            const auto x = a.fragments.verticesOf(idAt<FragmentId>(i));
            EXPECT_NEAR((x[4] - x[0]).norm(), 0.25, 1e-9);
        }
    }
}

TEST(FragmentsOfTheRcArch, SpeedsAreThoseOfTheFall) {
    const Arch& a = arch("rc-arch");
    const Distribution plain = centroidSpeeds(a);
    EXPECT_NEAR(plain.median, 13.0, 0.5);
    EXPECT_NEAR(plain.high, 16.0, 0.5);
    EXPECT_NEAR(plain.most, 24.0, 0.5);
    const Distribution ours = speeds(a);
    EXPECT_NEAR(ours.median, 13.0, 0.5);
    EXPECT_NEAR(ours.high, 16.0, 0.5);
    EXPECT_GT(ours.most, plain.most);
    EXPECT_LT(ours.most, plain.most + 2.0);
}

TEST(FragmentsOfTheRcArch, LedgerClosesAtEveryHandOver) {
    expectLedgerCloses(arch("rc-arch").fragments);
}

TEST(FragmentsOfTheRcArch, DeadShellsHaveNoExactDeathTime) {
    const Arch& a = arch("rc-arch");
    FragmentSettings settings;
    settings.birthTime = BirthTime::Exact;
    EXPECT_EQ(makeFragments(*a.fe, a.components, settings, Execution()).findings.count("fragments.no_death_time"), 191);
}

}  // namespace
}  // namespace rubble
