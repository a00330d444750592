#include "widgets/evidence/surveys/scanner_dialog.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <cmath>
#include <utility>

#include "widgets/basics/fixed_number.h"
#include "widgets/basics/number_field.h"
#include "widgets/basics/table_cell.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"
#include "widgets/evidence/model_marks.h"
#include "widgets/views/view_widget.h"

namespace rubble::widgets {

namespace {

constexpr int scannerRows = 5;
constexpr int scannerDecimals = 3;
constexpr double eyeHeight = 1.8;  // m
enum ScannerColumn { ScannerNumber, ScannerEast, ScannerNorth, ScannerHeight, ScannerColumnCount };

}  // namespace

ScannerDialog::ScannerDialog(std::vector<Vec3> places, Way way, QWidget* parent)
    : QDialog(parent),
      m_way(std::move(way)),
      m_now(std::move(places)),
      m_first(m_now),
      m_hint(new QLabel),
      m_model(new ViewWidget),
      m_marks(new ModelMarks(*m_model)),
      m_table(new QTableWidget(0, ScannerColumnCount)),
      m_above(new NumberField(tr("Height of a scanner above the place"))),
      m_undo(new QPushButton(tr("Undo"))),
      m_remove(new QPushButton(tr("Remove scanner"))),
      m_clear(new QPushButton(tr("Remove all"))) {
    setWindowTitle(tr("Places of the scanners"));
    auto* column = new QVBoxLayout(this);
    m_hint->setWordWrap(true);
    m_hint->setMinimumHeight(2 * m_hint->fontMetrics().lineSpacing());
    m_hint->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    column->addWidget(m_hint);
    m_model->setAccessibleName(tr("Model in which scanners are placed"));
    m_model->setMinimumSize(240, 160);
    m_marks->setPicking(true);
    column->addWidget(m_model, 1);
    column->addWidget(buildTable());
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    for (const auto which : {QDialogButtonBox::Ok, QDialogButtonBox::Cancel}) {
        buttons->button(which)->setAutoDefault(false);  // Enter in a field takes its number
        buttons->button(which)->setDefault(false);
    }
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Take these places"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons->button(QDialogButtonBox::Cancel), &QPushButton::clicked, this, &QDialog::reject);
    column->addWidget(buttons);
    connect(m_marks, &ModelMarks::picked, this, [this](const QPointF& at) {
        if (const auto hit = m_model->hitAt(at)) {
            pick(hit->point);
        } else {
            m_said = tr("There is nothing of the model there: click on the structure, a fragment or the ground.");
            showMarks();
        }
    });
    showPlaces();
}

QWidget* ScannerDialog::buildTable() {
    auto* box = new QWidget;
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    m_table->setHorizontalHeaderLabels({tr("scanner"), tr("easting, m"), tr("northing, m"), tr("height, m")});
    m_table->setAccessibleName(tr("Scanners and where they stand"));
    m_table->setToolTip(tr("In the system of the case; type another number to move a scanner"));
    m_table->verticalHeader()->hide();
    m_table->setShowGrid(false);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setTabKeyNavigation(false);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    const int rowHeight = m_table->fontMetrics().height() + 7;
    m_table->verticalHeader()->setDefaultSectionSize(rowHeight);
    m_table->setFixedHeight(m_table->horizontalHeader()->sizeHint().height() + scannerRows * rowHeight + 4);
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
    auto* buttons = new QHBoxLayout;
    m_undo->setToolTip(tr("Take back the last click or number (Ctrl+Z)"));
    for (QPushButton* button : {m_undo, m_remove, m_clear}) {
        button->setAutoDefault(false);
        buttons->addWidget(button);
    }
    side->addLayout(buttons);
    row->addLayout(side, 2);
    connect(m_undo, &QPushButton::clicked, this, &ScannerDialog::undo);
    connect(m_remove, &QPushButton::clicked, this, &ScannerDialog::removeChosen);
    connect(m_clear, &QPushButton::clicked, this, [this] { take({}); });
    connect(m_table, &QTableWidget::itemSelectionChanged, this, &ScannerDialog::showMarks);
    connect(m_table, &QTableWidget::cellChanged, this, &ScannerDialog::takeCell);
    return box;
}

void ScannerDialog::setModel(const render::SceneData& scene, render::View view) {
    m_model->setData(scene);
    view.legends = false;
    view.theme = currentTheme();
    m_model->setView(view);
    m_model->fit();
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

// Places that were picked are left by Cancel alone.
void ScannerDialog::leave() {
    if (m_now == m_first) {
        reject();
        return;
    }
    m_said = tr("Cancel leaves without taking these places.");
    showMarks();
}

void ScannerDialog::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        leave();
    } else if (event->matches(QKeySequence::Undo)) {
        undo();
    } else if (event->matches(QKeySequence::Delete)) {
        removeChosen();
    } else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        // It ends what is typed in a field; only a button that has the focus is pressed by it.
        if (auto* button = qobject_cast<QPushButton*>(focusWidget())) {
            button->click();
        }
    } else {
        QDialog::keyPressEvent(event);
    }
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
