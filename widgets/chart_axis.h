#pragma once

#include <vector>

namespace rubble::widgets {

/// 1, 2, 5 or 1, 3 times the powers of ten between two figures above 0, as many as there is room for.
std::vector<double> logTicks(double low, double high, double room);
/// The next number of the form 1, 2, 3 or 5 times a power of ten, down or up. @param value  above 0
double roundOut(double value, bool up);
/// Where a value lies between two others in logarithms: 0 at the low one, 1 at the high one.
double logShare(double value, double low, double high);

}  // namespace rubble::widgets
