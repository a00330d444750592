#pragma once

#include <array>

namespace rubble::widgets {

/// Whether views are to be drawn with less detail while they move, settled from how long pictures took.
class MovingDetail {
public:
    /// Two pictures in a row took longer than this with every detail, s.
    bool tooSlow(double limit) const;
    /// A picture was drawn with every detail while the views moved.
    void drewMoving(double seconds) { m_last = {m_last[1], seconds}; }
    /// The same at rest. What is drawn in less than half of the limit is tried with every detail when it moves next: what was
    /// hidden or closed made the model light.
    void drewResting(double seconds, double limit);

private:
    std::array<double, 2> m_last{};  ///< s
};

}  // namespace rubble::widgets
