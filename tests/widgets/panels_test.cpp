#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QTableWidget>
#include <QTest>
#include <QVBoxLayout>
#include <algorithm>
#include <map>

#include "core/analysis/accuracy/loose_beside.h"
#include "widgets/accuracy/grid_panel.h"
#include "widgets/basics/panel.h"
#include "widgets/basics/parameter_editor.h"
#include "widgets/basics/theme.h"
#include "widgets/case/case_panel.h"
#include "widgets/case/fragments_panel.h"
#include "widgets/evidence/report_panel.h"
#include "widgets/run/effects_panel.h"
#include "widgets/run/run_panel.h"
#include "widgets/views/stage_rail.h"
#include "widgets/views/status_line.h"

namespace rubble::widgets {

namespace {

/// A mesh of two unit cubes apart from each other, each a component.
std::shared_ptr<Components> twoComponents() {
    auto components = std::make_shared<Components>();
    for (const char* name : {"ring", "strip"}) {
        Component component;
        component.name = name;
        component.kind = "solid";
        component.density = 2000.0;
        component.mass = 2000.0;
        component.bounds = Aabb(Vec3(0, 0, 0), Vec3(1, 1, 1));
        components->list.push_back(component);
    }
    return components;
}

std::shared_ptr<Sizing> someSizing() {
    auto sizing = std::make_shared<Sizing>();
    for (AxisSizing& axis : sizing->axis) {
        axis.meanDistance = 1.08;
        axis.size = 5.95;
        axis.accuracyMin = 1.84;
        axis.accuracyMax = 7.0;
    }
    sizing->axis[2].clampedBy = ClampedBy::FragmentSize;
    sizing->axis[2].accuracyMin = 1.93;
    sizing->axis[2].accuracyMax = 1.6;
    sizing->axis[2].smallestComponent = idAt<ComponentId>(1);
    sizing->commonMultiple = 5.5;
    sizing->fragments = 49561;
    sizing->clusters = 4453;
    sizing->fpsTarget = 24;
    return sizing;
}

}  // namespace

TEST(Themes, WordsThatWereSetBeforeTakeTheTintsOfNow) {
    applyTheme(render::Theme::Light);
    Notice notice;
    notice.set(Notice::Kind::Finding, QStringLiteral("what"), QStringLiteral("remedy"));
    const QString light = tints().muted.name();
    EXPECT_TRUE(notice.text().contains(light));
    applyTheme(render::Theme::Dark);
    ASSERT_NE(tints().muted.name(), light);
    EXPECT_TRUE(notice.text().contains(tints().muted.name()));
    EXPECT_FALSE(notice.text().contains(light));
    applyTheme(render::Theme::Light);
    EXPECT_TRUE(notice.text().contains(light));
}

TEST(Themes, LinksThatAreShownTakeTheColourOfNow) {
    applyTheme(render::Theme::Light);
    ReportPanel panel;
    panel.setWritten(QStringLiteral("/somewhere"));
    panel.show();
    const QList<QLabel*> labels = panel.findChildren<QLabel*>();
    QLabel* link = *std::find_if(labels.begin(), labels.end(),
                                 [](const QLabel* label) { return label->text().contains(QLatin1String("<a ")); });
    // The document of a label is its own affair: what it paints is asked.
    const auto holds = [&](const QColor& colour) {
        const QImage picture = link->grab().toImage();
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                if (picture.pixelColor(x, y) == colour) {
                    return true;
                }
            }
        }
        return false;
    };
    const QColor light = tints().accent;
    EXPECT_TRUE(holds(light));
    applyTheme(render::Theme::Dark);
    EXPECT_TRUE(holds(tints().accent));
    EXPECT_FALSE(holds(light));
    applyTheme(render::Theme::Light);
    EXPECT_TRUE(holds(light));
}

TEST(Panels, EveryUnkeyedParameterHasExactlyOneEditor) {
    CasePanel ofCase;
    FragmentsPanel ofFragments;
    GridPanel ofGrid;
    EffectsPanel ofEffects;
    RunPanel ofRun;
    std::map<std::string, int> found;
    for (const Panel* panel : std::initializer_list<const Panel*>{&ofCase, &ofFragments, &ofGrid, &ofEffects, &ofRun}) {
        for (const ParameterEditor* editor : panel->findChildren<ParameterEditor*>()) {
            ++found[editor->key().toStdString()];
        }
    }
    for (const Parameter& row : parameterTable()) {
        if (!row.keyed()) {
            EXPECT_EQ(found[std::string(row.key)], 1) << row.key;
        }
    }
}

TEST(Panels, EditsLeaveWithTheirKey) {
    EffectsPanel panel;
    panel.setScenario(Scenario());
    QString key;
    ParameterValue value;
    QObject::connect(&panel, &Panel::edited, [&](const QString& k, const ParameterValue& v) {
        key = k;
        value = v;
    });
    auto* field = panel.editor(QStringLiteral("friction"))->findChild<QLineEdit*>();
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("0.65"));
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_EQ(key, QStringLiteral("friction"));
    EXPECT_EQ(value, ParameterValue(0.65));
}

TEST(Panels, WhatComesUpLaterHasTheHeightOfItsSentencesAtOnce) {
    Panel panel(QStringLiteral("Run"), QStringLiteral("Where the fragments go."));
    panel.resize(336, 300);
    auto* list = new QWidget;
    auto* words = new QLabel(QStringLiteral("Body 687 was 1.058 times as fast as its birth and its fall allow. ").repeated(40));
    words->setWordWrap(true);
    (new QVBoxLayout(list))->addWidget(words);
    list->hide();
    panel.addWide(list);
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
    list->show();
    EXPECT_LE(words->width(), 336);
    EXPECT_GE(words->height(), words->heightForWidth(words->width()));
    EXPECT_GE(words->height(), 40 * words->fontMetrics().height());
}

TEST(GridPanel, TheSliderRisesAndReadsBack) {
    double before = 0.0;
    for (int position = 0; position <= 400; ++position) {
        const double multiple = GridPanel::multipleAt(position);
        EXPECT_GE(multiple, before);
        before = multiple;
        // Two decimals move the place by one step at most where steps are finer than a hundredth.
        EXPECT_NEAR(GridPanel::positionOf(multiple), position, 1);
    }
    EXPECT_DOUBLE_EQ(GridPanel::multipleAt(0), 0.5);
    EXPECT_DOUBLE_EQ(GridPanel::multipleAt(400), 50.0);
}

TEST(GridPanel, DraggingIsOneGestureOfEdits) {
    GridPanel panel;
    panel.setContent({someSizing(), nullptr, nullptr, twoComponents(), nullptr});
    QStringList heard;
    QObject::connect(&panel, &GridPanel::draggingStarted, [&] { heard << QStringLiteral("start"); });
    QObject::connect(&panel, &GridPanel::draggingEnded, [&] { heard << QStringLiteral("end"); });
    QObject::connect(&panel, &Panel::edited, [&](const QString& key) { heard << key; });
    auto* slider = panel.findChild<QSlider*>();
    slider->setSliderDown(true);
    slider->setValue(300);
    slider->setValue(310);
    slider->setSliderDown(false);
    EXPECT_EQ(heard, QStringList(
                         {QStringLiteral("start"), QStringLiteral("multiple"), QStringLiteral("multiple"), QStringLiteral("end")}));
}

TEST(GridPanel, AClampIsExplainedInASentence) {
    GridPanel panel;
    panel.setContent({someSizing(), nullptr, nullptr, twoComponents(), nullptr});
    bool explained = false;
    for (const Notice* notice : panel.findChildren<Notice*>()) {
        explained =
            explained || (notice->text().contains(QStringLiteral("strip")) && notice->text().contains(QStringLiteral("1.93")));
    }
    EXPECT_TRUE(explained);
    const auto* table = panel.findChild<QTableWidget*>();
    EXPECT_EQ(table->item(0, 2)->text(), QStringLiteral("5.95"));
    EXPECT_EQ(table->item(2, 5)->text(), QStringLiteral("1.60"));
}

TEST(GridPanel, SizesByHandOutsideTheirBoundsAreExplainedAtTheirField) {
    GridPanel panel;
    Scenario scenario;
    scenario.grid.grouping = Grouping::Axes;
    scenario.grid.length = 9.0;
    scenario.grid.width = 1.0;
    panel.setScenario(scenario);
    auto sizing = someSizing();
    sizing->stoppedBy = StoppedBy::User;
    sizing->axis[0].size = 9.0;
    sizing->axis[0].smallestComponent = idAt<ComponentId>(1);
    sizing->axis[1].size = 1.0;
    panel.setContent({sizing, nullptr, nullptr, twoComponents(), nullptr});
    const auto told = [&panel](const char* text) {
        for (const Notice* notice : panel.findChildren<Notice*>()) {
            if (notice->text().contains(QString::fromUtf8(text))) {
                return true;
            }
        }
        return false;
    };
    EXPECT_TRUE(told("x: larger than the smallest component (strip, 7.00\u00A0m)"));
    EXPECT_TRUE(told("y: smaller than the largest fragment, 1.84\u00A0m"));
    EXPECT_TRUE(told("Set by hand along x, y"));
    EXPECT_TRUE(panel.findChild<QSlider*>()->isEnabled());
    scenario.grid.height = 2.0;
    panel.setScenario(scenario);
    EXPECT_TRUE(told("the multiple decides nothing"));
    EXPECT_FALSE(panel.findChild<QSlider*>()->isEnabled());
    scenario.grid.oneBodyPerFragment = true;
    panel.setScenario(scenario);
    EXPECT_TRUE(told("Every fragment moves alone"));
}

TEST(GridPanel, ACountWhileTheSliderMovesLeavesTheRestAsItIs) {
    GridPanel panel;
    auto clustering = std::make_shared<Clustering>();
    clustering->splitByComponent = 17;
    panel.setContent({someSizing(), clustering, nullptr, twoComponents(), nullptr});
    const auto told = [&panel](const QString& text) {
        for (const QLabel* label : panel.findChildren<QLabel*>()) {
            if (label->text() == text) {
                return true;
            }
        }
        return false;
    };
    EXPECT_TRUE(told(QStringLiteral("17, 0")));
    auto counted = someSizing();
    counted->clusters = 5111;
    panel.setContent({counted, clustering, nullptr, twoComponents(), nullptr, true});
    EXPECT_TRUE(told(QStringLiteral("5,111")));
    EXPECT_FALSE(told(QStringLiteral("17, 0"))) << "splits of another grid say nothing of this one";
    panel.setPublishedCounts({{2.0, 25584}, {2.5, 16818}, {3.0, 11632}});
    EXPECT_TRUE(told(QStringLiteral("16,818")));
}

TEST(GridPanel, TheMachinesAdviceIsOneEdit) {
    GridPanel panel;
    panel.setScenario(Scenario());
    auto* use = panel.findChild<QPushButton*>(QStringLiteral("useBodies"));
    EXPECT_TRUE(use->isHidden()) << "not calibrated";
    GridPanel::MachineAdvice advice;
    advice.calibrated = true;
    advice.target = 24.0;
    advice.typical = Calibration::BodiesMax{3147.0, false, false};
    advice.worst = Calibration::BodiesMax{1900.0, false, true};
    panel.setAdvice(advice);
    EXPECT_FALSE(use->isHidden());
    ParameterValue value;
    QObject::connect(&panel, &Panel::edited, [&](const QString&, const ParameterValue& v) { value = v; });
    use->click();
    EXPECT_EQ(value, ParameterValue(std::int64_t{3100})) << "two digits are what a fit can mean";
    Scenario taken;
    taken.grid.bodiesMax = 3100;
    panel.setScenario(taken);
    EXPECT_TRUE(use->isHidden());
    advice.disturbed = true;
    panel.setScenario(Scenario());
    panel.setAdvice(advice);
    EXPECT_TRUE(use->isHidden()) << "a busy machine says nothing";
}

TEST(CasePanel, SelectedComponentsAreMergedByAnEdit) {
    CasePanel panel;
    panel.setContent(nullptr, twoComponents());
    std::optional<RegroupStep> step;
    QObject::connect(&panel, &CasePanel::regroupRequested, [&](const RegroupStep& asked) { step = asked; });
    panel.findChild<QTableWidget*>()->selectAll();
    EXPECT_EQ(panel.selectedComponents(), QStringList({QStringLiteral("ring"), QStringLiteral("strip")}));
    panel.findChild<QPushButton*>(QStringLiteral("merge"))->click();
    auto* name = panel.findChild<QLineEdit*>(QStringLiteral("newName"));
    name->setText(QStringLiteral("whole ring"));
    emit name->returnPressed();
    ASSERT_TRUE(step.has_value());
    EXPECT_EQ(std::get<MergeComponents>(*step), (MergeComponents{{"ring", "strip"}, "whole ring"}));
}

TEST(CasePanel, ANameThatIsTakenIsRefusedInPlace) {
    CasePanel panel;
    panel.setContent(nullptr, twoComponents());
    int asked = 0;
    QObject::connect(&panel, &CasePanel::regroupRequested, [&] { ++asked; });
    panel.findChild<QTableWidget*>()->selectRow(0);
    panel.findChild<QPushButton*>(QStringLiteral("rename"))->click();
    auto* name = panel.findChild<QLineEdit*>(QStringLiteral("newName"));
    name->setText(QStringLiteral("strip"));
    emit name->returnPressed();
    EXPECT_EQ(asked, 0);
    name->setText(QStringLiteral("arch"));
    emit name->returnPressed();
    EXPECT_EQ(asked, 1);
}

TEST(CasePanel, ADensityIsTypedIntoTheTable) {
    CasePanel panel;
    panel.setContent(nullptr, twoComponents());
    QString key;
    ParameterValue value;
    QObject::connect(&panel, &Panel::edited, [&](const QString& k, const ParameterValue& v) {
        key = k;
        value = v;
    });
    auto* table = panel.findChild<QTableWidget*>();
    table->item(1, 4)->setText(QStringLiteral("2,350"));
    EXPECT_EQ(key, QStringLiteral("component[strip].density"));
    EXPECT_EQ(value, ParameterValue(2350.0));
    key.clear();
    table->item(1, 4)->setText(QStringLiteral("-5"));
    EXPECT_TRUE(key.isEmpty());
    table->item(1, 4)->setText(QString());
    EXPECT_EQ(key, QStringLiteral("component[strip].density"));
    EXPECT_EQ(value, ParameterValue());
}

TEST(RunPanel, OffersWhatCanBeDone) {
    RunPanel panel;
    auto* simulate = panel.findChild<QPushButton*>(QStringLiteral("primary"));
    EXPECT_FALSE(simulate->isEnabled());
    panel.setReady(true, false);
    EXPECT_TRUE(simulate->isEnabled());
    int asked = 0;
    QObject::connect(&panel, &RunPanel::simulateRequested, [&] { ++asked; });
    simulate->click();
    EXPECT_EQ(asked, 1);
    panel.setReady(true, true);
    EXPECT_FALSE(simulate->isEnabled());
    EXPECT_FALSE(simulate->isHidden()) << "Cancel does not take its place";
}

TEST(RunPanel, TheSolverIsNamedWithItsCostAndItsPile) {
    RunPanel panel;
    auto result = std::make_shared<SimulationResult>();
    result->stepTimes.meanMs = 2.345;
    result->bulkingFactor = 1.62;
    result->substeps = 4;
    RunPanel::Outcome outcome;
    outcome.result = result;
    const auto told = [&](const QString& text) {
        for (const QLabel* label : panel.findChildren<QLabel*>()) {
            if (label->text().contains(text)) {
                return true;
            }
        }
        return false;
    };
    outcome.solver = SolverKind::SoftStep;
    panel.setOutcome(outcome);
    EXPECT_TRUE(
        told(QStringLiteral("soft-step, 4 substeps or more, mean 2.3 ms per step while debris is born, bulking of the pile 1.62")));
    result->substeps = 0;
    panel.setOutcome(outcome);
    EXPECT_TRUE(told(QStringLiteral("soft-step, mean 2.3 ms per step")));
    outcome.solver = SolverKind::Bullet;
    panel.setOutcome(outcome);
    EXPECT_TRUE(told(QStringLiteral("bullet, mean 2.3 ms per step")));
    EXPECT_FALSE(told(QStringLiteral("fragments deep")));
    result->bulkingFactor = 0.741;
    panel.setOutcome(outcome);
    EXPECT_TRUE(told(QStringLiteral("bulking of the pile 0.741 (outside the 1.15 to 2 of a pile")));
}

TEST(RunPanel, ASettingThatHealthAndFindingsAskForHasOneButton) {
    RunPanel panel;
    auto result = std::make_shared<SimulationResult>();
    result->findings.add({"simulation.speed_held", "held back", {}}, {"r", "raise the steps", {}});
    result->findings.add({"simulation.auto_remedy", "halved", {}}, {"r", "raise the steps", {}});
    result->findings.add({"simulation.held_together", "left whole", {}}, {"r", "allow more bodies", {}});
    RunPanel::Outcome outcome;
    outcome.result = result;
    outcome.grounds = {Scenario(), 60.0};
    const auto buttons = [&panel] {
        QStringList words;
        for (const QPushButton* button : panel.findChildren<QPushButton*>(QStringLiteral("applyRemedy"))) {
            words << button->text();
        }
        return words;
    };
    panel.setOutcome(outcome);
    EXPECT_EQ(buttons().filter(QStringLiteral("Steps per second")).size(), 1) << qPrintable(buttons().join(u'|'));
    EXPECT_EQ(buttons().size(), 2);
    HealthList::Content health;
    HealthBreach deep;
    deep.check = HealthCheck::Penetration;
    deep.what = {"test.deep", "deep", {}};
    health.health.breaches = {deep};
    health.grounds = outcome.grounds;
    panel.setHealth(health);
    EXPECT_EQ(buttons().filter(QStringLiteral("Steps per second")).size(), 1) << qPrintable(buttons().join(u'|'));
    panel.setHealth(std::nullopt);
    EXPECT_EQ(buttons().filter(QStringLiteral("Steps per second")).size(), 1) << qPrintable(buttons().join(u'|'));
    panel.setOutcome({});
    EXPECT_TRUE(buttons().isEmpty());
}

TEST(GridPanel, SaysWhatTheBodiesAllowedLeaveOut) {
    GridPanel panel;
    const auto told = [&panel] {
        for (const Notice* notice : panel.findChildren<Notice*>()) {
            if (!notice->isHidden() && notice->text().contains(QStringLiteral("fragments alone"))) {
                return notice->text().replace(QChar(0x00A0), u' ');
            }
        }
        return QString();
    };
    EXPECT_TRUE(told().isEmpty());
    panel.setBeside(looseBesideCaution(24.0, LooseAtOnce{3.4, 10, 30117}, 60660));
    EXPECT_TRUE(told().contains(QStringLiteral("24.00 FPS"))) << told().toStdString();
    EXPECT_TRUE(told().contains(QStringLiteral("30,117 of 60,660 elements at one time (at 3.400 s)"))) << told().toStdString();
    EXPECT_TRUE(told().contains(QStringLiteral("“Loose structure” = "))) << "the remedy";
    panel.setBeside(std::nullopt);
    EXPECT_TRUE(told().isEmpty());
}

TEST(RunPanel, SaysAtOnceWhatHeldDoesNotHold) {
    RunPanel panel;
    const auto told = [&panel] {
        for (const Notice* notice : panel.findChildren<Notice*>()) {
            if (!notice->isHidden() && notice->text().contains(QStringLiteral("“Fallen live structure” = "))) {
                return true;
            }
        }
        return false;
    };
    Scenario scenario;
    panel.setScenario(scenario);
    EXPECT_FALSE(told());
    scenario.effects.islands = LiveIslandPolicy::Held;
    panel.setScenario(scenario);
    EXPECT_TRUE(told());
    scenario.effects.loose = LooseStructurePolicy::Fe;
    panel.setScenario(scenario);
    EXPECT_FALSE(told());
}

TEST(StageRail, ChoosesByMouseAndKeys) {
    StageRail rail({{QStringLiteral("Case"), {}, Glyph::Case}, {QStringLiteral("Run"), {}, Glyph::Run}});
    std::vector<int> chosen;
    QObject::connect(&rail, &StageRail::chosen, [&](int index) { chosen.push_back(index); });
    rail.findChild<QAbstractButton*>(QStringLiteral("rail0"))->click();
    QTest::keyClick(&rail, Qt::Key_Down);
    QTest::keyClick(&rail, Qt::Key_Down);
    EXPECT_EQ(chosen, (std::vector<int>{0, 1}));
    rail.setState(1, StageState::Stale, 2);
    EXPECT_EQ(rail.state(1), StageState::Stale);
    const auto* button = rail.findChild<QAbstractButton*>(QStringLiteral("rail1"));
    EXPECT_TRUE(button->accessibleDescription().contains(QStringLiteral("stale")));
    EXPECT_TRUE(button->accessibleDescription().contains(QStringLiteral("2")));
}

TEST(StageRail, EveryStateLooksDifferent) {
    StageRail rail({{QStringLiteral("Run"), {}, Glyph::Run}});
    rail.resize(140, 60);
    std::vector<QImage> pictures;
    for (const auto& [state, findings] :
         {std::pair(StageState::NotYet, 0), std::pair(StageState::Running, 0), std::pair(StageState::UpToDate, 0),
          std::pair(StageState::UpToDate, 1), std::pair(StageState::Stale, 0)}) {
        rail.setState(0, state, findings, 0.4);
        // Without colour, too.
        const QImage picture = rail.grab().toImage().convertToFormat(QImage::Format_Grayscale8);
        for (const QImage& other : pictures) {
            EXPECT_NE(picture, other);
        }
        pictures.push_back(picture);
    }
}

TEST(StatusLine, FiguresWithoutAValueAreNotShown) {
    StatusLine line;
    line.setFigure(StatusLine::Figure::Live, QStringLiteral("Live"), QStringLiteral("24.6 FPS"), QStringLiteral("target 24"));
    EXPECT_TRUE(line.figureText(StatusLine::Figure::Live).contains(QStringLiteral("24.6 FPS")));
    line.setFigure(StatusLine::Figure::Live, {}, {});
    EXPECT_TRUE(line.figureText(StatusLine::Figure::Live).isEmpty());
    line.setMessage(QStringLiteral("Saved"));
    line.setActivity(QStringLiteral("Simulating"), 0.5);
    EXPECT_EQ(line.activityText(), QStringLiteral("Simulating"));
    line.setActivity({});
    EXPECT_EQ(line.activityText(), QStringLiteral("Saved"));
}

TEST(StatusLine, NeverAsksForMoreThanItHas) {
    using Figure = StatusLine::Figure;
    StatusLine line;
    line.resize(1900, 30);
    line.show();
    for (const auto& [figure, name] : {std::pair(Figure::Playback, "Playback"), std::pair(Figure::Bodies, "Bodies"),
                                       std::pair(Figure::Health, "Health"), std::pair(Figure::Memory, "Memory")}) {
        line.setFigure(figure, QLatin1String(name), QStringLiteral("1,234 of something"), QStringLiteral("5,678 of it"));
    }
    const auto shows = [&](const char* name) {
        const auto labels = line.findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
            return !label->isHidden() && label->text().startsWith(QLatin1String(name));
        });
    };
    line.setActivity(QStringLiteral("Simulating, 4,458 bodies at 19.50 s · about 1 min 05 s left"), 0.5);
    EXPECT_TRUE(shows("Playback") && shows("Memory"));
    line.resize(900, 30);
    EXPECT_LE(line.minimumSizeHint().width(), 900);
    EXPECT_FALSE(shows("Playback")) << "what can be missed goes first";
    EXPECT_FALSE(line.figureText(Figure::Playback).isEmpty());
    line.resize(1900, 30);
    EXPECT_TRUE(shows("Playback")) << "and comes back";
}

}  // namespace rubble::widgets
