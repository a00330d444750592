#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "core/base/execution.h"
#include "core/scenario/scenario.h"
#include "core/selftest/check.h"

namespace rubble::selftest {

class TrajectoryHashes;

/// How the cases are to run.
struct CaseSetting {
    SolverKind solver = SolverKind::SoftStep;
    bool small = false;  ///< a smaller size of the long cases, for tests; their criteria stay
    Execution execution;
    std::shared_ptr<TrajectoryHashes> hashes;  ///< of what moves in the case; null: nobody asks for them
};

/// One hard case: a scene, what could go wrong in it, and what must hold.
struct HardCase {
    std::string_view id;  ///< stable, kebab-case
    std::string_view title;
    std::string_view risk;       ///< what could go wrong
    std::string_view criterion;  ///< in words, with its numbers
    double seconds;              ///< rough time that it takes; long ones start first
    /// Makes the scene, runs it, measures. May throw Cancelled.
    void (*run)(const CaseSetting& setting, Outcome& outcome);
};

// The cases by what they are about; hardCases() is all of them.
std::vector<HardCase> motionCases();
std::vector<HardCase> stackCases();
std::vector<HardCase> birthCases();
std::vector<HardCase> sizeCases();
std::vector<HardCase> impactCases();
std::vector<HardCase> pieceCases();
std::vector<HardCase> pileCases();
std::vector<HardCase> elementCases();
std::vector<HardCase> repeatCases();
std::vector<HardCase> closedFormCases();
std::vector<HardCase> granularCases();

}  // namespace rubble::selftest
