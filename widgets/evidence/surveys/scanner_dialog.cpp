#include "widgets/evidence/surveys/scanner_dialog.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <cmath>
#include <utility>

#include "widgets/basics/fixed_number.h"
#include "widgets/basics/number_field.h"
#include "widgets/basics/table_cell.h"
#include "widgets/basics/wording.h"
#include "widgets/evidence/model_marks.h"
#include "widgets/views/view_widget.h"

namespace rubble::widgets {

namespace {

constexpr int scannerDecimals = 3;
constexpr double eyeHeight = 1.8;  // m
enum ScannerColumn { ScannerNumber, ScannerEast, ScannerNorth, ScannerHeight };

}  // namespace

ScannerDialog::ScannerDialog(std::vector<Vec3> places, Way way, QWidget* parent)
    : PickedPlacesDialog(tr("Places of the scanners"), tr("Model in which scanners are placed"), parent),
      m_way(std::move(way)),
      m_now(std::move(places)),
      m_first(m_now),
      m_above(new NumberField(tr("Height of a scanner above the place"))) {
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_hint);
    column->addWidget(m_model, 1);
    column->addWidget(buildTable());
    column->addWidget(endButtons(tr("Take these places")));
    showPlaces();
}

QWidget* ScannerDialog::buildTable() {
    auto* box = new QWidget;
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    prepareTable({tr("scanner"), tr("easting, m"), tr("northing, m"), tr("height, m")}, tr("Scanners and where they stand"),
                 tr("In the system of the case; type another number to move a scanner"));
    row->addWidget(m_table, 3);
    auto* side = new QVBoxLayout;
    auto* field = new QHBoxLayout;
    auto* label = new QLabel(tr("Above the place, m"));
    label->setBuddy(m_above);
    m_above->setRange(0.0, 500.0);
    m_above->setNumber(eyeHeight);
    m_above->setToolTip(tr("How far above the clicked place a scanner stands, m: the height of its tripod, or of a drone"));
    field->addWidget(label);
    field->addWidget(m_above, 1);
    side->addLayout(field);
    side->addStretch(1);
    side->addLayout(changeButtons(tr("Take back the last click or number (Ctrl+Z)"), tr("Remove scanner")));
    row->addLayout(side, 2);
    connect(m_table, &QTableWidget::cellChanged, this, &ScannerDialog::takeCell);
    return box;
}

void ScannerDialog::pick(const Vec3& place) {
    std::vector<Vec3> now = m_now;
    now.push_back(m_way.toWorld(place + Vec3(0.0, 0.0, m_above->number().value_or(eyeHeight))));
    take(std::move(now));
}

void ScannerDialog::take(std::vector<Vec3> now) {
    if (now != m_now) {
        m_past.push_back(std::exchange(m_now, std::move(now)));
    }
    m_said.clear();
    showPlaces();
}

void ScannerDialog::takeCell(int row, int column) {
    if (m_filling || column == ScannerNumber || row >= static_cast<int>(m_now.size())) {
        return;
    }
    std::vector<Vec3> now = m_now;
    if (const std::optional<double> number = typedNumber(m_table->item(row, column)->text(), "")) {
        now[static_cast<std::size_t>(row)][column - ScannerEast] = *number;
        take(std::move(now));
    } else {
        m_said = tr("That is no coordinate in metres. The scanner stays where it was.");
        showPlaces();
    }
}

void ScannerDialog::undo() {
    if (!m_past.empty()) {
        m_now = std::move(m_past.back());
        m_past.pop_back();
        m_said.clear();
        showPlaces();
    }
}

void ScannerDialog::removeChosen() {
    const int row = m_table->currentRow();
    if (row >= 0 && row < static_cast<int>(m_now.size())) {
        std::vector<Vec3> now = m_now;
        now.erase(now.begin() + row);
        take(std::move(now));
    }
}

void ScannerDialog::removeAll() {
    take({});
}

// Places that were picked are left by Cancel alone.
void ScannerDialog::leave() {
    if (m_now == m_first) {
        reject();
        return;
    }
    m_said = tr("Cancel leaves without taking these places.");
    showMarks();
}

void ScannerDialog::showPlaces() {
    m_filling = true;
    const int chosen = m_table->currentRow();
    m_table->setRowCount(static_cast<int>(m_now.size()));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const Vec3& place = m_now[static_cast<std::size_t>(row)];
        m_table->setItem(row, ScannerNumber, fixedCell(QString::number(row + 1), true));
        for (int axis = 0; axis < 3; ++axis) {
            m_table->setItem(row, ScannerEast + axis, tableCell(shownFixed(place[axis], scannerDecimals), false));
        }
    }
    if (chosen >= m_table->rowCount()) {
        m_table->setCurrentCell(m_table->rowCount() - 1, ScannerEast);
    }
    m_filling = false;
    m_undo->setEnabled(!m_past.empty());
    m_clear->setEnabled(!m_now.empty());
    showMarks();
}

void ScannerDialog::showMarks() {
    const int chosen = m_table->currentRow();
    ModelMarks::Content marks{{}, chosen, {}};
    for (const Vec3& place : m_now) {
        marks.marks.push_back({m_way.toLocal(place), true});
    }
    m_marks->setContent(marks);
    m_hint->setText(
        !m_said.isEmpty() ? m_said
        : m_now.empty()
            ? tr("Click where a scanner stood: on the ground, the structure or a fragment. Without any, the scanners are as "
                 "the field says that opened this.")
            : tr("Click where the next scanner stood, or type another number. Scanners: %1.").arg(m_now.size()));
    m_remove->setEnabled(chosen >= 0 && chosen < static_cast<int>(m_now.size()));
}

}  // namespace rubble::widgets
