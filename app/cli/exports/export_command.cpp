#include "app/cli/exports/export_request.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/health_output.h"
#include "app/cli/frame/json_output.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/run_inputs.h"
#include "app/cli/frame/text_output.h"
#include "app/cli/frame/text_table.h"
#include "core/base/error.h"
#include "io/site/place_check.h"

namespace rubble::cli {

namespace {

void reportFiles(const Arguments& arguments, Session& session, const io::RunReader& run, const std::vector<std::string>& files) {
    if (!run.complete()) {
        session.err() << "rubble-cli: note: this run is not complete; it holds " << run.frameCount() << " frames\n";
    }
    const io::Taint taint = io::taintOf(run);
    warnIfTainted(session, arguments.operand(), taint);
    if (arguments.json()) {
        Json object;
        object["run"] = arguments.operand();
        object["complete"] = run.complete();
        object["frames"] = run.frameCount();
        object["exports"] = files;
        object["tainted"] = taint.tainted();
        object["cautions"] = cautionsOf(run);
        printJson(session, object);
        return;
    }
    for (const std::string& path : files) {
        session.out() << path << '\n';
    }
}

ExitCode listKinds(const Arguments& arguments, Session& session) {
    TextTable table({{"kind", "kind"}, {"files", "endings"}, {"content", "content"}, {"opened by", "readers"}});
    Json kinds = Json::array();
    for (const ExportKind& kind : exportKinds()) {
        table.add({textCell(std::string(kind.name)), textCell(std::string(kind.endings)), textCell(std::string(kind.content)),
                   textCell(std::string(kind.readers))});
        kinds.push_back({{"kind", kind.name}, {"endings", kind.endings}, {"content", kind.content}, {"readers", kind.readers}});
    }
    if (arguments.json()) {
        printJson(session, Json{{"kinds", std::move(kinds)}});
    } else {
        table.print(session.out());
    }
    return ExitCode::Ok;
}

ExitCode exportRun(const Arguments& arguments, Session& session) {
    if (arguments.has("--list")) {
        return listKinds(arguments, session);
    }
    const std::vector<std::string> inputs{arguments.operand()};
    const ExportRequest exports(arguments, inputs);
    if (exports.empty()) {
        throw UsageError({"cli.no_export", "Nothing was asked for.", {}},
                         {"cli.no_export.remedy", "Say what to write: --export KIND=PATH.", {}});
    }
    const std::shared_ptr<io::RunReader> run = io::openRun(arguments.operand());
    Inputs of;
    RunSurroundings around;
    if (exports.needsFe(*run)) {
        Findings site;
        of = openInputsOfRun(arguments.operand(), run->origin(), arguments, session, &site);
        printNotes(session, site);
        around = surroundingsOfRun(run->origin(), of, arguments, session);
        // What was found of the place and the terrain stands on a page as well.
        around.shown.findings.append(site);
    } else {
        printNotes(session, io::checkPlace(run->origin().frame, run->origin().site));
    }
    exports.perform(run, of, around, session);
    reportFiles(arguments, session, *run, exports.paths());
    return ExitCode::Ok;
}

ExitCode figure(const Arguments& arguments, Session& session) {
    const FigureRequest request(arguments);
    const std::optional<std::string> path = arguments.value("--out");
    if (!path) {
        throw UsageError({"cli.no_figure", "rubble-cli figure does not know where to write.", {}},
                         {"cli.no_figure.remedy", "Name the picture: --out F.png, F.svg or F.pdf.", {}});
    }
    FigureRequest::checkFormat("--out", *path);
    checkOutputPath(*path, std::vector<std::string>{arguments.operand()});
    const std::shared_ptr<io::RunReader> run = io::openRun(arguments.operand());
    const Inputs inputs = openInputsOfRun(run->origin(), arguments, session);
    request.write(*path, run, inputs, surroundingsOfRun(run->origin(), inputs, arguments, session), session.execution());
    reportFiles(arguments, session, *run, {*path});
    return ExitCode::Ok;
}

}  // namespace

Command exportCommand() {
    return {"export",
            "RUN",
            "tables, maps, figures, ParaView and glTF files of a run",
            "Writes files from a recorded run. The FE file is found by its path and SHA-256.",
            joined({{ExportRequest::option(),
                     {"--list", "", false, "print the kinds, and what opens them"},
                     caseOption(),
                     feOption(),
                     runTerrainOption()},
                    FigureRequest::options(),
                    MapRequest::options()}),
            exportRun};
}

Command figureCommand() {
    return {
        "figure",
        "RUN",
        "one figure of a run for print: PNG, SVG or PDF",
        "Draws the conventional FE view, the fragment view or both at one instant, or the arrangement of a published figure. The "
        "file carries what it was made from. Where no display answers, Xvfb is started for the purpose.",
        joined({{{"--out", "FILE", false, "the figure to write: .png, .svg or .pdf"}, caseOption(), feOption(), runTerrainOption()},
                FigureRequest::options()}),
        figure};
}

}  // namespace rubble::cli
