#include "widgets/case/component_tree.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include "widgets/basics/parameter_editor.h"

namespace rubble::widgets {
namespace {

std::vector<ComponentTree::Row> rows() {
    return {{"arch", "solid", "stone", QColor("#d55e00"), false},
            {"deck 1", "shell", "concrete", QColor("#0072b2"), false},
            {"pier", "solid", "stone", QColor("#009e73"), true}};
}

class Tree : public testing::Test {
protected:
    void SetUp() override {
        tree.setRows(rows());
        tree.setCounts({{10, 2}, {5, 0}, {7, 7}});
        tree.show();
    }
    QTreeWidgetItem* item(const QString& name) {
        const auto found = tree.tree().findItems(name, Qt::MatchExactly | Qt::MatchRecursive);
        return found.isEmpty() ? nullptr : found.front();
    }
    QToolButton* button(const QString& text) {
        for (auto* each : tree.findChildren<QToolButton*>()) {
            if (each->text() == text) {
                return each;
            }
        }
        return nullptr;
    }
    void choose(const QString& name) {
        tree.tree().setCurrentItem(item(name));
        item(name)->setSelected(true);
    }

    ComponentTree tree;
};

TEST_F(Tree, ShowsEveryComponentUnderItsKindWithItsCounts) {
    EXPECT_EQ(tree.tree().topLevelItemCount(), 2);
    ASSERT_NE(item("arch"), nullptr);
    EXPECT_EQ(item("arch")->parent(), item("pier")->parent());
    EXPECT_NE(item("arch")->parent(), item("deck 1")->parent());
    EXPECT_EQ(item("pier")->text(1), QStringLiteral("7"));
    EXPECT_EQ(item("pier")->text(2), QStringLiteral("7"));
    tree.setCounts({{9, 3}, {5, 0}, {0, 14}});
    EXPECT_EQ(item("pier")->text(2), QStringLiteral("14"));
}

TEST_F(Tree, TicksHideAndAKindTakesAllOfItsOwn) {
    QSignalSpy hidden(&tree, &ComponentTree::hiddenChanged);
    tree.tree().setCurrentItem(item("deck 1"));
    QTest::keyClick(&tree.tree(), Qt::Key_Space);
    ASSERT_EQ(hidden.size(), 1);
    EXPECT_EQ(hidden.last().at(0).value<std::vector<std::string>>(), std::vector<std::string>{"deck 1"});
    item("arch")->parent()->setCheckState(0, Qt::Unchecked);
    EXPECT_EQ(hidden.last().at(0).value<std::vector<std::string>>(), (std::vector<std::string>{"arch", "deck 1", "pier"}));
    const int told = static_cast<int>(hidden.size());
    tree.setHidden({"pier"});
    EXPECT_EQ(hidden.size(), told) << "what is set from outside is not told again";
    EXPECT_EQ(item("arch")->checkState(0), Qt::Checked);
    EXPECT_EQ(item("pier")->checkState(0), Qt::Unchecked);
}

TEST_F(Tree, ButtonsActOnWhatIsChosen) {
    EXPECT_FALSE(button("Isolate")->isEnabled());
    QSignalSpy isolate(&tree, &ComponentTree::isolateRequested);
    QSignalSpy select(&tree, &ComponentTree::selectRequested);
    choose("deck 1");
    ASSERT_TRUE(button("Isolate")->isEnabled());
    button("Isolate")->click();
    button("Select")->click();
    ASSERT_EQ(isolate.size(), 1);
    ASSERT_EQ(select.size(), 1);
    EXPECT_EQ(select.last().at(0).value<std::vector<std::string>>(), std::vector<std::string>{"deck 1"});
    QSignalSpy colour(&tree, &ComponentTree::colourChosen);
    item("deck 1")->setSelected(false);
    choose("pier");
    button("Colour…")->click();
    ASSERT_EQ(colour.size(), 1) << "a chosen colour is given back without a question";
    EXPECT_FALSE(colour.last().at(1).value<QColor>().isValid());
}

TEST_F(Tree, OneChosenComponentCanBeSet) {
    EXPECT_TRUE(tree.findChildren<ParameterEditor*>().isEmpty());
    choose("arch");
    const auto editors = tree.findChildren<ParameterEditor*>();
    ASSERT_EQ(editors.size(), 4);
    QStringList keys;
    for (const ParameterEditor* editor : editors) {
        keys << editor->key();
    }
    EXPECT_TRUE(keys.contains(QStringLiteral("component[arch].reinforced")));
    EXPECT_TRUE(keys.contains(QStringLiteral("component[arch].structural")));
    EXPECT_TRUE(keys.contains(QStringLiteral("component[arch].material")));
    item("pier")->setSelected(true);
    QTest::qWait(1);
    EXPECT_TRUE(tree.findChildren<ParameterEditor*>().isEmpty()) << "two at once are not set";
}

}  // namespace
}  // namespace rubble::widgets
