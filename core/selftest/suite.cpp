#include "core/selftest/suite.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "core/base/elapsed.h"
#include "core/base/error.h"
#include "core/base/nearest_names.h"
#include "core/selftest/trajectory_hashes.h"

namespace rubble::selftest {

namespace {

constexpr std::string_view closedFormGroup = "closed-form";
constexpr std::string_view closedFormPrefix = "form-";

}  // namespace

const std::vector<HardCase>& hardCases() {
    static const std::vector<HardCase> all = [] {
        std::vector<HardCase> list;
        for (const auto& part : {motionCases(), stackCases(), birthCases(), sizeCases(), impactCases(), pieceCases(), pileCases(),
                                 elementCases(), repeatCases(), closedFormCases(), granularCases()}) {
            list.insert(list.end(), part.begin(), part.end());
        }
        return list;
    }();
    return all;
}

std::vector<const HardCase*> chosenCases(const std::vector<std::string>& ids) {
    std::vector<const HardCase*> chosen;
    std::vector<std::string> names{std::string(closedFormGroup)};
    for (const HardCase& one : hardCases()) {
        names.emplace_back(one.id);
    }
    for (const std::string& id : ids) {
        if (std::find(names.begin(), names.end(), id) == names.end()) {
            throw UsageError({"selftest.unknown_case", "There is no case \"{0}\" in the self-test.", {id}},
                             {"selftest.unknown_case.remedy",
                              "The nearest are {0}; the manual's page on the self-test lists all.",
                              {quotedList(nearestNames(id, names, 3))}});
        }
    }
    for (const HardCase& one : hardCases()) {
        const bool asked = std::any_of(ids.begin(), ids.end(), [&](const std::string& id) {
            return one.id == id || (id == closedFormGroup && one.id.starts_with(closedFormPrefix));
        });
        if (ids.empty() || asked) {
            chosen.push_back(&one);
        }
    }
    return chosen;
}

std::vector<const HardCase*> reportCases(std::string_view scope) {
    if (scope == "all") {
        return chosenCases({});
    }
    if (scope != closedFormGroup) {
        return {};
    }
    constexpr double longest = 10.0;
    std::vector<const HardCase*> cases = chosenCases({std::string(scope)});
    std::erase_if(cases, [](const HardCase* one) { return one->seconds > longest; });
    return cases;
}

CaseResult runCase(const HardCase& hardCase, const SuiteSettings& settings, const Execution& execution) {
    CaseResult result;
    result.hardCase = &hardCase;
    const auto start = std::chrono::steady_clock::now();
    CaseSetting setting;
    setting.solver = settings.solver;
    setting.small = settings.small;
    setting.execution = execution;
    if (settings.hashes) {
        setting.hashes = std::make_shared<TrajectoryHashes>();
    }
    try {
        execution.check();
        hardCase.run(setting, result.outcome);
        result.finished = true;
        if (setting.hashes) {
            result.trajectories = setting.hashes->finish();
        }
    } catch (const Cancelled&) {
        result.outcome = {};
    } catch (const std::exception& error) {
        result.finished = true;
        result.error = error.what();
    }
    result.seconds = secondsSince(start);
    return result;
}

std::vector<CaseResult> runSuite(const std::vector<const HardCase*>& cases, const SuiteSettings& settings,
                                 const Execution& execution, const std::function<void(const CaseResult&)>& finished) {
    std::vector<CaseResult> results(cases.size());
    std::vector<std::size_t> order(cases.size());
    double total = 0.0;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        order[i] = i;
        results[i].hardCase = cases[i];
        total += cases[i]->seconds;
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return cases[a]->seconds > cases[b]->seconds; });

    // Cases report to nobody; this thread tells how far the suite is, and hands a cancel on.
    const Execution inner;
    std::atomic<std::size_t> next{0};
    std::mutex mutex;
    std::condition_variable changed;
    double done = 0.0;
    std::vector<std::size_t> ended;  // in the order in which they did
    const auto work = [&] {
        for (std::size_t place = next++; place < order.size(); place = next++) {
            const std::size_t i = order[place];
            results[i] = runCase(*cases[i], settings, inner);
            const std::lock_guard lock(mutex);
            done += cases[i]->seconds;
            ended.push_back(i);
            changed.notify_one();
        }
    };
    std::vector<std::jthread> threads;
    for (int t = 0; t < std::max(1, settings.threads); ++t) {
        threads.emplace_back(work);
    }
    std::unique_lock lock(mutex);
    for (std::size_t told = 0; told < cases.size();) {
        changed.wait_for(lock, std::chrono::milliseconds(100));
        for (; told < ended.size(); ++told) {
            if (finished && results[ended[told]].finished) {
                finished(results[ended[told]]);
            }
        }
        try {
            execution.report({"selftest.progress", "self-test, {0} of {1} cases", {told, cases.size()}},
                             total > 0.0 ? std::min(done / total, 1.0) : 1.0);
        } catch (const Cancelled&) {
            inner.cancel();
        }
    }
    return results;
}

}  // namespace rubble::selftest
