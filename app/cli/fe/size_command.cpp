#include "app/cli/frame/commands.h"
#include "app/cli/frame/json_output.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/subject.h"
#include "app/cli/frame/text_output.h"

namespace rubble::cli {

namespace {

ExitCode size(const Arguments& arguments, Session& session) {
    const io::OpenedCase subject = openSubject(arguments, session);
    checkCsvPath(arguments, subject.files);
    const Results results = runTo(subject, Stage::Sizing, nullptr, session.execution());
    const Sizing& sizing = *results.sizing;
    const Findings findings = io::allFindings(subject, results);
    const Mesh& mesh = subject.inputs.fe->mesh();
    writeCsv(arguments, boundsTable(sizing, *results.fragments, *results.components, mesh));
    if (arguments.json()) {
        Json object;
        object["fragments"] = sizing.fragments;
        addSizingJson(object, sizing);
        object["clusters"] = sizing.clusters;
        object["warnings"] = findingsJson(findings);
        printJson(session, object);
    } else {
        session.out() << subject.fePath << ", scenario \"" << subject.scenarioName << "\"\n";
        printSizing(session.out(), sizing, *results.fragments, *results.components, mesh);
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
