#pragma once

#include <deque>

namespace rubble::widgets {

/// Frames per second of wall clock: over the last second, the mean since start, and the worst whole second. Fed with the instants
/// at which frames were shown.
class FrameMeter {
public:
    /// Forgets everything.
    void reset();
    /// A frame was shown at this instant [s of a monotonic clock].
    void frame(double instant);

    double recent(double now) const;  ///< frames in the second before `now`, over the time they cover; 0 if none
    double mean() const;              ///< frames over time between the first and the last frame; 0 below two frames
    double worstSecond() const;       ///< smallest count in any complete second since the first frame; the mean below one second
    long frames() const { return m_frames; }

private:
    void closeSeconds(double instant);

    std::deque<double> m_recent;
    double m_first = 0.0;
    double m_last = 0.0;
    long m_frames = 0;
    long m_inSecond = 0;
    long m_second = 0;
    long m_worst = -1;
};

}  // namespace rubble::widgets
