#include "widgets/figures/number_text.h"

#include <QLocale>

#include <atomic>
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

namespace {

constexpr double briefest = 0.1;  // s: from there on hundredths of a second tell instants apart
std::atomic<double> resultSpan{0.0};

}  // namespace

void setResultSpan(double seconds) {
    resultSpan = seconds;
}

double briefUnit() {
    const double span = resultSpan;
    return span <= 0.0 || span >= briefest ? 1.0 : span < 1e-3 ? 1e-6 : 1e-3;
}

QString timeText(double seconds) {
    const double unit = briefUnit();
    if (unit < 1.0 && std::abs(seconds) < 1.0) {
        // A settling time of seconds is not told in millions of microseconds.
        const double told = std::abs(seconds) >= 1e-3 ? 1e-3 : unit;
        const QString name = told == 1e-3 ? QStringLiteral(" ms") : QStringLiteral(" µs");
        const double value = seconds / told;
        return numbers().toString(std::abs(value) < 0.005 ? 0.0 : value, 'f', std::abs(value) < 100.0 ? 2 : 1) + name;
    }
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
