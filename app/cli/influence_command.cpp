#include <algorithm>
#include <cmath>

#include "app/cli/commands.h"
#include "app/cli/influence_report.h"
#include "app/cli/option_value.h"
#include "app/cli/output_file.h"
#include "core/base/error.h"

namespace rubble::cli {

namespace {

constexpr int repeatsMax = 100;
constexpr int threadsMax = 1024;

std::vector<std::string> splitAtCommas(const std::string& text) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == ',') {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    return parts;
}

std::vector<EffectKind> parseEffects(const std::string& text) {
    std::string names;
    for (std::size_t k = 0; k < effectCount; ++k) {
        names += (k == 0 ? "" : ",") + std::string(effectName(static_cast<EffectKind>(k)));
    }
    std::vector<EffectKind> effects;
    for (const std::string& part : splitAtCommas(text)) {
        std::size_t k = 0;
        while (k < effectCount && effectName(static_cast<EffectKind>(k)) != part) {
            ++k;
        }
        if (k == effectCount) {
            throw wrongValue("--effects", part, "some of " + names);
        }
        effects.push_back(static_cast<EffectKind>(k));
    }
    return effects;
}

int parseCount(const Arguments& arguments, std::string_view option, int low, int high, int otherwise) {
    const auto text = arguments.value(option);
    int number = otherwise;
    if (text && (!parseNumber(*text, number) || number < low || number > high)) {
        throw wrongValue(option, *text, "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
    }
    return number;
}

StudySettings parseSettings(const Arguments& arguments) {
    StudySettings settings;
    settings.repeats = parseCount(arguments, "--repeats", 2, repeatsMax, settings.repeats);
    settings.threads = parseCount(arguments, "--threads", 1, threadsMax, settings.threads);
    const std::string instant = arguments.value("--instant").value_or("rest");
    if (instant == "fe_end") {
        settings.instant = DebrisInstant::AtFeEnd;
    } else if (instant != "rest") {
        throw wrongValue("--instant", instant, "rest or fe_end");
    }
    if (const auto text = arguments.value("--tolerances")) {
        settings.measures.tolerances.clear();
        for (const std::string& part : splitAtCommas(*text)) {
            double tolerance = 0.0;
            if (!parseNumber(part, tolerance) || !std::isfinite(tolerance) || tolerance <= 0.0) {
                throw wrongValue("--tolerances", part, "distances above zero in m, separated by commas");
            }
            settings.measures.tolerances.push_back(tolerance);
        }
    }
    return settings;
}

ExitCode measureInfluence(const Arguments& arguments, Session& session) {
    const StudySettings settings = parseSettings(arguments);
    const std::vector<EffectKind> effects =
        arguments.has("--effects") ? parseEffects(*arguments.value("--effects")) : std::vector<EffectKind>{};
    const Subject subject = openSubject(arguments, session);
    checkCsvPath(arguments, subject.files);
    const InfluenceReport report = influence(subject.inputs, subject.scenario, effects, settings, session.execution());
    const InfluenceOutput output{subject, report, settings};
    writeCsv(arguments, output.table());
    if (!report.complete) {
        session.err() << "rubble-cli: cancelled; what was simulated by then is reported\n";
    }
    if (arguments.json()) {
        Json object = output.json();
        if (!report.complete) {
            object["cancelled"] = true;
        }
        printJson(session, object);
    } else {
        output.print(session.out());
    }
    return report.complete ? ExitCode::Ok : ExitCode::Cancelled;
}

}  // namespace

Command influenceCommand() {
    return {
        "influence",
        "FE|CASE",
        "what each effect changes in the debris, against the repeat floor",
        "Simulates the scenario, repeats it with births shifted by a micrometre, and simulates it once for each effect with that "
        "effect in its other state. A change no larger than that between repeats says nothing. Ctrl-C reports what is done.",
        {setOption(),
         scenarioOption(),
         terrainOption(),
         {"--effects", "A,B", false, "these only (default: all), by the names that `effects` lists"},
         {"--repeats", "N", false, "repeats of the floor, at least 2 (default: 2)"},
         {"--instant", "WHEN", false, "debris at rest (default) or at fe_end, the last FE state"},
         {"--tolerances", "M,M", false, "distances of the accuracy rate, m (default: 0.1,0.2,0.3)"},
         {"--threads", "N", false, "threads to work on (default: as many as the machine has); no result depends on it"},
         csvOption("write one row for each effect")},
        measureInfluence};
}

}  // namespace rubble::cli
