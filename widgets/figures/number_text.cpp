#include "widgets/figures/number_text.h"

#include <QLocale>

#include <cmath>

#include "widgets/figures/shown_units.h"

namespace rubble::figures {
namespace {

/// The user's way to write numbers; the C locale groups nothing, so English stands in for it.
QLocale numbers() {
    const QLocale locale;
    return locale.language() == QLocale::C ? QLocale(QLocale::English) : locale;
}

}  // namespace

QString countText(std::size_t count) {
    return numbers().toString(static_cast<qulonglong>(count));
}

QString timeText(double seconds) {
    // Times near zero must not read "-0.00 s".
    const double value = std::abs(seconds) < 0.005 ? 0.0 : seconds;
    return numbers().toString(value, 'f', 2) + QStringLiteral(" s");
}

QString numberText(double value) {
    return numbers().toString(value, 'g', 4);
}

QString lengthText(double metres) {
    const ShownUnit unit = shownUnit("m");
    if (unitSet() == UnitSet::Si && metres >= 1000.0) {
        return numberText(metres / 1000.0) + QStringLiteral(" km");
    }
    return numbers().toString(metres * unit.perSi, 'g', unitSet() == UnitSet::Si ? 4 : 6) + u' ' + unit.name;
}

QString speedText(double metresPerSecond) {
    const ShownUnit unit = shownUnit("m/s");
    return numberText(metresPerSecond * unit.perSi) + u' ' + unit.name;
}

}  // namespace rubble::figures
