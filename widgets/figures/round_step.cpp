#include "widgets/figures/round_step.h"

#include <cmath>
#include <initializer_list>

namespace rubble::figures {

double roundStep(double span, double count) {
    if (!(span > 0.0) || !(count > 0.0)) {
        return 1.0;
    }
    const double least = span / count;
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= least * (1.0 - 1e-12)) {
            return factor * power;
        }
    }
    return 10.0 * power;
}

int digitsOfMark(double mark, double step) {
    const auto power = [](double value) { return static_cast<int>(std::floor(std::log10(value) + 1e-9)); };
    const double size = std::abs(mark);
    return size < step || !(step > 0.0) ? 1 : power(size) - power(step) + 1;
}

}  // namespace rubble::figures
