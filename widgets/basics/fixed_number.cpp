#include "widgets/basics/fixed_number.h"

#include <QLocale>
#include <cmath>

namespace rubble::widgets {

QString shownFixed(double value, int decimals) {
    if (!std::isfinite(value)) {
        return QString(QChar(0x2013));
    }
    const bool nothing = std::abs(value) < 0.5 * std::pow(10.0, -decimals);
    return QLocale().toString(nothing ? 0.0 : value, 'f', decimals);
}

}  // namespace rubble::widgets
