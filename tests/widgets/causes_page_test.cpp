#include "widgets/evidence/causes_page.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTest>
#include <QTextDocumentFragment>

#include "widgets/basics/panel.h"
#include "widgets/evidence/cause_chart.h"
#include "widgets/evidence/causes_panel.h"

namespace rubble::widgets {
namespace {

/// A patch of debris from a column on, one cell more to the east for every other member.
std::shared_ptr<const EnsembleReport> ensembleAt(int column) {
    auto report = std::make_shared<EnsembleReport>();
    report->surface.cell = 1.0;
    for (int m = 0; m < 12; ++m) {
        EnsembleMember& member = report->members.emplace_back();
        member.done = true;
        MemberSurface surface;
        for (int j = 0; j < 6; ++j) {
            for (int i = 0; i < 6; ++i) {
                surface.cells.push_back({j, column + i + m % 3});
                surface.heights.push_back(1.0F);
                surface.masses.push_back(2000.0F);
                surface.covered.push_back(1.0F);
            }
        }
        member.surface = std::make_shared<const MemberSurface>(surface);
    }
    return report;
}

CausesPage::Content compared(const std::vector<Hypothesis>& hypotheses, int seen) {
    CauseEvidence evidence;
    SurfaceEvidence& survey = evidence.surfaces.emplace_back();
    survey.name = "survey/footprint.gpkg";
    survey.seen = *ensembleAt(seen)->members[1].surface;
    CausesPage::Content content;
    content.comparison = std::make_shared<const CauseComparison>(compareCauses(hypotheses, evidence));
    if (content.comparison->separation) {
        content.separation = std::shared_ptr<const DebrisMap>(content.comparison, &*content.comparison->separation);
    }
    content.causes = {hypotheses[0].name, hypotheses[1].name};
    return content;
}

QString noticesOf(const QWidget& page) {
    QString text;
    for (const Notice* notice : page.findChildren<Notice*>()) {
        text += QTextDocumentFragment::fromHtml(notice->text()).toPlainText() + u'\n';
    }
    return text;
}

TEST(CausesPage, SaysWhichEvidenceWouldTell) {
    const std::vector<Hypothesis> hypotheses{{"scour", ensembleAt(0)}, {"crown struck", ensembleAt(30)}};
    CausesPage page;
    page.resize(880, 900);
    CausesPage::Content content = compared(hypotheses, 30);
    page.setContent(content);
    page.show();
    const auto table = [&]() -> QTableWidget* {
        for (QTableWidget* each : page.findChildren<QTableWidget*>()) {
            if (each->accessibleName() == QStringLiteral("Which evidence would tell")) {
                return each;
            }
        }
        return nullptr;
    };
    ASSERT_NE(table(), nullptr);
    EXPECT_FALSE(table()->isVisible()) << "it was not looked for";
    content.further = std::make_shared<const TellingEvidence>(
        tellingEvidence(hypotheses, {}, std::vector<std::size_t>{0, 1}, SiteSurface{}, Execution()));
    page.setContent(content);
    EXPECT_TRUE(table()->isVisible());
    EXPECT_EQ(table()->rowCount(), 8);
    EXPECT_EQ(table()->item(0, 0)->text(), QStringLiteral("outline of all debris"));
    EXPECT_EQ(table()->item(0, 1)->text(), QStringLiteral("100 %"));
    EXPECT_EQ(table()->item(0, 2)->text(), QStringLiteral("86 % to 100 %"));
}

TEST(CausesPage, NamesTheCauseByWhatAndWhere) {
    CausesPage page;
    page.resize(880, 700);
    page.setContent(compared({{"scour", ensembleAt(0)}, {"crown struck", ensembleAt(30)}}, 30));
    page.show();
    EXPECT_TRUE(noticesOf(page).contains(QStringLiteral("\"crown struck\" explains the outline best")));
    ASSERT_EQ(page.ranking().rowCount(), 2);
    EXPECT_EQ(page.ranking().item(0, 0)->text(), QStringLiteral("crown struck"));
    EXPECT_EQ(page.ranking().item(0, 6)->text(), QStringLiteral("closest"));
    EXPECT_EQ(page.ranking().item(1, 6)->text(), QStringLiteral("told apart"));
    EXPECT_EQ(page.ranking().horizontalHeaderItem(7)->text(), QStringLiteral("footprint.gpkg"));
    QString words;
    for (const QLabel* label : page.findChildren<QLabel*>()) {
        words += label->text() + u'\n';
    }
    EXPECT_TRUE(words.contains(QStringLiteral("footprint.gpkg tells most")));
    EXPECT_TRUE(words.contains(QStringLiteral("(ringed)")));
    QImage picture(page.size(), QImage::Format_RGB32);
    page.render(&picture);
    EXPECT_FALSE(page.chart().svg({600, 400}).isEmpty());
}

TEST(CausesPage, SaysWhenTheyCannotBeToldApart) {
    CausesPage page;
    page.setContent(compared({{"a", ensembleAt(0)}, {"b", ensembleAt(0)}}, 0));
    EXPECT_TRUE(noticesOf(page).contains(QStringLiteral("cannot tell \"a\" from \"b\"")));
    EXPECT_EQ(page.ranking().item(1, 6)->text(), QStringLiteral("not told apart"));
}

TEST(CausesPage, WithoutEvidenceOnlyTheBlindTestsStand) {
    CausesPage page;
    const std::vector<Hypothesis> hypotheses{{"a", ensembleAt(0)}, {"b", ensembleAt(30)}};
    CausesPage::Content content;
    content.causes = {"a", "b"};
    content.blind = {blindTest(hypotheses, EvidenceKind::Footprint, Execution())};
    page.setContent(content);
    page.show();
    EXPECT_TRUE(page.ranking().isHidden());
    auto* blind = page.findChildren<QTableWidget*>().last();
    ASSERT_EQ(blind->rowCount(), 2);
    EXPECT_EQ(blind->item(0, 1)->text(), QStringLiteral("12"));
    EXPECT_EQ(blind->item(0, 2)->text(), QStringLiteral("0"));
    page.setContent({});
    EXPECT_TRUE(noticesOf(page).contains(QStringLiteral("No causes have been compared yet")));
}

TEST(CausesPanel, TicksAndRemovalsAreToldByPlace) {
    CausesPanel panel;
    CausesPanel::Content content;
    content.causes = {{"as built", "a scenario", true, true, false}, {"scour", "/x/scour.rubble", true, true, true}};
    content.evidence = {{"photograph: a.jpg", "No outline", true, false, false}};
    content.available = content.ready = true;
    panel.setContent(content);
    panel.show();
    auto* causes = panel.findChild<QListWidget*>(QStringLiteral("causes"));
    QSignalSpy used(&panel, &CausesPanel::causeUsed);
    causes->item(1)->setCheckState(Qt::Unchecked);
    ASSERT_EQ(used.count(), 1);
    EXPECT_EQ(used[0][0].toInt(), 1);
    EXPECT_FALSE(used[0][1].toBool());
    auto* evidence = panel.findChild<QListWidget*>(QStringLiteral("causeEvidence"));
    EXPECT_EQ(evidence->item(0)->checkState(), Qt::Unchecked) << "what cannot be used is not ticked";
    EXPECT_FALSE(evidence->item(0)->flags() & Qt::ItemIsUserCheckable);
    QPushButton* remove = nullptr;
    for (QPushButton* button : panel.findChildren<QPushButton*>()) {
        if (remove == nullptr && button->text() == QStringLiteral("Remove")) {
            remove = button;
        }
    }
    causes->setCurrentRow(0);
    EXPECT_FALSE(remove->isEnabled()) << "scenarios of the case are removed in the case";
    causes->setCurrentRow(1);
    EXPECT_TRUE(remove->isEnabled());
    QSignalSpy removed(&panel, &CausesPanel::causeRemoved);
    QTest::mouseClick(remove, Qt::LeftButton);
    ASSERT_EQ(removed.count(), 1);
    EXPECT_EQ(removed[0][0].toInt(), 1);
}

TEST(CausesPanel, NamesFitTheListAndWhatIsGoneCanBeTakenOffIt) {
    CausesPanel panel;
    CausesPanel::Content content;
    const QString name = QStringLiteral("height model: north-abutment-2026-11-24-registered-by-four-pairs-of-points.tif");
    content.causes = {{"scour", "There is no file /x/scour.rubble", true, false, true}};
    content.evidence = {{name, "A survey of this case", true, true, false}};
    content.available = true;
    panel.setContent(content);
    panel.resize(320, 700);
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
    auto* evidence = panel.findChild<QListWidget*>(QStringLiteral("causeEvidence"));
    EXPECT_LE(evidence->visualItemRect(evidence->item(0)).width(), evidence->viewport()->width());
    EXPECT_EQ(evidence->textElideMode(), Qt::ElideMiddle);
    EXPECT_TRUE(evidence->item(0)->toolTip().startsWith(name));
    auto* causes = panel.findChild<QListWidget*>(QStringLiteral("causes"));
    QTest::mouseClick(causes->viewport(), Qt::LeftButton, {}, causes->visualItemRect(causes->item(0)).center());
    QSignalSpy removed(&panel, &CausesPanel::causeRemoved);
    for (QPushButton* button : panel.findChildren<QPushButton*>()) {
        if (button->text() == QStringLiteral("Remove") && button->isEnabled()) {
            QTest::mouseClick(button, Qt::LeftButton);
        }
    }
    EXPECT_EQ(removed.count(), 1);
}

}  // namespace
}  // namespace rubble::widgets
