#include <algorithm>
#include <chrono>
#include <string>

#include "app/cli/frame/commands.h"
#include "app/cli/frame/json_output.h"
#include "app/cli/frame/option_value.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/text_output.h"
#include "core/base/error.h"
#include "core/selftest/suite.h"

namespace rubble::cli {

namespace {

using selftest::Bound;
using selftest::CaseResult;
using selftest::Check;

constexpr int mostThreads = 64;

SolverKind solverOf(const Arguments& arguments) {
    const std::string name = arguments.value("--solver").value_or("soft-step");
    if (name != "soft-step" && name != "bullet") {
        throw UsageError({"cli.unknown_solver", "There is no solver \"{0}\".", {name}},
                         {"cli.unknown_solver.remedy", "Solvers: soft-step, bullet.", {}});
    }
    return name == "bullet" ? SolverKind::Bullet : SolverKind::SoftStep;
}

int threadsOf(const Arguments& arguments) {
    const std::string text = arguments.value("--threads").value_or("2");
    int threads = 0;
    if (!parseNumber(text, threads) || threads < 1 || threads > mostThreads) {
        throw UsageError({"cli.threads", "--threads {0}: this is no number of threads.", {text}},
                         {"cli.threads.remedy", "Give a number from 1 to {0}.", {mostThreads}});
    }
    return threads;
}

std::string withUnit(double number, const std::string& unit) {
    return numberCell(number).shown + (unit.empty() ? "" : " " + unit);
}

std::string limitText(const Check& check) {
    return (check.bound == Bound::AtMost ? "<= " : ">= ") + withUnit(check.limit, check.unit);
}

Cell limitCell(const Check& check) {
    Cell cell = numberCell(check.limit);
    cell.shown = limitText(check);
    return cell;
}

std::string_view verdict(const CaseResult& result) {
    return !result.finished ? "not run" : result.pass() ? "pass" : "FAIL";
}

/// One row for each number measured; the case is named on the first.
TextTable checkTable(const std::vector<CaseResult>& results, bool forPeople) {
    TextTable table({{"case", "case"},
                     {"what could go wrong", "what_could_go_wrong"},
                     {"criterion", "criterion"},
                     {"measured", "measured"},
                     {"limit", "limit"},
                     {"unit", "unit"},
                     {"", "result"}});
    for (const CaseResult& result : results) {
        bool first = true;
        const auto add = [&](const std::string& name, Cell measured, Cell limit, const std::string& unit, std::string_view how) {
            const bool named = first || !forPeople;
            table.add({textCell(named ? std::string(result.hardCase->id) : ""),
                       textCell(named ? std::string(result.hardCase->risk) : ""), textCell(name), std::move(measured),
                       std::move(limit), textCell(unit), textCell(std::string(how))});
            first = false;
        };
        for (const Check& check : result.outcome.checks()) {
            add(check.name, numberCell(check.measured), limitCell(check), check.unit, check.pass() ? "pass" : "FAIL");
        }
        if (!result.error.empty()) {
            add(result.error, textCell(""), textCell(""), "", "FAIL");
        } else if (!result.finished) {
            add(std::string(result.hardCase->criterion), textCell(""), textCell(""), "", "not run");
        }
    }
    return table;
}

/// What the laws say against what was measured.
TextTable closedFormTable(const std::vector<CaseResult>& results) {
    TextTable table({{"case", "case"},
                     {"quantity", "quantity"},
                     {"expected", "expected"},
                     {"measured", "measured"},
                     {"error", "error"},
                     {"tolerance", "tolerance"},
                     {"unit", "unit"}});
    for (const CaseResult& result : results) {
        for (const Check& check : result.outcome.checks()) {
            if (check.closedForm()) {
                table.add({textCell(std::string(result.hardCase->id)), textCell(check.name), numberCell(check.expected),
                           numberCell(check.value), numberCell(check.measured), numberCell(check.limit), textCell(check.unit)});
            }
        }
    }
    return table;
}

Json checkJson(const Check& check) {
    Json object;
    object["name"] = check.name;
    object["measured"] = check.measured;
    object["bound"] = check.bound == Bound::AtMost ? "at most" : "at least";
    object["limit"] = check.limit;
    object["unit"] = check.unit;
    object["pass"] = check.pass();
    object["expected"] = check.closedForm() ? Json(check.expected) : Json();
    object["value"] = check.closedForm() ? Json(check.value) : Json();
    return object;
}

Json caseJson(const CaseResult& result) {
    const Check* governing = result.outcome.governing();
    Json object;
    object["id"] = result.hardCase->id;
    object["title"] = result.hardCase->title;
    object["what_could_go_wrong"] = result.hardCase->risk;
    object["criterion"] = result.hardCase->criterion;
    object["measured"] = governing ? Json(governing->measured) : Json();
    object["limit"] = governing ? Json(governing->limit) : Json();
    object["unit"] = governing ? Json(governing->unit) : Json("");
    object["pass"] = result.pass();
    object["governed_by"] = governing ? Json(governing->name) : Json();
    object["failed_with"] = result.error.empty() ? Json() : Json(result.error);
    object["wall_s"] = result.seconds;
    object["checks"] = Json::array();
    for (const Check& check : result.outcome.checks()) {
        object["checks"].push_back(checkJson(check));
    }
    return object;
}

ExitCode selfTest(const Arguments& arguments, Session& session) {
    checkCsvPath(arguments, {});
    selftest::SuiteSettings settings;
    settings.solver = solverOf(arguments);
    settings.threads = threadsOf(arguments);
    const std::vector<const selftest::HardCase*> cases = selftest::chosenCases(arguments.values("--only"));
    const auto start = std::chrono::steady_clock::now();
    const std::vector<CaseResult> results = selftest::runSuite(cases, settings, session.execution(), [&](const CaseResult& result) {
        session.err() << verdict(result) << "  " << result.hardCase->id << ", " << englishNumber(result.seconds) << " s\n";
    });
    const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

    const bool cancelled = session.execution().cancelled();
    const auto run = std::count_if(results.begin(), results.end(), [](const CaseResult& r) { return r.finished; });
    const auto passed = std::count_if(results.begin(), results.end(), [](const CaseResult& r) { return r.pass(); });
    writeCsv(arguments, checkTable(results, false));
    if (arguments.json()) {
        Json object;
        object["solver"] = settings.solver == SolverKind::Bullet ? "bullet" : "soft-step";
        object["cases"] = Json::array();
        for (const CaseResult& result : results) {
            if (result.finished) {
                object["cases"].push_back(caseJson(result));
            }
        }
        object["passed"] = passed;
        object["failed"] = run - passed;
        object["not_run"] = static_cast<std::int64_t>(results.size()) - run;
        object["wall_s"] = wall;
        printJson(session, object);
    } else {
        checkTable(results, true).print(session.out());
        const TextTable laws = closedFormTable(results);
        if (laws.rows() > 0) {
            printHeading(session.out(), "Closed form");
            laws.print(session.out());
        }
        session.out() << passed << " passed, " << run - passed << " failed";
        if (cancelled) {
            session.out() << ", " << static_cast<std::int64_t>(results.size()) - run << " not run (cancelled)";
        }
        session.out() << ", " << englishNumber(wall) << " s\n";
        for (const CaseResult& result : results) {
            if (result.finished && !result.pass()) {
                session.out() << "  " << verdict(result) << ": " << result.hardCase->id << ", " << result.hardCase->title << '\n';
            }
        }
    }
    if (cancelled && run < static_cast<std::ptrdiff_t>(results.size())) {
        session.err() << "rubble-cli: cancelled; the table holds the cases that were finished\n";
        return ExitCode::Cancelled;
    }
    return passed == run ? ExitCode::Ok : ExitCode::Failed;
}

}  // namespace

Command selfTestCommand() {
    return {"self-test",
            "",
            "hard cases of the simulation, each with what must hold",
            "Runs small scenes in which a simulation of debris could go wrong, and compares what it measures with the criterion of "
            "each. Tells every case on the error stream as it ends, long ones first. --only closed-form runs those that a law of "
            "mechanics predicts. Ctrl-C keeps what was finished.",
            {{"--only", "ID", true, "run this case; closed-form stands for all that a law predicts"},
             {"--solver", "NAME", false, "soft-step (default) or bullet"},
             {"--threads", "N", false, "cases at a time, 2 by default; no result depends on it"},
             csvOption("write one row for each number measured")},
            selfTest};
}

}  // namespace rubble::cli
