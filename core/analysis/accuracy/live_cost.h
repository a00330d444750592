#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "core/analysis/accuracy/study_store.h"
#include "core/trajectory/trajectory.h"

namespace rubble {

/// Draws both views of a run, off screen or on. Used from the thread that made it.
class LiveScreen {
public:
    virtual ~LiveScreen() = default;
    /// Draws the run as it is at a time [s] and returns when the picture is done.
    virtual void draw(double time) = 0;
};

/// Makes the screen for one run. Throws WorldError where nothing can be drawn (no display).
using ScreenMaker =
    std::function<std::unique_ptr<LiveScreen>(const RunDescription& description, std::shared_ptr<const TrajectoryReader> run)>;

/// When frames were done: of the collapse [s], and by the wall clock [s].
struct FrameStamp {
    double time = 0.0;
    double wall = 0.0;
};

/// Frames per second of wall clock.
struct LiveRate {
    double mean = std::numeric_limits<double>::quiet_NaN();         ///< from the first to the last birth
    double worst = std::numeric_limits<double>::quiet_NaN();        ///< of the worst second of wall clock
    double othersShare = std::numeric_limits<double>::quiet_NaN();  ///< of the processors' time, taken by other programs
    std::int64_t frames = 0;
};

/// The rates of a row of frames.
/// @param from, to  s of the collapse: what the mean is taken over; all frames where fewer than two lie within
LiveRate rateOf(const std::vector<FrameStamp>& frames, double from, double to);

/// Times a run with nothing beside it: wall time and ms per step, on as many threads as the execution grants. Draws nothing and
/// keeps no frames. Throws what simulate() throws.
SettingCost timeRun(const RunDescription& description, const Execution& execution);

/// Runs in live mode (DESIGN.md 2.6) up to the last FE state, as fast as it goes: each frame simulates 1 / target s of the collapse
/// and draws both views, the next frame being simulated while one is drawn, as in the window. The calling thread draws.
/// @param target  frames per second of the collapse
/// @param screen  null: nothing is drawn, the rate is that of the physics alone
/// Throws Cancelled, what simulate() throws and what the screen throws.
LiveRate measureLive(const RunDescription& description, double target, const ScreenMaker& screen, const Execution& execution);

/// Draws the frames of a run that is there already, one for each 1 / target s of the collapse: the rate of drawing alone.
LiveRate measureDrawing(const RunDescription& description, const std::shared_ptr<const TrajectoryReader>& run, double target,
                        const ScreenMaker& screen, const Execution& execution);

}  // namespace rubble
