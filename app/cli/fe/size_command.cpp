#include "app/cli/frame/commands.h"
#include "app/cli/frame/json_output.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/subject.h"
#include "app/cli/frame/text_output.h"
#include "core/analysis/accuracy/loose_beside.h"

namespace rubble::cli {

namespace {

Json besideJson(const std::optional<LooseAtOnce>& beside) {
    return beside ? Json{{"elements", beside->elements}, {"islands", beside->islands}, {"time_s", beside->time}} : Json();
}

ExitCode size(const Arguments& arguments, Session& session) {
    const io::OpenedCase subject = openSubject(arguments, session);
    checkCsvPath(arguments, subject.files);
    const Results results = runTo(subject, Stage::Sizing, nullptr, session.execution());
    const Sizing& sizing = *results.sizing;
    const Findings findings = io::allFindings(subject, results);
    const Mesh& mesh = subject.inputs.fe->mesh();
    const std::optional<LooseAtOnce> beside = looseBeside(subject.inputs, subject.scenario, session.execution());
    std::optional<Finding> caution;
    if (beside) {
        caution = looseBesideCaution(sizing.fpsTarget, *beside, mesh.elementCount());
    }
    writeCsv(arguments, boundsTable(sizing, *results.fragments, *results.components, mesh));
    if (arguments.json()) {
        Json object;
        object["fragments"] = sizing.fragments;
        addSizingJson(object, sizing);
        object["clusters"] = sizing.clusters;
        object["loose_beside"] = besideJson(beside);
        object["warnings"] = findingsJson(findings, caution);
        printJson(session, object);
    } else {
        session.out() << subject.fePath << ", scenario \"" << subject.scenarioName << "\"\n";
        printSizing(session.out(), sizing, *results.fragments, *results.components, mesh, caution);
        printFindings(session.out(), findings);
    }
    return ExitCode::Ok;
}

}  // namespace

Command sizeCommand() {
    return {"size",
            "FE|CASE",
            "bounds of the Basic Grid, the clusters counted, what stopped the search",
            "Makes the fragments and searches the Basic Grid: the box that decides which fragments move together. --set multiple=M "
            "sets the common multiple of the mean distance by hand.",
            {setOption(), scenarioOption(), cachedOption(), csvOption("write the table of bounds")},
            size};
}

}  // namespace rubble::cli
