#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/analysis/accuracy/accuracy_study.h"
#include "core/analysis/accuracy/calibration.h"

namespace rubble {

/// What can be said of a setting before it is simulated.
enum class Predicted : std::uint8_t { WallSeconds, StepMeanMs, Fps, MassMap, CoreIou, FootprintIou, HeightRms, MeanHeight };
inline constexpr std::size_t predictedCount = 8;
/// The names of the columns of a sweep: "wall_s", "ms_per_step_mean", "fps", "mass_map_difference", ...
std::string_view predictedKey(Predicted what);

/// A setting that was measured: what decides its cost and accuracy, and what they were.
struct KnownPoint {
    Digest scene;         ///< what collapses, and when debris is looked at: accuracy holds for one scene only
    std::string machine;  ///< figures of time hold for one machine only
    int threads = 0;      ///< and for so many threads
    std::string setting;
    std::map<std::string, std::string> parameters;  ///< those that differ from the defaults, the grid left out
    std::int64_t fragments = 0;
    std::int64_t bodies = 0;
    double span = 0.0;                            ///< s, from the first birth to the last FE state; 0: not known
    double settle = 0.0;                          ///< s, at most after that
    bool carries = false;                         ///< the engine moves loose structure as well
    std::array<double, predictedCount> values{};  ///< NaN: not known

    double of(Predicted what) const { return values[static_cast<std::size_t>(what)]; }
};

/// What is known of a point of a sweep. @param reference  of the same sweep
KnownPoint knownPoint(const AccuracyPoint& point, const AccuracyReport& report);

/// A setting to be predicted: as a known point, without values.
KnownPoint openPoint(const Digest& scene, const std::string& machine, int threads, const Scenario& scenario, std::int64_t fragments,
                     std::int64_t bodies);
/// The same for a world of a study. @param threads  that it is to have
KnownPoint openPoint(const StudyTask& task, const std::string& machine, int threads);
/// All points but those of the same setting of the same scene: what it could be predicted from, had nobody measured it.
std::vector<KnownPoint> pointsBut(const KnownPoint& setting, std::span<const KnownPoint> known);
/// The scene that a reference and an instant stand for.
Digest sceneDigest(const WorldOrigin& reference, DebrisInstant instant);

/// A prediction with its 80 % interval; where nothing is known, why.
struct Prediction {
    bool known = false;
    double low = 0.0;
    double value = 0.0;
    double high = 0.0;
    bool fromCalibration = false;  ///< nothing but the curve of this machine stands behind it
    bool fromSpeed = false;        ///< nothing but bodies, births and the speed of this machine stand behind it: crude
    bool fromRun = false;          ///< a run of the very same setting on this machine stands behind it
    std::size_t points = 0;        ///< earlier points it rests on
    Message reason;                ///< why it is not known

    /// Half the interval over the value.
    double halfWidth() const { return 0.5 * (high - low) / std::abs(value); }
};
inline constexpr double predictionChance = 0.8;

/// Predicts from earlier points of the same scene (and, for figures of time, the same machine) whose parameters are the same but
/// for numbers, along the bodies and those numbers. Where there are fewer than four of them, live FPS come from the calibration, if
/// there is one. Nothing is said far outside what was measured, nor where the interval would be wider than the value.
Prediction predict(Predicted what, const KnownPoint& open, std::span<const KnownPoint> known, const Calibration* calibration);

/// What a run of the very same setting took on this machine is what it will take again, as far as machines are busy otherwise: two
/// thirds to one and a half of it. @param seconds  wall time of that run, > 0
Prediction wallSecondsAgain(double seconds);

/// How well the intervals hold: each point predicted from those of other settings.
struct PredictionCheck {
    Predicted what = Predicted::WallSeconds;
    std::size_t points = 0;   ///< with a value
    std::size_t unknown = 0;  ///< of these, of which the others do not allow to say anything
    std::size_t held = 0;     ///< of the rest: in the interval
    double halfWidth = 0.0;   ///< in the middle of the rest, share of the value; NaN without any

    double coverage() const { return static_cast<double>(held) / static_cast<double>(points - unknown); }
};
std::vector<PredictionCheck> checkPredictions(std::span<const KnownPoint> known);

}  // namespace rubble
