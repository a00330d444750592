#include "widgets/evidence/evidence_table.h"

#include <QFileInfo>
#include <QHeaderView>
#include <algorithm>
#include <cmath>

#include "widgets/basics/table_cell.h"
#include "widgets/basics/wording.h"

namespace rubble::widgets {

namespace {

constexpr int evidenceRowsShown = 6;

QString kindText(EvidenceForm form) {
    switch (form) {
        case EvidenceForm::Photograph:
            return EvidenceTable::tr("photograph");
        case EvidenceForm::Cloud:
            return EvidenceTable::tr("point cloud");
        case EvidenceForm::Outline:
            return EvidenceTable::tr("outline");
        case EvidenceForm::Points:
            return EvidenceTable::tr("control points");
        case EvidenceForm::Heights:
            break;
    }
    return EvidenceTable::tr("height model");
}

QString numberOrWords(double number, const QString& otherwise) {
    return std::isfinite(number) ? shownNumber(number) : otherwise;
}

}  // namespace

EvidenceTable::EvidenceTable(QWidget* parent) : QTableWidget(0, 4, parent) {
    setHorizontalHeaderLabels({tr("evidence"), tr("shows"), tr("within, m"), tr("overlap")});
    setAccessibleName(tr("All evidence of the case"));
    setToolTip(tr(
        "Photographs, surveys, clouds, outlines and control points: what each is held to show, within how many metres its place is "
        "known (95 %), and how far the run overlaps with it"));
    verticalHeader()->hide();
    setEditTriggers(NoEditTriggers);
    setSelectionBehavior(SelectRows);
    setSelectionMode(SingleSelection);
    setTabKeyNavigation(false);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 7);
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
    connect(this, &QTableWidget::currentCellChanged, this, [this](int row) {
        if (!m_showing && row >= 0 && row < static_cast<int>(m_rows.size())) {
            emit chosen(QString::fromStdString(m_rows[static_cast<std::size_t>(row)].id));
        }
    });
    setRows({});
}

void EvidenceTable::setRows(const std::vector<EvidenceRow>& rows) {
    m_showing = true;
    m_rows = rows;
    const int current = currentRow();
    setRowCount(static_cast<int>(rows.size()));
    for (int r = 0; r < rowCount(); ++r) {
        const EvidenceRow& row = rows[static_cast<std::size_t>(r)];
        const QString name = QFileInfo(QString::fromStdString(row.path)).fileName();
        const QString shows = worded(row.says);
        const QStringList cells{name.isEmpty() ? kindText(row.form) : name, shows, numberOrWords(row.within, tr("not known")),
                                numberOrWords(row.score, QStringLiteral("–"))};
        for (int c = 0; c < cells.size(); ++c) {
            const QString tip = kindText(row.form) + QStringLiteral(" · ") + name + QStringLiteral(" · ") + shows;
            setItem(r, c, tableCell(cells[c], c < 2, tip));
        }
    }
    if (current >= 0 && current < rowCount()) {
        setCurrentCell(current, 0);
    }
    setVisible(!rows.empty());
    setFixedHeight(horizontalHeader()->sizeHint().height() + 2 * frameWidth() + 2 +
                   std::min(rowCount(), evidenceRowsShown) * verticalHeader()->defaultSectionSize());
    m_showing = false;
}

}  // namespace rubble::widgets
