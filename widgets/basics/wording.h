#pragma once

#include <QString>
#include <QStringList>
#include <functional>

#include "core/base/finding.h"
#include "core/base/message.h"
#include "core/scenario/parameters.h"

namespace rubble::widgets {

/// Words as what says them, in the language that is spoken when they are asked for: kept where a text would grow old.
using Wording = std::function<QString()>;

/// A message of core or io in the language of the window: pattern and words among its arguments are looked up as they stand,
/// English if there is no translation.
QString worded(const Message& message);

/// A number rounded to the significant digits it deserves, with the locale's decimal sign and grouping; powers of ten where it is
/// very small or large; an en dash for NaN and infinity.
QString shownNumber(double value, int significant = 3);
/// An angle, rad, in degrees; what is less than any survey can tell is told as less than that, not in powers of ten.
QString shownDegrees(double angle);
/// A quantity in the units that are shown, without and with their name: "3.28", "3.28 ft". @param unit as figures::shownUnit()
QString shownIn(double value, std::string_view unit, int significant = 3);
QString shownWith(double value, std::string_view unit, int significant = 3);
/// A length, m: "1.2 m".
QString shownLength(double metres, int significant = 3);
/// With so many decimals as it has in metres: places are compared digit by digit.
QString shownPlace(double metres, int decimals = 2);
/// Numbers typed in the units that are shown, in SI.
double typedIn(double shown, std::string_view unit);
/// A number that was typed in the locale's or the plain way, in SI; nothing where it is none. Its unit may follow ("70 µs", "70
/// us", "2 s"); without, it is in the unit in which figures::shownUnit() shows a value like the one that stood there.
std::optional<double> typedNumber(const QString& text, std::string_view unit, double near = 0.0);
/// An energy in the unit that keeps its number readable: "7.89 GJ".
QString shownEnergy(double joules, int significant = 3);
/// A mass in the unit that keeps its number readable: "65,870 t", "591 g".
QString shownMass(double kilograms, int significant = 3);
/// A whole number with the locale's grouping.
QString shownCount(std::int64_t value);
/// A share as percent: "98.4 %".
QString shownShare(double share, int decimals = 1);
/// A length of time for people: "12 s", "3 min 05 s", "2 h 40 min".
QString shownDuration(double seconds);
/// What is being done and how long it still takes: "Simulating · about 12 s left". @param secondsLeft  NaN: not known yet
QString shownProgress(const QString& what, double secondsLeft);
/// What a setting does, for its tip; other settings in it have their names.
QString shownHelp(const Parameter& row);
/// A value of a parameter for people: choices without underscores, "auto", "on", "off".
QString shownValue(const ParameterValue& value);
/// Parts of a line, one after another: "a; b".
QString inOneLine(const QStringList& parts);
/// A choice or a stable name for people: "oriented_box" becomes "oriented box".
QString shownName(std::string_view name);

}  // namespace rubble::widgets
