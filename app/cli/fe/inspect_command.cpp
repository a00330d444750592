#include <algorithm>
#include <optional>

#include "app/cli/fe/component_origin.h"
#include "app/cli/fe/growth_watch.h"
#include "app/cli/fe/loose_output.h"
#include "app/cli/fe/missing_facts.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/json_output.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/subject.h"
#include "app/cli/frame/text_output.h"
#include "core/base/message.h"
#include "core/fe/audit.h"
#include "core/fe/unit_evidence.h"
#include "core/fragments/lifetimes.h"
#include "core/pipeline/loose_scene.h"
#include "core/scenario/case_lookup.h"

namespace rubble::cli {

namespace {

constexpr std::size_t deathRows = 16;
constexpr double barLength = 32.0;

/// Units and up axis that were taken, and those that the file fits.
struct UnitReport {
    Proposal units;
    Proposal upAxis;
};

UnitReport unitReport(const FeResult& fe, const Execution& execution) {
    const FeResult::Contents& contents = fe.contents();
    UnitEvidence found = evidenceOf(contents);
    addSeenFall(found, contents, execution);
    const UnitEvidence evidence = evidenceInFile(std::move(found), contents.units, contents.frame);
    return {proposeUnits(evidence), proposeUpAxis(evidence)};
}

Json proposalJson(const Proposal& proposal) {
    return {{"choice", proposal.choice.empty() ? Json() : Json(proposal.choice)}, {"reason", englishText(proposal.reason)}};
}

Json unitsJson(const FeResult::Contents& contents, const UnitReport& report) {
    Json object;
    const UnitSystem* system = systemOf(contents.units);
    object["system"] = system ? Json(system->id) : Json();
    object["metres"] = contents.units.metres;
    object["kilograms"] = contents.units.kilograms > 0.0 ? Json(contents.units.kilograms) : Json();
    object["seconds"] = contents.units.seconds;
    object["up_axis"] = contents.frame.upAxis;
    object["origin_m"] = {contents.frame.origin.x(), contents.frame.origin.y(), contents.frame.origin.z()};
    object["decided"] = contents.unitsFrom;
    object["fits"] = proposalJson(report.units);
    object["fits_up_axis"] = proposalJson(report.upAxis);
    return object;
}

std::string proposalText(const Proposal& proposal) {
    return (proposal.choice.empty() ? "cannot be told: " : proposal.choice + ": ") + englishText(proposal.reason);
}

/// What is loose at which state, by the rule that releases live structure at the end of the FE result.
struct LooseReport {
    LooseStructure structure;
    LooseAccount account;
};

LooseReport looseReport(const io::OpenedCase& subject, const Components& components, const Execution& execution) {
    const FeResult& fe = *subject.inputs.fe;
    const Activity activity = activityUnder(fe.activity(), subject.scenario.fragments.revival);
    LooseReport report{looseScene(subject.inputs, subject.scenario, execution), {}};
    report.account = accountOf(report.structure, fe, activity, components);
    return report;
}

/// What a component is made of, and who says so.
struct ComponentMaterial {
    std::string_view name;
    ComponentOrigin origin;
};

std::vector<ComponentMaterial> materialsOf(const io::OpenedCase& subject, const Components& components) {
    const std::vector<ComponentOrigin> origins = originsOf(components, subject.inputs.fe->mesh(), subject.scenario.components);
    std::vector<ComponentMaterial> materials;
    for (std::size_t c = 0; c < origins.size(); ++c) {
        materials.push_back({materialName(components.list[c].material), origins[c]});
    }
    return materials;
}

/// What the case says of its scenario: where densities come from belongs there. Empty: nothing, or no case.
std::string noteOf(const io::OpenedCase& subject) {
    const CaseScenario* scenario = findScenario(subject.theCase, subject.scenarioId);
    return scenario == nullptr ? std::string() : scenario->note;
}

/// All that is told of one result.
struct Inspection {
    Audit audit;
    std::vector<ComponentMaterial> materials;  ///< by component
    Findings findings;
    UnitReport units;
    LooseReport loose;
};

Json inspectionJson(const io::OpenedCase& subject, const Inspection& inspection) {
    const Audit& audit = inspection.audit;
    const FeResult& fe = *subject.inputs.fe;
    Json object;
    object["format"] = fe.contents().format;
    object["path"] = subject.fePath;
    object["sha256"] = fe.contents().sha256;
    object["files"] = fe.contents().files.size();
    object["bytes"] = fe.contents().bytes;
    object["index_s"] = fe.contents().indexSeconds;
    object["nodes"] = fe.mesh().nodeCount();
    object["elements"] = fe.mesh().elementCount();
    object["states"] = fe.stateCount();
    object["time_first_s"] = fe.times().front();
    object["time_last_s"] = fe.times().back();
    object["scenario"] = {{"name", subject.scenarioName}, {"note", noteOf(subject)}};
    object["components"] = Json::array();
    for (std::size_t c = 0; c < audit.components.size(); ++c) {
        const ComponentAudit& component = audit.components[c];
        const ComponentMaterial& material = inspection.materials[c];
        Json row;
        row["name"] = component.name;
        row["kind"] = component.kind;
        row["elements"] = component.elements;
        row["dead"] = component.dead;
        row["density_kg_m3"] = component.density;
        row["mass_kg"] = component.mass;
        row["dead_mass_kg"] = component.deadMass;
        row["density_from"] = material.origin.density;
        row["material"] = material.name;
        row["material_from"] = material.origin.material;
        object["components"].push_back(std::move(row));
    }
    object["mass_kg"] = audit.mass;
    object["dead_mass_kg"] = audit.deadMass;
    object["dead_total"] = audit.deadTotal;
    object["dead_per_state"] = audit.deadPerState;
    object["has_velocity"] = fe.contents().hasVelocity;
    object["has_death_time"] = !fe.contents().deathTime.empty();
    object["activity_from"] = fe.contents().activityFrom;
    object["units"] = unitsJson(fe.contents(), inspection.units);
    object["missing"] = Json::array();
    for (const MissingFact& fact : missingFacts(fe)) {
        object["missing"].push_back({{"what", fact.what}, {"elements", fact.count}, {"instead", fact.instead}});
    }
    object["anomalies"] = Json::array();
    for (const Anomaly& anomaly : audit.anomalies) {
        object["anomalies"].push_back({{"kind", anomaly.kind}, {"count", anomaly.count}, {"example", anomaly.example}});
    }
    object["loose"] = looseJson(inspection.loose.structure, inspection.loose.account, fe);
    object["warnings"] = findingsJson(inspection.findings);
    return object;
}

TextTable componentTable(const Inspection& inspection) {
    const Audit& audit = inspection.audit;
    TextTable table({{"component", "component"},
                     {"kind", "kind"},
                     {"elements", "elements"},
                     {"dead", "dead"},
                     {"density [kg/m3]", "density_kg_m3"},
                     {"mass [kg]", "mass_kg"},
                     {"dead mass [kg]", "dead_mass_kg"},
                     {"density by", "density_from"},
                     {"material", "material"},
                     {"by", "material_from"}});
    for (std::size_t c = 0; c < audit.components.size(); ++c) {
        const ComponentAudit& component = audit.components[c];
        const ComponentMaterial& material = inspection.materials[c];
        table.add({textCell(component.name), textCell(component.kind), integerCell(component.elements), integerCell(component.dead),
                   numberCell(component.density), numberCell(component.mass), numberCell(component.deadMass),
                   textCell(std::string(material.origin.density)), textCell(std::string(material.name)),
                   textCell(std::string(material.origin.material))});
    }
    return table;
}

/// Deaths over time in at most deathRows rows of equally many states.
TextTable deathTable(const FeResult& fe, const Audit& audit) {
    TextTable table({{"states", "states"}, {"to time [s]", "time_s"}, {"new", "new"}, {"dead", "dead"}, {"", "bar"}});
    const std::size_t states = audit.deadPerState.size();
    const std::size_t perRow = (states + deathRows - 1) / deathRows;
    std::vector<std::int64_t> births;
    for (std::size_t first = 0; first < states; first += perRow) {
        const std::size_t last = std::min(first + perRow, states) - 1;
        births.push_back(audit.deadPerState[last] - (first == 0 ? 0 : audit.deadPerState[first - 1]));
    }
    const std::int64_t most = births.empty() ? 0 : *std::max_element(births.begin(), births.end());
    for (std::size_t row = 0; row < births.size(); ++row) {
        const std::size_t first = row * perRow;
        const std::size_t last = std::min(first + perRow, states) - 1;
        const double share =
            most > 0 ? static_cast<double>(std::max<std::int64_t>(births[row], 0)) / static_cast<double>(most) : 0.0;
        table.add({textCell(std::to_string(first) + (last > first ? "-" + std::to_string(last) : "")), numberCell(fe.times()[last]),
                   integerCell(births[row]), integerCell(audit.deadPerState[last]),
                   textCell(std::string(static_cast<std::size_t>(share * barLength + 0.5), '#'))});
    }
    return table;
}

void printInspection(std::ostream& out, const io::OpenedCase& subject, const Inspection& inspection) {
    const Audit& audit = inspection.audit;
    const UnitReport& units = inspection.units;
    const FeResult& fe = *subject.inputs.fe;
    const auto whole = [](std::size_t number) { return englishInteger(static_cast<std::int64_t>(number)); };
    out << subject.fePath << '\n';
    FactList facts;
    facts.add("format", fe.contents().format);
    facts.add("SHA-256", fe.contents().sha256);
    facts.add("files", whole(fe.contents().files.size()) + ", " + englishInteger(static_cast<std::int64_t>(fe.contents().bytes)) +
                           " bytes; indexed in " + englishNumber(fe.contents().indexSeconds) + " s, one state takes about " +
                           englishInteger(static_cast<std::int64_t>(fe.contents().bytes / fe.stateCount())) + " bytes");
    facts.add("nodes, elements", whole(fe.mesh().nodeCount()) + ", " + whole(fe.mesh().elementCount()));
    facts.add("states", whole(fe.stateCount()) + ", from " + englishNumber(fe.times().front()) + " s to " +
                            englishNumber(fe.times().back()) + " s");
    facts.add("active flag", fe.contents().activityFrom);
    facts.add("velocities", fe.contents().hasVelocity ? "from the file" : "by differences of positions");
    facts.add("exact death times", fe.contents().deathTime.empty() ? "none" : "from the file");
    facts.add("units, up axis", fe.contents().unitsFrom);
    facts.add("units that fit", proposalText(units.units));
    facts.add("up axis that fits", proposalText(units.upAxis));
    facts.add("mass", tonnesText(audit.mass) + ", of which dead " + tonnesText(audit.deadMass));
    facts.print(out);

    printHeading(out, "Not in the file");
    for (const MissingFact& fact : missingFacts(fe)) {
        out << "  " << fact.what << (fact.count > 0 ? " of " + englishInteger(fact.count) + " elements" : "") << ": "
            << fact.instead << '\n';
    }
    printHeading(out, "Components");
    componentTable(inspection).print(out);
    if (const std::string note = noteOf(subject); !note.empty()) {
        out << "\nScenario \"" << subject.scenarioName << "\": " << note << '\n';
    }
    if (audit.deadTotal == 0) {
        out << "\nNo element is dead at the end: there are no fragments in this result.\n";
    } else {
        printHeading(out, "Deaths: " + englishInteger(audit.deadTotal) + " elements are dead at the end");
        deathTable(fe, audit).print(out);
    }
    printLoose(out, inspection.loose.structure, inspection.loose.account);
    if (audit.anomalies.empty()) {
        out << "\nNo anomalies.\n";
    } else {
        printHeading(out, "Anomalies");
        for (const Anomaly& anomaly : audit.anomalies) {
            out << "  " << englishInteger(anomaly.count) << " x  " << anomaly.kind << ", for example " << anomaly.example << '\n';
        }
    }
    printFindings(out, inspection.findings);
}

ExitCode inspect(const Arguments& arguments, Session& session) {
    const std::optional<double> pause = followPause(arguments);
    const io::OpenedCase subject = openSubject(arguments, session);
    checkCsvPath(arguments, subject.files);
    const Results results = runTo(subject, Stage::Components, nullptr, session.execution());
    const Execution& execution = session.execution();
    const Inspection inspection{auditDeaths(*subject.inputs.fe, *results.components, execution),
                                materialsOf(subject, *results.components), io::allFindings(subject, results),
                                unitReport(*subject.inputs.fe, execution), looseReport(subject, *results.components, execution)};
    writeCsv(arguments, componentTable(inspection));
    if (arguments.json()) {
        printJson(session, inspectionJson(subject, inspection));
    } else {
        printInspection(session.out(), subject, inspection);
    }
    if (pause) {
        followGrowth(subject, *pause, session);
    }
    return ExitCode::Ok;
}

}  // namespace

Command inspectCommand() {
    return {"inspect",
            "FE|CASE",
            "what is in the file, and an audit of every death",
            "Reads the mesh, the states and the active flag, and lists components, deaths over time, masses and anomalies with a "
            "place.",
            {setOption(),
             scenarioOption(),
             cachedOption(),
             {"--follow", "SECONDS", false, "look again this often and say what has come, until Ctrl-C"},
             csvOption("write the table of components")},
            inspect};
}

}  // namespace rubble::cli
