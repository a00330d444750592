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
#include "widgets/basics/fixed_number.h"
#include "widgets/basics/number_field.h"
#include "widgets/basics/panel.h"
#include "widgets/basics/wording.h"

namespace rubble::widgets {

namespace {

enum Column { Used, Name, X, Y, Z, Easting, Northing, Height, PlanResidual, HeightResidual, ColumnCount };
enum OffsetColumn { Mesh, OffsetEast, OffsetNorth, OffsetHeight, OffsetColumnCount };
constexpr double farthest = 1e8;  // m

QString metres(double value) {
    return shownFixed(value, 3);
}

/// The number of metres that somebody typed; unset: it is none, or none on Earth.
std::optional<double> metresIn(const QString& text) {
    bool good = false;
    double value = QLocale().toDouble(text, &good);
    if (!good) {
        value = text.toDouble(&good);
    }
    return good && std::abs(value) <= farthest ? std::optional(value) : std::nullopt;
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
      m_classes(new QLineEdit),
      m_terrain(new QLabel),
      m_table(new QTableWidget(0, ColumnCount)),
      m_offsets(new QTableWidget(0, OffsetColumnCount)),
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
    m_classes->setAccessibleName(tr("Ground classes"));
    m_classes->setPlaceholderText(tr("2; without it all but vegetation and wires"));
    m_classes->setToolTip(
        tr("Classes of a point cloud whose points are the terrain, 0 to 255, parted by commas, such as 2,9. Left empty it is 2, "
           "ground; of a cloud without ground all points but vegetation and wires"));
    form->addRow(tr("Ground classes"), m_classes);
    m_terrain->setWordWrap(true);
    m_terrain->setObjectName(QStringLiteral("muted"));
    m_terrain->setTextInteractionFlags(Qt::TextSelectableByMouse);
    QSizePolicy asHighAsItsWords(QSizePolicy::Preferred, QSizePolicy::Maximum);
    asHighAsItsWords.setHeightForWidth(true);
    m_terrain->setSizePolicy(asHighAsItsWords);
    m_terrain->hide();
    form->addRow(QString(), m_terrain);
    column->addLayout(form);
    buildTable();
    column->addWidget(m_table, 2);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_add);
    buttons->addWidget(m_remove);
    buttons->addStretch();
    column->addLayout(buttons);
    m_fit->setWordWrap(true);
    m_fit->setTextInteractionFlags(Qt::TextSelectableByMouse);
    column->addWidget(m_fit);
    column->addWidget(m_notice);
    buildOffsets();
    column->addWidget(m_offsets, 1);
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
    connect(m_offsets, &QTableWidget::cellChanged, this, &SiteDialog::takeOffset);
    connect(m_crs, &QLineEdit::editingFinished, this, &SiteDialog::showFit);
    connect(m_shift, &NumberField::edited, this, [this](std::optional<double> value) { m_site.heightShift = value.value_or(0.0); });
    connect(m_classes, &QLineEdit::editingFinished, this, &SiteDialog::takeClasses);
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
    // Three points are seen at once, whatever stands above and below.
    constexpr int pointsSeen = 3;
    m_table->setMinimumHeight(m_table->horizontalHeader()->sizeHint().height() +
                              pointsSeen * m_table->verticalHeader()->defaultSectionSize() + 2 * m_table->frameWidth());
    m_remove->setToolTip(tr("Delete the chosen control point"));
    m_add->setToolTip(tr("Add a control point to be typed"));
}

void SiteDialog::takeClasses() {
    std::vector<std::uint16_t> classes;
    bool sound = true;
    for (const QString& part : m_classes->text().split(QLatin1Char(','), Qt::SkipEmptyParts)) {
        bool number = false;
        const int each = part.trimmed().toInt(&number);
        sound = sound && number && each >= 0 && each <= groundClassMost;
        classes.push_back(static_cast<std::uint16_t>(each));
    }
    if (sound) {
        m_site.groundClasses = std::move(classes);
    }
    showClasses();
}

void SiteDialog::showClasses() {
    QStringList words;
    for (const std::uint16_t each : m_site.groundClasses) {
        words << QString::number(each);
    }
    m_classes->setText(words.join(QLatin1Char(',')));
}

void SiteDialog::buildOffsets() {
    m_offsets->setHorizontalHeaderLabels(
        {tr("mesh of the surroundings"), tr("offset east, m"), tr("offset north, m"), tr("offset height, m")});
    m_offsets->setAccessibleName(tr("Offsets of the surroundings"));
    m_offsets->setToolTip(
        tr("Added to the coordinates of a mesh that was written about an origin near the site. Leave the three fields empty "
           "where a file beside the mesh names its offset, or where it has none"));
    m_offsets->verticalHeader()->hide();
    m_offsets->setShowGrid(false);
    m_offsets->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_offsets->horizontalHeader()->setSectionResizeMode(Mesh, QHeaderView::Stretch);
    m_offsets->setTabKeyNavigation(false);
}

void SiteDialog::fillOffsets() {
    m_filling = true;
    m_offsets->setRowCount(static_cast<int>(m_meshes.size()));
    for (int row = 0; row < m_offsets->rowCount(); ++row) {
        const SiteMeshOffset& mesh = m_meshes[static_cast<std::size_t>(row)];
        auto* name = new QTableWidgetItem(mesh.mesh);
        name->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
        m_offsets->setItem(row, Mesh, name);
        for (int c = OffsetEast; c < OffsetColumnCount; ++c) {
            auto* item = new QTableWidgetItem(mesh.offset ? metres((*mesh.offset)[c - OffsetEast]) : QString());
            item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            m_offsets->setItem(row, c, item);
        }
    }
    m_filling = false;
}

void SiteDialog::takeOffset(int row, int column) {
    if (m_filling || row >= static_cast<int>(m_meshes.size()) || column < OffsetEast) {
        return;
    }
    SiteMeshOffset& mesh = m_meshes[static_cast<std::size_t>(row)];
    const QString text = m_offsets->item(row, column)->text().trimmed();
    const std::optional<double> value = text.isEmpty() ? std::optional(0.0) : metresIn(text);
    if (value) {
        Vec3 offset = mesh.offset.value_or(Vec3::Zero());
        offset[column - OffsetEast] = *value;
        mesh.offset = text.isEmpty() && offset.isZero() ? std::nullopt : std::optional(offset);
    } else {
        m_notice->set(Notice::Kind::Error, tr("That is no offset in metres."), tr("The mesh stays as it was."));
    }
    fillOffsets();
}

void SiteDialog::setCheck(std::function<Findings(const Site&, const std::string&)> check) {
    m_check = std::move(check);
    showFit();
}

void SiteDialog::setTerrain(const Findings& findings) {
    QStringList lines;
    for (const Finding& finding : findings.list()) {
        const std::string& id = finding.what.id;
        if (id == "cloud.ground" || id == "cloud.no_ground" || id == "cloud.gridded" || id == "terrain.filled" ||
            id == "terrain.wider_filled") {
            lines << worded(finding.what);
        }
    }
    m_terrain->setText(tr("The terrain as it was read: %1.").arg(lines.join(QStringLiteral("; "))));
    m_terrain->setVisible(!lines.isEmpty());
}

void SiteDialog::setContent(const Site& site, const QString& crs, const std::vector<SiteMeshOffset>& surroundings) {
    m_site = site;
    m_meshes = surroundings;
    m_crs->setText(crs);
    m_shift->setNumber(site.heightShift);
    m_collide->setChecked(site.collide);
    showClasses();
    m_collide->setEnabled(!surroundings.empty() || site.collide);
    m_offsets->setVisible(!surroundings.empty());
    fillOffsets();
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
        if (const std::optional<double> value = metresIn(item->text())) {
            coordinate(point, column) = *value;
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
        showFindings(used);
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
    } catch (const Error& error) {
        m_fit->clear();
        m_notice->set(Notice::Kind::Error, worded(error.message()), worded(error.remedy()));
        m_filling = false;
        return;
    }
    m_filling = false;
    showFindings(used);
}

void SiteDialog::showFindings(std::size_t used) {
    const Findings found = m_check    ? m_check(m_site, crs().toStdString())
                           : used < 2 ? Findings()
                                      : checkControlPoints(m_site.controlPoints);
    if (!found.empty()) {
        QStringList lines;
        for (const Finding& finding : found.list()) {
            lines << worded(finding.what);
        }
        m_notice->set(Notice::Kind::Finding, lines.join(QLatin1Char('\n')), worded(found.list().front().remedy));
    } else if (used == 2) {
        m_notice->set(Notice::Kind::Note, tr("Two points always fit in plan: a third shows whether they are right."));
    }
}

}  // namespace rubble::widgets
