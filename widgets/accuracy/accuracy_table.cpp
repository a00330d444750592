#include "widgets/accuracy/accuracy_table.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <algorithm>
#include <cmath>

#include "core/analysis/accuracy/accuracy_settings.h"
#include "widgets/accuracy/accuracy_words.h"
#include "widgets/basics/table_cell.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"

namespace rubble::widgets {

namespace {

constexpr int rowRole = Qt::UserRole;
constexpr int floorRow = -2;  // cannot be chosen
constexpr int costColumn = 1;
constexpr int lineHeight = 26;         // px, of one line
constexpr int settingCharacters = 34;  // a longer name takes further lines, never the room of the figures
constexpr int accuracyColumn = costColumn + static_cast<int>(costKindCount);

CostKind costKind(int column) {
    // As in the chart's choices.
    return static_cast<CostKind>(column - costColumn);
}

/// Without its unit, which stands in the heading.
QString bare(CostKind kind, double value) {
    return kind == CostKind::Bodies && std::isfinite(value) ? shownCount(std::llround(value)) : shownNumber(value);
}
QString bare(const AccuracyKind& kind, double value) {
    return kind.tolerance && std::isfinite(value) ? shownNumber(100.0 * value) : shownNumber(value);
}

}  // namespace

AccuracyTable::AccuracyTable(QWidget* parent) : QTableWidget(parent) {
    setAccessibleName(tr("Settings compared"));
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setTabKeyNavigation(false);
    setShowGrid(false);
    setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    verticalHeader()->hide();
    verticalHeader()->setMinimumSectionSize(lineHeight);
    horizontalHeader()->setHighlightSections(false);
    connect(this, &QTableWidget::cellDoubleClicked, this, &AccuracyTable::choose);
    setHeadings(MeasureSettings().tolerances);
}

void AccuracyTable::setHeadings(const std::vector<double>& tolerances) {
    m_kinds = accuracyKinds(tolerances);
    setColumnCount(accuracyColumn + static_cast<int>(m_kinds.size()));
    const auto head = [this](int column, const QString& text, const QString& tip) {
        setHorizontalHeaderItem(column, tableCell(text, column == 0, tip));
    };
    head(0, tr("setting"), tr("What departs from the settings of the case"));
    const std::array<std::pair<QString, QString>, costKindCount> costs{
        {{tr("bodies"), tr("Clusters: each is moved by one rigid body")},
         {tr("ms a step"), tr("Milliseconds per step, mean from the first to the last birth, with nothing beside it")},
         {tr("wall, s"), tr("Wall time of the simulation from start to end, seconds")},
         {tr("live FPS"), tr("Frames per second of live mode, mean from the first to the last birth")}}};
    for (std::size_t c = 0; c < costs.size(); ++c) {
        head(costColumn + static_cast<int>(c), costs[c].first, costs[c].second);
    }
    for (std::size_t k = 0; k < m_kinds.size(); ++k) {
        const AccuracyKind& kind = m_kinds[k];
        const bool metres = !kind.tolerance && kind.measure > Measure::FootprintIou;
        const QString unit = kind.tolerance ? tr(", %") : metres ? tr(", m") : QString();
        head(accuracyColumn + static_cast<int>(k), accuracyWords(kind) + unit, accuracyTip(kind));
    }
}

void AccuracyTable::put(int line, int column, const QString& text, const QString& tip) {
    setItem(line, column, tableCell(text, column == 0, tip));
}

void AccuracyTable::addPoint(const AccuracyPoint& point, int row, bool inUse) {
    const int line = rowCount();
    insertRow(line);
    const QString words = pointWords(point);
    QString name = settingWords(point.setting);
    if (inUse) {
        name = tr("● %1 (in use)").arg(name);
    }
    if (!point.failure.empty()) {
        name = QStringLiteral("⚠ ") + name + tr(": failed");
    } else if (!point.done) {
        name += tr(": not done");
    }
    put(line, 0, name, words);
    item(line, 0)->setData(rowRole, row);
    if (inUse) {
        QFont font = item(line, 0)->font();
        font.setBold(true);
        item(line, 0)->setFont(font);
    }
    for (int column = costColumn; column < accuracyColumn; ++column) {
        put(line, column, bare(costKind(column), costOf(point, costKind(column))), words);
    }
    for (std::size_t k = 0; k < m_kinds.size(); ++k) {
        const double value = point.done ? accuracyOf(point.difference, m_kinds[k]) : std::numeric_limits<double>::quiet_NaN();
        const bool below =
            point.done && !m_kinds[k].tolerance && point.standings[static_cast<std::size_t>(m_kinds[k].measure)] == Standing::Below;
        put(line, accuracyColumn + static_cast<int>(k), bare(m_kinds[k], value) + (below ? QStringLiteral(" ~") : QString()),
            below ? tr("No more than the repeat floor of the reference: says nothing") : words);
    }
}

void AccuracyTable::addFloor(const AccuracyReport& report) {
    const int line = rowCount();
    insertRow(line);
    const QString tip = tr("How far the reference departs from its own repeats, births shifted by a micrometre: the worst of all "
                           "pairs, repeats: %1")
                            .arg(report.floor->repeats.size());
    put(line, 0, settingWords(std::string(floorSetting)), tip);
    item(line, 0)->setData(rowRole, floorRow);
    for (int column = costColumn; column < accuracyColumn; ++column) {
        put(line, column, {}, tip);
    }
    for (std::size_t k = 0; k < m_kinds.size(); ++k) {
        put(line, accuracyColumn + static_cast<int>(k), bare(m_kinds[k], accuracyOf(report.floor->largest, m_kinds[k])), tip);
    }
}

void AccuracyTable::setReport(const AccuracyReport& report, std::optional<int> inUse) {
    const int current = currentRow();
    setRowCount(0);
    setHeadings(report.reference.done ? report.reference.difference.tolerances : MeasureSettings().tolerances);
    addPoint(report.reference, referenceRow, inUse == referenceRow);
    if (report.floor && !report.floor->repeats.empty()) {
        addFloor(report);
    }
    for (std::size_t i = 0; i < report.points.size(); ++i) {
        addPoint(report.points[i], static_cast<int>(i), inUse == static_cast<int>(i));
    }
    resizeColumnsToContents();
    setColumnWidth(0, std::min(columnWidth(0), settingCharacters * fontMetrics().averageCharWidth()));
    resizeRowsToContents();
    if (current >= 0 && current < rowCount()) {
        setCurrentCell(current, 0);
    }
}

void AccuracyTable::bringForward(CostKind cost, const AccuracyKind& accuracy) {
    QHeaderView& header = *horizontalHeader();
    for (int column = 0; column < columnCount(); ++column) {
        header.moveSection(header.visualIndex(column), column);
    }
    const auto found = std::find(m_kinds.begin(), m_kinds.end(), accuracy);
    if (found != m_kinds.end()) {
        header.moveSection(header.visualIndex(accuracyColumn + static_cast<int>(found - m_kinds.begin())), costColumn);
    }
    header.moveSection(header.visualIndex(costColumn + static_cast<int>(cost)), costColumn);
}

void AccuracyTable::choose(int line) {
    const QTableWidgetItem* first = line >= 0 ? item(line, 0) : nullptr;
    if (first != nullptr && first->data(rowRole).toInt() != floorRow) {
        emit rowChosen(first->data(rowRole).toInt());
    }
}

bool AccuracyTable::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        // Keys that move in the table are no transport here.
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Home || key == Qt::Key_End) {
            event->accept();
            return true;
        }
    }
    return QTableWidget::event(event);
}

void AccuracyTable::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        choose(currentRow());
        return;
    }
    QTableWidget::keyPressEvent(event);
}

}  // namespace rubble::widgets
