#include "widgets/run/health_list.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>

#include "widgets/basics/panel.h"
#include "widgets/basics/theme.h"
#include "widgets/run/run_panel.h"

namespace rubble::widgets {

namespace {

HealthReport twoBreaches() {
    HealthReport health;
    HealthBreach deep;
    deep.check = HealthCheck::Penetration;
    deep.from = 3.2;
    deep.to = 4.1;
    deep.worstAt = 3.75;
    deep.body = idAt<BodyId>(1234);
    deep.place = Vec3(12.5, -3.0, 0.4);
    deep.worst = 0.31;
    deep.limit = 0.1;
    deep.bodies = 17;
    deep.what = {"test.deep", "17 bodies were inside each other for {0}", {Argument(0.9, "s")}};
    deep.remedy = {"test.deep.remedy", "Raise step_rate.", {}};
    HealthBreach gain;
    gain.check = HealthCheck::Energy;
    gain.from = gain.to = 6.0;
    gain.worst = 0.02;
    gain.limit = 0.001;
    gain.what = {"test.gain", "the bodies gained {0} of energy", {Argument(4.0, "MJ")}};
    health.breaches = {deep, gain};
    return health;
}

QString allText(const QWidget& widget) {
    QString all;
    for (const QLabel* label : widget.findChildren<QLabel*>()) {
        all += label->text();
    }
    return all;
}

bool offersToAcknowledge(const HealthList& list) {
    return list.findChild<QPushButton*>(QStringLiteral("acknowledge"))->isVisibleTo(&list);
}

/// Labels whose text does not have the height that it needs.
QStringList cutLabels(const QWidget& panel) {
    QStringList cut;
    for (const QLabel* label : panel.findChildren<QLabel*>()) {
        if (label->isVisibleTo(&panel) && label->wordWrap() && label->height() < label->heightForWidth(label->width())) {
            cut << QStringLiteral("%1 of %2: %3")
                       .arg(label->height())
                       .arg(label->heightForWidth(label->width()))
                       .arg(label->text());
        }
    }
    return cut;
}
}  // namespace

TEST(HealthList, WhatIsLongHasTheRoomThatItNeedsInThePanel) {
    applyTheme(render::Theme::Light);
    for (const bool shownBefore : {true, false}) {
        RunPanel panel;
        panel.resize(336, 560);
        if (shownBefore) {
            panel.show();
            QTest::qWait(20);
        }
        HealthList::Content content;
        content.health = twoBreaches();
        content.health.breaches[0].remedy = {
            "test.long",
            "raise step_rate, or set auto_remedy = true, or raise bodies_max for smaller clusters; under "
            "solver = bullet deep piles squeeze together, take soft-step there",
            {}};
        panel.setHealth(content);
        RunPanel::Outcome outcome;
        outcome.result = std::make_shared<const SimulationResult>();
        outcome.wallSeconds = 43.0;
        panel.setOutcome(outcome);
        panel.show();
        // Layouts settle when their events come: later on a busy machine.
        const auto settled = [&] { return cutLabels(panel).isEmpty(); };
        EXPECT_TRUE(QTest::qWaitFor(settled, 5000)) << shownBefore << ": " << cutLabels(panel).join('|').toStdString();
        panel.resize(312, 560);
        QTest::qWait(50);
        EXPECT_TRUE(QTest::qWaitFor(settled, 5000)) << "narrower: " << cutLabels(panel).join('|').toStdString();
    }
}

TEST(HealthList, ASoundRunSaysSoAndAsksForNothing) {
    HealthList list;
    list.setContent({});
    EXPECT_TRUE(allText(list).contains(QStringLiteral("No limit of health was passed")));
    EXPECT_FALSE(offersToAcknowledge(list));
}

TEST(HealthList, AStoppedRunSaysHowFarItWasLookedAt) {
    HealthList list;
    HealthList::Content content;
    content.upTo = 2.5;
    list.setContent(content);
    EXPECT_TRUE(allText(list).contains(QStringLiteral("up to 2.50"))) << allText(list).toStdString();
    content.health = twoBreaches();
    list.setContent(content);
    EXPECT_TRUE(allText(list).contains(QStringLiteral("it is tainted"))) << allText(list).toStdString();
    EXPECT_FALSE(offersToAcknowledge(list)) << "nobody vouches for a part of a run";
}

TEST(HealthList, ABreachSaysWhatWhereWhenAndTheRemedy) {
    const QString words = breachWords(twoBreaches().breaches[0], Vec3(500000, 4000000, 0));
    for (const char* part :
         {"inside each other", "3.20", "4.10", "3.75", "1,234", "500,012.5", "3,999,997.0", "31.00", "17 bodies", "notice",
          "the pile keeps its shape", "Nothing needs to be done. For less of it: Raise “Steps per second”"}) {
        EXPECT_TRUE(words.contains(QString::fromUtf8(part))) << part << " in " << words.toStdString();
    }
}

TEST(HealthList, ATaintedRunCanBeAcknowledgedWithNameAndNote) {
    HealthList list;
    list.setContent({twoBreaches(), {}, Vec3::Zero()});
    EXPECT_TRUE(allText(list).contains(QStringLiteral("tainted")));
    ASSERT_TRUE(offersToAcknowledge(list));
    QStringList asked;
    QObject::connect(&list, &HealthList::acknowledgeRequested,
                     [&](const QString& name, const QString& note) { asked << name << note; });
    auto* button = list.findChild<QPushButton*>(QStringLiteral("acknowledge"));
    const auto fields = list.findChildren<QLineEdit*>();
    ASSERT_EQ(fields.size(), 2);
    button->click();
    EXPECT_TRUE(asked.isEmpty()) << "nobody vouches without a name";
    fields[0]->setText(QStringLiteral("  A. Examiner "));
    button->click();
    EXPECT_TRUE(asked.isEmpty()) << "nor without a reason";
    fields[1]->setText(QStringLiteral("One body, far from the piers."));
    button->click();
    EXPECT_EQ(asked, QStringList({QStringLiteral("A. Examiner"), QStringLiteral("One body, far from the piers.")}));
}

TEST(HealthList, AnAcknowledgedRunShowsWhoAndWhy) {
    HealthList list;
    const Acknowledgement seen{"A. Examiner", "2024-05-31T08:15:30Z", "One body, far from the piers.", {}};
    list.setContent({twoBreaches(), seen, Vec3::Zero()});
    EXPECT_FALSE(offersToAcknowledge(list));
    EXPECT_TRUE(allText(list).contains(QStringLiteral("A. Examiner")));
    EXPECT_TRUE(allText(list).contains(QStringLiteral("far from the piers")));
    EXPECT_FALSE(allText(list).contains(QStringLiteral("is tainted")));
}

TEST(HealthList, ARemedyIsSetByItsButtonUntilItIsSet) {
    HealthList list;
    HealthList::Content content{twoBreaches(), {}, Vec3::Zero(), {Scenario(), 60.0}, {}};
    list.setContent(content);
    std::vector<std::pair<QString, ParameterValue>> set;
    QObject::connect(&list, &HealthList::remedyChosen,
                     [&](const QString& key, const ParameterValue& value) { set.emplace_back(key, value); });
    const auto buttons = list.findChildren<QPushButton*>(QStringLiteral("applyRemedy"));
    ASSERT_EQ(buttons.size(), 1) << "both limits ask for the same setting";
    EXPECT_EQ(buttons[0]->text(), QStringLiteral("Set “Steps per second” to 120"));
    QTest::mouseClick(buttons[0], Qt::LeftButton);
    ASSERT_EQ(set.size(), 1U);
    EXPECT_EQ(set[0].first, QStringLiteral("step_rate"));
    EXPECT_EQ(set[0].second, ParameterValue(120.0));
    // Set already: told, not offered. In the run already: the next one.
    content.scenario.simulation.stepRate = 120.0;
    list.setContent(content);
    EXPECT_FALSE(list.findChild<QPushButton*>(QStringLiteral("applyRemedy"))->isEnabled());
    content.grounds.ran.simulation.stepRate = 120.0;
    const auto next = remedySettingOf(content.health.breaches[0], content.grounds);
    ASSERT_TRUE(next.has_value());
    EXPECT_EQ(next->key, "auto_remedy");
    EXPECT_EQ(next->value, ParameterValue(true));
    // What was measured says limit and bodies: they stand there once.
    EXPECT_FALSE(allText(list).contains(QStringLiteral(", limit "))) << qPrintable(allText(list));
    EXPECT_FALSE(allText(list).contains(QStringLiteral("at worst"))) << qPrintable(allText(list));
}

TEST(HealthList, ALimitThatWasPassedTwiceCountsOnce) {
    HealthReport health = twoBreaches();
    health.breaches.push_back(health.breaches[0]);
    health.breaches.back().from = 7.5;
    health.breaches.back().to = 8.25;
    health.breaches.back().worst = 4.742;
    EXPECT_EQ(limitsIn(health), 2);
    HealthList list;
    list.setContent({health, {}, Vec3::Zero(), {Scenario(), 60.0}, {}});
    EXPECT_EQ(list.findChildren<QPushButton*>(QStringLiteral("applyRemedy")).size(), 1);
    EXPECT_TRUE(allText(list).contains(QStringLiteral("2 limits passed")));
    const auto entries = list.findChildren<QLabel*>(QStringLiteral("breach"));
    ASSERT_EQ(entries.size(), 2) << "one entry with its times";
    EXPECT_TRUE(entries[0]->text().contains(QString::fromUtf8("3.20–4.10 s, 7.50–8.25 s"))) << entries[0]->text().toStdString();
    EXPECT_TRUE(entries[0]->text().contains(QStringLiteral("4.742×"))) << entries[0]->text().toStdString();
    EXPECT_TRUE(entries[0]->text().contains(QStringLiteral("finding")));
    std::vector<std::size_t> chosen;
    QObject::connect(&list, &HealthList::breachChosen, [&](std::size_t breach) { chosen.push_back(breach); });
    for (QPushButton* button : list.findChildren<QPushButton*>()) {
        if (button->text().startsWith(QStringLiteral("Show"))) {
            QTest::mouseClick(button, Qt::LeftButton);
        }
    }
    EXPECT_EQ(chosen, (std::vector<std::size_t>{2, 1})) << "to the worst of its times";
}

TEST(HealthList, WhatIsNotTaintedAsksForNoName) {
    HealthReport health = twoBreaches();
    health.breaches.pop_back();
    HealthList list;
    list.setContent({health, {}, Vec3::Zero(), {Scenario(), 60.0}, {}});
    EXPECT_FALSE(offersToAcknowledge(list));
    EXPECT_FALSE(allText(list).contains(QStringLiteral("tainted")));
    EXPECT_TRUE(allText(list).contains(QStringLiteral("1 limit passed.")));
}

TEST(HealthList, ShowLeadsToItsBreach) {
    HealthList list;
    list.setContent({twoBreaches(), {}, Vec3::Zero()});
    std::vector<std::size_t> chosen;
    QObject::connect(&list, &HealthList::breachChosen, [&](std::size_t breach) { chosen.push_back(breach); });
    for (QPushButton* button : list.findChildren<QPushButton*>()) {
        if (button->text().startsWith(QStringLiteral("Show"))) {
            EXPECT_FALSE(button->accessibleName().isEmpty());
            button->click();
        }
    }
    EXPECT_EQ(chosen, (std::vector<std::size_t>{0, 1}));
}

TEST(HealthMarks, OfATimelineAreChosenByTheirSignAndScrubElsewhere) {
    Timeline timeline;
    timeline.resize(900, 116);
    timeline.setRange(0.0, 10.0);
    timeline.setHealth(healthMarks(twoBreaches(), false, Vec3::Zero()));
    std::vector<std::size_t> chosen;
    int scrubbed = 0;
    QObject::connect(&timeline, &Timeline::markChosen, [&](std::size_t mark) { chosen.push_back(mark); });
    QObject::connect(&timeline, &Timeline::scrubbed, [&] { ++scrubbed; });
    QTest::mouseClick(&timeline, Qt::LeftButton, {}, timeline.signOf(1).toPoint());
    QTest::mouseClick(&timeline, Qt::LeftButton, {}, QPoint(static_cast<int>(timeline.toX(3.9)), timeline.signOf(0).toPoint().y()));
    EXPECT_EQ(chosen, (std::vector<std::size_t>{1, 0})) << "by the sign, and by its interval";
    EXPECT_EQ(scrubbed, 0);
    QTest::mouseClick(&timeline, Qt::LeftButton, {}, QPoint(static_cast<int>(timeline.toX(3.9)), 30));
    QTest::mouseClick(&timeline, Qt::LeftButton, {}, QPoint(static_cast<int>(timeline.toX(8.0)), timeline.signOf(0).toPoint().y()));
    EXPECT_EQ(scrubbed, 2) << "beside a mark the timeline scrubs";
    EXPECT_EQ(chosen.size(), 2U);
}

TEST(HealthMarks, ThatWouldCoverEachOtherShareASign) {
    Timeline timeline;
    timeline.resize(900, 116);
    timeline.setRange(0.0, 10.0);
    HealthReport health = twoBreaches();
    health.breaches[1].from = 3.21;
    health.breaches[1].to = 5.0;
    timeline.setHealth(healthMarks(health, false, Vec3::Zero()));
    EXPECT_EQ(timeline.signOf(0), timeline.signOf(1));
    EXPECT_EQ(timeline.marksAt(timeline.signOf(0)), (std::vector<std::size_t>{0, 1})) << "both are told of";
    timeline.setRange(3.0, 3.4);
    EXPECT_NE(timeline.signOf(0), timeline.signOf(1)) << "there is room for both";
}

TEST(HealthMarks, AreSeenAndLookOtherwiseOnceAcknowledged) {
    Timeline timeline;
    timeline.resize(900, 116);
    timeline.setRange(0.0, 10.0);
    const QImage without = timeline.grab().toImage();
    timeline.setHealth(healthMarks(twoBreaches(), false, Vec3::Zero()));
    const QImage with = timeline.grab().toImage();
    timeline.setHealth(healthMarks(twoBreaches(), true, Vec3::Zero()));
    const QImage acknowledged = timeline.grab().toImage();
    EXPECT_NE(with, without);
    EXPECT_NE(with, acknowledged);
    EXPECT_TRUE(timeline.accessibleDescription().contains(QStringLiteral("inside each other"), Qt::CaseInsensitive));
}

}  // namespace rubble::widgets
