#include "widgets/chart_axis.h"

#include <array>
#include <cmath>

namespace rubble::widgets {

std::vector<double> logTicks(double low, double high, double room) {
    std::vector<double> ticks;
    for (const auto& steps : {std::vector<double>{1.0, 2.0, 5.0}, std::vector<double>{1.0, 3.0}, std::vector<double>{1.0}}) {
        ticks.clear();
        for (int power = static_cast<int>(std::floor(std::log10(low))); std::pow(10.0, power) <= high; ++power) {
            for (const double step : steps) {
                const double tick = step * std::pow(10.0, power);
                if (tick >= low * (1.0 - 1e-9) && tick <= high * (1.0 + 1e-9)) {
                    ticks.push_back(tick);
                }
            }
        }
        if (static_cast<double>(ticks.size()) <= room) {
            break;
        }
    }
    return ticks;
}

double roundOut(double value, bool up) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    const std::array<double, 6> steps{1.0, 2.0, 3.0, 5.0, 10.0, 20.0};
    double found = steps[0];
    for (const double step : steps) {
        if (up && step * power >= value * (1.0 - 1e-9)) {
            return step * power;
        }
        if (!up && step * power <= value * (1.0 + 1e-9)) {
            found = step;
        }
    }
    return found * power;
}

double logShare(double value, double low, double high) {
    return std::log(value / low) / std::log(high / low);
}

}  // namespace rubble::widgets
