#include "widgets/evidence/surveys/point_box.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/basics/number_field.h"
#include "widgets/basics/panel.h"
#include "widgets/evidence/surveys/distance_fields.h"
#include "widgets/evidence/surveys/scanner_field.h"

namespace rubble::widgets {

PointBox::PointBox(QWidget* parent)
    : QWidget(parent),
      m_shown(new QCheckBox(tr("Points in the views"))),
      m_colour(new QComboBox),
      m_status(new QLabel),
      m_complaint(new Notice),
      m_findings(new FindingList),
      m_distances(new DistanceFields(
          {tr("as known"),
           tr("By which the cloud may be out of place, m. Left empty it is that of its registration or its offset error")},
          this)),
      m_scanners(new ScannerField(tr("as the cloud says"))),
      m_photographs(new QPushButton),
      m_noPhotographs(new QPushButton(tr("Cancel"))),
      m_measure(new QPushButton(tr("Measure distances"))),
      m_cancel(new QPushButton(tr("Cancel"))),
      m_save(new QPushButton(tr("Save distances…"))),
      m_said(new QLabel) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    m_shown->setToolTip(
        tr("Draws the points of this cloud where it lies in the case. They are read from an octree in levels of detail, which is "
           "made once beside the cloud"));
    m_colour->addItem(tr("colours of the file"));
    m_colour->addItem(tr("by height"));
    m_colour->addItem(tr("by class"));
    m_colour->addItem(tr("by distance to the run"));
    m_colour->setAccessibleName(tr("What the colours of the points say"));
    m_colour->setToolTip(
        tr("Colours of the file, else intensity, else height; height; class; or the measured distance to the simulated site"));
    m_colour->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_colour->setMinimumContentsLength(8);
    auto* row = new QHBoxLayout;
    row->addWidget(m_shown);
    row->addWidget(m_colour, 1);
    column->addLayout(row);
    m_status->setWordWrap(true);
    column->addWidget(m_status);
    m_photographs->setToolTip(tr(
        "Adds the pictures in this cloud that have a pinhole and a pose as photographs with that camera; their files are written "
        "beside the case"));
    auto* pictures = new QHBoxLayout;
    pictures->addWidget(m_photographs, 1);
    pictures->addWidget(m_noPhotographs);
    column->addLayout(pictures);
    m_photographs->setObjectName(QStringLiteral("addPhotographs"));
    m_noPhotographs->setObjectName(QStringLiteral("cancelPhotographs"));
    connect(m_noPhotographs, &QPushButton::clicked, this, &PointBox::photographsCancelled);
    connect(m_photographs, &QPushButton::clicked, this, &PointBox::photographsRequested);
    column->addWidget(m_complaint);
    column->addWidget(m_findings);
    m_findings->setDoings(
        {{"distance.from_above", tr("Give the scanners"), [this] { m_scanners->ask(); }},
         {"distance.registration_unknown", tr("State the error"), [this] { askIn(m_distances->registration()); }}});
    buildMeasuring();
    connect(m_shown, &QCheckBox::toggled, this, [this](bool shown) {
        if (!m_showing) {
            emit shownChosen(shown);
        }
    });
    connect(m_colour, &QComboBox::currentIndexChanged, this, [this](int colour) {
        if (!m_showing) {
            emit colourChosen(static_cast<render::PointColour>(colour));
        }
    });
    connect(m_measure, &QPushButton::clicked, this, &PointBox::measureRequested);
    connect(m_cancel, &QPushButton::clicked, this, &PointBox::cancelRequested);
    setContent({});
}

void PointBox::buildMeasuring() {
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(8);
    form->setVerticalSpacing(4);
    m_distances->addTo(*form);
    // A narrow panel has no room for places beside a label.
    form->addRow(new QLabel(tr("Scanners")));
    form->addRow(m_scanners);
    auto* column = static_cast<QVBoxLayout*>(layout());
    column->addLayout(form);
    m_measure->setToolTip(
        tr("Measures from points of the cloud to the simulated site along the local normal (M3C2) and colours those that differ by "
           "more than the level of detection at 95 %"));
    auto* row = new QHBoxLayout;
    row->addWidget(m_measure);
    row->addWidget(m_cancel);
    row->addWidget(m_save);
    row->addStretch(1);
    column->addLayout(row);
    m_save->setObjectName(QStringLiteral("saveDistances"));
    m_save->setToolTip(
        tr("Writes the measured places with distance, level of detection and roughness as a cloud (LAS, PLY) or a table (CSV)"));
    connect(m_save, &QPushButton::clicked, this, &PointBox::saveRequested);
    m_said->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_said->setWordWrap(true);
    column->addWidget(m_said);
}

void PointBox::setContent(const Content& content) {
    m_showing = true;
    m_content = content;
    setVisible(content.cloud);
    m_shown->setChecked(content.shown);
    m_colour->setCurrentIndex(static_cast<int>(content.colour));
    m_status->setText(content.status);
    m_status->setVisible(!content.status.isEmpty());
    const bool adding = !content.adding.isEmpty();
    m_photographs->setText(adding ? content.adding : tr("Add its photographs: %1").arg(content.photographs));
    m_photographs->setVisible(content.photographs > 0 || adding);
    m_photographs->setEnabled(!adding);
    m_noPhotographs->setVisible(adding);
    m_complaint->set(Notice::Kind::Error, content.complaint);
    m_findings->set(content.findings);
    m_scanners->setPlaces(content.scanners);
    m_measure->setEnabled(content.noMeasuring.isEmpty() && !content.measuring);
    m_cancel->setVisible(content.measuring);
    m_save->setVisible(content.savable);
    const QString said = content.measured.isEmpty() ? content.noMeasuring : content.measured;
    m_said->setText(said);
    m_said->setVisible(!said.isEmpty());
    m_showing = false;
}

}  // namespace rubble::widgets
