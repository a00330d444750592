#include "widgets/run/effects_panel.h"
#include <gtest/gtest.h>

#include "core/base/unknown.h"

#include <QAbstractButton>
#include <QLabel>
#include <QLineEdit>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>

#include "widgets/basics/parameter_editor.h"
#include "widgets/case/contact_table.h"
#include "widgets/case/materials_table.h"
#include "widgets/run/effect_row.h"

namespace rubble::widgets {

namespace {

std::shared_ptr<EffectDecisions> someDecisions() {
    auto decisions = std::make_shared<EffectDecisions>();
    for (std::size_t i = 0; i < effectCount; ++i) {
        EffectDecision& decision = (*decisions)[i];
        decision.kind = static_cast<EffectKind>(i);
        decision.on = i % 2 == 0;
        decision.reason = {"test.reason", "the measure is {0} for {1}", {static_cast<int>(i), effectName(decision.kind)}};
        decision.measure = static_cast<double>(i);
        decision.threshold = i == 7 ? unknown : 17.0;
    }
    return decisions;
}

/// A run of 2 ms a step of which the effects that are on take 0.25 ms each; structure contact takes too little to be counted.
std::shared_ptr<SimulationResult> someRun() {
    auto run = std::make_shared<SimulationResult>();
    const auto decisions = someDecisions();
    for (const EffectDecision& decision : *decisions) {
        EffectReport report;
        report.decision = decision;
        report.msPerStep = decision.on ? 0.25 : 0.0;
        report.share = report.msPerStep / 2.0;
        run->effects.push_back(report);
    }
    run->effects[2].msPerStep = 0.01;
    run->effects[2].share = 0.005;
    return run;
}

std::shared_ptr<Components> stoneAndConcrete() {
    auto components = std::make_shared<Components>();
    for (const auto& [name, material] : {std::pair("ring", Material::Stone), std::pair("deck", Material::Concrete)}) {
        Component component;
        component.name = name;
        component.material = material;
        components->list.push_back(component);
    }
    return components;
}

QAbstractButton* segment(const EffectRow& row, const QString& text) {
    for (auto* button : row.switchEditor()->findChildren<QAbstractButton*>()) {
        if (button->text() == text) {
            return button;
        }
    }
    return nullptr;
}

/// Every edit that a panel emits.
struct Edits {
    explicit Edits(Panel& panel) {
        QObject::connect(&panel, &Panel::edited, [this](const QString& key, const ParameterValue& value) {
            keys << key;
            values.push_back(value);
        });
    }
    QStringList keys;
    std::vector<ParameterValue> values;
};

}  // namespace

TEST(EffectsPanel, EveryEffectHasARowThatSaysItsStateAndReason) {
    EffectsPanel panel;
    panel.setContent({someDecisions(), false, nullptr, false, nullptr});
    for (std::size_t i = 0; i < effectCount; ++i) {
        const EffectRow* row = panel.row(static_cast<EffectKind>(i));
        ASSERT_NE(row, nullptr);
        EXPECT_EQ(row->switchEditor()->key().toStdString(), effectName(static_cast<EffectKind>(i)));
        EXPECT_TRUE(row->stateText().contains(i % 2 == 0 ? QStringLiteral("<b>on</b>") : QStringLiteral("<b>off</b>")));
        EXPECT_TRUE(row->stateText().contains(QStringLiteral("the measure is %1").arg(i)));
        EXPECT_TRUE(row->costText().isEmpty()) << "no run has measured it";
        for (const QLabel* label : row->findChildren<QLabel*>()) {
            if (label->text().contains(QStringLiteral("measure"))) {
                EXPECT_TRUE(label->wordWrap());
            }
        }
    }
}

TEST(EffectsPanel, BeforeAResultItSaysWhatWouldBeHere) {
    EffectsPanel panel;
    EXPECT_FALSE(panel.row(EffectKind::Water)->stateText().isEmpty());
    bool told = false;
    for (const QLabel* label : panel.findChildren<QLabel*>()) {
        told = told || label->text().contains(QStringLiteral("Open a result"));
    }
    EXPECT_TRUE(told);
}

TEST(EffectsPanel, ASwitchIsOneEditWithItsKey) {
    EffectsPanel panel;
    panel.setScenario(Scenario());
    Edits edits(panel);
    EffectRow* row = panel.row(EffectKind::Water);
    EXPECT_TRUE(segment(*row, QStringLiteral("auto"))->isChecked());
    segment(*row, QStringLiteral("off"))->click();
    segment(*row, QStringLiteral("off"))->click();
    EXPECT_EQ(edits.keys, QStringList(QStringLiteral("water")));
    EXPECT_EQ(edits.values.front(), ParameterValue(std::string("off")));
    Scenario off;
    setParameter(off, "water", std::string("on"));
    panel.setScenario(off);
    EXPECT_TRUE(segment(*row, QStringLiteral("on"))->isChecked());
    EXPECT_EQ(edits.keys.size(), 1) << "showing a scenario is no edit";
}

TEST(EffectsPanel, SettingsUnfoldUnderTheirEffect) {
    EffectsPanel panel;
    panel.resize(320, 600);
    EffectRow* row = panel.row(EffectKind::Water);
    EXPECT_FALSE(row->unfolded());
    auto* fold = row->findChild<QToolButton*>(QStringLiteral("fold"));
    fold->click();
    EXPECT_TRUE(row->unfolded());
    ParameterEditor* level = panel.editor(QStringLiteral("water_level"));
    ASSERT_NE(level, nullptr);
    EXPECT_TRUE(row->isAncestorOf(level));
    EXPECT_TRUE(level->isVisibleTo(row));
    fold->click();
    EXPECT_FALSE(level->isVisibleTo(row));
    EXPECT_FALSE(fold->accessibleName().isEmpty());
}

TEST(EffectsPanel, AnAutomaticTimeOfOverlapSaysWhatItComesTo) {
    EffectsPanel panel;
    const auto shown = [&](LooseStructurePolicy loose) {
        Scenario scenario;
        scenario.effects.loose = loose;
        panel.setScenario(scenario);
        return panel.editor(QStringLiteral("overlap_time"))->findChild<QLineEdit*>()->placeholderText();
    };
    EXPECT_EQ(shown(LooseStructurePolicy::AtOnce), QStringLiteral("1.00"));
    EXPECT_EQ(shown(LooseStructurePolicy::Fe), QStringLiteral("7.00"));
}

TEST(EffectsPanel, CostsAddUpToTheLineBelow) {
    EffectsPanel panel;
    panel.setContent({someDecisions(), false, someRun(), false, nullptr});
    EXPECT_TRUE(panel.row(EffectKind::Water)->costText().contains(QStringLiteral("0.25")));
    EXPECT_TRUE(panel.row(EffectKind::Water)->costText().contains(QStringLiteral("12 %")) ||
                panel.row(EffectKind::Water)->costText().contains(QStringLiteral("13 %")));
    EXPECT_TRUE(panel.row(EffectKind::StructureContact)->costText().contains(QStringLiteral("below 1 %")));
    EXPECT_TRUE(panel.row(EffectKind::AirDrag)->costText().isEmpty()) << "what is off costs nothing and shows nothing";
    // Three effects of 0.25 ms and one of 0.01 ms in a step of 2 ms.
    EXPECT_TRUE(panel.sumText().contains(QStringLiteral("0.76"))) << panel.sumText().toStdString();
    EXPECT_TRUE(panel.sumText().contains(QStringLiteral("38 %"))) << panel.sumText().toStdString();
    EXPECT_TRUE(panel.sumText().contains(QStringLiteral("2.0"))) << panel.sumText().toStdString();
}

TEST(EffectsPanel, StaleDecisionsAndCostsSaySo) {
    EffectsPanel panel;
    panel.setContent({someDecisions(), true, someRun(), true, nullptr});
    bool told = false;
    for (const Notice* notice : panel.findChildren<Notice*>()) {
        told = told || notice->text().contains(QStringLiteral("changed"));
    }
    EXPECT_TRUE(told);
    EXPECT_TRUE(panel.row(EffectKind::Water)->stateText().contains(QStringLiteral("before the change")));
    EXPECT_TRUE(panel.sumText().contains(QStringLiteral("before the settings changed")));
}

TEST(EffectsPanel, ComponentsSayTheirMaterial) {
    EffectsPanel panel;
    Edits edits(panel);
    panel.setScenario(Scenario());
    panel.setContent({nullptr, false, nullptr, false, stoneAndConcrete()});
    const auto* table = panel.findChild<MaterialsTable*>();
    ASSERT_EQ(table->editors().size(), 4U);
    EXPECT_EQ(table->editors()[0]->key(), QStringLiteral("component[ring].material"));
    EXPECT_EQ(table->editors()[3]->key(), QStringLiteral("component[deck].reinforced"));
    auto* reinforced = table->editors()[3]->findChild<QAbstractButton*>();
    ASSERT_NE(reinforced, nullptr);
    reinforced->click();
    EXPECT_EQ(edits.keys, QStringList(QStringLiteral("component[deck].reinforced")));
    EXPECT_EQ(edits.values.front(), ParameterValue(true));
}

TEST(ContactTable, ShowsThePairsOfTheSceneAndAllOnRequest) {
    ContactTable table;
    EXPECT_EQ(table.table()->rowCount(), static_cast<int>(materialPairs().size()));
    table.setMaterials({Material::Stone, Material::Soil});
    EXPECT_EQ(table.table()->rowCount(), 2) << "stone on stone and stone on soil";
    Scenario scenario;
    setParameter(scenario, "pair[steel,steel].friction", 0.9);
    table.setScenario(scenario);
    EXPECT_EQ(table.table()->rowCount(), 3) << "what was changed is never hidden";
    table.findChild<QAbstractButton*>()->click();
    EXPECT_EQ(table.table()->rowCount(), static_cast<int>(materialPairs().size()));
}

TEST(ContactTable, ATypedValueIsAnEditAndAnEmptyCellGivesTheDefaultBack) {
    ContactTable table;
    std::vector<std::pair<QString, ParameterValue>> edits;
    QObject::connect(&table, &ContactTable::edited,
                     [&](const QString& key, const ParameterValue& value) { edits.emplace_back(key, value); });
    Scenario scenario;
    table.setScenario(scenario);
    const QString first = QStringLiteral("pair[%1].friction").arg(QString::fromStdString(pairName(materialPairs().front())));
    table.table()->item(0, ContactTable::Friction)->setText(QStringLiteral("0.71"));
    ASSERT_EQ(edits.size(), 1U);
    EXPECT_EQ(edits[0].first, first);
    EXPECT_EQ(edits[0].second, ParameterValue(0.71));
    setParameter(scenario, first.toStdString(), edits[0].second);
    table.setScenario(scenario);
    EXPECT_EQ(table.table()->item(0, ContactTable::Friction)->text(), QStringLiteral("0.71"));
    EXPECT_TRUE(table.table()->item(0, ContactTable::Source)->text().contains(QStringLiteral("set")));
    table.table()->item(0, ContactTable::Friction)->setText(QString());
    ASSERT_EQ(edits.size(), 2U);
    setParameter(scenario, first.toStdString(), edits[1].second);
    EXPECT_EQ(scenario, Scenario()) << "the default is back";
}

TEST(ContactTable, TellsTheRangeOfEachPairAndMovesAlongIt) {
    ContactTable table;
    table.setMaterials({Material::Stone, Material::Soil});
    EXPECT_TRUE(table.table()->item(1, ContactTable::Friction)->toolTip().contains(QStringLiteral("0.3 to 0.6")))
        << table.table()->item(1, ContactTable::Friction)->toolTip().toStdString();
    EXPECT_EQ(table.table()->item(1, ContactTable::Friction)->text(), QStringLiteral("0.55"));
    Scenario scenario;
    setParameter(scenario, "friction_level", 0.0);
    table.setScenario(scenario);
    EXPECT_EQ(table.table()->item(1, ContactTable::Friction)->text(), QStringLiteral("0.3"));
    EXPECT_EQ(table.table()->item(1, ContactTable::Restitution)->text(), QStringLiteral("0.1"));
}

TEST(ContactTable, DeleteGivesTheDefaultBack) {
    ContactTable table;
    Scenario scenario;
    setParameter(scenario, "pair[" + pairName(materialPairs().front()) + "].restitution", 0.44);
    table.setScenario(scenario);
    QStringList keys;
    QObject::connect(&table, &ContactTable::edited, [&](const QString& key) { keys << key; });
    table.table()->setCurrentCell(0, ContactTable::Friction);
    QTest::keyClick(table.table(), Qt::Key_Delete);
    EXPECT_TRUE(keys.isEmpty()) << "nothing to give back";
    table.table()->setCurrentCell(0, ContactTable::Restitution);
    QTest::keyClick(table.table(), Qt::Key_Delete);
    EXPECT_EQ(keys.size(), 1);
}

TEST(ContactTable, WhatIsNoCoefficientIsRefusedInPlace) {
    ContactTable table;
    int edits = 0;
    QObject::connect(&table, &ContactTable::edited, [&] { ++edits; });
    const QString before = table.table()->item(0, ContactTable::Restitution)->text();
    for (const char* wrong : {"1.5", "-0.1", "nan", "inf", "stone"}) {
        table.table()->item(0, ContactTable::Restitution)->setText(QLatin1String(wrong));
        EXPECT_EQ(table.table()->item(0, ContactTable::Restitution)->text(), before);
        auto* complaint = table.findChild<QLabel*>(QStringLiteral("complaint"));
        EXPECT_FALSE(complaint->isHidden());
        EXPECT_TRUE(complaint->text().contains(QLatin1String(wrong)));
    }
    EXPECT_EQ(edits, 0);
}

TEST(ContactTable, EverySourceThatIsCitedIsListed) {
    ContactTable table;
    QString listed;
    for (const QLabel* label : table.findChildren<QLabel*>()) {
        listed += label->text();
    }
    for (const PairSource& source : pairSources()) {
        EXPECT_TRUE(listed.contains(QString::fromUtf8(source.friction.data(), static_cast<qsizetype>(source.friction.size()))));
    }
    for (int row = 0; row < table.table()->rowCount(); ++row) {
        EXPECT_FALSE(table.table()->item(row, ContactTable::Source)->text().isEmpty());
    }
}

TEST(ContactTable, OneNumberForAllPairsTakesThePlaceOfTheTable) {
    ContactTable table;
    Scenario scenario;
    setParameter(scenario, "friction", 0.33);
    table.setScenario(scenario);
    EXPECT_EQ(table.table()->item(0, ContactTable::Friction)->text(), QStringLiteral("0.33"));
    EXPECT_FALSE((table.table()->item(0, ContactTable::Friction)->flags() & Qt::ItemIsEditable) != 0);
    EXPECT_TRUE((table.table()->item(0, ContactTable::Restitution)->flags() & Qt::ItemIsEditable) != 0);
}

}  // namespace rubble::widgets
