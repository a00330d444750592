#pragma once

#include <QString>

#include "core/base/finding.h"
#include "core/base/message.h"
#include "core/scenario/parameters.h"

namespace rubble::widgets {

/// A message of core or io in the language of the window: pattern and words among its arguments are looked up as they stand,
/// English if there is no translation.
QString worded(const Message& message);

/// A number rounded to the significant digits it deserves, with the locale's decimal sign and grouping; powers of ten where it is
/// very small or large; an en dash for NaN and infinity.
QString shownNumber(double value, int significant = 3);
/// An energy in the unit that keeps its number readable: "7.89 GJ".
QString shownEnergy(double joules);
/// A whole number with the locale's grouping.
QString shownCount(std::int64_t value);
/// A share as percent: "98.4 %".
QString shownShare(double share, int decimals = 1);
/// A length of time for people: "12 s", "3 min 05 s".
QString shownDuration(double seconds);
/// A value of a parameter for people: choices without underscores, "auto", "on", "off".
QString shownValue(const ParameterValue& value);
/// A choice or a stable name for people: "oriented_box" becomes "oriented box".
QString shownName(std::string_view name);

}  // namespace rubble::widgets
