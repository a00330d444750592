#include "widgets/views/fragment_table.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <algorithm>
#include <ctime>

#include "tests/scenes/fe_scenes.h"
#include "tests/widgets/scenes/ballistic_run.h"
#include "widgets/basics/number_field.h"

namespace rubble::widgets {
namespace {

class Table : public testing::Test {
protected:
    void SetUp() override {
        table.resize(760, 240);
        QObject::connect(&table, &FragmentTable::selectionRequested, &table,
                         [this](const auto& elements) { asked.push_back(elements); });
        QObject::connect(&table, &FragmentTable::filterEdited, &table, [this](const auto& filter) { filters.push_back(filter); });
        QObject::connect(&table, &FragmentTable::birthRequested, &table, [this] { ++births; });
        table.setData(data);
        table.setSpeeds(std::vector<double>(data.fragments->size(), 2.0));
        table.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&table));
    }
    QAbstractItemModel& rows() { return *table.rows().model(); }
    QPoint middleOf(int row, int column = 0) { return table.rows().visualRect(rows().index(row, column)).center(); }
    void clickRow(int row, Qt::KeyboardModifiers keys = {}) {
        QTest::mouseClick(table.rows().viewport(), Qt::LeftButton, keys, middleOf(row));
    }
    void clickHead(int column) {
        QHeaderView& head = *table.rows().horizontalHeader();
        QTest::mouseClick(head.viewport(), Qt::LeftButton, {},
                          QPoint(head.sectionViewportPosition(column) + head.sectionSize(column) / 2, head.height() / 2));
    }
    void type(const char* field, const char* text) {
        auto* bound = table.findChild<NumberField*>(QLatin1String(field));
        ASSERT_NE(bound, nullptr) << field;
        bound->setFocus();
        bound->selectAll();
        QTest::keyClicks(bound, QLatin1String(text));
        QTest::keyClick(bound, Qt::Key_Return);
    }
    double figure(int row, int column) { return QLocale().toDouble(rows().index(row, column).data().toString()); }

    render::SceneData data = scenes::ballisticRun(scenes::collapsingWall(4, 3), 1.0);
    FragmentTable table;
    std::vector<std::vector<ElementIndex>> asked;
    std::vector<render::FragmentFilter> filters;
    int births = 0;
};

TEST_F(Table, EveryColumnHasAHeadWithItsUnit) {
    QStringList heads;
    for (int column = 0; column < rows().columnCount(); ++column) {
        heads << rows().headerData(column, Qt::Horizontal).toString();
        EXPECT_FALSE(rows().headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString().isEmpty()) << column;
    }
    EXPECT_EQ(heads.join(u'|'), QStringLiteral("fragment|element|component|born, s|mass, kg|longest side, m|speed, m/s|cluster"));
    EXPECT_EQ(rows().rowCount(), static_cast<int>(data.fragments->size()));
}

TEST_F(Table, AClickOnARowAsksForItsElementAndCtrlForMore) {
    clickRow(1);
    ASSERT_FALSE(asked.empty());
    EXPECT_EQ(asked.back(), std::vector{table.model().elementAt(1)});
    clickRow(3, Qt::ControlModifier);
    std::vector expected{table.model().elementAt(1), table.model().elementAt(3)};
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(asked.back(), expected);
}

TEST_F(Table, KeysGoThroughTheRowsAndEnterGoesToTheBirth) {
    clickRow(0);
    QTest::keyClick(&table.rows(), Qt::Key_Down);
    EXPECT_EQ(asked.back(), std::vector{table.model().elementAt(1)});
    QTest::keyClick(&table.rows(), Qt::Key_Down, Qt::ShiftModifier);
    EXPECT_EQ(asked.back().size(), 2U);
    QTest::keyClick(&table.rows(), Qt::Key_A, Qt::ControlModifier);
    EXPECT_EQ(asked.back().size(), data.fragments->size());
    EXPECT_EQ(births, 0);
    QTest::keyClick(&table.rows(), Qt::Key_Return);
    EXPECT_EQ(births, 1);
}

TEST_F(Table, WhatIsSelectedElsewhereIsChosenAndTellsNothingBack) {
    const ElementIndex element = data.fragments->list[5].element;
    table.setSelection({element});
    EXPECT_TRUE(asked.empty());
    const QModelIndexList chosen = table.rows().selectionModel()->selectedRows();
    ASSERT_EQ(chosen.size(), 1);
    EXPECT_EQ(chosen.front().row(), 5);
    clickHead(FragmentModel::Element);
    clickHead(FragmentModel::Element);
    ASSERT_EQ(table.rows().selectionModel()->selectedRows().size(), 1) << "it stays chosen where it is sorted to";
    EXPECT_EQ(table.model().elementAt(table.rows().selectionModel()->selectedRows().front().row()), element);
    EXPECT_TRUE(asked.empty());
}

TEST_F(Table, AHeadSortsUpAndDown) {
    clickHead(FragmentModel::Birth);
    for (const bool up : {true, false}) {
        for (int row = 1; row < rows().rowCount(); ++row) {
            const double before = figure(row - 1, FragmentModel::Birth);
            const double here = figure(row, FragmentModel::Birth);
            EXPECT_TRUE(up ? before <= here : before >= here) << row;
        }
        clickHead(FragmentModel::Birth);
    }
}

TEST_F(Table, BoundsLeaveRowsOutAndSayHowMany) {
    const double first = data.fragments->list.front().birthTime;
    type("filterHigh3", qPrintable(QString::number(first)));
    ASSERT_EQ(filters.size(), 1U);
    EXPECT_EQ(filters.back().birth.high, first);
    const int left = rows().rowCount();
    EXPECT_GT(left, 0);
    EXPECT_LT(left, static_cast<int>(data.fragments->size()));
    EXPECT_EQ(table.findChild<QLabel*>(QStringLiteral("fragmentsShown"))->text(),
              QStringLiteral("%1 of %2 fragments shown").arg(left).arg(data.fragments->size()));
    QTest::mouseClick(table.findChild<QPushButton*>(QStringLiteral("clearFilter")), Qt::LeftButton);
    EXPECT_TRUE(filters.back().empty());
    EXPECT_EQ(rows().rowCount(), static_cast<int>(data.fragments->size()));
    EXPECT_TRUE(table.findChild<NumberField*>(QStringLiteral("filterHigh3"))->text().isEmpty());
}

TEST_F(Table, RowsFollowTheSpeedsOfTheTimeShown) {
    type("filterLow0", "3");
    EXPECT_EQ(rows().rowCount(), 0) << "all move at 2 m/s";
    std::vector<double> speeds(data.fragments->size(), 1.0);
    speeds[4] = 5.0;
    table.setSpeeds(speeds);
    ASSERT_EQ(rows().rowCount(), 1);
    EXPECT_EQ(table.model().fragmentAt(0), FragmentId{4});
    EXPECT_EQ(rows().index(0, FragmentModel::Speed).data().toString(), QStringLiteral("5.00"));
}

TEST_F(Table, AComponentIsChosenByTheKeyboard) {
    auto* box = table.findChild<QComboBox*>(QStringLiteral("filterComponent"));
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Down);
    ASSERT_FALSE(filters.empty());
    EXPECT_EQ(filters.back().component, data.components->list.front().name);
}

TEST(TableOfMany, FiftyThousandRowsAreSortedSiftedAndChosenAtOnce) {
    blocks::Block block;
    block.size = Vec3(50, 50, 20);
    block.cells = {50, 50, 20};
    block.deathState = [](std::size_t e) { return e % 2 == 0 ? std::size_t{1} : std::size_t{2}; };
    render::SceneData data;
    data.fe = blocks::makeScene({block}, 3, 0.5);
    auto components = std::make_shared<Components>(groupComponents(data.fe->mesh(), {}, {}, {}));
    data.fragments = std::make_shared<FragmentSet>(makeFragments(*data.fe, *components, {}, Execution()));
    data.components = components;
    ASSERT_EQ(data.fragments->size(), 50000U);
    FragmentTable table;
    table.resize(760, 240);
    table.show();
    std::vector<ElementIndex> all;
    for (const Fragment& fragment : data.fragments->list) {
        all.push_back(fragment.element);
    }
    // Seconds of this process, whatever else the machine does.
    const std::clock_t from = std::clock();
    table.setData(data);
    std::vector<double> speeds(all.size());
    for (std::size_t f = 0; f < speeds.size(); ++f) {
        speeds[f] = static_cast<double>((f * 7919) % 1000);
    }
    table.setSpeeds(speeds);
    table.rows().sortByColumn(FragmentModel::Speed, Qt::DescendingOrder);
    render::FragmentFilter filter;
    filter.speed.low = 500.0;
    table.setFilter(filter);
    EXPECT_EQ(table.rows().model()->rowCount(), 25000);
    EXPECT_EQ(table.model().speeds()[at(table.model().fragmentAt(0))], 999.0);
    table.setSelection(all);
    EXPECT_EQ(table.rows().selectionModel()->selection().size(), 1) << "one range, not 25,000";
    table.grab();
    EXPECT_LT(static_cast<double>(std::clock() - from) / CLOCKS_PER_SEC, 2.0);
}

}  // namespace
}  // namespace rubble::widgets
