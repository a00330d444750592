#include <gtest/gtest.h>

#include <thread>

#include "tests/scenes/fe_scenes.h"
#include "tests/widgets/scenes/ballistic_run.h"
#include "widgets/render/pane_geometry.h"

namespace rubble::render {
namespace {

/// Box of what is drawn, m.
Aabb drawn(const PaneGeometry& pane) {
    Aabb box;
    for (const std::int32_t point : pane.triangles()) {
        const float* p = pane.points().data() + 3 * static_cast<std::size_t>(point);
        box.extend(Vec3(p[0], p[1], p[2]));
    }
    return box;
}

class PaneDetail : public testing::Test {
protected:
    void show(PaneGeometry& pane, double time) { pane.update(time, ColourBy::BirthTime, m_scale, {}); }

    // 200 x 110 cubes show more faces than simplifiedFaces from the first state to the last.
    const std::shared_ptr<const FeResult> m_fe = scenes::collapsingWall(200, 110);
    const SceneData m_data = scenes::ballisticRun(m_fe, 0.7);
    ColourScale m_scale;
};

TEST_F(PaneDetail, WhatIsCountedAndFoundIsTheSameWithLess) {
    for (const PaneContent content : {PaneContent::Fe, PaneContent::Fragments}) {
        PaneGeometry full(content, m_data, false);
        PaneGeometry less(content, m_data, false);
        less.setSimplified(true);
        for (const double time : {0.0, 0.25, 0.45, 0.65}) {
            show(full, time);
            show(less, time);
            EXPECT_EQ(full.status().simplifiedTo, 0.0);
            EXPECT_GT(less.status().simplifiedTo, 1.0);
            EXPECT_LT(less.status().faces, full.status().faces) << time;
            EXPECT_EQ(less.status().active, full.status().active);
            EXPECT_EQ(less.status().fragments, full.status().fragments);
            EXPECT_EQ(less.status().clusters, full.status().clusters);
            EXPECT_EQ(less.status().bornByComponent, full.status().bornByComponent);
            EXPECT_EQ(less.status().elements, full.status().elements);
            const auto left = [](const Vec3& centre) { return centre.x() < 70.0; };
            EXPECT_EQ(less.elementsWhere(left), full.elementsWhere(left));
            // The picture has the same outline to within what the status says.
            const double within = less.status().simplifiedTo;
            EXPECT_LT((drawn(less).min() - drawn(full).min()).cwiseAbs().maxCoeff(), within);
            EXPECT_LT((drawn(less).max() - drawn(full).max()).cwiseAbs().maxCoeff(), within);
        }
    }
}

TEST_F(PaneDetail, FullDetailComesBack) {
    PaneGeometry never(PaneContent::Fragments, m_data, false);
    PaneGeometry pane(PaneContent::Fragments, m_data, false);
    for (const bool simplified : {true, false, true, false}) {
        pane.setSimplified(simplified);
        show(pane, 0.45);
        EXPECT_EQ(pane.status().simplifiedTo > 0.0, simplified);
    }
    show(never, 0.45);
    EXPECT_EQ(pane.triangles(), never.triangles());
    EXPECT_EQ(pane.points(), never.points());
    EXPECT_EQ(pane.colours(), never.colours());
    EXPECT_EQ(pane.status().faces, never.status().faces);
}

TEST_F(PaneDetail, AtRestNodesLieWhereTheyLieExactly) {
    PaneGeometry pane(PaneContent::Fe, m_data, false);
    // Backwards the state before the interval is not at hand, by which nodes that nothing holds fly on.
    for (const double time : {0.45, 0.4, 0.32, 0.24, 0.16, 0.08}) {
        pane.setSimplified(true);
        show(pane, time);
        pane.setSimplified(false);
        show(pane, time);
        PaneGeometry never(PaneContent::Fe, m_data, false);
        show(never, time);
        EXPECT_EQ(pane.points(), never.points()) << time;
        EXPECT_EQ(pane.status().statesApart, 1u) << time;
    }
}

TEST_F(PaneDetail, WhatIsBroughtFromTimeToTimeIsWhatIsMadeAnew) {
    for (const PaneContent content : {PaneContent::Fe, PaneContent::Fragments}) {
        for (const bool simplified : {false, true}) {
            PaneGeometry pane(content, m_data, false);
            pane.setSimplified(simplified);
            int compared = 0;
            // Each on another side of an event than the one before: vertices stay joined as they were until the next one.
            for (const double time : {0.0, 0.3, 0.45, 0.3, 0.05, 0.45, 0.1, 0.3}) {
                show(pane, time);
                PaneGeometry anew(content, m_data, false);
                anew.setSimplified(simplified);
                show(anew, time);
                if (pane.status().statesApart > 1) {
                    continue;
                }
                ++compared;
                EXPECT_EQ(pane.triangles(), anew.triangles()) << time;
                EXPECT_EQ(pane.points(), anew.points()) << time;
                EXPECT_EQ(pane.colours(), anew.colours()) << time;
                EXPECT_EQ(pane.lines(), anew.lines()) << time;
                EXPECT_EQ(pane.status().active, anew.status().active) << time;
                EXPECT_EQ(pane.status().fragments, anew.status().fragments) << time;
                EXPECT_EQ(pane.status().clusters, anew.status().clusters) << time;
                EXPECT_EQ(pane.status().bornByComponent, anew.status().bornByComponent) << time;
            }
            EXPECT_GT(compared, simplified ? 2 : 7);
        }
    }
}

TEST_F(PaneDetail, PanesMoveAtOnceOnThreadsOfTheirOwn) {
    const auto states = std::make_shared<StateReadAhead>(m_fe);
    PaneGeometry fe(PaneContent::Fe, m_data, false, states);
    PaneGeometry fragments(PaneContent::Fragments, m_data, false, states);
    for (PaneGeometry* pane : {&fe, &fragments}) {
        pane->setSimplified(true);
    }
    for (int i = 0; i < 30; ++i) {
        const double time = 0.02 * (i % 20 + i / 20);
        std::thread other([&] { show(fe, time); });
        show(fragments, time);
        other.join();
        EXPECT_EQ(fe.status().state, fragments.status().state);
    }
    for (PaneGeometry* pane : {&fe, &fragments}) {
        pane->setSimplified(false);
        show(*pane, 0.33);
        EXPECT_EQ(pane->status().statesApart, 1u);
    }
}

TEST_F(PaneDetail, ASmallModelStaysAsItIs) {
    const SceneData small = scenes::ballisticRun(scenes::collapsingWall(4, 3), 0.7);
    PaneGeometry full(PaneContent::Fragments, small, false);
    PaneGeometry less(PaneContent::Fragments, small, false);
    less.setSimplified(true);
    show(full, 0.45);
    show(less, 0.45);
    EXPECT_EQ(less.status().simplifiedTo, 0.0);
    EXPECT_EQ(less.triangles(), full.triangles());
}

TEST_F(PaneDetail, HiddenElementsStayHidden) {
    PaneGeometry pane(PaneContent::Fragments, m_data, false);
    pane.setSimplified(true);
    show(pane, 0.0);
    std::vector<std::uint8_t> hidden(m_fe->mesh().elementCount(), 0);
    std::fill(hidden.begin(), hidden.begin() + 20000, std::uint8_t{1});  // the lower hundred rows
    pane.setHidden(hidden);
    show(pane, 0.0);
    // What is left is small enough to be drawn as it is.
    EXPECT_EQ(pane.status().simplifiedTo, 0.0);
    EXPECT_EQ(pane.status().hidden, 20000u);
    EXPECT_GT(drawn(pane).min().z(), 99.0);
}

}  // namespace
}  // namespace rubble::render
