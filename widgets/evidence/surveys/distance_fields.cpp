#include "widgets/evidence/surveys/distance_fields.h"

#include <QFormLayout>

#include "widgets/basics/number_field.h"

namespace rubble::widgets {

namespace {

constexpr CloudDistanceSettings usualScales{1.0, 0.5, 3.0, std::nullopt, false};

}  // namespace

DistanceFields::DistanceFields(const Words& words, QWidget* parent)
    : QObject(parent),
      m_normal(new NumberField(tr("Normal scale"))),
      m_projection(new NumberField(tr("Projection scale"))),
      m_depth(new NumberField(tr("Depth of the cylinder"))),
      m_registration(new NumberField(tr("Registration error"))),
      m_cell(new NumberField(tr("Cells of the volumes"))) {
    for (NumberField* field : {m_normal, m_projection, m_depth}) {
        field->setRange(0.001, 1000.0);
    }
    m_normal->setToolTip(tr("Radius within which points of the cloud give the local normal, m: several times their spacing"));
    m_projection->setToolTip(
        tr("Radius of the cylinder along the normal in which both sides are averaged, m: 20 points or more should fall into it"));
    m_depth->setToolTip(tr("Of the cylinder to each side, m: more than the largest distance"));
    m_registration->setRange(0.0, 100.0);
    m_registration->setEmptyMeans(words.registrationEmpty);
    m_registration->setToolTip(words.registrationTip);
    m_cell->setRange(0.01, 1000.0);
    m_cell->setEmptyMeans(tr("no volumes"));
    m_cell->setToolTip(
        tr("Side of the square cells over which cut, fill and net are summed straight up, m; left empty none are. Where nobody "
           "stated the registration error, their systematic error is not known"));
    for (NumberField* field : {m_normal, m_projection, m_depth, m_registration, m_cell}) {
        field->setParent(parent);
        connect(field, &NumberField::edited, this, &DistanceFields::edited);
    }
    setSettings(usualScales);
}

void DistanceFields::addTo(QFormLayout& form) const {
    form.addRow(tr("Normal scale, m"), m_normal);
    form.addRow(tr("Projection scale, m"), m_projection);
    form.addRow(tr("Depth, m"), m_depth);
    form.addRow(tr("Registration error, m"), m_registration);
    form.addRow(tr("Volume cells, m"), m_cell);
}

CloudDistanceSettings DistanceFields::settings() const {
    CloudDistanceSettings settings = usualScales;
    settings.normalRadius = m_normal->number().value_or(settings.normalRadius);
    settings.projectionRadius = m_projection->number().value_or(settings.projectionRadius);
    settings.depth = m_depth->number().value_or(settings.depth);
    settings.registrationError = m_registration->number();
    return settings;
}

void DistanceFields::setSettings(const CloudDistanceSettings& settings) {
    m_normal->setNumber(settings.normalRadius);
    m_projection->setNumber(settings.projectionRadius);
    m_depth->setNumber(settings.depth);
    m_registration->setNumber(settings.registrationError);
}

std::optional<double> DistanceFields::cell() const {
    return m_cell->number();
}

void DistanceFields::setCell(const std::optional<double>& cell) {
    m_cell->setNumber(cell);
}

}  // namespace rubble::widgets
