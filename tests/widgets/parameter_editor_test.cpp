#include "widgets/basics/parameter_editor.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QTest>
#include <QToolButton>
#include <cmath>

namespace rubble::widgets {

namespace {

struct Edits {
    std::vector<ParameterValue> values;
    explicit Edits(ParameterEditor& editor) {
        QObject::connect(&editor, &ParameterEditor::edited,
                         [this](const QString&, const ParameterValue& value) { values.push_back(value); });
    }
};

void type(ParameterEditor& editor, const QString& text) {
    auto* field = editor.findChild<QLineEdit*>();
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
}

}  // namespace

TEST(ParameterEditor, EveryRowShowsItsDefaultWithoutEditingIt) {
    const Scenario defaults;
    for (const Parameter& row : parameterTable()) {
        ParameterEditor editor(row, row.keyed() ? "deck" : "");
        Edits edits(editor);
        const ParameterValue value = row.get(defaults, "deck");
        editor.setValue(value);
        EXPECT_EQ(editor.value(), value) << row.key;
        if (auto* field = editor.findChild<QLineEdit*>()) {
            // Leaving a field that was not touched must not round its value.
            emit field->editingFinished();
        }
        EXPECT_TRUE(edits.values.empty()) << row.key;
        EXPECT_FALSE(editor.toolTip().isEmpty()) << row.key;
    }
}

TEST(ParameterEditor, NumbersOfEveryRowCanBeTypedWithinTheirRange) {
    for (const Parameter& row : parameterTable()) {
        if (row.kind != ParameterKind::Number && row.kind != ParameterKind::Integer) {
            continue;
        }
        ParameterEditor editor(row, row.keyed() ? "deck" : "");
        editor.setValue(row.automatic ? ParameterValue() : row.get(Scenario(), "deck"));
        Edits edits(editor);
        double wanted = std::isfinite(row.high) && std::isfinite(row.low) ? row.low + (row.high - row.low) / 3.0 : 3.0;
        if (row.kind == ParameterKind::Integer) {
            wanted = std::ceil(wanted);
        }
        type(editor, QString::number(wanted, 'g', 12));
        ASSERT_EQ(edits.values.size(), 1U) << row.key;
        const double got = row.kind == ParameterKind::Integer ? static_cast<double>(std::get<std::int64_t>(edits.values[0]))
                                                              : std::get<double>(edits.values[0]);
        EXPECT_NEAR(got, wanted, 1e-11 * std::abs(wanted)) << row.key;  // twelve digits were typed
        type(editor, QString::number(row.high * 2.0 + 1.0, 'g', 12));
        EXPECT_EQ(edits.values.size(), 1U) << row.key << " took a value out of range";
        EXPECT_FALSE(editor.findChild<QLabel*>(QStringLiteral("complaint"))->isHidden()) << row.key;
        type(editor, QStringLiteral("much"));
        EXPECT_EQ(edits.values.size(), 1U) << row.key << " took a word for a number";
    }
}

TEST(ParameterEditor, ChoicesAreOfferedAsTheyAreInTheTable) {
    const auto [row, subject] = findParameter("cluster_shape");
    ParameterEditor editor(*row, subject);
    editor.setValue(std::string("oriented_box"));
    Edits edits(editor);
    auto* combo = editor.findChild<QComboBox*>();
    ASSERT_NE(combo, nullptr);
    EXPECT_EQ(combo->count(), static_cast<int>(row->choices.size()));
    EXPECT_EQ(combo->currentText(), QStringLiteral("oriented box"));
    combo->setCurrentIndex(2);
    emit combo->activated(2);
    ASSERT_EQ(edits.values.size(), 1U);
    EXPECT_EQ(std::get<std::string>(edits.values[0]), row->choices[2]);
}

TEST(ParameterEditor, TypingTakesAnAutomaticValueOverAndTheMarkGivesItBack) {
    const auto [row, subject] = findParameter("multiple");
    ParameterEditor editor(*row, subject);
    editor.setValue(std::monostate{});
    editor.setAutomaticValue(5.43);
    Edits edits(editor);
    auto* mark = editor.findChild<QToolButton*>(QStringLiteral("autoMark"));
    auto* field = editor.findChild<QLineEdit*>();
    EXPECT_TRUE(mark->isChecked());
    EXPECT_EQ(field->placeholderText(), QStringLiteral("5.43"));
    type(editor, QStringLiteral("2.5"));
    EXPECT_FALSE(mark->isChecked());
    mark->click();
    EXPECT_TRUE(mark->isChecked());
    ASSERT_EQ(edits.values.size(), 2U);
    EXPECT_DOUBLE_EQ(std::get<double>(edits.values[0]), 2.5);
    EXPECT_TRUE(std::holds_alternative<std::monostate>(edits.values[1]));
}

TEST(ParameterEditor, ASwitchSwitches) {
    const auto [row, subject] = findParameter("freeze");
    ParameterEditor editor(*row, subject);
    editor.setValue(true);
    Edits edits(editor);
    editor.findChild<QCheckBox*>()->click();
    ASSERT_EQ(edits.values.size(), 1U);
    EXPECT_FALSE(std::get<bool>(edits.values[0]));
}

}  // namespace rubble::widgets
