#pragma once

#include <QObject>
#include <optional>

#include "core/evidence/clouds/cloud_distance.h"

class QFormLayout;
class QWidget;

namespace rubble::widgets {

class NumberField;

/// What distances between clouds (M3C2), and from a cloud to a site, are asked with: scales, registration error, cells of volumes.
class DistanceFields : public QObject {
    Q_OBJECT

public:
    /// What is left to whoever shows the fields.
    struct Words {
        QString registrationEmpty;  ///< what an empty registration error means
        QString registrationTip;
    };
    DistanceFields(const Words& words, QWidget* parent);

    /// A row for each field, below those that are there.
    void addTo(QFormLayout& form) const;
    /// What the fields ask for; an empty scale is the usual one.
    CloudDistanceSettings settings() const;
    void setSettings(const CloudDistanceSettings& settings);
    /// m, side of the cells that volumes are taken over; unset: none are.
    std::optional<double> cell() const;
    void setCell(const std::optional<double>& cell);
    NumberField& registration() { return *m_registration; }

signals:
    void edited();

private:
    NumberField* m_normal;
    NumberField* m_projection;
    NumberField* m_depth;
    NumberField* m_registration;
    NumberField* m_cell;
};

}  // namespace rubble::widgets
