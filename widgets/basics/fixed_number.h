#pragma once

#include <QString>

namespace rubble::widgets {

/// A number with so many decimals in the user's locale; one that rounds to zero has no sign. An en dash for NaN and infinity.
QString shownFixed(double value, int decimals);

}  // namespace rubble::widgets
