#include "widgets/render/pane_geometry.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/scenes/fe_scenes.h"
#include "tests/widgets/scenes/ballistic_run.h"

namespace rubble::render {
namespace {

ColourScale scaleOfTests() {
    ColourScale scale;
    scale.colours.fragment = {213, 94, 0};
    scale.colours.structure = {{100, 100, 100}, {120, 120, 120}, {140, 140, 140}, {160, 160, 160}, {180, 180, 180}};
    scale.colours.categories = {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
    for (std::size_t i = 0; i < 256; ++i) {
        scale.colours.birthRamp[i] = {static_cast<std::uint8_t>(i), 1, 0};
        scale.colours.speedRamp[i] = {static_cast<std::uint8_t>(i), 2, 0};
    }
    scale.lastBirth = 0.4;
    scale.speedTop = 10.0;
    return scale;
}

Rgb colourOf(const PaneGeometry& pane, std::size_t point) {
    return {pane.colours()[4 * point], pane.colours()[4 * point + 1], pane.colours()[4 * point + 2]};
}

std::size_t pointsOfColour(const PaneGeometry& pane, const Rgb& colour) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < pane.points().size() / 3; ++i) {
        count += colourOf(pane, i) == colour;
    }
    return count;
}

/// Area of all triangles, m2: what is shown twice, or not at all, changes it.
double area(const PaneGeometry& pane) {
    double sum = 0.0;
    const auto p = [&](std::size_t i) {
        const auto at = 3 * static_cast<std::size_t>(pane.triangles()[i]);
        return Vec3(pane.points()[at], pane.points()[at + 1], pane.points()[at + 2]);
    };
    for (std::size_t i = 0; i < pane.triangles().size(); i += 3) {
        sum += 0.5 * (p(i + 1) - p(i)).cross(p(i + 2) - p(i)).norm();
    }
    return sum;
}

class PaneContents : public testing::Test {
protected:
    std::shared_ptr<const FeResult> m_fe = scenes::collapsingWall(4, 3);
    ColourScale m_scale = scaleOfTests();
    std::vector<ElementIndex> m_nothing;
};

TEST_F(PaneContents, EveryElementIsShownOnceAtEveryTime) {
    const SceneData run = scenes::ballisticRun(m_fe, 1.0);
    for (const bool simulated : {true, false}) {
        SceneData data = run;
        data.trajectory = simulated ? run.trajectory : nullptr;
        PaneGeometry pane(PaneContent::Fragments, data, true);
        for (double t = 0.0; t < 0.9; t += 0.013) {
            pane.update(t, ColourBy::Highlight, m_scale, m_nothing);
            // All faces of all 16 unit cubes, each once; they only move rigidly here.
            EXPECT_NEAR(area(pane), 16 * 6.0, 1e-3) << t;
            EXPECT_EQ(pane.status().active + pane.status().fragments, 16u) << t;
        }
    }
}

TEST_F(PaneContents, CountsFollowTheFileInTheFePane) {
    PaneGeometry pane(PaneContent::Fe, scenes::ballisticRun(m_fe, 1.0), false);
    for (std::size_t k = 0; k < m_fe->stateCount(); ++k) {
        pane.update(m_fe->times()[k], ColourBy::Highlight, m_scale, m_nothing);
        EXPECT_EQ(pane.status().active, m_fe->activity().activeCount(k));
        EXPECT_EQ(pane.status().state, k);
        EXPECT_FALSE(pane.status().interpolated);
        EXPECT_EQ(pane.status().fragments, 0u);
    }
    pane.update(0.33, ColourBy::Highlight, m_scale, m_nothing);
    EXPECT_TRUE(pane.status().interpolated);
    EXPECT_EQ(pane.status().kind, FrameKind::Interpolated);
}

TEST_F(PaneContents, TimesCloseToAStateAreThatState) {
    PaneGeometry pane(PaneContent::Fe, scenes::withoutRun(m_fe), false);
    pane.update(0.2 - 0.0005, ColourBy::Highlight, m_scale, m_nothing);
    EXPECT_EQ(pane.status().state, 2u);
    EXPECT_FALSE(pane.status().interpolated);
    pane.update(0.2 - 0.005, ColourBy::Highlight, m_scale, m_nothing);
    EXPECT_EQ(pane.status().state, 1u);
    EXPECT_TRUE(pane.status().interpolated);
}

TEST_F(PaneContents, FragmentsTurnVermilionAtTheirBirthAndNotBefore) {
    PaneGeometry pane(PaneContent::Fragments, scenes::ballisticRun(m_fe, 1.0), false);
    pane.update(0.15, ColourBy::Highlight, m_scale, m_nothing);  // handed over at 0.1, born at 0.2
    EXPECT_EQ(pointsOfColour(pane, m_scale.colours.fragment), 0u);
    EXPECT_EQ(pane.status().fragments, 0u);
    pane.update(0.2, ColourBy::Highlight, m_scale, m_nothing);
    EXPECT_GT(pointsOfColour(pane, m_scale.colours.fragment), 0u);
    EXPECT_EQ(pane.status().fragments, 6u);
    ASSERT_EQ(pane.status().bornByComponent.size(), 2u);
    EXPECT_EQ(pane.status().bornByComponent[0], 6u);
    EXPECT_EQ(pane.status().bornByComponent[1], 0u);
}

TEST_F(PaneContents, GeometryDoesNotJumpAtHandOverAndBirth) {
    PaneGeometry pane(PaneContent::Fragments, scenes::ballisticRun(m_fe, 1.0), false);
    const auto box = [&](double t) {
        pane.update(t, ColourBy::Highlight, m_scale, m_nothing);
        Eigen::AlignedBox3f bounds;
        for (std::size_t i = 0; i < pane.points().size(); i += 3) {
            bounds.extend(Eigen::Vector3f(pane.points()[i], pane.points()[i + 1], pane.points()[i + 2]));
        }
        return bounds;
    };
    for (const double event : {0.1, 0.2, 0.3, 0.4}) {
        const auto before = box(event - 0.0011), after = box(event + 0.0011);
        EXPECT_LT((before.min() - after.min()).norm(), 0.05f) << event;  // 2.2 ms at the speeds of this scene
        EXPECT_LT((before.max() - after.max()).norm(), 0.05f) << event;
    }
}

TEST_F(PaneContents, AGrowingRunIsShownAsFarAsItGoes) {
    PaneGeometry pane(PaneContent::Fragments, scenes::ballisticRun(m_fe, 0.32, false), false);
    pane.update(0.6, ColourBy::Highlight, m_scale, m_nothing);
    EXPECT_TRUE(pane.status().waitsForRun);
    EXPECT_NEAR(pane.status().time, 0.32, 1e-9);
    EXPECT_EQ(pane.status().fragments, 6u);
    PaneGeometry done(PaneContent::Fragments, scenes::ballisticRun(m_fe, 0.32, true), false);
    done.update(0.6, ColourBy::Highlight, m_scale, m_nothing);
    EXPECT_FALSE(done.status().waitsForRun);
}

TEST_F(PaneContents, ARunThatBeginsLaterIsTakenUp) {
    const SceneData finished = scenes::ballisticRun(m_fe, 0.6);
    SceneData data = finished;
    auto growing = std::make_shared<MemoryTrajectory>();
    growing->begin({});
    data.trajectory = growing;
    PaneGeometry pane(PaneContent::Fragments, data, false);
    pane.update(0.5, ColourBy::Highlight, m_scale, m_nothing);
    EXPECT_FALSE(pane.status().simulated);
    growing->addBodies(finished.trajectory->bodies(), finished.trajectory->carriers());
    for (std::size_t i = 0; i < finished.trajectory->frameCount(); ++i) {
        growing->commit(*finished.trajectory->frame(i));
    }
    pane.update(0.5, ColourBy::Highlight, m_scale, m_nothing);
    EXPECT_TRUE(pane.status().simulated);
    PaneGeometry fresh(PaneContent::Fragments, finished, false);
    fresh.update(0.5, ColourBy::Highlight, m_scale, m_nothing);
    EXPECT_EQ(pane.points(), fresh.points());
    EXPECT_EQ(pane.triangles(), fresh.triangles());
}

TEST_F(PaneContents, ScrubbingGivesTheSamePictureAsPlaying) {
    const SceneData data = scenes::ballisticRun(m_fe, 1.0);
    PaneGeometry played(PaneContent::Fragments, data, false);
    for (double t = 0.0; t < 0.8; t += 0.017) {
        played.update(t, ColourBy::Speed, m_scale, m_nothing);
        PaneGeometry jumped(PaneContent::Fragments, data, false);
        jumped.update(t, ColourBy::Speed, m_scale, m_nothing);
        EXPECT_EQ(played.points(), jumped.points());
        EXPECT_EQ(played.triangles(), jumped.triangles());
        EXPECT_EQ(played.colours(), jumped.colours());
    }
}

TEST_F(PaneContents, OnlyWhatChangedGetsANewVersion) {
    PaneGeometry pane(PaneContent::Fragments, scenes::ballisticRun(m_fe, 1.0), false);
    pane.update(0.5, ColourBy::Highlight, m_scale, m_nothing);
    const auto points = pane.pointsVersion(), triangles = pane.trianglesVersion(), colours = pane.coloursVersion();
    pane.update(0.5, ColourBy::Highlight, m_scale, m_nothing);
    EXPECT_EQ(pane.pointsVersion(), points);
    pane.update(0.55, ColourBy::Highlight, m_scale, m_nothing);
    EXPECT_GT(pane.pointsVersion(), points);
    EXPECT_EQ(pane.trianglesVersion(), triangles);
    EXPECT_EQ(pane.coloursVersion(), colours);
    pane.update(0.55, ColourBy::Component, m_scale, m_nothing);
    EXPECT_GT(pane.coloursVersion(), colours);
    EXPECT_EQ(pane.trianglesVersion(), triangles);
}

TEST_F(PaneContents, ColoursSayWhatTheyStandFor) {
    PaneGeometry pane(PaneContent::Fragments, scenes::ballisticRun(m_fe, 1.0), false);
    pane.update(0.5, ColourBy::Component, m_scale, m_nothing);
    EXPECT_GT(pointsOfColour(pane, {1, 0, 0}), 0u);  // the wall, first category
    pane.update(0.5, ColourBy::BirthTime, m_scale, m_nothing);
    EXPECT_GT(pointsOfColour(pane, {128, 1, 0}), 0u);  // born at 0.2 of 0.4 s
    EXPECT_GT(pointsOfColour(pane, {255, 1, 0}), 0u);  // born at 0.4 s
    pane.update(0.5, ColourBy::Speed, m_scale, m_nothing);
    EXPECT_GT(pointsOfColour(pane, {13, 2, 0}), 0u);  // the scene's speed is the time: 0.5 of 10 m/s
    pane.update(0.5, ColourBy::Cluster, m_scale, m_nothing);
    std::set<std::uint8_t> seen;
    for (std::size_t i = 0; i < pane.points().size() / 3; ++i) {
        seen.insert(colourOf(pane, i).r);
    }
    EXPECT_GT(seen.size(), 3u);
}

/// The same run with all bodies moved by a length along x, and without those that entered last.
std::shared_ptr<const TrajectoryReader> movedRun(const TrajectoryReader& run, float along, std::size_t leftOut = 0) {
    auto moved = std::make_shared<MemoryTrajectory>();
    moved->begin({});
    std::vector<BodyRecord> bodies = run.bodies();
    bodies.resize(bodies.size() - leftOut);
    std::vector<Carrier> carriers = run.carriers();
    std::erase_if(carriers, [&bodies](const Carrier& carrier) { return at(carrier.body) >= bodies.size(); });
    moved->addBodies(bodies, carriers);
    for (std::size_t i = 0; i < run.frameCount(); ++i) {
        TrajectoryFrame frame = *run.frame(i);
        for (Eigen::Vector3f& position : frame.positions) {
            position.x() += along;
        }
        moved->commit(frame);
    }
    moved->finish({});
    return moved;
}

TEST_F(PaneContents, ErrorsAreDistancesFromTheReferenceAtTheSameTime) {
    m_scale.errorSteps = {0.1, 0.2, 0.3};
    for (std::size_t i = 0; i < 256; ++i) {
        m_scale.colours.errorRamp[i] = {static_cast<std::uint8_t>(i), 3, 0};
    }
    m_scale.colours.unknown = {9, 9, 9};
    SceneData data = scenes::ballisticRun(m_fe, 1.0);
    data.reference = movedRun(*data.trajectory, 0.25f);
    PaneGeometry pane(PaneContent::Fragments, data, false);
    for (const double time : {0.25, 0.5, 0.87}) {
        pane.update(time, ColourBy::Error, m_scale, m_nothing);
        ASSERT_EQ(pane.status().errors.size(), 4u);
        EXPECT_EQ(pane.status().errors[2], pane.status().fragments) << "all of them 0.25 m away, at " << time;
        EXPECT_GT(pointsOfColour(pane, {170, 3, 0}), 0u) << "the third of four colours";
        EXPECT_EQ(pane.status().errorsUnknown, 0u);
    }
    m_scale.errorSteps = {0.2};
    pane.update(0.87, ColourBy::Error, m_scale, m_nothing);
    EXPECT_EQ(pane.status().errors, (std::vector<std::size_t>{0, 12}));
    pane.update(0.87, ColourBy::Highlight, m_scale, m_nothing);
    EXPECT_TRUE(pane.status().errors.empty()) << "nothing is counted that is not shown";
}

TEST_F(PaneContents, WhatTheReferenceLacksHasAColourOfItsOwn) {
    m_scale.colours.unknown = {9, 9, 9};
    m_scale.errorSteps = {0.1};
    SceneData data = scenes::ballisticRun(m_fe, 1.0);
    data.reference = movedRun(*data.trajectory, 0.0f, 1);
    PaneGeometry pane(PaneContent::Fragments, data, false);
    pane.update(0.8, ColourBy::Error, m_scale, m_nothing);
    EXPECT_GT(pane.status().errorsUnknown, 0u);
    EXPECT_EQ(pane.status().errors[0] + pane.status().errorsUnknown, pane.status().fragments);
    EXPECT_GT(pointsOfColour(pane, {9, 9, 9}), 0u);
    data.reference = nullptr;
    PaneGeometry alone(PaneContent::Fragments, data, false);
    alone.update(0.8, ColourBy::Error, m_scale, m_nothing);
    EXPECT_TRUE(alone.status().errors.empty());
    EXPECT_GT(pointsOfColour(alone, m_scale.colours.fragment), 0u) << "without a reference fragments keep their own colour";
}

TEST_F(PaneContents, ARayMeetsWhatIsInFront) {
    PaneGeometry pane(PaneContent::Fragments, scenes::ballisticRun(m_fe, 1.0), false);
    pane.update(0.0, ColourBy::Highlight, m_scale, m_nothing);
    // From the south onto the element at column 2 of the middle row (elements run along x, then z).
    const auto wall = pane.cast({Vec3(2.5, -50, 1.5), Vec3::UnitY()});
    ASSERT_TRUE(wall);
    EXPECT_EQ(wall->element, idAt<ElementIndex>(6));
    EXPECT_FALSE(wall->fragment);
    EXPECT_NEAR(wall->position.y(), 0.0, 1e-4);
    EXPECT_FALSE(pane.cast({Vec3(2.5, -50, 1.5), -Vec3::UnitY()}));
    EXPECT_FALSE(pane.cast({Vec3(2.5, -50, 90), Vec3::UnitY()}));
    SceneData still = scenes::withoutRun(m_fe);
    PaneGeometry standing(PaneContent::Fragments, still, false);
    standing.update(0.5, ColourBy::Highlight, m_scale, m_nothing);
    const auto fragment = standing.cast({Vec3(2.5, -50, 1.5), Vec3::UnitY()});
    ASSERT_TRUE(fragment && fragment->fragment);
    EXPECT_EQ(still.fragments->list[at(*fragment->fragment)].element, idAt<ElementIndex>(6));
}

TEST_F(PaneContents, SelectionTakesTheTrianglesOfItsElements) {
    PaneGeometry pane(PaneContent::Fe, scenes::withoutRun(m_fe), false);
    pane.update(0.0, ColourBy::Highlight, m_scale, {idAt<ElementIndex>(0)});
    EXPECT_EQ(pane.selected().size(), 3u * 2u * 4u);  // a corner of the wall: two of its six faces have neighbours
    pane.update(0.0, ColourBy::Highlight, m_scale, {});
    EXPECT_TRUE(pane.selected().empty());
}

TEST_F(PaneContents, WhatAHiddenNeighbourCoveredIsDrawn) {
    for (const PaneContent content : {PaneContent::Fe, PaneContent::Fragments}) {
        PaneGeometry pane(content, scenes::ballisticRun(m_fe, 1.0), false);
        pane.update(0.0, ColourBy::Highlight, m_scale, m_nothing);
        // The middle of the wall: element 6 has neighbours left, right and above; below it stands another.
        const double whole = area(pane);
        std::vector<std::uint8_t> hidden(m_fe->mesh().elementCount(), 0);
        hidden[6] = 1;
        pane.setHidden(hidden);
        pane.update(0.0, ColourBy::Highlight, m_scale, m_nothing);
        EXPECT_NEAR(area(pane), whole - 2.0 + 4.0, 1e-4) << "its two outer faces go, four of its neighbours appear";
        EXPECT_EQ(pane.status().active, 16u) << "counts hold what is hidden";
        EXPECT_EQ(pane.status().hidden, 1u);
        const auto behind = pane.cast({Vec3(2.5, -50, 1.5), Vec3::UnitY()});
        EXPECT_FALSE(behind && behind->element == idAt<ElementIndex>(6));
        pane.setHidden({});
        pane.update(0.0, ColourBy::Highlight, m_scale, m_nothing);
        EXPECT_NEAR(area(pane), whole, 1e-4);
    }
}

TEST_F(PaneContents, HiddenFragmentsOpenTheirClusters) {
    SceneData data = scenes::ballisticRun(m_fe, 1.0);
    ASSERT_GE(data.clustering->list.front().memberCount, 1u);
    PaneGeometry all(PaneContent::Fragments, data, true);
    PaneGeometry pane(PaneContent::Fragments, data, false);
    for (const double time : {0.3, 0.45, 0.8}) {
        std::vector<std::uint8_t> hidden(m_fe->mesh().elementCount(), 0);
        for (std::size_t e = 0; e < hidden.size(); ++e) {
            hidden[e] = e % 3 == 0;
        }
        all.setHidden(hidden);
        all.update(time, ColourBy::Highlight, m_scale, m_nothing);
        // Of sixteen unit cubes, six are hidden; each other one has its six faces once.
        EXPECT_NEAR(area(all), 10 * 6.0, 1e-3) << time;
        pane.setHidden(hidden);
        pane.update(time, ColourBy::Highlight, m_scale, m_nothing);
        EXPECT_LE(area(pane), area(all));
        std::set<ElementIndex> left;
        for (const ElementIndex e : pane.elementsWhere([](const Vec3&) { return true; })) {
            left.insert(e);
        }
        EXPECT_EQ(left.size(), 10u) << time;
        EXPECT_FALSE(left.contains(idAt<ElementIndex>(3)));
    }
}

TEST_F(PaneContents, ACutShowsTheFacesInside) {
    PaneGeometry pane(PaneContent::Fe, scenes::withoutRun(m_fe), false);
    pane.update(0.0, ColourBy::Highlight, m_scale, m_nothing);
    EXPECT_LT(area(pane), 16 * 6.0 - 1.0);
    pane.setClip(ClipPlane{Vec3(2.2, 0, 0), Vec3::UnitX()});
    pane.update(0.0, ColourBy::Highlight, m_scale, m_nothing);
    EXPECT_NEAR(area(pane), 16 * 6.0, 1e-3) << "all of them are there for the plane to cut";
    // From the east along -x at the height of the middle row: the near half is gone, so the ray meets what lies behind the plane.
    const auto hit = pane.cast({Vec3(50, 0.5, 1.5), -Vec3::UnitX()});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->position.x(), 2.0, 1e-4);
    for (const ElementIndex e : pane.elementsWhere([](const Vec3&) { return true; })) {
        double x = 0.0;
        for (const std::uint32_t node : m_fe->mesh().cornersOf(e)) {
            x += m_fe->mesh().nodes[node].x() / 8.0;
        }
        EXPECT_LE(x, 2.2);
    }
    pane.setClip(std::nullopt);
    pane.update(0.0, ColourBy::Highlight, m_scale, m_nothing);
    EXPECT_LT(area(pane), 16 * 6.0 - 1.0);
}

TEST_F(PaneContents, InThePresentationStyleAnElementLooksTheSameDeadOrAlive) {
    for (std::size_t m = 0; m < materialCount; ++m) {
        m_scale.colours.materials[m] = {static_cast<std::uint8_t>(10 + m), 5, 5};
    }
    SceneData data = scenes::ballisticRun(m_fe, 1.0);
    auto components = std::make_shared<Components>(*data.components);
    components->list[0].material = Material::Stone;
    components->list[1].material = Material::Steel;
    data.components = components;
    m_scale.style = Style::Presentation;
    PaneGeometry pane(PaneContent::Fragments, data, false);
    for (const double time : {0.0, 0.5, 0.9}) {
        pane.update(time, ColourBy::Highlight, m_scale, m_nothing);
        const std::size_t stone = pointsOfColour(pane, {10, 5, 5});
        const std::size_t steel = pointsOfColour(pane, {12, 5, 5});
        EXPECT_GT(stone, 0u);
        EXPECT_GT(steel, 0u);
        EXPECT_EQ(stone + steel, pane.points().size() / 3) << time;
        EXPECT_EQ(pane.grain().size(), 4 * (pane.points().size() / 3)) << time;
    }
    // At the hand-over the wall has not moved: each point carries the place at which it is.
    pane.update(0.1, ColourBy::Highlight, m_scale, m_nothing);
    const std::vector<std::int32_t>& corners = pane.triangles();
    std::size_t compared = 0;
    for (const std::int32_t corner : corners) {
        const auto i = static_cast<std::size_t>(corner);
        if (pane.grain()[4 * i + 3] == 1.0f) {  // stone
            for (std::size_t axis = 0; axis < 3; ++axis) {
                EXPECT_NEAR(pane.grain()[4 * i + axis], pane.points()[3 * i + axis], 1e-4);
            }
            ++compared;
        }
    }
    EXPECT_GT(compared, 50u);
    pane.update(0.5, ColourBy::BirthTime, m_scale, m_nothing);
    EXPECT_GT(pane.points().size() / 3, pointsOfColour(pane, {10, 5, 5}) + pointsOfColour(pane, {12, 5, 5})) << "scales still tell";
    m_scale.style = Style::Analysis;
    pane.update(0.5, ColourBy::Highlight, m_scale, m_nothing);
    EXPECT_TRUE(pane.grain().empty());
    EXPECT_GT(pointsOfColour(pane, m_scale.colours.fragment), 0u);
}

TEST_F(PaneContents, AChosenColourTakesThePlaceOfAComponentsOwn) {
    const SceneData data = scenes::ballisticRun(m_fe, 1.0);
    PaneGeometry pane(PaneContent::Fragments, data, false);
    m_scale.componentColours[data.components->list[0].name] = {77, 8, 8};
    pane.update(0.0, ColourBy::Component, m_scale, m_nothing);
    EXPECT_GT(pointsOfColour(pane, {77, 8, 8}), 0u) << "active";
    pane.update(0.5, ColourBy::Component, m_scale, m_nothing);
    EXPECT_GT(pointsOfColour(pane, {77, 8, 8}), 0u) << "as fragments";
    m_scale.componentColours.clear();
    pane.update(0.5, ColourBy::Component, m_scale, m_nothing);
    EXPECT_EQ(pointsOfColour(pane, {77, 8, 8}), 0u);
}

}  // namespace
}  // namespace rubble::render
