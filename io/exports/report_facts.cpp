#include "io/exports/report_facts.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "core/analysis/accuracy/accuracy_study.h"
#include "core/analysis/debris/collapse_plan.h"
#include "core/base/build.h"
#include "core/base/error.h"
#include "core/evidence/ensembles/probability_map.h"
#include "core/evidence/evidence_list.h"
#include "core/evidence/no_evidence.h"
#include "core/evidence/surveys/stated_survey.h"
#include "core/fe/components.h"
#include "core/scenario/case_lookup.h"
#include "core/scenario/differences.h"
#include "io/base/files.h"
#include "io/base/machine.h"
#include "io/case/case_file.h"
#include "io/case/terrain_reader.h"
#include "io/exports/compared_causes.h"
#include "io/exports/own_words.h"
#include "io/exports/survey_files.h"
#include "io/fe/fe_reader.h"
#include "io/json/run_behind.h"
#include "io/run/acknowledgements.h"
#include "io/run/run_cautions.h"
#include "io/run/settled_files.h"
#include "io/run/study_files.h"
#include "io/site/input_files.h"
#include "io/site/photograph_file.h"
#include "io/site/site_place.h"
#include "io/site/survey_file.h"
#include "io/site/surveys/evidence_origin.h"
#include "io/validation/kept_validation.h"

namespace rubble::io {

namespace {

namespace fs = std::filesystem;

constexpr int photographSide = 1400;  // px, the longest of a photograph in a report
constexpr std::array<std::pair<InputRole, std::string_view>, 4> evidenceRoles{{{InputRole::Photograph, "photograph"},
                                                                               {InputRole::Survey, "survey"},
                                                                               {InputRole::Orthophoto, "orthophoto"},
                                                                               {InputRole::Surroundings, "surroundings"}}};

const CaseScenario* scenarioOf(const ReportRequest& request) {
    if (request.theCase == nullptr) {
        return nullptr;
    }
    const std::string& id = request.scenarioId;
    if (const CaseScenario* found = findScenario(*request.theCase, id.empty() ? std::nullopt : std::optional(id))) {
        return found;
    }
    throw UsageError({"report.no_scenario", "The case has no scenario \"{0}\"", {id}},
                     {"report.no_scenario.remedy", "Name one of its scenarios.", {}});
}

std::string settingText(const SharedDifference& difference, const ParameterValue& value) {
    return difference.key() + " = " + valueText(value);
}

void addStaleFile(std::vector<Message>& stale, const std::string& what, const std::string& path, const std::string& recorded,
                  const std::string& found) {
    if (recorded != found) {
        stale.push_back({"report.stale_input",
                         "the {0} {1} has the SHA-256 {2} now, the run was made from {3}",
                         {what, path, found, recorded}});
    }
}

/// Settings in which the case departs from what was run.
void addStaleSettings(std::vector<Message>& stale, const ReportRequest& request) {
    const CaseScenario* scenario = scenarioOf(request);
    if (scenario == nullptr) {
        return;
    }
    const Scenario& ran = request.run->origin().scenario;
    for (const SharedDifference& difference : sharedDifferences(differencesBetween(ran, scenario->scenario))) {
        stale.push_back({"report.stale_setting",
                         "the run has {0}, the case {1}",
                         {settingText(difference, difference.change.first), settingText(difference, difference.change.second)}});
    }
    if (!(ran.regrouping == scenario->scenario.regrouping)) {
        stale.push_back({"report.stale_regrouping", "the case regroups its components in another way than the run", {}});
    }
    if (const CaseInput* input = findFeInput(*request.theCase, *scenario); input != nullptr && !input->sha256.empty()) {
        addStaleFile(stale, "FE result of the case", input->path, request.run->origin().feSha256, input->sha256);
    }
}

std::vector<CaseInput> filesOfCase(const Case& theCase, const std::string& basePath, InputRole role) {
    std::vector<CaseInput> files;
    for (CaseInput input : theCase.inputs) {
        if (input.role == role) {
            input.path = inputPath(basePath, input);
            files.push_back(std::move(input));
        }
    }
    return files;
}

std::vector<CaseInput> evidenceFiles(const ReportRequest& request, InputRole role) {
    return request.theCase != nullptr ? filesOfCase(*request.theCase, request.basePath, role) : std::vector<CaseInput>();
}

/// Photographs, surveys and surroundings that are other files now than when the case was saved.
void addStaleEvidence(std::vector<Message>& stale, const ReportRequest& request, const Execution& execution) {
    for (const auto& [role, name] : evidenceRoles) {
        for (const CaseInput& input : evidenceFiles(request, role)) {
            const InputDigest found = digestOfInput(input.path, role, execution);
            if (!input.sha256.empty() && !found.is(input.sha256)) {
                stale.push_back({"report.stale_evidence",
                                 "the {0} {1} has the SHA-256 {2} now, the case names {3}",
                                 {name, input.path, found.sha256, input.sha256}});
            }
        }
    }
}

DebrisFigures figuresAt(const ReportFacts& facts, const ReportRequest& request, DebrisInstant instant) {
    const double time = instant == DebrisInstant::AtRest ? facts.result->endTime : facts.result->feEndTime;
    const MappedRun mapped{facts.fe.get(), request.run.get(), facts.fragments, facts.result, facts.terrain, facts.scenario};
    return measureDebris(debrisAt(*facts.fragments, *facts.components, *request.run, time),
                         CollapsePlan(*facts.fragments, facts.fe->mesh()), groundOf(mapped), {})
        .figures;
}

/// Runs what may fail for one piece of evidence; the report says why it did.
template <class Attempt>
void attempt(Message& problem, Attempt attempt) {
    try {
        attempt();
    } catch (const Cancelled&) {
        throw;
    } catch (const Error& error) {
        problem = error.message();
    }
}

void addSurveys(ReportFacts& facts, const ReportRequest& request, const Execution& execution) {
    const MappedRun mapped{facts.fe.get(), request.run.get(), facts.fragments, facts.result, facts.terrain, facts.scenario};
    for (const CaseInput& input : evidenceFiles(request, InputRole::Survey)) {
        ReportSurvey survey;
        survey.name = fs::path(input.path).filename().string();
        attempt(survey.problem, [&] {
            const SurveyRequest wanted = surveyRequest(request.run->origin(), input, request.terrainPath);
            checkHasOverlap(input);
            Site site = request.theCase->site;
            site.groundClasses = request.run->origin().site.groundClasses;
            const SiteWindow window(boundsAtRest(facts.fe->mesh()), debrisBounds(mapped, input.instant));
            const SurveyInput read = readSurvey(input.path, request.inputs.frame, site, window, execution, wanted);
            SurveySettings settings = surveySettingsOf(*request.theCase);
            takeStated(settings, *request.theCase, input, facts.findings);
            settings.turn = SitePlace(read.frame, read.site).transform().angle;
            survey.comparison = compareRunWithSurvey(mapped, input.instant, read.survey, settings, execution);
            Findings told = read.findings;
            told.append(survey.comparison->findings);
            survey.cautions = evidenceCautions(told);
            // That it is no evidence stands beside it by its name.
            facts.findings.append(otherThanNoEvidence(read.findings));
            facts.findings.append(survey.comparison->findings);
        });
        facts.surveys.push_back(std::move(survey));
    }
}

/// A large file is left in the middle where the report is given up.
std::string digestOf(const std::string& path, const Execution& execution) {
    return sha256OfFile(path, [&execution](std::size_t) { execution.check(); });
}

void addFiles(ReportFacts& facts, const ReportRequest& request, const Execution& execution) {
    const RunOrigin& origin = request.run->origin();
    facts.files.push_back({"fe", request.fePath, origin.feSha256});
    if (!origin.terrainPath.empty()) {
        facts.files.push_back({"terrain", request.terrainPath, origin.terrainSha256});
    }
    for (const auto& [role, name] : evidenceRoles) {
        for (const CaseInput& input : evidenceFiles(request, role)) {
            facts.files.push_back(
                {std::string(name), input.path, digestOfInput(input.path, role, execution).against(input.sha256)});
        }
    }
    if (request.run->kept()) {
        facts.files.push_back({"run", request.run->path(), digestOf(request.run->path(), execution)});
    }
    if (!request.casePath.empty()) {
        facts.files.push_back({"case", request.casePath, digestOf(request.casePath, execution)});
    }
}

ReportPlace placeOf(const RunOrigin& origin) {
    ReportPlace place;
    const SitePlace lies(origin.frame, origin.site);
    place.named = origin.frame.crs;
    place.system = lies.system();
    place.fit = lies.transform();
    place.points = origin.site.controlPoints;
    place.terrain = fs::path(origin.terrainPath).filename().string();
    for (const RecordedInput& mesh : origin.surroundings) {
        place.meshes.push_back({fs::path(mesh.path).filename().string(), mesh.offset});
    }
    return place;
}

/// The reference of the scene and those of its repeats that a sweep has kept; nothing is simulated.
std::optional<RepeatFloor> keptReference(const ReportRequest& request, const ReportFacts& facts, StudyFiles& files,
                                         const Execution& execution) {
    constexpr int repeatsMost = 16;
    AccuracyOptions options;
    options.study.repeats = repeatsMost;
    options.machine = facts.machine;
    options.store = &files;
    options.choice = WorldChoice::none();
    AccuracyReport kept = accuracyStudy(request.inputs, facts.scenario, {}, options, execution);
    execution.check();
    return std::move(kept.floor);
}

void addAccuracy(ReportFacts& facts, const ReportRequest& request, const Execution& execution) {
    if (request.studyFolder.empty()) {
        return;
    }
    const WorldOrigin reference = originOf(request.inputs, referenceScenario(facts.scenario), 0, 0.0, facts.machine);
    Findings ignored;
    StudyFiles files(request.studyFolder);
    facts.points = files.points(sceneDigest(reference, DebrisInstant::AtRest), ignored);
    if (!facts.points.empty()) {
        facts.reference = keptReference(request, facts, files, execution);
    }
    std::sort(facts.points.begin(), facts.points.end(), [](const KnownPoint& a, const KnownPoint& b) {
        return a.bodies != b.bodies ? a.bodies < b.bodies : a.setting < b.setting;
    });
}

/// The members of the ensemble of the case that were simulated from what the run was made of.
void addEnsemble(ReportFacts& facts, const ReportRequest& request, const Execution& execution) {
    if (request.theCase == nullptr || request.studyFolder.empty()) {
        return;
    }
    EnsembleSettings settings = request.theCase->ensemble;
    // A report is of one scenario.
    std::erase_if(settings.varied, [](const VariedSetting& varied) { return varied.key == scenarioKey; });
    const std::vector<EnsembleScene> scenes{{{}, facts.scenarioName, request.inputs, facts.scenario}};
    SettledFiles files(request.studyFolder);
    EnsembleOptions options;
    options.machine = facts.machine;
    options.store = &files;
    options.choice = WorldChoice::none();
    auto report = std::make_shared<EnsembleReport>(ensembleStudy(scenes, settings, options, execution));
    execution.check();
    if (!report->done().empty()) {
        facts.probability = std::make_shared<const DebrisMap>(probabilityMap(*report, usualThresholds));
        facts.ensemble = std::move(report);
    }
}

ReportFacts identityOf(const ReportRequest& request) {
    const RunOrigin& origin = request.run->origin();
    ReportFacts facts;
    facts.question = request.question;
    facts.author = request.author;
    facts.words = request.wordsPath.empty() ? request.words : readOwnWords(request.wordsPath);
    facts.when = utcNow();
    facts.machine = machineText();
    facts.casePath = request.casePath;
    facts.runKept = request.run->kept();
    facts.fingerprint = origin.fingerprint.hex();
    facts.build = origin.build;
    facts.place = placeOf(origin);
    facts.scenario = origin.scenario;
    facts.scenarioName = origin.scenarioName;
    if (const CaseScenario* scenario = scenarioOf(request)) {
        facts.scenarioName = scenario->name;
        facts.scenarioNote = scenario->note;
        facts.journal = request.theCase->journal.entries;
    }
    facts.title = !request.title.empty()       ? request.title
                  : request.theCase != nullptr ? request.theCase->title
                                               : fs::path(origin.fePath).stem().string();
    return facts;
}

}  // namespace

std::vector<ReportPhoto> photographsOfCase(const MappedRun& run, const Case& theCase, const std::string& basePath,
                                           const RunStanding& standing, const Execution& execution) {
    std::vector<ReportPhoto> photographs;
    for (const CaseInput& input : filesOfCase(theCase, basePath, InputRole::Photograph)) {
        const std::vector<Photograph>& all = theCase.photographs;
        const auto drawn = std::find_if(all.begin(), all.end(), [&](const Photograph& each) { return each.input == input.id; });
        if (drawn == all.end()) {
            continue;
        }
        ReportPhoto photo;
        photo.name = fs::path(input.path).filename().string();
        photo.photograph = *drawn;
        attempt(photo.problem, [&] {
            PhotoPicture picture = readPicture(input.path, photographSide, execution);
            photo.width = picture.width;
            photo.height = picture.height;
            photo.rgb = std::move(picture.rgb);
            photo.match = matchPhotograph(*drawn, execution);
            photo.comparison = compareRunWithPhoto(run, *drawn, *photo.match, photographSettingsOf(theCase), execution);
        });
        photo.cautions = photographCautions(*drawn, photo.match ? &*photo.match : nullptr, &standing);
        Findings origin;
        noteOrigin(origin, photo.name, photographOriginOf(input.path), {});
        addCautions(photo.cautions, evidenceCautions(origin));
        photographs.push_back(std::move(photo));
    }
    return photographs;
}

std::vector<Message> staleParts(const ReportRequest& request, const Execution& execution) {
    std::vector<Message> stale;
    const RunOrigin& origin = request.run->origin();
    if (!request.run->complete() || request.run->result() == nullptr) {
        stale.push_back({"report.incomplete", "the run is not complete: it ends after {0} frames", {request.run->frameCount()}});
        return stale;
    }
    try {
        checkRunDigest(request.run->path(), execution);
    } catch (const ParseError& error) {
        stale.push_back(error.message());
    }
    addStaleFile(stale, "FE result", request.fePath, origin.feSha256,
                 digestOfInput(request.fePath, InputRole::Fe, execution).sha256);
    if (!origin.terrainPath.empty()) {
        addStaleFile(stale, "terrain", request.terrainPath, origin.terrainSha256,
                     digestOfInput(request.terrainPath, InputRole::Terrain, execution).against(origin.terrainSha256));
    }
    addStaleSettings(stale, request);
    addStaleEvidence(stale, request, execution);
    // Of another build the fingerprint is another one in any case.
    const Digest now = stageKey(request.inputs, origin.scenario, Stage::Simulation);
    if (stale.empty() && origin.build == buildText() && !(now == origin.fingerprint)) {
        stale.push_back({"report.stale_fingerprint",
                         "the run's fingerprint is {0}, its inputs and settings now give {1}",
                         {origin.fingerprint.hex(), now.hex()}});
    }
    return stale;
}

ReportFacts reportFacts(const ReportRequest& request, const Execution& execution) {
    execution.report({"report.checking", "Checking that nothing is stale", {}}, 0.0);
    if (const std::vector<Message> stale = staleParts(request, execution); !stale.empty()) {
        std::string reasons;
        for (const Message& each : stale) {
            reasons += (reasons.empty() ? "" : "; ") + englishText(each);
        }
        throw UsageError(
            {"report.stale", "No report is made of {0}, which is stale: {1}", {request.run->path(), reasons}},
            {"report.stale.remedy", "Simulate again with the settings and inputs of now, or report the case as it was.", {}});
    }
    ReportFacts facts = identityOf(request);
    facts.fe = request.inputs.fe;
    facts.terrain = request.inputs.terrain;
    facts.components = std::make_shared<const Components>(
        groupComponents(facts.fe->mesh(), facts.scenario.regrouping, facts.scenario.components, facts.scenario.assumptions));
    facts.fragments = request.run->fragments();
    facts.clustering = request.run->clustering();
    facts.sizing = request.run->sizing();
    facts.result = request.run->result();
    facts.ledger = request.run->ledger();
    facts.findings = request.inputs.fe->contents().findings;
    facts.findings.append(request.siteFindings);
    facts.findings.append(request.run->findings());
    const Taint taint = taintOf(*request.run);
    facts.cautions = runCautions(standingOf(*request.run));
    facts.acknowledged = taint.acknowledgement;
    addFiles(facts, request, execution);
    if (!request.causesPath.empty()) {
        facts.causes = readComparedCauses(request.causesPath);
        facts.files.push_back({"causes", request.causesPath, sha256OfFile(request.causesPath)});
    } else if (request.causes) {
        facts.causes = request.causes;
        facts.files.insert(facts.files.end(), request.causesFiles.begin(), request.causesFiles.end());
    }
    if (!request.wordsPath.empty()) {
        facts.files.push_back({"words", request.wordsPath, sha256OfFile(request.wordsPath)});
    }
    execution.report({"report.measuring", "Measuring the debris", {}}, 0.1);
    facts.atRest = figuresAt(facts, request, DebrisInstant::AtRest);
    execution.check();
    facts.atFeEnd = figuresAt(facts, request, DebrisInstant::AtFeEnd);
    execution.check();
    const MappedRun mapped{facts.fe.get(), request.run.get(), facts.fragments, facts.result, facts.terrain, facts.scenario};
    facts.map = mapOfRun(mapped, std::nullopt, {}, true, execution);
    if (request.theCase != nullptr) {
        facts.photographs = photographsOfCase(mapped, *request.theCase, request.basePath, standingOf(*request.run), execution);
        for (const CaseInput& input : evidenceFiles(request, InputRole::Photograph)) {
            noteRunBehind(facts.findings, input.path, runWithin(input.path), request.run->origin().fingerprint.hex());
        }
    }
    addSurveys(facts, request, execution);
    addAccuracy(facts, request, execution);
    addEnsemble(facts, request, execution);
    if (!request.studyFolder.empty()) {
        facts.validation = keptValidations(request.studyFolder, facts.findings);
    }
    if (request.repeats > 0) {
        execution.report({"report.repeating", "Simulating the run again, and its repeats", {}}, 0.0);
        StudySettings settings;
        settings.repeats = request.repeats;
        facts.floor = repeatFloor(request.inputs, facts.scenario, settings, execution);
        facts.reproduced = facts.floor->trajectoryHash == facts.result->trajectoryHash;
    }
    return facts;
}

}  // namespace rubble::io
