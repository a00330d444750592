#include "widgets/figures/shown_units.h"

#include <QRegularExpression>
#include <array>
#include <atomic>

#include "core/base/standard_gravity.h"
#include "widgets/figures/number_text.h"

namespace rubble::figures {

namespace {

struct Row {
    std::string_view unit;
    const char* millimetreTonne;
    double perMillimetreTonne;
    const char* usCustomary;
    double perUsCustomary;
};

// International foot, avoirdupois pound, short ton; standard gravity between pound and pound-force.
constexpr double footLength = 0.3048;                         // m
constexpr double pound = 0.45359237;                          // kg
constexpr double poundForce = pound * standardGravity;        // N
constexpr double squareInch = footLength * footLength / 144;  // m2

constexpr std::array rows{
    Row{"m", "mm", 1e3, "ft", 1.0 / footLength},
    Row{"m2", "mm²", 1e6, "ft²", 1.0 / (footLength * footLength)},
    Row{"m3", "mm³", 1e9, "ft³", 1.0 / (footLength * footLength * footLength)},
    Row{"kg", "t", 1e-3, "lb", 1.0 / pound},
    Row{"t", "t", 1.0, "short tons", 1000.0 / (2000.0 * pound)},
    Row{"kg/m3", "t/mm³", 1e-12, "lb/ft³", footLength* footLength* footLength / pound},
    Row{"m/s", "mm/s", 1e3, "ft/s", 1.0 / footLength},
    Row{"m/s2", "mm/s²", 1e3, "ft/s²", 1.0 / footLength},
    Row{"N", "N", 1.0, "lbf", 1.0 / poundForce},
    Row{"Pa", "MPa", 1e-6, "psi", squareInch / poundForce},
    Row{"J", "mJ", 1e3, "ft·lbf", 1.0 / (footLength * poundForce)},
    Row{"m3/m2", "mm³/mm²", 1e3, "ft³/ft²", 1.0 / footLength},
    Row{"kg/m2", "t/mm²", 1e-9, "lb/ft²", footLength* footLength / pound},
    Row{"J/m2", "mJ/mm²", 1e-3, "ft·lbf/ft²", footLength / poundForce},
};

std::atomic<UnitSet>& chosenUnits() {
    static std::atomic<UnitSet> set{UnitSet::Si};
    return set;
}

int& filesBeingWritten() {
    thread_local int files = 0;
    return files;
}

}  // namespace

void chooseUnits(UnitSet set) {
    chosenUnits() = set;
}

UnitSet unitSet() {
    return filesBeingWritten() > 0 ? UnitSet::Si : chosenUnits().load();
}

ShownUnit shownUnit(std::string_view unit) {
    return shownUnit(unit, 0.0);
}

ShownUnit shownUnit(std::string_view unit, double value) {
    if (unit == "s" && filesBeingWritten() == 0) {
        return timeUnit(value);
    }
    const UnitSet set = unitSet();
    QString plain = QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size()));
    plain.replace(u'²', u'2').replace(u'³', u'3');
    for (const Row& row : rows) {
        if (set != UnitSet::Si && plain.toStdString() == row.unit) {
            return set == UnitSet::MillimetreTonne ? ShownUnit{QString::fromUtf8(row.millimetreTonne), row.perMillimetreTonne}
                                                   : ShownUnit{QString::fromUtf8(row.usCustomary), row.perUsCustomary};
        }
    }
    return {raisedUnits(plain), 1.0};
}

QString raisedUnits(QString text) {
    // Only where a unit ends with them: "m3/m2", "kN/m3", "m/s2", but no name such as "beam2" or "form3".
    static const QRegularExpression powers(
        QStringLiteral("(?<![A-Za-z0-9_])((?:[kM]?[A-Za-z]{1,2}/)?(?:[ckm]?m|s))([23])(?![0-9A-Za-z_])"));
    if (!text.contains(u'2') && !text.contains(u'3')) {
        return text;
    }
    for (auto found = powers.match(text); found.hasMatch(); found = powers.match(text)) {
        text.replace(found.capturedStart(2), 1, found.captured(2) == QLatin1String("2") ? u'²' : u'³');
    }
    return text;
}

FileUnits::FileUnits() {
    ++filesBeingWritten();
}

FileUnits::~FileUnits() {
    --filesBeingWritten();
}

}  // namespace rubble::figures
