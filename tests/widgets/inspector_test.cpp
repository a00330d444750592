#include "widgets/views/inspector.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <algorithm>

namespace rubble::widgets {
namespace {

Inspector::ElementFacts fragmentFacts() {
    Inspector::ElementFacts facts;
    facts.number = 21877;
    facts.component = "arch ring 2";
    facts.material = "stone";
    facts.shape = "hexahedron";
    facts.mass = 803.0;
    facts.volume = 0.31;
    facts.lastActive = 4.8;
    facts.firstInactive = 4.88;
    facts.reportedBy = "STATUS, 1 is active";
    Inspector::FragmentFacts fragment;
    fragment.id = idAt<FragmentId>(18204);
    fragment.birthTime = 4.88;
    fragment.birthPlace = Vec3(10.0, 2.0, 30.0);
    fragment.birthSpeed = 24.2;
    fragment.finalPlace = Vec3(13.0, 6.0, 1.5);
    fragment.finalTime = 19.7;
    fragment.cluster = idAt<ClusterId>(1733);
    fragment.clusterSize = 14;
    fragment.error = 0.27;
    FragmentPath path;
    path.restTime = 8.31;
    path.points = {{4.88, Vec3(10, 2, 30), 0.0}, {19.7, Vec3(13, 6, 1.5), 0.0}};
    path.impacts = {{5.02, 21.3, 19.0, 182000.0}, {5.9, 4.1, 3.0, 6700.0}};
    fragment.path = path;
    facts.fragment = fragment;
    return facts;
}

QString textOf(const Inspector& inspector) {
    QStringList all;
    for (const QLabel* label : inspector.findChildren<QLabel*>()) {
        all << label->text();
    }
    for (const QPushButton* button : inspector.findChildren<QPushButton*>()) {
        all << button->text();
    }
    return all.join(QLatin1Char('\n'));
}

QToolButton* button(Inspector& inspector, const QString& text) {
    for (auto* each : inspector.findChildren<QToolButton*>()) {
        if (each->text() == text) {
            return each;
        }
    }
    return nullptr;
}

TEST(Inspector, TellsTheStoryOfAFragment) {
    Inspector inspector;
    inspector.showElement(fragmentFacts());
    EXPECT_EQ(inspector.title(), QStringLiteral("Fragment 18,204"));
    const QString text = textOf(inspector);
    for (const char* part :
         {"arch ring 2 · element 21,877", "803", "4.800", "4.880", "STATUS, 1 is active", "24.2", "10.00, 2.00, 30.00",
          "13.00, 6.00, 1.50", "5.00", "28.50", "8.310", "1,733 (14)", "0.27", "5.020 s   21.3\u00A0m/s   182"}) {
        EXPECT_TRUE(text.contains(QString::fromUtf8(part))) << part << " is not in\n" << text.toStdString();
    }
    EXPECT_TRUE(button(inspector, "Go to birth")->isEnabled());
    EXPECT_TRUE(button(inspector, "Follow")->isEnabled());
    EXPECT_TRUE(button(inspector, "Cluster")->isEnabled());
}

TEST(Inspector, AnImpactLeadsToItsTime) {
    Inspector inspector;
    inspector.showElement(fragmentFacts());
    inspector.show();
    QSignalSpy asked(&inspector, &Inspector::timeRequested);
    for (QPushButton* each : inspector.findChildren<QPushButton*>()) {
        if (each->text().startsWith(QStringLiteral("5.020"))) {
            each->setFocus();
            QTest::keyClick(each, Qt::Key_Space);
        }
    }
    ASSERT_EQ(asked.size(), 1);
    EXPECT_DOUBLE_EQ(asked.last().at(0).toDouble(), 5.02);
}

TEST(Inspector, AnElementThatLivesHasNoJourney) {
    Inspector inspector;
    Inspector::ElementFacts facts = fragmentFacts();
    facts.fragment.reset();
    facts.firstInactive.reset();
    inspector.showElement(facts);
    EXPECT_EQ(inspector.title(), QStringLiteral("Element 21,877"));
    EXPECT_TRUE(textOf(inspector).contains(QStringLiteral("stays active")));
    EXPECT_FALSE(textOf(inspector).contains(QStringLiteral("JOURNEY")));
    EXPECT_FALSE(button(inspector, "Go to birth")->isEnabled());
    EXPECT_FALSE(button(inspector, "Follow")->isEnabled());
}

TEST(Inspector, SaysSinceWhenTheEngineHasCarriedAnElement) {
    Inspector inspector;
    Inspector::ElementFacts facts;
    facts.number = 21877;
    facts.lastActive = 4.94;
    inspector.showElement(facts);
    EXPECT_FALSE(textOf(inspector).contains(QStringLiteral("engine")));
    facts.carriedSince = 4.0801;
    inspector.showElement(facts);
    EXPECT_TRUE(textOf(inspector).contains(QStringLiteral("Carried by the engine since 4.08 s")));
}

TEST(Inspector, WithoutARunItSaysHowToGetOne) {
    Inspector inspector;
    Inspector::ElementFacts facts = fragmentFacts();
    facts.fragment->finalPlace.reset();
    facts.fragment->path.reset();
    inspector.showElement(facts);
    EXPECT_TRUE(textOf(inspector).contains(QStringLiteral("Simulate to see")));
    EXPECT_TRUE(button(inspector, "Go to birth")->isEnabled());
}

TEST(Inspector, ManyAreSummed) {
    Inspector inspector;
    Inspector::Sums sums;
    sums.elements = 1234;
    sums.fragments = 1000;
    sums.dead = 400;
    sums.mass = 5.6e6;
    sums.firstBirth = 1.25;
    sums.lastBirth = 4.5;
    for (int i = 0; i < 9; ++i) {
        sums.components.emplace_back("pier " + std::to_string(i), 100 - i);
    }
    inspector.showSums(sums);
    const QString text = textOf(inspector);
    for (const char* part : {"1,234 elements", "1,000", "400", "1.250–4.500", "pier 0", "and 3 more components"}) {
        EXPECT_TRUE(text.contains(QString::fromUtf8(part))) << part << " is not in\n" << text.toStdString();
    }
    const auto usable = [&inspector] {
        const auto buttons = inspector.findChildren<QToolButton*>();
        return std::count_if(buttons.begin(), buttons.end(), [](const QToolButton* button) { return button->isEnabled(); });
    };
    EXPECT_EQ(usable(), 5) << "many are not followed";
    inspector.showNothing();
    EXPECT_FALSE(textOf(inspector).contains(QStringLiteral("pier 0")));
    EXPECT_EQ(usable(), 0) << "nothing is there to be hidden";
}

}  // namespace
}  // namespace rubble::widgets
