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

}  // namespace rubble::figures
