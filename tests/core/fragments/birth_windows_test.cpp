#include "core/fragments/birth_windows.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/fragments/fragment_set.h"
#include "tests/core/fragments/element_scene.h"

namespace rubble {
namespace {

using test::ElementScene;
using test::fragmentsOf;

const std::vector<Vec3> rightTetrahedron{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

ElementScene sceneOf(const std::vector<std::string>& activity, double stateInterval = 0.1) {
    ElementScene scene;
    for (const std::string& a : activity) {
        scene.element(ElementShape::Tetrahedron, rightTetrahedron, a);
    }
    for (std::size_t k = 0; k < activity.front().size(); ++k) {
        // As a file in single precision keeps them.
        scene.times.push_back(static_cast<float>(stateInterval * static_cast<double>(k)));
    }
    scene.position = [](const Vec3& x, double t) { return Vec3(x - Vec3(0, 0, 5 * t * t)); };
    return scene;
}

FragmentSettings windowOf(double seconds, Revival revival = Revival::Latch) {
    FragmentSettings settings;
    settings.birthWindow = seconds;
    settings.revival = revival;
    return settings;
}

std::vector<std::uint32_t> handOvers(const FragmentSet& set) {
    std::vector<std::uint32_t> found;
    for (const Fragment& fragment : set.list) {
        found.push_back(fragment.handOverState);
    }
    return found;
}

using States = std::vector<std::uint32_t>;

const std::vector<std::string> deaths{"111000000", "111100000", "111110000", "111111110", "111111111"};  // hand-overs 2, 3, 4, 7

TEST(BirthWindows, TakeStatesTogetherFromTheFirstOfThem) {
    const ElementScene scene = sceneOf(deaths);
    EXPECT_EQ(handOvers(fragmentsOf(scene, windowOf(0.0))), (States{2, 3, 4, 7}));
    EXPECT_EQ(handOvers(fragmentsOf(scene, windowOf(0.05))), (States{2, 3, 4, 7})) << "shorter than an interval";
    EXPECT_EQ(handOvers(fragmentsOf(scene, windowOf(0.1))), (States{2, 2, 4, 7}));
    EXPECT_EQ(handOvers(fragmentsOf(scene, windowOf(0.2))), (States{2, 2, 2, 7}));
    EXPECT_EQ(handOvers(fragmentsOf(scene, windowOf(0.3))), (States{2, 2, 2, 7}));
    EXPECT_EQ(handOvers(fragmentsOf(scene, windowOf(1000.0))), (States{2, 2, 2, 2}));
}

std::int64_t findingsOfWindow(const ElementScene& scene, double window) {
    return fragmentsOf(scene, windowOf(window)).findings.count("fragments.birth_window");
}

// A collapse of microseconds: the window of collapses of seconds makes one birth of all of them, and says so.
TEST(BirthWindows, OfMostOfACollapseAreAFindingWithAWindowThatFits) {
    const ElementScene blast = sceneOf(deaths, 1e-6);
    const FragmentSet set = fragmentsOf(blast, FragmentSettings());
    EXPECT_EQ(handOvers(set), (States{2, 2, 2, 2}));
    ASSERT_EQ(set.findings.list().size(), 1U);
    const Finding& finding = set.findings.list().front();
    EXPECT_EQ(
        englishText(finding.what),
        "The birth window of 0.1 s is long for a result that lasts 8e-06 s: deaths of 4 states become debris at 1, up to 5e-06 s "
        "early");
    EXPECT_TRUE(englishText(finding.remedy).starts_with("Set birth_window to a hundredth of that, 8e-08 s,"))
        << englishText(finding.remedy);
    EXPECT_EQ(handOvers(fragmentsOf(blast, windowOf(fittingBirthWindow(8e-6)))), (States{2, 3, 4, 7}));
    EXPECT_EQ(findingsOfWindow(blast, fittingBirthWindow(8e-6)), 0);
    EXPECT_EQ(findingsOfWindow(blast, 0.0), 0) << "each state by itself";
}

TEST(BirthWindows, OfALittleOfACollapseAreNone) {
    EXPECT_EQ(findingsOfWindow(sceneOf(deaths), 0.1), 0) << "an eighth of 0.8 s";
    EXPECT_EQ(findingsOfWindow(sceneOf(deaths), 0.3), 1) << "three eighths";
    EXPECT_EQ(findingsOfWindow(sceneOf({"1100", "1100", "1111"}), 1000.0), 0) << "all die in one state: nothing is joined";
    EXPECT_EQ(findingsOfWindow(sceneOf({"1111", "1111"}), 1000.0), 0) << "nothing dies";
}

TEST(BirthWindows, ThatFitHaveOneDigit) {
    EXPECT_EQ(fittingBirthWindow(10.0), 0.1) << "the default is of ten seconds";
    EXPECT_EQ(fittingBirthWindow(7e-5), 7e-7);
    EXPECT_EQ(fittingBirthWindow(9.64e-5), 1e-6);
    EXPECT_EQ(fittingBirthWindow(3'000.0), 30.0);
    EXPECT_EQ(fittingBirthWindow(0.0), 0.0);
}

TEST(BirthWindows, LeaveNumberOrderMassAndFormAsTheyAre) {
    const ElementScene scene = sceneOf({"11110", "11000", "11111", "10000", "11100"});
    const FragmentSet apart = fragmentsOf(scene, windowOf(0.0));
    const FragmentSet together = fragmentsOf(scene, windowOf(0.2));
    ASSERT_EQ(together.size(), apart.size());
    for (std::size_t i = 0; i < apart.size(); ++i) {
        EXPECT_EQ(together.list[i].element, apart.list[i].element);
        EXPECT_NEAR(together.list[i].mass, apart.list[i].mass, 1e-9 * apart.list[i].mass);
        EXPECT_LE(together.list[i].handOverState, apart.list[i].handOverState);
        EXPECT_EQ(together.list[i].birthState, together.list[i].handOverState + 1);
    }
    EXPECT_EQ(handOvers(together), (States{0, 0, 0, 3}));
}

TEST(BirthWindows, GiveTheMotionOfTheFirstState) {
    // 5 t^2 m of fall: at state 3 of 0.1 s the second-order difference is exact, 3 m/s.
    const FragmentSet together = fragmentsOf(sceneOf({"1111000", "1111110"}), windowOf(0.2));
    ASSERT_EQ(together.size(), 2u);
    EXPECT_NEAR(together.list[1].velocity.z(), -3.0, 1e-5) << "times are those of single precision";
    EXPECT_TRUE(together.list[1].centre.isApprox(together.list[0].centre, 1e-9));
}

TEST(BirthWindows, BeginAnewWhereAnElementAppearedInTheMiddle) {
    const ElementScene scene = sceneOf({"110000", "000100", "111110"});
    EXPECT_EQ(handOvers(fragmentsOf(scene, windowOf(10.0))), (States{1, 3, 3})) << "it is not there at state 1";
}

TEST(BirthWindows, FollowEachLifeOfAnElementThatComesBack) {
    const ElementScene scene = sceneOf({"1101100", "1111000"});
    const FragmentSet follow = fragmentsOf(scene, windowOf(10.0, Revival::Follow));
    EXPECT_EQ(handOvers(follow), (States{1, 1, 4}));
    EXPECT_NEAR(follow.list[0].endTime, 0.3, 1e-6);
    EXPECT_EQ(handOvers(fragmentsOf(scene, windowOf(10.0))), (States{1, 1}));
}

TEST(BirthWindows, TheStructureLosesWhatBecameDebris) {
    for (const Revival revival : {Revival::Latch, Revival::Follow}) {
        for (const double window : {0.0, 0.1, 0.2, 10.0}) {
            const ElementScene scene = sceneOf({"1101100", "1111000", "1111111", "0111110", "1111100"});
            const auto fe = scene.result();
            const FragmentSettings settings = windowOf(window, revival);
            const Activity activity = simulatedActivity(*fe, settings);
            const Activity file = activityUnder(fe->activity(), revival);
            std::size_t taken = 0;
            for (const Fragment& fragment : fragmentsOf(scene, settings).list) {
                EXPECT_TRUE(activity.active(fragment.handOverState, fragment.element));
                EXPECT_FALSE(activity.active(fragment.birthState, fragment.element));
                for (std::uint32_t k = fragment.birthState; file.active(k, fragment.element) && fragment.endTime > fe->times()[k];
                     ++k) {
                    EXPECT_FALSE(activity.active(k, fragment.element)) << k;
                    ++taken;
                }
            }
            std::size_t fewer = 0;
            for (std::size_t k = 0; k < fe->stateCount(); ++k) {
                fewer += file.activeCount(k) - activity.activeCount(k);
            }
            EXPECT_EQ(fewer, taken) << "nothing else changes";
            EXPECT_EQ(fewer == 0, window == 0.0);
        }
    }
}

TEST(BirthWindows, AreNotReadWithExactTimes) {
    FragmentSettings settings = windowOf(0.1);
    settings.birthTime = BirthTime::Exact;
    const ElementScene scene = sceneOf(deaths);
    EXPECT_EQ(handOvers(fragmentsOf(scene, settings)), (States{2, 3, 4, 7}));
    const auto fe = scene.result();
    const Activity activity = simulatedActivity(*fe, settings);
    for (std::size_t k = 0; k < fe->stateCount(); ++k) {
        EXPECT_EQ(activity.activeCount(k), fe->activity().activeCount(k)) << k;
    }
}

}  // namespace
}  // namespace rubble
