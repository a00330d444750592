#include "app/cli/accuracy/study_options.h"

#include "app/cli/frame/option_value.h"

namespace rubble::cli {

namespace {

constexpr int repeatsMax = 100;

}  // namespace

std::vector<Option> studyOptions() {
    return {{"--repeats", "N", false, "repeats of the floor (default: 2)"},
            {"--instant", "WHEN", false, "debris at rest (default) or at fe_end, the last FE state"},
            {"--tolerances", "M,M", false, "distances of the accuracy rate, m (default: 0.1,0.2,0.3)"},
            {"--threads", "N", false, "threads to work on (default: as many as the machine has); no result depends on it"}};
}

StudySettings parseStudySettings(const Arguments& arguments, int repeatsLeast) {
    StudySettings settings;
    settings.repeats = parseCount(arguments, "--repeats", repeatsLeast, repeatsMax, settings.repeats);
    settings.threads = parseCount(arguments, "--threads", 1, jobsMax, settings.threads);
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
