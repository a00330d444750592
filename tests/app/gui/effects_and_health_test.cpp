#include <QFileInfo>

#include "app/gui/case/file_commands.h"
#include "app/gui/run/health_display.h"
#include "app/gui/stage/playback.h"
#include "app/gui/stage/view_area.h"
#include "io/run/acknowledgements.h"
#include "tests/app/gui/workbench.h"
#include "widgets/run/effect_row.h"
#include "widgets/run/effects_panel.h"
#include "widgets/run/health_list.h"
#include "widgets/views/status_line.h"
#include "widgets/views/timeline.h"

namespace rubble {

namespace {

constexpr auto health = widgets::StatusLine::Figure::Health;

}  // namespace

TEST_F(Workbench, EffectsAreDecidedBeforeAnyRunAndAnewAfterAnEdit) {
    openArch();
    Computation& computation = session->computation();
    ASSERT_TRUE(QTest::qWaitFor([&] { return computation.decisions() != nullptr; }, patience));
    EXPECT_EQ(computation.currentRun(), nullptr);
    EXPECT_EQ(rail(PanelDeck::Effects), widgets::StageState::UpToDate);
    const auto water = static_cast<std::size_t>(EffectKind::Water);
    EXPECT_FALSE((*computation.decisions())[water].on) << "no level is given";
    EXPECT_TRUE(window->rooms().deck->effects().row(EffectKind::Water)->stateText().contains(QStringLiteral("off")));

    session->document().setParameter(QStringLiteral("water_level"), 1.0);
    EXPECT_EQ(rail(PanelDeck::Effects), widgets::StageState::Stale);
    EXPECT_TRUE(window->rooms().deck->effects().row(EffectKind::Water)->stateText().contains(QStringLiteral("before the change")));
    ASSERT_TRUE(QTest::qWaitFor([&] { return rail(PanelDeck::Effects) == widgets::StageState::UpToDate; }, patience));
    EXPECT_TRUE((*computation.decisions())[water].on) << englishText((*computation.decisions())[water].reason);
    session->document().undoStack().undo();
    ASSERT_TRUE(QTest::qWaitFor([&] { return rail(PanelDeck::Effects) == widgets::StageState::UpToDate; }, patience));
    EXPECT_FALSE((*computation.decisions())[water].on);
}

TEST_F(Workbench, AnEditInTheEffectsPanelIsOneStepOfUndo) {
    openArch();
    const Scenario before = session->document().scenario();
    emit window->rooms().deck->effects().edited(QStringLiteral("air_drag"), ParameterValue(std::string("on")));
    EXPECT_EQ(session->document().undoStack().count(), 1);
    EXPECT_EQ(session->document().scenario().effects.of(EffectKind::AirDrag), EffectSwitch::On);
    session->document().undoStack().undo();
    EXPECT_EQ(session->document().scenario(), before);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
}

// An hour of free fall that nobody waits for: the sign is there while it goes on, and stays when it is cancelled.
TEST_F(Workbench, ABreachIsMarkedWhileTheRunGoesOn) {
    openArch();
    ASSERT_NO_FATAL_FAILURE(fallUntilABreach());
    Computation& computation = session->computation();
    EXPECT_EQ(computation.currentRun()->outcome, nullptr);
    widgets::Timeline& timeline = (*window->findChild<widgets::Timeline*>());
    EXPECT_FALSE(timeline.marksAt(timeline.signOf(0)).empty());
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return window->findChild<widgets::StatusLine*>()->figureText(health).contains(QStringLiteral("tainted")); },
        patience));
    computation.cancel();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !computation.busy(); }, patience));
    EXPECT_FALSE(timeline.marksAt(timeline.signOf(0)).empty());
}

// Without a ground everything falls for ever: 8 s of free fall are more than ten heights of the arch.
TEST_F(Workbench, ABreachIsMarkedShownAndAcknowledged) {
    openArch();
    session->document().setParameter(QStringLiteral("multiple"), 8.0);
    session->document().setParameter(QStringLiteral("ground"), std::string("off"));
    session->document().setParameter(QStringLiteral("settle_time"), 8.0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    window->rooms().runs->simulate(false);
    // It may be over before it is looked at.
    const auto ended = [&] {
        const RunRecord* record = session->computation().currentRun();
        return record != nullptr && record->outcome != nullptr && !session->computation().busy();
    };
    ASSERT_TRUE(QTest::qWaitFor(ended, patience));
    const RunRecord* record = session->computation().currentRun();
    const auto& breaches = record->outcome->health.breaches;
    ASSERT_FALSE(breaches.empty());
    EXPECT_TRUE(window->findChild<widgets::StatusLine*>()->figureText(health).contains(QStringLiteral("tainted")));

    // Every effect that took part has a cost in the panel.
    EXPECT_EQ(record->outcome->effects.size(), effectCount);
    EXPECT_TRUE(window->rooms().deck->effects().row(EffectKind::Ground)->costText().isEmpty()) << "it was off";
    EXPECT_FALSE(window->rooms().deck->effects().row(EffectKind::FragmentContact)->costText().isEmpty());

    // A click on the sign leads to the first instant, with the body in the colour of selection.
    widgets::Timeline& timeline = (*window->findChild<widgets::Timeline*>());
    window->rooms().playback->clock().pause();  // the run was being played as it grew
    QTest::qWait(200);
    const std::vector<std::size_t> marks = timeline.marksAt(timeline.signOf(0).toPoint());
    ASSERT_FALSE(marks.empty());
    QTest::mouseClick(&timeline, Qt::LeftButton, {}, timeline.signOf(0).toPoint());
    EXPECT_DOUBLE_EQ(window->rooms().playback->clock().time(), breaches[marks.front()].from);
    EXPECT_EQ(window->rooms().deck->stack().currentIndex(), PanelDeck::Run);
    for (std::size_t i = 0; i < breaches.size(); ++i) {
        if (breaches[i].body) {
            window->rooms().health->show(i, true);
            EXPECT_FALSE(window->area().views().view().selection.empty());
        }
    }

    emit window->rooms().deck->run().health().acknowledgeRequested(QStringLiteral("A. Examiner"),
                                                                   QStringLiteral("A test of falling."));
    ASSERT_TRUE(QTest::qWaitFor([&] { return record->acknowledged.has_value(); }, patience));
    EXPECT_EQ(record->acknowledged->by, "A. Examiner");
    EXPECT_EQ(io::acknowledgements(record->path.toStdString()).size(), 1U);
    window->rooms().deck->showState();
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return window->findChild<widgets::StatusLine*>()->figureText(health).contains(QStringLiteral("acknowledged")); },
        patience));
    EXPECT_FALSE(window->findChild<widgets::StatusLine*>()->figureText(health).contains(QStringLiteral("tainted")));
}

}  // namespace rubble
