#include "widgets/evidence/validation_view.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>

#include "tests/scenes/validation_records.h"

namespace rubble::widgets {

namespace {

QString textsOf(const ValidationView& view) {
    QString all;
    for (const QLabel* label : view.findChildren<QLabel*>()) {
        all += label->text() + u'\n';
    }
    return all;
}

TEST(ValidationView, ShowsWhatWasMeasuredBesideWhatWasSimulated) {
    ValidationView view;
    ValidationView::Content content;
    content.records = {scenes::tossRecord()};
    view.setContent(content);
    const QTableWidget& table = view.figures();
    ASSERT_EQ(table.rowCount(), 4) << "a quantity and a figure of each variant";
    const auto cell = [&](int row, int column) { return table.item(row, column)->text(); };
    EXPECT_EQ(cell(0, 0), QStringLiteral("tosses, blind"));
    EXPECT_EQ(cell(0, 1), QStringLiteral("run-out, Plate [m]"));
    EXPECT_EQ(cell(0, 2), QStringLiteral("0.500 ± 0.050"));
    EXPECT_EQ(cell(0, 3), QStringLiteral("0.250 ± 0.040"));
    EXPECT_EQ(cell(0, 4), QStringLiteral("−0.250 (−0.375 to −0.125)"));
    EXPECT_EQ(cell(0, 5), QStringLiteral("0.26 (0.030)"));
    EXPECT_EQ(cell(0, 6), QStringLiteral("2"));
    EXPECT_EQ(cell(1, 1), QStringLiteral("right face up"));
    EXPECT_EQ(cell(1, 2), QStringLiteral("–")) << "nobody measured it";
    EXPECT_EQ(cell(1, 7), QStringLiteral("at least 0.8: does not hold"));
    EXPECT_EQ(cell(2, 7), QStringLiteral("error at least -0.5: holds"));
    EXPECT_EQ(view.parameters().rowCount(), 2);
    EXPECT_EQ(view.parameters().item(0, 1)->text(), QStringLiteral("Friction = 0.6")) << "its name, not its key";
    EXPECT_EQ(view.parameters().item(0, 2)->text(), QStringLiteral("assumed: concrete"));
    EXPECT_TRUE(
        textsOf(view).contains(QStringLiteral("64 falls simulated, of which 2 still moved at the end, 4 left the terrain")));
}

TEST(ValidationView, TellsValidationFromAgreementWithTheReference) {
    ValidationView view;
    EXPECT_TRUE(textsOf(view).contains(QStringLiteral("Agreement with the reference, in the panel Accuracy, is a verification")));
    EXPECT_TRUE(textsOf(view).contains(QStringLiteral("was not held against measured falls on this machine yet")));
    for (const QLabel* label : view.findChildren<QLabel*>()) {
        EXPECT_TRUE(!label->text().contains(QLatin1String("&amp;")) || label->textFormat() == Qt::RichText)
            << qPrintable(label->text());
    }
    EXPECT_EQ(view.figures().rowCount(), 0);
}

TEST(ValidationView, IsStartedAndStoppedByItsButtons) {
    ValidationView view;
    QSignalSpy begun(&view, &ValidationView::validateRequested), cancelled(&view, &ValidationView::cancelRequested);
    auto* start = view.findChild<QPushButton*>(QStringLiteral("primary"));
    auto* stop = view.findChild<QPushButton*>(QStringLiteral("cancelValidation"));
    EXPECT_TRUE(stop->isHidden());
    start->click();
    EXPECT_EQ(begun.count(), 1);
    ValidationView::Content running;
    running.running = true;
    view.setContent(running);
    EXPECT_TRUE(start->isHidden());
    stop->click();
    EXPECT_EQ(cancelled.count(), 1);
}

}  // namespace

}  // namespace rubble::widgets
