#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/hash.h"
#include "core/selftest/hard_case.h"

namespace rubble::selftest {

/// Every case, in the order in which tables list them. Ids are unique.
const std::vector<HardCase>& hardCases();

/// The cases with the given ids, in table order; "closed-form" stands for all whose id begins with "form-". Empty: all.
/// Throws UsageError for an id that does not exist.
std::vector<const HardCase*> chosenCases(const std::vector<std::string>& ids);

/// The cases that a report runs by its scope: "all"; "closed-form", of which it leaves out those that take more than ten seconds
/// (heaps and columns of blocks, minutes in all); "none". Empty for any other scope.
std::vector<const HardCase*> reportCases(std::string_view scope);

/// What became of one case.
struct CaseResult {
    const HardCase* hardCase = nullptr;
    bool finished = false;  ///< not cancelled
    Outcome outcome;
    std::string error;  ///< the case could not be run to its end; empty if it could
    double seconds = 0.0;
    Digest trajectories;  ///< of all that moved, where it was asked for
    bool pass() const { return finished && error.empty() && outcome.pass(); }
};

struct SuiteSettings {
    SolverKind solver = SolverKind::SoftStep;
    bool small = false;
    bool hashes = false;  ///< hash what moves in each case as well
    int threads = 2;      ///< cases at a time; no result depends on it
};

/// Runs cases, long ones first, each in worlds of its own. What was not finished when the execution was cancelled is marked so.
/// @param finished  called on this thread with every case as it ends, in whatever order they do
/// @return  in the order of `cases`
std::vector<CaseResult> runSuite(const std::vector<const HardCase*>& cases, const SuiteSettings& settings,
                                 const Execution& execution, const std::function<void(const CaseResult&)>& finished = {});

/// One case as the suite runs it.
CaseResult runCase(const HardCase& hardCase, const SuiteSettings& settings, const Execution& execution);

}  // namespace rubble::selftest
