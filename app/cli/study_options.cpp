#include "app/cli/study_options.h"

#include <cmath>

#include "app/cli/option_value.h"

namespace rubble::cli {

namespace {

constexpr int repeatsMax = 100;
constexpr int threadsMax = 1024;

}  // namespace

std::vector<Option> studyOptions() {
    return {{"--repeats", "N", false, "repeats of the floor (default: 2)"},
            {"--instant", "WHEN", false, "debris at rest (default) or at fe_end, the last FE state"},
            {"--tolerances", "M,M", false, "distances of the accuracy rate, m (default: 0.1,0.2,0.3)"},
            {"--threads", "N", false, "threads to work on (default: as many as the machine has); no result depends on it"}};
}

int parseCount(const Arguments& arguments, std::string_view option, int low, int high, int otherwise) {
    const auto text = arguments.value(option);
    int number = otherwise;
    if (text && (!parseNumber(*text, number) || number < low || number > high)) {
        throw wrongValue(option, *text, "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
    }
    return number;
}

std::vector<double> parsePositives(const Arguments& arguments, std::string_view option, std::string_view offered) {
    std::vector<double> numbers;
    if (const auto text = arguments.value(option)) {
        for (const std::string& part : splitAtCommas(*text)) {
            double number = 0.0;
            if (!parseNumber(part, number) || !std::isfinite(number) || number <= 0.0) {
                throw wrongValue(option, part, offered);
            }
            numbers.push_back(number);
        }
    }
    return numbers;
}

StudySettings parseStudySettings(const Arguments& arguments, int repeatsLeast) {
    StudySettings settings;
    settings.repeats = parseCount(arguments, "--repeats", repeatsLeast, repeatsMax, settings.repeats);
    settings.threads = parseCount(arguments, "--threads", 1, threadsMax, settings.threads);
    const std::string instant = arguments.value("--instant").value_or("rest");
    if (instant == "fe_end") {
        settings.instant = DebrisInstant::AtFeEnd;
    } else if (instant != "rest") {
        throw wrongValue("--instant", instant, "rest or fe_end");
    }
    if (arguments.has("--tolerances")) {
        settings.measures.tolerances = parsePositives(arguments, "--tolerances", "distances above zero in m, separated by commas");
    }
    return settings;
}

}  // namespace rubble::cli
