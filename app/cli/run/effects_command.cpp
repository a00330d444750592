#include "app/cli/frame/commands.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/subject.h"
#include "app/cli/frame/text_output.h"
#include "app/cli/run/effects_output.h"
#include "core/simulation/effects/held_islands.h"

namespace rubble::cli {

namespace {

ExitCode effects(const Arguments& arguments, Session& session) {
    const io::OpenedCase subject = openSubject(arguments, session);
    checkCsvPath(arguments, subject.files);
    const Results results = runTo(subject, Stage::Clusters, nullptr, session.execution());
    const EffectScene scene{*subject.inputs.fe,  *results.components,          *results.fragments,
                            *results.clustering, subject.inputs.terrain.get(), subject.scenario};
    const EffectDecisions decisions = decideEffects(scene);
    Findings findings = io::allFindings(subject, results);
    if (const std::optional<Finding> finding = notHeld(settledScenario(scene))) {
        findings.add(finding->what, finding->remedy);
    }
    writeCsv(arguments, effectsTable(decisions));
    if (arguments.json()) {
        Json object;
        object["fragments"] = results.fragments->size();
        object["clusters"] = results.clustering->list.size();
        object["effects"] = effectsJson(decisions);
        object["scenario"] = subject.scenarioName;
        object["fe"] = {{"path", subject.fePath}, {"sha256", subject.inputs.fe->contents().sha256}};
        object["warnings"] = findingsJson(findings);
        printJson(session, object);
    } else {
        session.out() << subject.fePath << ", scenario \"" << subject.scenarioName << "\"\n";
        printEffects(session.out(), decisions);
        printFindings(session.out(), findings);
    }
    return ExitCode::Ok;
}

}  // namespace

Command effectsCommand() {
    return {"effects",
            "FE|CASE",
            "every effect, on or off, and why",
            "Makes fragments and clusters and decides on every effect without simulating. --set water_level=2 gives water a level, "
            "--set air_drag=off takes an effect out whatever the test says.",
            joined({{scenarioOption()}, simulationOptions(), {csvOption("write the table of effects")}}),
            effects};
}

}  // namespace rubble::cli
