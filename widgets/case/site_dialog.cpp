#include "widgets/case/site_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "widgets/basics/number_field.h"
#include "widgets/basics/panel.h"
#include "widgets/basics/wording.h"

namespace rubble::widgets {

namespace {

enum Column { Used, Name, X, Y, Z, Easting, Northing, Height, PlanResidual, HeightResidual, ColumnCount };
constexpr double farthest = 1e8;         // m
constexpr double scaleExpected = 0.005;  // share by which a scale may depart from 1

QString metres(double value) {
    return QLocale().toString(value, 'f', 3);
}

/// The coordinate behind a column of numbers.
double& coordinate(ControlPoint& point, int column) {
    return column < Easting ? point.local[column - X] : point.world[column - Easting];
}

}  // namespace

SiteDialog::SiteDialog(QWidget* parent)
    : QDialog(parent),
      m_crs(new QLineEdit),
      m_shift(new NumberField(tr("Height shift"))),
      m_collide(new QCheckBox(tr("Debris falls on the surroundings too"))),
      m_table(new QTableWidget(0, ColumnCount)),
      m_add(new QPushButton(tr("Add control point"))),
      m_remove(new QPushButton(tr("Delete"))),
      m_fit(new QLabel),
      m_notice(new Notice) {
    setWindowTitle(tr("Site"));
    auto* column = new QVBoxLayout(this);
    auto* form = new QFormLayout;
    m_crs->setPlaceholderText(tr("none: local coordinates"));
    m_crs->setToolTip(
        tr("Coordinate system of the case, such as EPSG:25832: terrain, orthophoto and surveys in another one are "
           "projected to it, and maps are written in it. Needs eastings and northings, not degrees"));
    m_crs->setAccessibleName(tr("Coordinate system"));
    form->addRow(tr("Coordinate system"), m_crs);
    m_shift->setRange(-10000.0, 10000.0);
    m_shift->setToolTip(
        tr("Added to the heights of terrain, surroundings and surveys, m (-10,000 to 10,000): the difference between "
           "their vertical datum and that of the case"));
    form->addRow(tr("Height shift, m"), m_shift);
    m_collide->setToolTip(
        tr("The highest surface of the meshes becomes part of the terrain: debris meets roofs, walls and banks, "
           "and gets below no overhang. Needs a terrain"));
    form->addRow(QString(), m_collide);
    column->addLayout(form);
    buildTable();
    column->addWidget(m_table, 1);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_add);
    buttons->addWidget(m_remove);
    buttons->addStretch();
    column->addLayout(buttons);
    m_fit->setWordWrap(true);
    m_fit->setTextInteractionFlags(Qt::TextSelectableByMouse);
    column->addWidget(m_fit);
    column->addWidget(m_notice);
    auto* box = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    box->button(QDialogButtonBox::Ok)->setDefault(true);
    m_add->setAutoDefault(false);
    m_remove->setAutoDefault(false);
    column->addWidget(box);
    connect(box, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(box, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_add, &QPushButton::clicked, this, &SiteDialog::addPoint);
    connect(m_remove, &QPushButton::clicked, this, &SiteDialog::removePoint);
    connect(m_table, &QTableWidget::cellChanged, this, &SiteDialog::take);
    connect(m_shift, &NumberField::edited, this, [this](std::optional<double> value) { m_site.heightShift = value.value_or(0.0); });
    connect(m_collide, &QCheckBox::toggled, this, [this](bool on) { m_site.collide = on; });
    resize(880, 460);
}

void SiteDialog::buildTable() {
    m_table->setHorizontalHeaderLabels({tr("used"), tr("point"), tr("x, m"), tr("y, m"), tr("z, m"), tr("easting, m"),
                                        tr("northing, m"), tr("height, m"), tr("off in plan, m"), tr("off in height, m")});
    m_table->setAccessibleName(tr("Control points"));
    m_table->setToolTip(
        tr("Points known in the frame of the case (x, y, z as the views show them) and in the world. Two or more that "
           "are used take the place of the frame's origin; three or more show a wrong one by its residual"));
    m_table->verticalHeader()->hide();
    m_table->setShowGrid(false);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(Name, QHeaderView::Stretch);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setTabKeyNavigation(false);
    m_remove->setToolTip(tr("Delete the chosen control point"));
    m_add->setToolTip(tr("Add a control point to be typed"));
}

void SiteDialog::setContent(const Site& site, const QString& crs, int surroundings) {
    m_site = site;
    m_crs->setText(crs);
    m_shift->setNumber(site.heightShift);
    m_collide->setChecked(site.collide);
    m_collide->setEnabled(surroundings > 0 || site.collide);
    fill();
}

QString SiteDialog::crs() const {
    return m_crs->text().trimmed();
}

void SiteDialog::addPoint() {
    ControlPoint point;
    point.name = tr("point %1").arg(m_site.controlPoints.size() + 1).toStdString();
    // A new point takes no part before it has coordinates.
    point.used = false;
    m_site.controlPoints.push_back(point);
    fill();
    m_table->setCurrentCell(m_table->rowCount() - 1, Name);
}

void SiteDialog::removePoint() {
    const int row = m_table->currentRow();
    if (row >= 0 && row < static_cast<int>(m_site.controlPoints.size())) {
        m_site.controlPoints.erase(m_site.controlPoints.begin() + row);
        fill();
    }
}

void SiteDialog::fill() {
    m_filling = true;
    m_table->setRowCount(static_cast<int>(m_site.controlPoints.size()));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        ControlPoint& point = m_site.controlPoints[static_cast<std::size_t>(row)];
        auto* used = new QTableWidgetItem;
        used->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        used->setCheckState(point.used ? Qt::Checked : Qt::Unchecked);
        m_table->setItem(row, Used, used);
        m_table->setItem(row, Name, new QTableWidgetItem(QString::fromStdString(point.name)));
        for (int c = X; c <= Height; ++c) {
            auto* item = new QTableWidgetItem(metres(coordinate(point, c)));
            item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            m_table->setItem(row, c, item);
        }
        for (int c = PlanResidual; c < ColumnCount; ++c) {
            auto* item = new QTableWidgetItem;
            item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
            m_table->setItem(row, c, item);
        }
    }
    m_filling = false;
    showFit();
}

void SiteDialog::take(int row, int column) {
    if (m_filling || row >= static_cast<int>(m_site.controlPoints.size())) {
        return;
    }
    ControlPoint& point = m_site.controlPoints[static_cast<std::size_t>(row)];
    const QTableWidgetItem* item = m_table->item(row, column);
    if (column == Used) {
        point.used = item->checkState() == Qt::Checked;
    } else if (column == Name) {
        point.name = item->text().toStdString();
    } else if (column <= Height) {
        bool good = false;
        double value = QLocale().toDouble(item->text(), &good);
        if (!good) {
            value = item->text().toDouble(&good);
        }
        if (good && std::abs(value) <= farthest) {
            coordinate(point, column) = value;
        } else {
            m_filling = true;
            m_table->item(row, column)->setText(metres(coordinate(point, column)));
            m_filling = false;
            m_notice->set(Notice::Kind::Error, tr("That is no coordinate in metres."), tr("The point stays as it was."));
            return;
        }
    }
    showFit();
}

void SiteDialog::showFit() {
    m_notice->set(Notice::Kind::Note, {});
    const std::size_t used = usedPoints(m_site.controlPoints);
    const auto residual = [this](std::size_t row, int column, const QString& text) {
        m_table->item(static_cast<int>(row), column)->setText(text);
    };
    m_filling = true;
    for (std::size_t row = 0; row < m_site.controlPoints.size(); ++row) {
        residual(row, PlanResidual, QStringLiteral("–"));
        residual(row, HeightResidual, QStringLiteral("–"));
    }
    if (used < 2) {
        m_fit->setText(used == 0 ? tr("The origin of the frame says where the site lies.")
                                 : tr("One control point says nothing yet: use two or more."));
        m_filling = false;
        return;
    }
    try {
        const SiteFit fit = fitControlPoints(m_site.controlPoints);
        for (std::size_t row = 0; row < fit.residuals.size(); ++row) {
            residual(row, PlanResidual, metres(fit.residuals[row].head<2>().norm()));
            residual(row, HeightResidual, metres(fit.residuals[row].z()));
        }
        m_fit->setText(tr("Least squares over %1 points: turned by %2°, scale %3, residuals %4 m in plan and %5 m in height (RMS).")
                           .arg(used)
                           .arg(QLocale().toString(fit.angle * 180.0 / std::numbers::pi, 'f', 3),
                                QLocale().toString(fit.scale, 'f', 5), metres(fit.rmsPlan), metres(fit.rmsHeight)));
        if (std::abs(fit.scale - 1.0) > scaleExpected) {
            m_notice->set(Notice::Kind::Finding,
                          tr("The scale is far from 1: a point is wrong, or the two sides have different units."),
                          tr("Leave points out one by one and look at the residuals."));
        } else if (used == 2) {
            m_notice->set(Notice::Kind::Note, tr("Two points always fit in plan: a third shows whether they are right."));
        }
    } catch (const Error& error) {
        m_fit->clear();
        m_notice->set(Notice::Kind::Error, worded(error.message()), worded(error.remedy()));
    }
    m_filling = false;
}

}  // namespace rubble::widgets
