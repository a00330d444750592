#include "core/analysis/accuracy/loose_beside.h"

#include "core/fragments/birth_windows.h"
#include "core/pipeline/loose_scene.h"

namespace rubble {

namespace {

Finding caution(Message what) {
    return {std::move(what),
            {"sizing.loose_beside.remedy",
             "Take loose_structure = fe where the rate matters more than where the debris lies, or play the finished run",
             {}},
            1,
            {}};
}

}  // namespace

std::optional<LooseAtOnce> looseBeside(const Inputs& inputs, const Scenario& scenario, const Execution& execution) {
    if (scenario.effects.loose == LooseStructurePolicy::Fe) {
        return std::nullopt;
    }
    const LooseAtOnce most = mostLooseAtOnce(*inputs.fe, simulatedActivity(*inputs.fe, scenario.fragments),
                                             groundBeforeRun(inputs, scenario), execution);
    return most.elements > 0 ? std::optional(most) : std::nullopt;
}

Finding looseBesideCaution(double fpsTarget, const LooseAtOnce& beside, std::size_t elements) {
    return caution(
        {"sizing.loose_beside",
         "The bodies that {0} allow are fragments alone. The engine moves loose structure beside them (loose_structure), "
         "{1} of {2} elements at one time (at {3}), which takes from that rate",
         {Argument(fpsTarget, "FPS"), beside.elements, elements, Argument(beside.time, "s")}});
}

std::optional<Finding> looseBesideCaution(double fpsTarget, const SimulationResult& run, std::size_t elements) {
    if (run.carried.islands == 0) {
        return std::nullopt;
    }
    return caution(
        {"sizing.loose_beside.run",
         "The bodies that {0} allow are fragments alone. The engine moved loose structure beside them (loose_structure), "
         "{1} of {2} elements in all, and simulated at {3} times real time while fragments were born",
         {Argument(fpsTarget, "FPS"), run.carried.elements, elements, run.stepTimes.realTimeFactor}});
}

}  // namespace rubble
