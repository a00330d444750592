#include "widgets/evidence/evidence_table.h"

#include <QComboBox>
#include <QFileInfo>
#include <QHeaderView>
#include <QResizeEvent>
#include <algorithm>
#include <cmath>

#include "widgets/basics/table_cell.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"

namespace rubble::widgets {

namespace {

constexpr int evidenceRowsShown = 6;
// px, that the style leaves free in a cell, both sides together.
constexpr int besideWords = 18;
constexpr int aboveWords = 7;

QString numberOrWords(double number, const QString& otherwise) {
    return std::isfinite(number) ? shownNumber(number) : otherwise;
}

/// Metres; no place is known to less than a millimetre, whatever the residuals of its control points say.
QString withinWords(double within, const QString& otherwise) {
    constexpr double least = 0.001;
    return within >= 0.0 && within < least ? QStringLiteral("< ") + shownNumber(least, 1) : numberOrWords(within, otherwise);
}

}  // namespace

QString evidenceFormText(EvidenceForm form) {
    switch (form) {
        case EvidenceForm::Photograph:
            return EvidenceTable::tr("photograph");
        case EvidenceForm::Cloud:
            return EvidenceTable::tr("point cloud");
        case EvidenceForm::Outline:
            return EvidenceTable::tr("outline");
        case EvidenceForm::Points:
            return EvidenceTable::tr("control points");
        case EvidenceForm::Measured:
            return EvidenceTable::tr("measured points");
        case EvidenceForm::Heights:
            break;
    }
    return EvidenceTable::tr("height model");
}

EvidenceTable::EvidenceTable(QWidget* parent) : QTableWidget(0, 4, parent) {
    setHorizontalHeaderLabels({tr("evidence"), tr("shows"), tr("within, m"), tr("overlap")});
    setAccessibleName(tr("All evidence of the case"));
    setToolTip(
        tr("Photographs, surveys, clouds, outlines, measured points and control points: what each is held to show, within how many "
           "metres its place is "
           "known (95 %), and how far the run overlaps with it"));
    verticalHeader()->hide();
    setEditTriggers(NoEditTriggers);
    setSelectionBehavior(SelectRows);
    setSelectionMode(SingleSelection);
    setTabKeyNavigation(false);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setWordWrap(true);
    // The end of a name tells files apart as often as its beginning.
    setTextElideMode(Qt::ElideMiddle);
    setFont(headingFont());
    horizontalHeader()->setFont(headingFont());
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
    // A word that widens its own column narrows these, while the table stays as wide as it is.
    connect(horizontalHeader(), &QHeaderView::sectionResized, this, [this](int column) {
        if (column < 2 && !m_showing) {
            fitRows();
        }
    });
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
        const bool elsewhere = !row.elsewhere.id.empty();
        const bool unread = !row.unread.id.empty();
        const QStringList cells{name.isEmpty() ? evidenceFormText(row.form) : name, shows,
                                unread      ? tr("unreadable")
                                : elsewhere ? tr("elsewhere")
                                            : withinWords(row.within, tr("not known")),
                                numberOrWords(row.score, QStringLiteral("–"))};
        QStringList tip{evidenceFormText(row.form), name, shows};
        if (row.byEnding) {
            tip << tr("what it is was told by the ending of its name");
        }
        for (const Message* said : {&row.elsewhere, &row.unread}) {
            if (!said->id.empty()) {
                tip << worded(*said);
            }
        }
        for (int c = 0; c < cells.size(); ++c) {
            setItem(r, c, tableCell(cells[c], c < 2, tip.join(QStringLiteral(" · "))));
        }
        if (elsewhere || unread) {
            item(r, 2)->setForeground(tints().finding);
        }
        if (row.ours) {
            item(r, 1)->setForeground(tints().finding);
        }
        offerHeld(r);
    }
    if (current >= 0 && current < rowCount()) {
        setCurrentCell(current, 0);
    }
    setVisible(!rows.empty());
    fitRows();
    m_showing = false;
}

void EvidenceTable::offerHeld(int row) {
    const EvidenceRow& shown = m_rows[static_cast<std::size_t>(row)];
    auto* choice = qobject_cast<QComboBox*>(cellWidget(row, 1));
    if (!shown.held) {
        if (choice != nullptr) {
            removeCellWidget(row, 1);
        }
        return;
    }
    if (choice == nullptr) {
        choice = new QComboBox;
        // [PointsHeld]
        choice->addItems({tr("sections"), tr("outline"), tr("control")});
        choice->setItemData(0, tr("Heights, which every section shows; unless something else is chosen"), Qt::ToolTipRole);
        choice->setItemData(1, tr("The edge of the debris, from point to point in their order, which is compared"),
                            Qt::ToolTipRole);
        choice->setItemData(2, tr("Places by their names, for pairs of photographs; they show no debris"), Qt::ToolTipRole);
        choice->setAccessibleName(tr("What the points are held to say"));
        choice->setFont(headingFont());
        choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        choice->setMinimumContentsLength(4);
        setCellWidget(row, 1, choice);
        connect(choice, &QComboBox::activated, this, [this, choice](int as) {
            const int at = indexAt(choice->pos()).row();
            if (at >= 0 && at < static_cast<int>(m_rows.size())) {
                emit held(QString::fromStdString(m_rows[static_cast<std::size_t>(at)].id), static_cast<PointsHeld>(as));
            }
        });
    }
    choice->setCurrentIndex(static_cast<int>(*shown.held));
    choice->setToolTip(item(row, 1)->toolTip() + QStringLiteral(" · ") +
                       tr("Choose what these points are held to say; kept in the case"));
}

void EvidenceTable::resizeEvent(QResizeEvent* event) {
    QTableWidget::resizeEvent(event);
    if (event->oldSize().width() != event->size().width()) {
        fitRows();
    }
}

void EvidenceTable::showEvent(QShowEvent* event) {
    QTableWidget::showEvent(event);
    // Rows that changed while nobody saw them were fitted to another width.
    fitRows();
}

/// Words that are too long for their column take a second line.
void EvidenceTable::fitRows() {
    for (int row = 0; row < rowCount(); ++row) {
        int lines = fontMetrics().height();
        const QWidget* choice = cellWidget(row, 1);
        for (const int column : {0, 1}) {
            if (column == 1 && choice != nullptr) {
                continue;  // its words lie below the choice, which says them in its tip
            }
            const QRect room(0, 0, columnWidth(column) - besideWords, QWIDGETSIZE_MAX);
            lines = std::max(lines, fontMetrics().boundingRect(room, Qt::TextWordWrap, item(row, column)->text()).height());
        }
        setRowHeight(row, std::max(lines + aboveWords, choice != nullptr ? choice->sizeHint().height() : 0));
    }
    int height = horizontalHeader()->sizeHint().height() + 2 * frameWidth() + 2;
    for (int row = 0; row < std::min(rowCount(), evidenceRowsShown); ++row) {
        height += rowHeight(row);
    }
    setFixedHeight(height);
}

}  // namespace rubble::widgets
