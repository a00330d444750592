#include <filesystem>

#include "app/cli/accuracy/study_place.h"
#include "app/cli/evidence/ensemble_output.h"
#include "app/cli/evidence/reached_places.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/ensemble_commands.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/text_output.h"
#include "core/base/error.h"
#include "io/base/files.h"
#include "io/base/machine.h"
#include "io/exports/ensemble_origin.h"
#include "io/run/settled_files.h"

namespace rubble::cli {

namespace {

void writeTables(const EnsembleMaps& maps, const EnsembleReport& report, std::vector<std::string>& written) {
    for (const std::string& folder : maps.folders()) {
        const auto add = [&](const char* name, const TextTable& table) {
            written.push_back((std::filesystem::path(folder) / name).string());
            io::writeAtomically(written.back(), [&](std::ostream& out) { table.writeCsv(out); });
        };
        add("members.csv", memberTable(report));
        add("convergence.csv", convergenceTable(report));
    }
}

ExitCode exitCodeOf(const EnsembleReport& report, Session& session) {
    if (report.complete) {
        return ExitCode::Ok;
    }
    if (session.execution().cancelled()) {
        session.err() << "rubble-cli: cancelled; what is done is kept, and the same command goes on from there\n";
        return ExitCode::Cancelled;
    }
    session.err() << "rubble-cli: some members failed; what is done is kept, and the same command goes on from there\n";
    return ExitCode::Failed;
}

/// Why a member that was to be made alone was not.
std::string failureOf(const EnsembleReport& report) {
    std::string text;
    for (const EnsembleMember& member : report.members) {
        if (text.empty()) {
            text = englishText(member.failure);
        }
    }
    return text;
}

ExitCode ensemble(const Arguments& arguments, Session& session) {
    const StudyPlace place(arguments);
    const EnsembleRequest request(arguments);
    const EnsembleMaps maps(arguments,
                            {MapLayer::Probability, MapLayer::AboveSecond, MapLayer::HeightMiddle, MapLayer::HeightHigh});
    const HeightThresholds heights = parseThresholds(arguments);
    const std::vector<ReachedPlace> places = reachedPlaces(arguments);
    checkCsvPath(arguments, operandsOf(arguments));
    EnsembleSubject subject = openEnsembleSubject(arguments.operand(), arguments.value("--scenario"), arguments, request, session);
    io::SettledFiles files(arguments.value("--cache").value_or(io::cacheFolder()));
    EnsembleOptions options = request.studyOptions(&files);
    options.choice = place.choice();
    if (place.elsewhere()) {
        StudyPlace::Study study{tasksOf(subject, request, session.execution()), files.worlds().folder(), true,
                                [&](const WorldOrigin& origin) { return files.keeps(origin); }, subject.files};
        if (const auto ended = place.haveMade(std::move(study), session)) {
            return *ended;
        }
    }
    EnsembleReport report = ensembleStudy(subject.scenes, subject.settings, options, session.execution());
    if (place.single()) {
        return place.endSingle(files.worlds().folder(), true, failureOf(report), report.findings, session);
    }
    report.findings.append(subject.findings);
    std::optional<DebrisMap> map;
    std::vector<std::string> written;
    // What was asked for is written after Ctrl-C too: of what is done.
    ProgressLine silent(session.err(), false);
    Session writing(session.out(), session.err(), Execution(), silent);
    if (!report.done().empty()) {
        map = probabilityMap(report, heights);
        written = maps.write(*map, "probability", io::ensembleOrigin(report, *map, subject.basis()),
                             io::ensembleCautions(report, *map, subject.basis()), std::nullopt, writing);
        writeTables(maps, report, written);
    }
    writeCsv(arguments, memberTable(report));
    if (arguments.json()) {
        Json object = ensembleJson(report, map ? &*map : nullptr);
        object["reached"] = reachedJson(report, places);
        object["exports"] = written;
        object["warnings"] = findingsJson(report.findings);
        if (session.execution().cancelled()) {
            object["cancelled"] = true;
        }
        printJson(session, object);
    } else {
        printEnsemble(session.out(), report);
        printReached(session.out(), report, places);
        for (const std::string& path : written) {
            session.out() << path << '\n';
        }
        printFindings(session.out(), report.findings);
    }
    return exitCodeOf(report, session);
}

}  // namespace

Command ensembleCommand() {
    const std::vector<Option> own{
        {"--heights", "M,M,M", false, "heights that the map has the probability of, m (default: 0.25,0.5,1)"}, reachedOption()};
    return {
        "ensemble",
        "FE|CASE",
        "probability maps: a collapse simulated again and again with what is not known drawn anew",
        "Simulates the members of an ensemble, each with values drawn from stated distributions, and maps how often debris lies "
        "where. Members that were simulated before are taken from the cache: after Ctrl-C, or with more members, the same command "
        "goes on from there.",
        joined({EnsembleRequest::options(),
                EnsembleMaps::options(),
                own,
                StudyPlace::options(),
                {scenarioOption()},
                simulationOptions(),
                {csvOption("write one row for each member")}}),
        ensemble};
}

}  // namespace rubble::cli
