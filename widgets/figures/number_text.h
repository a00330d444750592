#pragma once

#include <QString>

#include <cstddef>

#include "widgets/figures/shown_units.h"

namespace rubble::figures {

/// A count with thousands grouped: "49,561".
QString countText(std::size_t count);
/// A time with its unit to a hundredth: "5.76 s". Of a brief result: "35.02 µs".
QString timeText(double seconds);
/// A result that lasts less than a tenth of a second has its times told in ms and µs from now on.
/// @param seconds  that the FE result at hand lasts; 0: none is open
void setResultSpan(double seconds);
/// s that the FE result at hand lasts where that is brief; 0: it is not, or none is open.
double briefSpan();
/// What a time of this size is told in: "s"; of a brief result below a second "ms" or "µs". 0 s: the unit of its instants.
ShownUnit timeUnit(double seconds = 0.0);
/// Whether a pace is told as a time of collapse in a second, not as a factor. @param pace  seconds of collapse in one second
bool paceIsTime(double pace);
/// How fast a collapse is played: "0.5 ×"; of a brief result "5 µs/s".
QString paceText(double pace);
/// A length with its unit: "25 m", "0.5 m", "2 km".
QString lengthText(double metres);
/// A speed with its unit: "25 m/s".
QString speedText(double metresPerSecond);
/// A number without needless zeros.
QString numberText(double value, int significant = 4);

}  // namespace rubble::figures
