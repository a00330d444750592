#include "widgets/evidence/photo_pairs.h"

#include <QGridLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "widgets/basics/number_field.h"
#include "widgets/basics/panel.h"
#include "widgets/basics/table_cell.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/unit_label.h"
#include "widgets/basics/wording.h"

namespace rubble::widgets {

namespace {

constexpr int rowHeight = 24;  // px
constexpr int rowsShown = 8;
constexpr double farthest = 1e7;  // m, and px

QString residualText(const CameraMatch* match, std::size_t pair) {
    if (match == nullptr || pair >= match->residuals.size()) {
        return QStringLiteral("–");
    }
    const double length = match->residuals[pair].norm();
    if (!std::isfinite(length)) {
        return PhotoPairs::tr("behind");
    }
    return QLocale().toString(length, 'f', 1) + (match->used[pair] ? QString() : QStringLiteral("  ") + PhotoPairs::tr("wrong"));
}

}  // namespace

PhotoPairs::PhotoPairs(QWidget* parent)
    : QWidget(parent),
      m_table(new QTableWidget(0, 3)),
      m_notice(new Notice),
      m_add(new QPushButton(tr("Add point"))),
      m_read(new QPushButton(tr("From table…"))),
      m_remove(new QPushButton(tr("Delete"))),
      m_fields(new QWidget),
      m_name(new QLineEdit) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    m_table->setAccessibleName(tr("Point pairs"));
    m_table->setObjectName(QStringLiteral("pointPairs"));
    m_table->setHorizontalHeaderLabels({tr("no."), tr("point"), tr("residual, px")});
    m_table->horizontalHeaderItem(0)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_table->horizontalHeaderItem(0)->setToolTip(tr("Number of the pair, as it stands in the photograph and in the model"));
    m_table->horizontalHeaderItem(1)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->horizontalHeaderItem(2)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_table->horizontalHeaderItem(2)->setToolTip(
        tr("How far the point that was clicked lies from where the camera sees it, pixels"));
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setTabKeyNavigation(false);
    m_table->setShowGrid(false);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(rowHeight);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
    m_table->horizontalHeader()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
    m_table->installEventFilter(this);
    column->addWidget(m_table);
    column->addWidget(m_notice);
    auto* buttons = new QHBoxLayout;
    m_add->setCheckable(true);
    m_add->setToolTip(tr("Click a point in the photograph, then the same point in the model beside it (Shift+A)"));
    m_read->setToolTip(tr("Read pairs from a table with the columns of rubble-cli camera, for surveyed points"));
    m_remove->setToolTip(tr("Delete the chosen pair (Delete)"));
    for (QPushButton* button : {m_add, m_read, m_remove}) {
        buttons->addWidget(button);
    }
    column->addLayout(buttons);
    auto* grid = new QGridLayout(m_fields);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(4);
    m_name->setAccessibleName(tr("Name of the point"));
    m_name->setToolTip(tr("Name of the point: pier 1, top west corner"));
    grid->addWidget(m_name, 0, 0, 1, 4);
    const std::array names = {tr("picture x"), tr("picture y"), tr("x"), tr("y"), tr("z")};
    const auto addRow = [&](int row, std::size_t first, std::size_t end, const QString& unit, const QString& tip) {
        for (std::size_t f = first; f < end; ++f) {
            m_numbers[f] = new NumberField(names[f]);
            m_numbers[f]->setRange(-farthest, farthest);
            m_numbers[f]->setToolTip(tip.arg(names[f]));
            m_numbers[f]->setUnit(f < 2 ? std::string() : std::string("m"));
            m_numbers[f]->setMinimumWidth(40);
            connect(m_numbers[f], &NumberField::edited, this, [this, f](std::optional<double> value) { setNumber(f, *value); });
            grid->addWidget(m_numbers[f], row, static_cast<int>(f - first));
        }
        auto* of = new UnitLabel(unit);
        grid->addWidget(of, row, 3);
    };
    addRow(1, 0, 2, tr("px"), tr("%1: where the photograph shows the point, pixels from the upper left corner"));
    addRow(2, 2, 5, tr("m"), tr("%1 of the point of the model or survey, in the frame of the case"));
    column->addWidget(m_fields);
    connect(m_add, &QPushButton::clicked, this, &PhotoPairs::addToggled);
    connect(m_read, &QPushButton::clicked, this, &PhotoPairs::readRequested);
    connect(m_remove, &QPushButton::clicked, this, &PhotoPairs::removeChosen);
    connect(m_table, &QTableWidget::currentCellChanged, this, [this](int row) {
        if (!m_showing) {
            emit pairChosen(row);
        }
    });
    connect(m_name, &QLineEdit::editingFinished, this, [this] {
        const auto chosen = static_cast<std::size_t>(m_chosen);
        if (!m_name->isModified() || m_chosen < 0 || chosen >= m_pairs.size()) {
            return;
        }
        m_name->setModified(false);
        std::vector<PointPair> after = m_pairs;
        after[chosen].name = m_name->text().toStdString();
        emit pairsEdited(after, [number = m_chosen + 1] { return tr("name of point %1").arg(number); });
    });
}

void PhotoPairs::setAdding(bool adding) {
    m_add->setChecked(adding);
}

void PhotoPairs::setContent(const std::vector<PointPair>& pairs, const CameraMatch* match, int chosen) {
    m_pairs = pairs;
    m_chosen = chosen < static_cast<int>(pairs.size()) ? chosen : -1;
    m_showing = true;
    showTable(match);
    showWrong(match);
    showFields();
    m_showing = false;
}

void PhotoPairs::showTable(const CameraMatch* match) {
    m_table->setRowCount(static_cast<int>(m_pairs.size()));
    for (std::size_t i = 0; i < m_pairs.size(); ++i) {
        const int row = static_cast<int>(i);
        const bool wrong = match != nullptr && i < match->used.size() && !match->used[i];
        QTableWidgetItem* residual = fixedCell(residualText(match, i), false);
        if (wrong) {
            QFont bold = m_table->font();
            bold.setWeight(QFont::DemiBold);
            residual->setFont(bold);
            residual->setForeground(tints().finding);
        }
        m_table->setItem(row, 0, fixedCell(QString::number(i + 1), false));
        m_table->setItem(row, 1, fixedCell(QString::fromStdString(m_pairs[i].name), true));
        m_table->item(row, 1)->setToolTip(QString::fromStdString(m_pairs[i].name));
        m_table->setItem(row, 2, residual);
    }
    m_table->setCurrentCell(m_chosen, 1);
    m_table->setVisible(!m_pairs.empty());
    const int rows = std::clamp(static_cast<int>(m_pairs.size()), 1, rowsShown);
    m_table->setFixedHeight(m_table->horizontalHeader()->sizeHint().height() + rows * rowHeight + 2);
}

void PhotoPairs::showWrong(const CameraMatch* match) {
    const std::vector<std::size_t> wrong = match != nullptr ? match->wrong() : std::vector<std::size_t>();
    if (wrong.empty()) {
        m_notice->set(Notice::Kind::Finding, {});
        return;
    }
    QStringList numbers;
    for (const std::size_t k : wrong) {
        const double length = match->residuals[k].norm();
        numbers << (std::isfinite(length) ? tr("%1 (%2 px)").arg(k + 1).arg(QLocale().toString(length, 'f', 0))
                                          : tr("%1 (behind the camera)").arg(k + 1));
    }
    m_notice->set(
        Notice::Kind::Finding,
        wrong.size() == 1
            ? tr("Point %1 disagrees with the other %2 and takes no part.").arg(numbers.front()).arg(m_pairs.size() - wrong.size())
            : tr("Points %1 disagree with the other %2 and take no part.")
                  .arg(numbers.join(QStringLiteral(", ")))
                  .arg(m_pairs.size() - wrong.size()),
        tr("Move them on the photograph, click their counterparts anew, or delete them."));
}

void PhotoPairs::showFields() {
    const bool one = m_chosen >= 0;
    m_fields->setVisible(one);
    m_remove->setEnabled(one);
    if (!one) {
        return;
    }
    const PointPair& pair = m_pairs[static_cast<std::size_t>(m_chosen)];
    m_name->setText(QString::fromStdString(pair.name));
    const std::array values = {pair.picture.x(), pair.picture.y(), pair.model.x(), pair.model.y(), pair.model.z()};
    for (std::size_t f = 0; f < values.size(); ++f) {
        // No more digits than a click or a survey deserves.
        m_numbers[f]->setNumber(std::round(values[f] * (f < 2 ? 10.0 : 1000.0)) / (f < 2 ? 10.0 : 1000.0));
        m_numbers[f]->setCursorPosition(0);
    }
}

void PhotoPairs::setNumber(std::size_t field, double value) {
    if (m_chosen < 0) {
        return;
    }
    std::vector<PointPair> after = m_pairs;
    PointPair& pair = after[static_cast<std::size_t>(m_chosen)];
    (field < 2 ? pair.picture[static_cast<Eigen::Index>(field)] : pair.model[static_cast<Eigen::Index>(field - 2)]) = value;
    emit pairsEdited(after, [number = m_chosen + 1] { return tr("place of point %1").arg(number); });
}

void PhotoPairs::removeChosen() {
    if (m_chosen >= 0) {
        std::vector<PointPair> after = m_pairs;
        after.erase(after.begin() + m_chosen);
        emit pairsEdited(after, [number = m_chosen + 1] { return tr("point %1 deleted").arg(number); });
    }
}

bool PhotoPairs::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_table && event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Delete) {
        removeChosen();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace rubble::widgets
