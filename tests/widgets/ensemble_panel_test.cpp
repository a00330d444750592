#include "widgets/evidence/ensemble_panel.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>

#include "core/evidence/ensembles/probability_map.h"
#include "widgets/basics/number_field.h"
#include "widgets/evidence/ensemble_page.h"

namespace rubble::widgets {
namespace {

class EnsembleBox : public testing::Test {
protected:
    void SetUp() override {
        QObject::connect(&m_panel, &EnsemblePanel::settingsEdited, &m_panel,
                         [this](const EnsembleSettings& settings, const Wording& what) {
                             m_settings = settings;
                             m_edits << what();
                             show();
                         });
        show();
        m_panel.resize(336, 700);
        m_panel.show();
    }
    void show() {
        EnsemblePanel::Content content;
        content.settings = m_settings;
        content.scenarios = {{"scenario-1", "as built"}, {"scenario-2", "scour"}};
        content.available = content.ready = true;
        m_panel.setContent(content);
    }
    QComboBox* additions() { return m_panel.findChild<QComboBox*>(QStringLiteral("addVaried")); }
    void add(const char* key) {
        const int index = additions()->findData(QLatin1String(key));
        ASSERT_GE(index, 0) << key;
        additions()->setCurrentIndex(index);
        emit additions() -> activated(index);
    }
    template <class Widget>
    Widget* named(const QString& name) {
        for (Widget* widget : m_panel.findChildren<Widget*>()) {
            if (widget->accessibleName() == name && !widget->isHidden()) {
                return widget;
            }
        }
        return nullptr;
    }
    void type(const QString& name, const QString& text) {
        auto* field = named<QLineEdit>(name);
        ASSERT_NE(field, nullptr) << name.toStdString();
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    }

    const std::vector<VariedSetting> m_begun{variationFrom("friction", "uniform:0.4:0.8"),
                                             variationFrom("restitution", "uniform:0:0.2"),
                                             variationFrom("birth_shift", "uniform:0:0.02")};
    EnsembleSettings m_settings{m_begun};
    QStringList m_edits;
    EnsemblePanel m_panel;
};

TEST_F(EnsembleBox, TypedEndsOfADistributionLeaveAsTheWholeSettings) {
    type(QStringLiteral("Friction, least"), QStringLiteral("0.5"));
    ASSERT_EQ(m_edits.size(), 1);
    EXPECT_EQ(m_edits[0], QStringLiteral("distribution of Friction"));
    EXPECT_EQ(m_settings.varied[0].first, 0.5);
    EXPECT_EQ(m_settings.varied[0].second, 0.8);
    EXPECT_EQ(m_settings.members, 16);
}

TEST_F(EnsembleBox, WhatCannotBeDrawnIsExplainedAndStaysOut) {
    type(QStringLiteral("Friction, least"), QStringLiteral("0.9"));
    EXPECT_TRUE(m_edits.isEmpty());
    QString complaint;
    for (const QLabel* label : m_panel.findChildren<QLabel*>(QStringLiteral("complaint"))) {
        complaint += label->isHidden() ? QString() : label->text();
    }
    EXPECT_TRUE(complaint.contains(QStringLiteral("the lesser first"))) << complaint.toStdString();
}

TEST_F(EnsembleBox, ParametersComeAndGo) {
    add("ground_height");
    ASSERT_EQ(m_settings.varied.size(), 4u);
    EXPECT_EQ(m_settings.varied[3].key, "ground_height");
    EXPECT_EQ(additions()->findData(QStringLiteral("ground_height")), -1) << "offered once only";
    EXPECT_EQ(additions()->findData(QStringLiteral("seed")), -1) << "every member has its own";
    add("scenario");
    ASSERT_EQ(m_settings.varied.size(), 5u);
    EXPECT_EQ(m_settings.varied[4].choices, (std::vector<std::string>{"scenario-1", "scenario-2"}));
    auto* remove = named<QToolButton>(QStringLiteral("Do not vary Friction"));
    ASSERT_NE(remove, nullptr);
    QTest::mouseClick(remove, Qt::LeftButton);
    EXPECT_EQ(m_settings.varied.size(), 4u);
    EXPECT_EQ(m_edits.last(), QStringLiteral("Friction not varied"));
}

TEST_F(EnsembleBox, AnotherKindOfDistributionCoversAboutTheSameValues) {
    auto* kind = named<QComboBox>(QStringLiteral("Distribution of Friction"));
    ASSERT_NE(kind, nullptr);
    emit kind->activated(static_cast<int>(Distribution::Normal));
    EXPECT_EQ(m_settings.varied[0].distribution, Distribution::Normal);
    EXPECT_NEAR(m_settings.varied[0].first, 0.6, 1e-12);
    EXPECT_NEAR(m_settings.varied[0].second, 0.1, 1e-12);
    emit named<QComboBox>(QStringLiteral("Distribution of Friction"))->activated(static_cast<int>(Distribution::Choice));
    EXPECT_EQ(m_settings.varied[0].choices.size(), 2u);
    type(QStringLiteral("Values of Friction"), QStringLiteral("0.4, 0.6, 0.8"));
    EXPECT_EQ(m_settings.varied[0].choices, (std::vector<std::string>{"0.4", "0.6", "0.8"}));
    checkEnsemble(m_settings);
}

TEST_F(EnsembleBox, EveryParameterThatIsOfferedCanBeDrawnAsProposed) {
    for (int i = 1; i < additions()->count(); ++i) {
        const QString key = additions()->itemData(i).toString();
        m_settings.varied.clear();
        m_edits.clear();
        show();
        add(key.toUtf8().constData());
        ASSERT_EQ(m_settings.varied.size(), 1u) << key.toStdString();
        EXPECT_NO_THROW(memberScenario(Scenario(), m_settings, 0)) << key.toStdString();
        m_settings.varied.clear();
        show();
    }
}

TEST_F(EnsembleBox, MembersSeedAndCellsAreTheirOwnEdits) {
    m_panel.findChild<QSpinBox*>(QStringLiteral("members"))->setValue(40);
    EXPECT_EQ(m_settings.members, 40);
    type(QStringLiteral("Seed"), QStringLiteral("9"));
    EXPECT_EQ(m_settings.seed, 9);
    EXPECT_EQ(m_settings.varied, m_begun);
    QSignalSpy surface(&m_panel, &EnsemblePanel::surfaceChanged);
    type(QStringLiteral("Cells"), QStringLiteral("1.5"));
    EXPECT_EQ(surface.count(), 1);
    EXPECT_EQ(m_panel.surface().cell, 1.5);
}

TEST(EnsemblePage, ShowsTheSpreadOfTheMembersThatAreDone) {
    EnsemblePage page;
    const int needed = page.minimumSizeHint().height();
    EXPECT_TRUE(page.spread().isHidden() || !page.spread().isVisible());
    auto report = std::make_shared<EnsembleReport>();
    for (int m = 0; m < 3; ++m) {
        EnsembleMember& member = report->members.emplace_back();
        member.done = m < 2;
        member.figures = {100.0 + 10.0 * m, 20.0, 5.0, 1e6, 0.5, 2.0};
        MemberSurface surface;
        surface.cells = {{0, 0}, {0, m + 1}};
        surface.heights = {1.0F, 0.5F};
        surface.masses = {2000.0F, 1000.0F};
        surface.covered = {1.0F, 1.0F};
        member.surface = std::make_shared<const MemberSurface>(surface);
    }
    EnsemblePage::Content content;
    content.report = report;
    content.map = std::make_shared<const DebrisMap>(probabilityMap(*report, usualThresholds));
    page.resize(900, 600);
    page.setContent(content);
    page.show();
    ASSERT_EQ(page.spread().rowCount(), static_cast<int>(memberMeasureCount));
    EXPECT_EQ(page.spread().item(0, 0)->text(), QStringLiteral("Covered area, m²"));
    EXPECT_EQ(page.spread().item(0, 1)->text(), QStringLiteral("105.0")) << "of the two that are done";
    EXPECT_EQ(page.spread().item(0, 2)->text(), QStringLiteral("5.0"));
    const auto head = [&](int column) { return page.spread().horizontalHeaderItem(column)->text(); };
    EXPECT_EQ(head(4), QStringLiteral("least")) << "two members have no one in twenty";
    EXPECT_EQ(page.spread().item(0, 4)->text(), QStringLiteral("100.0"));
    EXPECT_EQ(page.spread().item(1, 3)->text(), QStringLiteral("none")) << "the same in all members";
    EXPECT_EQ(page.spread().item(3, 0)->text(), QStringLiteral("Mass that fell, t"));
    EXPECT_EQ(page.spread().item(3, 1)->text(), QStringLiteral("1,000"));
    EXPECT_EQ(page.minimumSizeHint().height(), needed) << "the window would grow while members come in";
    EXPECT_EQ(head(6), QStringLiteral("most"));
    EXPECT_EQ(page.spread().item(0, 6)->text(), QStringLiteral("110.0"));
    auto many = std::make_shared<EnsembleReport>(*report);
    many->members.resize(20, report->members.front());
    for (EnsembleMember& member : many->members) {
        member.done = true;
    }
    EnsemblePage::Content more = content;
    more.report = many;
    page.setContent(more);
    EXPECT_EQ(head(4), QStringLiteral("5 %"));
    page.setContent(content);
    QSignalSpy layers(&page, &EnsemblePage::layerChanged);
    page.setLayer(MapLayer::HeightMiddle);
    EXPECT_EQ(page.layer(), MapLayer::HeightMiddle);
    EXPECT_EQ(layers.count(), 1);
    // The layer stays while members come in.
    page.setContent(content);
    EXPECT_EQ(page.layer(), MapLayer::HeightMiddle);
    QImage picture(page.size(), QImage::Format_RGB32);
    page.render(&picture);
}

}  // namespace
}  // namespace rubble::widgets
