#include "app/cli/accuracy/influence_report.h"
#include "app/cli/accuracy/study_options.h"
#include "app/cli/accuracy/study_place.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/option_value.h"
#include "app/cli/frame/output_file.h"
#include "core/base/error.h"
#include "io/base/machine.h"
#include "io/run/study_files.h"

namespace rubble::cli {

namespace {

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

ExitCode measureInfluence(const Arguments& arguments, Session& session) {
    const StudyPlace place(arguments);
    const StudySettings settings = parseStudySettings(arguments, 2);
    const std::vector<EffectKind> effects =
        arguments.has("--effects") ? parseEffects(*arguments.value("--effects")) : std::vector<EffectKind>{};
    const io::OpenedCase subject = openSubject(arguments, session);
    checkCsvPath(arguments, subject.files);
    io::StudyFiles files(arguments.value("--cache").value_or(io::cacheFolder()));
    if (place.elsewhere()) {
        StudyPlace::Study study{influenceTasks(subject.inputs, subject.scenario, effects, settings, session.execution()),
                                files.folder(), false, [&](const WorldOrigin& origin) { return files.keeps(origin); },
                                subject.files};
        if (const auto ended = place.haveMade(std::move(study), session)) {
            return *ended;
        }
    }
    const InfluenceReport report = influence(subject.inputs, subject.scenario, effects, settings, session.execution(),
                                             {&files, io::machineText(), place.choice()});
    if (place.single()) {
        return place.endSingle(files.folder(), false, {}, report.findings, session);
    }
    const InfluenceOutput output{subject, report, settings};
    writeCsv(arguments, output.table());
    const bool cancelled = session.execution().cancelled();
    if (!report.complete) {
        session.err() << (cancelled ? "rubble-cli: cancelled; what was simulated by then is reported\n"
                                    : "rubble-cli: some worlds were not made; what is there is reported\n");
    }
    if (arguments.json()) {
        Json object = output.json();
        if (cancelled) {
            object["cancelled"] = true;
        }
        printJson(session, object);
    } else {
        output.print(session.out());
    }
    return report.complete ? ExitCode::Ok : cancelled ? ExitCode::Cancelled : ExitCode::Failed;
}

}  // namespace

Command influenceCommand() {
    const std::vector<Option> own{
        {"--effects", "A,B", false, "these only (default: all), by the names that `effects` lists"},
        {"--cache", "FOLDER", false, "where worlds are kept (default: RUBBLE_CACHE, else the user's cache)"},
    };
    return {
        "influence",
        "FE|CASE",
        "what each effect changes in the debris, against the repeat floor",
        "Simulates the scenario, repeats it with births shifted by a micrometre, and simulates it once for each effect with that "
        "effect in its other state. A change no larger than that between repeats says nothing. Ctrl-C reports what is done. Worlds "
        "that were simulated before are taken from the cache.",
        joined({{scenarioOption()},
                simulationOptions(),
                own,
                studyOptions(),
                StudyPlace::options(),
                {csvOption("write one row for each effect")}}),
        measureInfluence};
}

}  // namespace rubble::cli
