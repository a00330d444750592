#include "widgets/figures/number_text.h"

#include <QLocale>

#include <atomic>
#include <cmath>

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

constexpr double briefest = 0.1;       // s: from there on hundredths of a second tell instants apart
constexpr double slowestFactor = 0.1;  // paces up to it are told in units of a brief result a second
std::atomic<double> resultSpan{0.0};

}  // namespace

void setResultSpan(double seconds) {
    resultSpan = seconds;
}

double briefSpan() {
    const double span = resultSpan;
    return span >= briefest ? 0.0 : span;
}

// A settling time of seconds is not told in millions of microseconds.
ShownUnit timeUnit(double seconds) {
    const double brief = briefSpan();
    if (brief <= 0.0 || std::abs(seconds) >= 1.0) {
        return {QStringLiteral("s"), 1.0};
    }
    return brief >= 1e-3 || std::abs(seconds) >= 1e-3 ? ShownUnit{QStringLiteral("ms"), 1e3} : ShownUnit{QStringLiteral("µs"), 1e6};
}

QString timeText(double seconds) {
    const ShownUnit unit = timeUnit(seconds);
    // Times near zero must not read "-0.00 s".
    const double value = std::abs(seconds * unit.perSi) < 0.005 ? 0.0 : seconds * unit.perSi;
    const int decimals = unit.perSi > 1.0 && std::abs(value) >= 100.0 ? 1 : 2;
    return numbers().toString(value, 'f', decimals) + u' ' + unit.name;
}

bool paceIsTime(double pace) {
    return briefSpan() > 0.0 && pace <= slowestFactor * (1.0 + 1e-9);
}

QString paceText(double pace) {
    const ShownUnit unit = timeUnit(pace);
    return paceIsTime(pace) ? numberText(pace * unit.perSi) + u' ' + unit.name + QStringLiteral("/s")
                            : numberText(pace) + QStringLiteral(" ×");
}

QString numberText(double value, int significant) {
    return numbers().toString(value, 'g', significant);
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
