#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/analysis/accuracy/interval_fit.h"
#include "core/analysis/accuracy/live_cost.h"
#include "core/pipeline/pipeline.h"

namespace rubble {

/// What a machine is measured with. Typical: a falling block that crumbles where it meets the ground, so that some bodies fall,
/// some pile up and some lie still; its mean counts. Worst: all bodies in one heap at once, none of which is ever frozen; its worst
/// second counts.
enum class PileKind : std::uint8_t { Typical, Worst };
std::string_view pileName(PileKind kind);  ///< "typical", "worst"

/// What a frame is made of: simulating its share of the collapse, drawing both views, or both as in live mode.
enum class LiveLoad : std::uint8_t { Physics, Drawing, Both };

/// Frames per second at one number of bodies.
struct CalibrationPoint {
    PileKind pile = PileKind::Typical;
    std::int64_t bodies = 0;
    double physicsFps = 0.0;  ///< nothing drawn
    double drawingFps = 0.0;  ///< recorded frames drawn; NaN where nothing can be drawn
    double liveFps = 0.0;     ///< both; NaN likewise

    double fps(LiveLoad load) const;
};

/// Live FPS against the number of bodies on one machine (the figure 7 of the published method).
struct Calibration {
    std::string machine;   ///< in words
    std::string renderer;  ///< what drew, in words; empty if nothing could be drawn
    std::string build;
    int threads = 0;
    double target = 24.0;  ///< frames per second of the collapse that were asked for
    std::vector<CalibrationPoint> points;
    double othersShare = std::numeric_limits<double>::quiet_NaN();  ///< of the processors' time, taken by other programs meanwhile
    Findings findings;
    bool complete = false;  ///< false after a cancel

    /// Other programs took so much that the curve says little of the machine: nothing is predicted from it.
    bool disturbed() const;

    /// FPS at a number of bodies with their 80 % interval; unset with fewer than three points, and further than 1.5 times beyond
    /// them.
    std::optional<FitInterval> fps(PileKind pile, LiveLoad load, double bodies) const;
    /// The most bodies that keep a rate, N_A^max: where the fitted curve meets it. At the ends of what may be said, `bounded` tells
    /// that it is only "at least" or "at most".
    struct BodiesMax {
        double bodies = 0.0;
        bool atLeast = false;
        bool atMost = false;
    };
    std::optional<BodiesMax> bodiesMax(PileKind pile, LiveLoad load, double fpsTarget) const;
    /// Exponent p of the power law, frame time ~ bodies^p, that fits best; unset with fewer than two points.
    std::optional<double> exponent(PileKind pile, LiveLoad load) const;
};

/// How a machine is calibrated.
struct CalibrationSettings {
    std::vector<std::int64_t> bodies{250, 500, 1000, 2000, 4000};  ///< about so many; each at least 8
    double target = 24.0;
    ScreenMaker screen;                     ///< null: drawing is not measured
    std::function<std::string()> renderer;  ///< asked once something was drawn; null: unknown
    std::string machine;
};

/// A pile that becomes about so many bodies: its FE result and the scenario that it is simulated with.
std::pair<Inputs, Scenario> pileScene(PileKind kind, std::int64_t bodies);

/// Measures this machine: one world at a time, smallest first. Returns what there is when cancelled. A screen that does not work is
/// a finding, and the physics alone is measured. Throws UsageError for numbers of bodies out of range (8 to 100,000).
Calibration calibrate(const CalibrationSettings& settings, const Execution& execution);

}  // namespace rubble
