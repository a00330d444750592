#pragma once

#include <QString>

#include <cstddef>

namespace rubble::figures {

/// A count with thousands grouped: "49,561".
QString countText(std::size_t count);
/// A time with its unit to a hundredth: "5.76 s". Of a brief result: "35.02 µs".
QString timeText(double seconds);
/// A result that lasts less than a tenth of a second has its times told in ms and µs from now on.
/// @param seconds  that the FE result at hand lasts; 0: none is open
void setResultSpan(double seconds);
/// s in one unit of times below a second: 1 unless the result at hand is brief.
double briefUnit();
/// A length with its unit: "25 m", "0.5 m", "2 km".
QString lengthText(double metres);
/// A speed with its unit: "25 m/s".
QString speedText(double metresPerSecond);
/// A number without needless zeros, to four significant digits.
QString numberText(double value);

}  // namespace rubble::figures
