#include "widgets/basics/number_field.h"

#include <QLocale>
#include <QStyle>

#include "widgets/basics/unit_label.h"
#include "widgets/basics/wording.h"
#include "widgets/figures/shown_units.h"

namespace rubble::widgets {

NumberField::NumberField(const QString& name, QWidget* parent) : QLineEdit(parent) {
    setAccessibleName(name);
    setAlignment(Qt::AlignRight);
    connect(this, &QLineEdit::editingFinished, this, &NumberField::take);
}

void NumberField::setRange(double low, double high) {
    m_low = low;
    m_high = high;
}

void NumberField::setEmptyMeans(const QString& words) {
    m_mayBeEmpty = true;
    setPlaceholderText(words);
}

void NumberField::setNumber(std::optional<double> number) {
    m_number = number;
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    setText(number ? locale.toString(*number * figures::shownUnit(m_unit).perSi, 'g', m_digits) : QString());
    setProperty("wrong", false);
    style()->unpolish(this);
    style()->polish(this);
}

bool NumberField::event(QEvent* event) {
    if (event->type() == unitsChanged() && !m_unit.empty()) {
        setNumber(m_number);
    }
    return QLineEdit::event(event);
}

void NumberField::take() {
    if (!isModified()) {
        return;
    }
    setModified(false);
    const QString typed = text().trimmed();
    const std::optional<double> number = typedNumber(typed, m_unit);
    const bool good = typed.isEmpty() ? m_mayBeEmpty : number && *number >= m_low && *number <= m_high;
    setProperty("wrong", !good);
    style()->unpolish(this);
    style()->polish(this);
    if (good && number != m_number) {
        setNumber(number);
        emit edited(number);
    }
}

}  // namespace rubble::widgets
