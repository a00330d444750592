#include "widgets/basics/unit_label.h"

#include <QApplication>

#include "widgets/figures/number_text.h"
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

bool showTimesFor(double seconds) {
    const QString before = figures::timeUnit().name;
    figures::setResultSpan(seconds);
    const bool changed = figures::timeUnit().name != before;
    if (changed) {
        tellUnitsChanged();
    }
    return changed;
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
