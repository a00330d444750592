#include "app/gui/session/time_left.h"

#include <algorithm>
#include <limits>

namespace rubble {

double TimeLeft::after(const Progress& progress) {
    const double fraction = std::clamp(progress.fraction, 0.0, 1.0);
    if (progress.stage.id != m_stage || fraction < m_first) {
        m_stage = progress.stage.id;
        m_first = fraction;
        m_since.start();
    }
    const double spent = static_cast<double>(m_since.elapsed()) / 1000.0;
    const double did = fraction - m_first;
    // What seems all but done may have something to come that its stage does not count: no time is better than none left.
    const bool known = did > 0.02 && spent > 1.0 && fraction < 0.99;
    return known ? spent * (1.0 - fraction) / did : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace rubble
