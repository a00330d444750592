#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/analysis/accuracy/study_world.h"

namespace rubble {

/// What a world was simulated from and on. Two worlds may be compared only if all but the repeat agrees; figures of time only on
/// one machine.
struct WorldOrigin {
    Digest key;            ///< of inputs, scenario, build and repeat: decides every bit of the result
    std::string build;     ///< buildText()
    std::string feSha256;  ///< of the FE file
    Digest scenario;       ///< of all its parameters, regrouping included
    std::int64_t repeat = 0;
    double birthShift = 0.0;  ///< m, of a repeat
    std::string machine;      ///< in words
};

/// Origin of the world of a base, or of one of its repeats.
WorldOrigin originOf(const Inputs& inputs, const Scenario& scenario, std::int64_t repeat, double birthShift,
                     const std::string& machine);

/// Which of the things that decide a result differ: "build", "scenario", "FE result", "repeat"; empty if none does. The machine is
/// none of them: it marks a world, and its figures of time do not hold.
std::string foreignPart(const WorldOrigin& expected, const WorldOrigin& found);

/// What a setting costs on one machine with nothing beside it.
struct SettingCost {
    double wallSeconds;  ///< of the simulation, start to end; NaN: not measured
    double stepMeanMs;   ///< from the first to the last birth
    double stepWorstMs;  ///< likewise
    double fps;          ///< live FPS, mean from the first to the last birth
    double fpsWorst;     ///< live FPS of the worst second
    double othersShare;  ///< of the processors' time that other programs took meanwhile, the larger of both measurements
    int threads = 0;

    SettingCost();
    bool timed() const;
    /// Other programs took so much that the figures say little of the setting.
    bool disturbed() const;
};

/// Where a study keeps what took long to make, so that a second start goes on from there. Members may be called from several
/// threads at once.
class StudyStore {
public:
    virtual ~StudyStore() = default;
    /// The world of this origin, if it is kept and sound. What is kept under its name but of another origin, or damaged, is not
    /// taken; one of another machine is: each is said in the findings.
    virtual std::optional<SimulatedWorld> world(const WorldOrigin& origin, Findings& findings) = 0;
    /// Throws WorldError when there is no room.
    virtual void keep(const WorldOrigin& origin, const SimulatedWorld& world) = 0;
    /// Where this world keeps checkpoints while it is simulated, until it is kept itself. Null: nowhere.
    virtual std::unique_ptr<CheckpointStore> checkpoints(const WorldOrigin&) { return nullptr; }
    /// The cost of a world on the machine and with the threads named.
    virtual std::optional<SettingCost> cost(const WorldOrigin& origin, int threads) = 0;
    virtual void keep(const WorldOrigin& origin, const SettingCost& cost) = 0;
};

}  // namespace rubble
