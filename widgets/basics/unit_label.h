#pragma once

#include <QEvent>
#include <QLabel>

namespace rubble::widgets {

/// The unit beside a value: says what is shown in place of a unit of SI, and says it anew when other units are chosen.
class UnitLabel : public QLabel {
    Q_OBJECT

public:
    /// @param unit  "m", "kg/m3", ...; others stand as they are
    explicit UnitLabel(const QString& unit, QWidget* parent = nullptr);
    void setUnit(const QString& unit);
    /// What is shown is said from now on by the field beside it, whose unit depends on its value.
    void follow(const QString& shown);

protected:
    bool event(QEvent* event) override;

private:
    QString m_unit;
    bool m_follows = false;
};

/// The event that tells a widget that other units are shown from now on.
QEvent::Type unitsChanged();
/// Tells all widgets.
void tellUnitsChanged();
/// Times are shown from now on as suits a result that lasts so many seconds; tells all widgets where that is another unit.
/// @returns whether it was
bool showTimesFor(double seconds);

}  // namespace rubble::widgets
