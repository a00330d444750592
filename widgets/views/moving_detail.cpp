#include "widgets/views/moving_detail.h"

#include <algorithm>

namespace rubble::widgets {

bool MovingDetail::tooSlow(double limit) const {
    return std::min(m_last[0], m_last[1]) > limit;
}

void MovingDetail::drewResting(double seconds, double limit) {
    if (seconds < 0.5 * limit && seconds < m_last[1]) {
        m_last[1] = seconds;
    }
}

}  // namespace rubble::widgets
