#include "widgets/basics/unit_label.h"

#include <QApplication>

#include "widgets/figures/shown_units.h"

namespace rubble::widgets {

QEvent::Type unitsChanged() {
    static const int type = QEvent::registerEventType();
    return static_cast<QEvent::Type>(type);
}

void tellUnitsChanged() {
    for (QWidget* widget : QApplication::allWidgets()) {
        QEvent event(unitsChanged());
        QApplication::sendEvent(widget, &event);
    }
}

UnitLabel::UnitLabel(const QString& unit, QWidget* parent) : QLabel(parent) {
    setObjectName(QStringLiteral("unit"));
    setUnit(unit);
}

void UnitLabel::setUnit(const QString& unit) {
    m_unit = unit;
    setText(figures::shownUnit(unit.toStdString()).name);
}

void UnitLabel::follow(const QString& shown) {
    m_follows = true;
    setText(shown);
}

bool UnitLabel::event(QEvent* event) {
    if (event->type() == unitsChanged()) {
        if (!m_follows) {
            setUnit(m_unit);
        }
        return true;
    }
    return QLabel::event(event);
}

}  // namespace rubble::widgets
