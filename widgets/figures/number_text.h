#pragma once

#include <QString>

#include <cstddef>

namespace rubble::figures {

/// A count with thousands grouped: "49,561".
QString countText(std::size_t count);
/// A time with its unit to a hundredth: "5.76 s".
QString timeText(double seconds);
/// A length with its unit: "25 m", "0.5 m", "2 km".
QString lengthText(double metres);
/// A speed with its unit: "25 m/s".
QString speedText(double metresPerSecond);
/// A number without needless zeros, to four significant digits.
QString numberText(double value);

}  // namespace rubble::figures
