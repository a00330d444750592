#include "app/gui/session/document.h"

#include <gtest/gtest.h>

#include "app/gui/session/regrouping_edit.h"
#include "core/base/error.h"

namespace rubble {

namespace {

Case plainCase() {
    Case theCase;
    theCase.title = "arch";
    theCase.scenarios.push_back({"scenario-1", "As computed", {}, "fe-1", {}});
    theCase.activeScenario = "scenario-1";
    return theCase;
}

}  // namespace

TEST(Document, EveryEditIsOneCommandThatNamesItself) {
    Document document;
    document.replace(plainCase(), {}, {});
    int changed = 0;
    QObject::connect(&document, &Document::scenarioChanged, [&] { ++changed; });
    document.setParameter(QStringLiteral("friction"), 0.65);
    EXPECT_EQ(document.undoStack().undoText(), QStringLiteral("friction auto → 0.65"));
    EXPECT_TRUE(document.modified());
    document.undoStack().undo();
    EXPECT_FALSE(document.scenario().simulation.friction.has_value());
    EXPECT_FALSE(document.modified());
    document.undoStack().redo();
    EXPECT_EQ(document.scenario().simulation.friction, 0.65);
    EXPECT_EQ(changed, 3);
}

TEST(Document, WhereAnotherCaseLiesIsToldOnceTheCaseIsTold) {
    Document document;
    const QString first = QStringLiteral("first.rubble");
    document.replace(plainCase(), first, first);
    document.setParameter(QStringLiteral("friction"), 0.65);
    // Who keeps something beside the case would else write it beside the other one.
    QStringList told;
    QObject::connect(&document, &Document::replaced, [&] { told << QStringLiteral("replaced"); });
    QObject::connect(&document, &Document::titleChanged, [&] { told << document.path(); });
    for (const bool recovered : {false, true}) {
        told.clear();
        const QString path = recovered ? QStringLiteral("third.rubble") : QStringLiteral("second.rubble");
        document.replace(plainCase(), path, path, recovered);
        EXPECT_EQ(document.modified(), recovered);
        ASSERT_TRUE(told.contains(QStringLiteral("replaced")));
        EXPECT_GT(told.indexOf(path), told.indexOf(QStringLiteral("replaced"))) << qPrintable(told.join(u' '));
    }
}

// A case was called changed that had just been opened, because the one before had come back unsaved.
TEST(Document, ACaseAfterARecoveredOneIsNotChanged) {
    Document document;
    const QString path = QStringLiteral("case.rubble");
    document.replace(plainCase(), path, path, true);
    EXPECT_TRUE(document.modified());
    document.close();
    document.replace(plainCase(), path, path);
    EXPECT_FALSE(document.modified());
    document.setParameter(QStringLiteral("friction"), 0.65);
    EXPECT_TRUE(document.modified());
    document.undoStack().undo();
    EXPECT_FALSE(document.modified());
}

TEST(Document, InputsChangeAsOneCommandAndAreReadAnew) {
    Document document;
    document.replace(plainCase(), {}, {});
    int reads = 0;
    QObject::connect(&document, &Document::inputsChanged, [&] { ++reads; });
    document.setInputs({{"terrain-1", InputRole::Terrain, "valley.asc", ""}}, [] { return QStringLiteral("terrain valley.asc"); });
    EXPECT_TRUE(document.modified());
    EXPECT_EQ(document.undoStack().undoText(), QStringLiteral("terrain valley.asc"));
    document.setInputs(document.theCase().inputs, [] { return QStringLiteral("nothing new"); });
    EXPECT_EQ(document.undoStack().count(), 1);
    document.undoStack().undo();
    EXPECT_TRUE(document.theCase().inputs.empty());
    EXPECT_FALSE(document.modified());
    EXPECT_EQ(reads, 2);
}

TEST(Document, AGestureIsOneStepAndTwoGesturesAreTwo) {
    Document document;
    document.replace(plainCase(), {}, {});
    for (int gesture = 0; gesture < 2; ++gesture) {
        document.beginGesture();
        for (int i = 1; i <= 20; ++i) {
            document.setParameter(QStringLiteral("multiple"), 1.0 + gesture + 0.01 * i);
        }
        document.endGesture();
    }
    EXPECT_EQ(document.undoStack().count(), 2);
    EXPECT_EQ(document.undoStack().undoText(), QStringLiteral("multiple of mean distance 1.2 → 2.2"));
    document.undoStack().undo();
    EXPECT_DOUBLE_EQ(*document.scenario().grid.multiple, 1.2);
    document.undoStack().undo();
    EXPECT_FALSE(document.scenario().grid.multiple.has_value());
}

TEST(Document, ADragBackToWhereItBeganLeavesNothingToUndo) {
    Document document;
    document.replace(plainCase(), {}, {});
    document.setParameter(QStringLiteral("multiple"), 2.0);
    document.beginGesture();
    document.setParameter(QStringLiteral("multiple"), 3.0);
    document.setParameter(QStringLiteral("multiple"), 2.0);
    document.endGesture();
    EXPECT_EQ(document.undoStack().count(), 1);
}

TEST(Document, EditsOutsideAGestureDoNotMerge) {
    Document document;
    document.replace(plainCase(), {}, {});
    document.setParameter(QStringLiteral("friction"), 0.5);
    document.setParameter(QStringLiteral("friction"), 0.4);
    EXPECT_EQ(document.undoStack().count(), 2);
}

TEST(Document, ARefusedEditChangesNothing) {
    Document document;
    document.replace(plainCase(), {}, {});
    EXPECT_THROW(document.setParameter(QStringLiteral("friction"), -1.0), UsageError);
    EXPECT_THROW(document.setParameter(QStringLiteral("frction"), 1.0), UsageError);
    EXPECT_EQ(document.undoStack().count(), 0);
    document.setParameter(QStringLiteral("friction"), {});  // as it is already
    EXPECT_EQ(document.undoStack().count(), 0);
}

TEST(Document, EveryParameterCanBeSetAndUndone) {
    Document document;
    document.replace(plainCase(), {}, {});
    for (const Parameter& row : parameterTable()) {
        const QString key = QString::fromStdString(row.keyFor(row.subject() == ParameterSubject::Pair ? "stone,soil" : "deck"));
        const ParameterValue before = parameterValue(document.scenario(), key.toStdString());
        ParameterValue after;
        switch (row.kind) {
            case ParameterKind::Switch:
                after = std::holds_alternative<bool>(before) ? !std::get<bool>(before) : false;
                break;
            case ParameterKind::Integer:
                after = static_cast<std::int64_t>(std::max(row.low, 1.0)) + 2;
                break;
            case ParameterKind::Number:
                after = row.low + std::min(1.0, row.high - row.low) * 0.7071;
                break;
            case ParameterKind::Choice:
                after = std::string(row.choices.back());
                break;
            case ParameterKind::Text:
                after = std::string("NAME");
                break;
        }
        document.setParameter(key, after);
        EXPECT_EQ(parameterValue(document.scenario(), key.toStdString()), after) << row.key;
        if (after != before) {
            document.undoStack().undo();
        }
        EXPECT_EQ(parameterValue(document.scenario(), key.toStdString()), before) << row.key;
    }
    EXPECT_EQ(document.scenario(), Scenario());
}

TEST(Document, SavingMakesItCleanAndUndoMakesItModifiedAgain) {
    Document document;
    document.replace(plainCase(), {}, QStringLiteral("/a/b.rubble"));
    document.setParameter(QStringLiteral("friction"), 0.5);
    document.saved(document.theCase(), QStringLiteral("/a/c.rubble"));
    EXPECT_FALSE(document.modified());
    EXPECT_EQ(document.path(), QStringLiteral("/a/c.rubble"));
    document.undoStack().undo();
    EXPECT_TRUE(document.modified());
}

TEST(RegroupingEdit, WhatWasSaidOfAComponentGoesWithItsName) {
    Scenario scenario;
    scenario.components["deck"].density = 2350.0;
    scenario.components["strip"].density = 2350.0;
    const Scenario renamed = withRegrouping(scenario, RenameComponent{"deck", "slab"});
    EXPECT_EQ(renamed.components.count("deck"), 0U);
    EXPECT_EQ(*renamed.components.at("slab").density, 2350.0);
    const Scenario merged = withRegrouping(scenario, MergeComponents{{"deck", "strip"}, "deck"});
    EXPECT_EQ(merged.components.size(), 1U);
    EXPECT_EQ(*merged.components.at("deck").density, 2350.0);
    scenario.components["strip"].density = 1900.0;
    EXPECT_TRUE(withRegrouping(scenario, MergeComponents{{"deck", "strip"}, "deck"}).components.empty());
    const Scenario split = withRegrouping(scenario, SplitByPlane{"deck", {}, Vec3::UnitX(), "deck east"});
    EXPECT_EQ(*split.components.at("deck east").density, 2350.0);
    EXPECT_EQ(*split.components.at("deck").density, 2350.0);
    EXPECT_EQ(withRegrouping(scenario, SplitByConnectivity{"deck"}).components.count("deck"), 0U);
    const Scenario plain = withoutRegrouping(renamed, {"deck", "strip"});
    EXPECT_TRUE(plain.regrouping.empty());
    EXPECT_EQ(plain.components.count("slab"), 0U);
    EXPECT_EQ(plain.components.count("strip"), 1U);
}

}  // namespace rubble
