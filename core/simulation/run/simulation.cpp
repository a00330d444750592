#include "core/simulation/run/simulation.h"

#include "core/simulation/run/collapse.h"
#include "core/simulation/run/sealed_checkpoint.h"

namespace rubble {

double accountedMs(const SimulationResult& result) {
    double sum = result.stepTimes.restMs();
    for (const EffectReport& report : result.effects) {
        sum += report.msPerStep;
    }
    return sum;
}

double accountError(const SimulationResult& result) {
    const double measured = result.stepTimes.allMs;
    return measured > 0.0 ? accountedMs(result) / measured - 1.0 : 0.0;
}

SimulationResult simulateIn(const WorldFactory& makeWorld, const RunDescription& description, TrajectorySink& sink,
                            const Execution& execution, CheckpointStore* checkpoints) {
    Findings findings;
    const auto begin = [&] { return std::make_unique<Collapse>(makeWorld, description, sink, execution, checkpoints); };
    const auto resume = [&]() -> std::unique_ptr<Collapse> {
        const std::optional<std::string> bytes = latestCheckpoint(checkpoints, findings);
        const auto content = bytes ? openCheckpoint(*bytes, runDigest(description), findings) : std::nullopt;
        if (!content) {
            return nullptr;
        }
        auto collapse = begin();
        if (!collapse->resume(*content)) {
            addDamagedCheckpoint(findings, "what it says does not belong together");
            return nullptr;
        }
        return collapse;
    };
    std::unique_ptr<Collapse> collapse = resume();
    if (!collapse) {
        collapse = begin();
    }
    collapse->note(findings);
    return collapse->run();
}

SimulationResult simulate(const RunDescription& description, TrajectorySink& sink, const Execution& execution,
                          CheckpointStore* checkpoints) {
    const SolverKind solver = description.scenario.simulation.solver;
    return simulateIn([solver](const WorldSettings& settings) { return makeWorld(solver, settings); }, description, sink, execution,
                      checkpoints);
}

}  // namespace rubble
