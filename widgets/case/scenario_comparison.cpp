#include "widgets/case/scenario_comparison.h"

#include <QComboBox>
#include <QDateTime>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/scenario/differences.h"
#include "widgets/basics/group_heading.h"
#include "widgets/basics/table_cell.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"
#include "widgets/case/run_verdict.h"
#include "widgets/figures/number_text.h"
#include "widgets/figures/shown_units.h"

namespace rubble::widgets {

namespace {

QTableWidget* table(const QString& name, const QString& first) {
    auto* made = new QTableWidget(0, 4);
    made->setHorizontalHeaderLabels({first, {}, {}, ScenarioComparison::tr("unit")});
    made->setAccessibleName(name);
    made->verticalHeader()->hide();
    made->verticalHeader()->setDefaultSectionSize(made->fontMetrics().height() + 9);
    made->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    made->horizontalHeader()->setSectionResizeMode(3, QHeaderView::ResizeToContents);
    made->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    made->setShowGrid(false);
    made->setEditTriggers(QAbstractItemView::NoEditTriggers);
    made->setSelectionBehavior(QAbstractItemView::SelectRows);
    made->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    return made;
}

void addRow(QTableWidget& to, const QString& label, const QString& left, const QString& right, const QString& unit,
            const QString& tip = {}) {
    const int row = to.rowCount();
    to.insertRow(row);
    const std::array texts = {label, left, right, unit};
    for (int column = 0; column < 4; ++column) {
        QTableWidgetItem* item = tableCell(texts[static_cast<std::size_t>(column)], column != 1 && column != 2, tip);
        if (column == 3) {
            item->setForeground(tints().muted);
        }
        to.setItem(row, column, item);
    }
}

/// A value of a setting in the unit that is shown. @param perSi  of that unit
QString settingShown(const ParameterValue& value, double perSi) {
    const auto* number = std::get_if<double>(&value);
    return number != nullptr ? QLocale().toString(*number * perSi, 'g', 6) : shownValue(value);
}

QString text(std::string_view view) {
    return QString::fromUtf8(view.data(), static_cast<qsizetype>(view.size()));
}

/// One figure of two runs; a dash where there is no run.
QString figure(const std::optional<RunEntry>& run, const std::function<QString(const RunEntry&)>& of) {
    return run ? of(*run) : QString(QChar(0x2013));
}

}  // namespace

ScenarioComparison::ScenarioComparison(QWidget* parent)
    : QWidget(parent),
      m_left(new QComboBox),
      m_right(new QComboBox),
      m_notes(new QLabel),
      m_same(new QLabel),
      m_settings(table(tr("Settings that differ"), tr("setting"))),
      m_runs(new QLabel),
      m_results(table(tr("Results"), tr("result"))) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 12, 16, 12);
    column->setSpacing(8);
    auto* choices = new QHBoxLayout;
    m_left->setObjectName(QStringLiteral("leftScenario"));
    m_left->setAccessibleName(tr("First scenario"));
    m_left->setToolTip(tr("The scenario in the first column"));
    m_right->setObjectName(QStringLiteral("rightScenario"));
    m_right->setAccessibleName(tr("Second scenario"));
    m_right->setToolTip(tr("The scenario in the second column"));
    choices->addWidget(m_left, 1);
    choices->addWidget(new QLabel(tr("against")));
    choices->addWidget(m_right, 1);
    column->addLayout(choices);
    for (QLabel* label : {m_notes, m_same, m_runs}) {
        label->setObjectName(QStringLiteral("muted"));
        label->setWordWrap(true);
    }
    column->addWidget(m_notes);
    column->addWidget(groupHeading(tr("SETTINGS THAT DIFFER")));
    column->addWidget(m_same);
    column->addWidget(m_settings, 3);
    column->addWidget(groupHeading(tr("RESULTS OF THE NEWEST COMPLETE RUNS")));
    column->addWidget(m_runs);
    column->addWidget(m_results, 2);
    connect(m_left, &QComboBox::activated, this, &ScenarioComparison::show);
    connect(m_right, &QComboBox::activated, this, &ScenarioComparison::show);
}

void ScenarioComparison::setContent(std::vector<ScenarioSide> sides) {
    const QString left = m_left->currentData().toString();
    const QString right = m_right->currentData().toString();
    m_sides = std::move(sides);
    for (QComboBox* choice : {m_left, m_right}) {
        choice->clear();
        for (const ScenarioSide& side : m_sides) {
            choice->addItem(side.name, side.id);
        }
    }
    m_right->setCurrentIndex(m_right->count() > 1 ? 1 : 0);
    choose(left, right);
}

void ScenarioComparison::choose(const QString& left, const QString& right) {
    if (const int at = m_left->findData(left); at >= 0) {
        m_left->setCurrentIndex(at);
    }
    if (const int at = m_right->findData(right); at >= 0) {
        m_right->setCurrentIndex(at);
    }
    show();
}

const ScenarioSide* ScenarioComparison::sideOf(const QComboBox& choice) const {
    const auto at = static_cast<std::size_t>(choice.currentIndex());
    return choice.currentIndex() >= 0 && at < m_sides.size() ? &m_sides[at] : nullptr;
}

void ScenarioComparison::show() {
    m_settings->setRowCount(0);
    m_results->setRowCount(0);
    const ScenarioSide* left = sideOf(*m_left);
    const ScenarioSide* right = sideOf(*m_right);
    if (left == nullptr || right == nullptr) {
        return;
    }
    QStringList notes;
    for (const ScenarioSide* side : {left, right}) {
        if (!side->note.isEmpty()) {
            notes << tr("%1: %2").arg(side->name, side->note);
        }
    }
    m_notes->setText(notes.join(u'\n'));
    m_notes->setVisible(!notes.isEmpty());
    for (QTableWidget* each : {m_settings, m_results}) {
        each->horizontalHeaderItem(1)->setText(left->name);
        each->horizontalHeaderItem(2)->setText(right->name);
        each->horizontalHeaderItem(1)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        each->horizontalHeaderItem(2)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    }
    showSettings(*left, *right);
    showResults(*left, *right);
}

void ScenarioComparison::showSettings(const ScenarioSide& left, const ScenarioSide& right) {
    for (const SettingDifference& each : differencesBetween(left.scenario, right.scenario)) {
        const QString label =
            text(each.row->label) + (each.subject.empty() ? QString() : u' ' + QString::fromStdString(each.subject));
        const auto sizeOf = [](const ParameterValue& value) {
            const auto* number = std::get_if<double>(&value);
            return number != nullptr ? std::abs(*number) : 0.0;
        };
        // One unit for both, in which the larger one is readable.
        const figures::ShownUnit unit = figures::shownUnit(each.row->unit, std::max(sizeOf(each.first), sizeOf(each.second)));
        addRow(*m_settings, label, settingShown(each.first, unit.perSi), settingShown(each.second, unit.perSi), unit.name,
               shownHelp(*each.row));
    }
    if (!(left.scenario.regrouping == right.scenario.regrouping)) {
        const auto steps = [](const Scenario& scenario) {
            return scenario.regrouping.empty() ? tr("none") : tr("%1 steps").arg(scenario.regrouping.size());
        };
        addRow(*m_settings, tr("Regrouping of components"), steps(left.scenario), steps(right.scenario), {},
               tr("Which parts of the file are joined, split or renamed; the Case panel lists the steps"));
    }
    const int count = m_settings->rowCount();
    m_same->setText(count == 0 ? tr("None: all settings are the same.") : QString());
    m_same->setVisible(count == 0);
    m_settings->setVisible(count > 0);
}

void ScenarioComparison::showResults(const ScenarioSide& left, const ScenarioSide& right) {
    QStringList words;
    for (const ScenarioSide* side : {&left, &right}) {
        if (!side->run) {
            words << tr("%1 has no complete run.").arg(side->name);
        } else if (side->runStale) {
            words << tr("The run of %1 is stale: settings, inputs or the program have changed since.").arg(side->name);
        }
    }
    m_runs->setText(words.join(u' '));
    m_runs->setVisible(!words.isEmpty());
    m_results->setVisible(left.run || right.run);
    const auto row = [&](const QString& label, const QString& unit, const std::function<QString(const RunEntry&)>& of) {
        addRow(*m_results, label, figure(left.run, of), figure(right.run, of), unit);
    };
    row(tr("When"), {}, [](const RunEntry& run) {
        const QDateTime when = QDateTime::fromString(QString::fromStdString(run.when), Qt::ISODate);
        return QLocale().toString(when.toLocalTime(), QLocale::ShortFormat);
    });
    row(tr("Fragments"), {}, [](const RunEntry& run) { return shownCount(run.fragments); });
    row(tr("Bodies at most"), {}, [](const RunEntry& run) { return shownCount(run.bodies); });
    row(tr("Wall time"), {}, [](const RunEntry& run) { return shownDuration(run.wallSeconds); });
    row(tr("Step, mean"), tr("ms"), [](const RunEntry& run) { return shownNumber(run.msPerStep, 2); });
    row(tr("The end"), {}, [](const RunEntry& run) { return figures::timeText(run.endTime); });
    row(tr("Asleep at the end"), {}, [](const RunEntry& run) { return shownShare(run.asleepAtEnd); });
    row(tr("Highest speed"), figures::shownUnit("m/s").name, [](const RunEntry& run) { return shownIn(run.maxSpeed, "m/s"); });
    row(tr("Bulking of the pile"), {}, [](const RunEntry& run) { return shownNumber(run.bulkingFactor); });
    row(tr("Energy drift"), {}, [](const RunEntry& run) { return shownShare(run.energyDrift, 2); });
    row(tr("What came of it"), {}, [](const RunEntry& run) { return runVerdict(run); });
}

}  // namespace rubble::widgets
