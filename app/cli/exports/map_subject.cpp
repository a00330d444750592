#include "app/cli/exports/map_subject.h"

#include <array>
#include <string_view>

#include "app/cli/frame/commands.h"
#include "app/cli/frame/health_output.h"
#include "app/cli/frame/run_inputs.h"
#include "app/cli/frame/subject.h"
#include "app/cli/frame/text_output.h"
#include "core/base/error.h"
#include "io/case/case_file.h"
#include "io/run/run_cautions.h"

namespace rubble::cli {

namespace {

void refuseSettingsOfRun(const Arguments& arguments) {
    constexpr std::array<std::string_view, 6> settings{"--set",          "--scenario",   "--mesh-offset",
                                                       "--ground-class", terrainColumns, terrainSystem};
    for (const std::string_view option : settings) {
        if (arguments.has(option)) {
            throw UsageError({"cli.setting_of_run", "{0} cannot change a run that is recorded already.", {option}},
                             {"cli.setting_of_run.remedy", "Leave it out, or give the case instead of the run.", {}});
        }
    }
}

}  // namespace

std::shared_ptr<io::RunReader> runAt(const std::string& path) {
    if (io::isCaseFile(path)) {
        return nullptr;
    }
    try {
        return io::openRun(path);
    } catch (const ParseError& error) {
        const std::string& id = error.message().id;
        if (id == "io.run.not_a_run" || (id == "io.run.not_hdf5" && !path.ends_with(".run.h5"))) {
            return nullptr;
        }
        throw;
    }
}

MapSubject openMapSubject(const Arguments& arguments, Session& session) {
    MapSubject subject;
    subject.run = runAt(arguments.operand());
    if (subject.run) {
        refuseSettingsOfRun(arguments);
        subject.path = arguments.operand();
        subject.inputs = openInputsOfRun(arguments.operand(), subject.run->origin(), arguments, session, &subject.findings);
        return subject;
    }
    const io::OpenedCase opened = openSubject(arguments, session);
    subject.temporary = std::make_unique<TemporaryRun>();
    const std::string path = subject.temporary->path();
    std::unique_ptr<TrajectorySink> file = io::createRun(path, io::originOf(opened));
    const Results results = runTo(opened, Stage::Simulation, file.get(), session.execution());
    file.reset();
    subject.run = subject.temporary->open();
    subject.inputs = opened.inputs;
    subject.findings = io::openingFindings(opened);
    return subject;
}

void conclude(const Arguments& arguments, Session& session, const MapSubject& subject, const Findings& findings,
              const std::function<Json()>& json, const std::function<void(std::ostream&)>& tables) {
    const std::vector<std::string> files = arguments.values("--out");
    const io::Taint taint = io::taintOf(*subject.run);
    const std::vector<Caution> known =
        runCautions(subject.instant ? io::standingAt(*subject.run, *subject.instant) : io::standingOf(*subject.run));
    if (arguments.json()) {
        Json object = json();
        object["exports"] = files;
        object["tainted"] = taint.tainted();
        object["cautions"] = cautionsJson(known);
        object["warnings"] = findingsJson(findings);
        printJson(session, object);
    } else {
        tables(session.out());
        for (const std::string& path : files) {
            session.out() << path << '\n';
        }
        printFindings(session.out(), findings);
        printCautions(session.out(), known);
    }
    warnIfTainted(session, subject.path, taint);
}

}  // namespace rubble::cli
