#include "app/cli/fe/growth_watch.h"

#include <chrono>
#include <cmath>
#include <thread>

#include "app/cli/frame/option_value.h"
#include "core/base/error.h"
#include "core/base/message.h"
#include "io/fe/fe_reader.h"

namespace rubble::cli {

namespace {

constexpr double shortestPause = 0.1;
constexpr double longestPause = 86400.0;

void wait(double seconds, const Execution& execution) {
    const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    while (std::chrono::steady_clock::now() < until) {
        execution.check();
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    execution.check();
}

std::string withSign(std::int64_t number) {
    return (number > 0 ? "+" : "") + englishInteger(number);
}

void printGrowth(std::ostream& out, const FeResult& before, const FeResult& after) {
    const io::FeGrowth growth = io::growthBetween(before, after);
    out << withSign(growth.states) << " states, " << withSign(growth.deaths) << " dead: now "
        << englishInteger(static_cast<std::int64_t>(after.stateCount())) << " states to " << englishNumber(after.times().back())
        << " s" << std::endl;
}

}  // namespace

std::optional<double> followPause(const Arguments& arguments) {
    const auto text = arguments.value("--follow");
    if (!text) {
        return std::nullopt;
    }
    double seconds = 0.0;
    if (!parseNumber(*text, seconds) || !(seconds >= shortestPause) || seconds > longestPause) {
        throw wrongValue("--follow", *text, "seconds from 0.1 to 86400");
    }
    if (arguments.json()) {
        throw UsageError({"cli.follow_json", "--follow prints line after line, which is not one JSON object.", {}},
                         {"cli.follow_json.remedy", "Leave out --json or --follow.", {}});
    }
    return seconds;
}

void followGrowth(const io::OpenedCase& subject, double pause, Session& session) {
    std::shared_ptr<const FeResult> fe = subject.inputs.fe;
    for (;;) {
        wait(pause, session.execution());
        try {
            if (io::hasGrown(*fe)) {
                const auto newer = io::openFe(subject.fePath, subject.scenario.import, subject.inputs.frame, session.execution());
                if (newer->contents().sha256 != fe->contents().sha256) {
                    printGrowth(session.out(), *fe, *newer);
                }
                fe = newer;
            }
        } catch (const Error&) {
            // The analysis may be writing a file that must be whole.
        }
    }
}

}  // namespace rubble::cli
