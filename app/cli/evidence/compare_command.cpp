#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/cli/accuracy/study_place.h"
#include "app/cli/evidence/ensemble_output.h"
#include "app/cli/evidence/reached_places.h"
#include "app/cli/evidence/scope_options.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/ensemble_commands.h"
#include "app/cli/frame/option_value.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/text_output.h"
#include "core/base/error.h"
#include "core/evidence/ensembles/cause_comparison.h"
#include "core/evidence/ensembles/member_doubts.h"
#include "core/evidence/ensembles/telling_evidence.h"
#include "io/base/machine.h"
#include "io/case/case_file.h"
#include "io/exports/compared_causes.h"
#include "io/exports/ensemble_origin.h"
#include "io/run/settled_files.h"
#include "io/site/cause_evidence.h"
#include "io/site/clouds/height_source.h"
#include "io/site/input_files.h"

namespace rubble::cli {

namespace {

/// What --against names.
struct Against {
    std::vector<io::EvidenceFile> files;
    std::vector<TimeEvidence> times;
    bool photographs = false;
};

Against parseAgainst(const Arguments& arguments) {
    using Kind = io::EvidenceFile::Kind;
    Against against;
    for (const std::string& text : arguments.values("--against")) {
        if (text == "photographs") {
            against.photographs = true;
            continue;
        }
        const auto [keyword, path] = splitAssignment("--against", text);
        if (keyword == evidenceKindName(EvidenceKind::Time)) {
            against.times.push_back(parseTimeEvidence(path));
            continue;
        }
        const std::size_t before = against.files.size();
        for (const Kind kind : {Kind::Footprint, Kind::Heights, Kind::Surface}) {
            if (keyword == io::evidenceKeyword(kind)) {
                against.files.push_back({kind, path});
            }
        }
        if (against.files.size() == before) {
            throw wrongValue("--against", text, "footprint=FILE, height=FILE, surface=FILE, time=SECONDS,X,Y or photographs");
        }
    }
    return against;
}

/// The hypotheses of one site, opened.
struct Causes {
    std::vector<std::string> names;
    std::vector<EnsembleSubject> subjects;
};

/// The causes that the operands name: each one, or of a single case each of its scenarios.
std::vector<std::pair<std::string, std::optional<std::string>>> causesOf(const std::vector<std::string>& paths) {
    std::vector<std::pair<std::string, std::optional<std::string>>> list;
    for (const std::string& path : paths) {
        list.emplace_back(path, std::nullopt);
    }
    if (paths.size() == 1 && io::isCaseFile(paths.front())) {
        const Case theCase = io::loadCase(paths.front());
        if (theCase.scenarios.size() > 1) {
            list.clear();
            for (const CaseScenario& scenario : theCase.scenarios) {
                list.emplace_back(paths.front(), scenario.id);
            }
        }
    }
    return list;
}

Causes openCauses(const Arguments& arguments, const EnsembleRequest& request, Session& session) {
    Causes causes;
    for (const auto& [path, scenario] : causesOf(operandsOf(arguments))) {
        const EnsembleSubject* first = causes.subjects.empty() ? nullptr : &causes.subjects.front();
        const bool like = first != nullptr && io::isCaseFile(first->path);
        EnsembleSubject subject = openEnsembleSubject(path, scenario, arguments, request, session, like ? first : nullptr);
        io::joinCauses(subject, first, causes.names);
        causes.names.push_back(subject.name);
        causes.subjects.push_back(std::move(subject));
    }
    return causes;
}

CauseEvidence readEvidence(const Arguments& arguments, const EnsembleRequest& request, Causes& causes, Findings& findings,
                           Session& session) {
    const Against against = parseAgainst(arguments);
    CauseEvidence evidence;
    evidence.times = against.times;
    EnsembleSubject& first = causes.subjects.front();
    const EnsembleScene& scene = first.scenes.front();
    io::EvidenceSite site{first.frame, first.theCase.site, {true, scene.scenario.simulation.groundHeight, scene.inputs.terrain}};
    site.groundFile = io::evidenceGround(first);
    site.groundRead = first.terrainRead;
    const SurveyScope given = scopeFrom(arguments, first.frame, first.theCase.site, findings, session.execution());
    bool read = !arguments.has("--columns") && !arguments.has("--crs");
    for (const io::EvidenceFile& file : against.files) {
        CaseInput stated = io::statedOfFile(first.theCase, arguments.operand(), file.path, given, findings);
        CloudRequest asked = stated.read;
        takeCloudRequest(arguments, asked);
        if (!(asked == stated.read) && io::holdsCloud(file.path, asked)) {
            stated.read = asked;
            read = true;
        }
        evidence.surfaces.push_back(io::readEvidence(file, site, stated, request.surface(), findings, session.execution()));
        first.inputs.push_back(
            {"evidence", file.path, io::digestOfInput(file.path, InputRole::Survey, session.execution()).sha256});
    }
    if (!read && !against.files.empty()) {
        io::refuseRequestOfNoCloud(against.files.front().path);
    }
    if (against.photographs) {
        if (request.instant() != DebrisInstant::AtRest) {
            throw wrongValue("--against", "photographs",
                             "footprints or heights with --instant fe_end: photographs show debris at rest");
        }
        evidence.photographs = io::photographsAsEvidence(first.theCase, findings, session.execution());
        if (evidence.photographs.empty()) {
            throw UsageError(
                {"cli.no_usable_photographs", "{0} has no photograph at rest with an outline and a camera.", {arguments.operand()}},
                {"cli.no_usable_photographs.remedy", "Match and draw on one in the window, under Evidence.", {}});
        }
    }
    return evidence;
}

std::vector<Hypothesis> simulate(Causes& causes, const EnsembleRequest& request, const CauseEvidence& evidence, SettledStore& store,
                                 const WorldChoice& choice, Findings& findings, Session& session) {
    std::vector<Hypothesis> hypotheses;
    for (std::size_t h = 0; h < causes.subjects.size(); ++h) {
        EnsembleSubject& subject = causes.subjects[h];
        EnsembleOptions options = request.studyOptions(&store);
        options.choice = choice;
        if (!evidence.photographs.empty()) {
            options.look = [&](const MemberSite& site, const Execution& own) {
                return lookedAt(evidence, site, request.surface(), own);
            };
        }
        auto report =
            std::make_shared<EnsembleReport>(ensembleStudy(subject.scenes, subject.settings, options, session.execution()));
        session.execution().check();
        report->findings.append(subject.findings);
        hypotheses.push_back({causes.names[h], std::move(report)});
    }
    findings.append(findingsOfMembers(hypotheses));
    return hypotheses;
}

std::string percent(double share) {
    return englishNumber(std::round(1000.0 * share) / 10.0) + " %";
}

TextTable rankTable(const CauseComparison& made) {
    std::vector<TextTable::Column> columns{{"rank", "rank"},
                                           {"cause", "cause"},
                                           {"members", "members"},
                                           {"score", "score_p50"},
                                           {"5 %", "score_p05"},
                                           {"95 %", "score_p95"},
                                           {"closest over it", "superiority"},
                                           {"at least", "superiority_low"},
                                           {"", "told_apart"}};
    for (std::size_t e = 0; e < made.evidence.size(); ++e) {
        columns.push_back({made.evidence[e], "departure_" + std::to_string(e + 1)});
        columns.push_back({"±", "departure_" + std::to_string(e + 1) + "_deviation"});
    }
    TextTable table(std::move(columns));
    for (std::size_t r = 0; r < made.ranking.causes.size(); ++r) {
        const RankedCause& cause = made.ranking.causes[r];
        std::vector<Cell> row{integerCell(static_cast<std::int64_t>(r + 1)),
                              textCell(made.hypotheses[cause.hypothesis]),
                              integerCell(static_cast<std::int64_t>(cause.score.count)),
                              numberCell(cause.score.middle),
                              numberCell(cause.score.low),
                              numberCell(cause.score.high),
                              r == 0 ? textCell("") : numberCell(cause.bestOver.share),
                              r == 0 ? textCell("") : numberCell(cause.bestOver.low),
                              textCell(r == 0        ? "closest"
                                       : cause.apart ? "told apart"
                                                     : "not told apart")};
        for (const FigureSpread& spread : cause.departures) {
            row.push_back(numberCell(spread.mean));
            row.push_back(numberCell(spread.deviation));
        }
        table.add(std::move(row));
    }
    return table;
}

TextTable blindTable(const BlindTest& test, const std::vector<std::string>& names) {
    std::vector<TextTable::Column> columns{{"true cause", "true_cause"}};
    for (const std::string& name : names) {
        columns.push_back({"named " + name, "named_" + name});
    }
    columns.push_back({"not told apart", "undecided"});
    columns.push_back({"closest rightly", "closest_right"});
    if (!test.noticed.empty()) {
        columns.push_back({"noticed if left out", "noticed_left_out"});
    }
    TextTable table(std::move(columns));
    for (std::size_t h = 0; h < names.size(); ++h) {
        std::vector<Cell> row{textCell(names[h])};
        for (const std::int64_t count : test.named[h]) {
            row.push_back(integerCell(count));
        }
        row.push_back(integerCell(test.undecided[h]));
        row.push_back(integerCell(test.closest[h]));
        if (!test.noticed.empty()) {
            row.push_back(integerCell(test.noticed[h]));
        }
        table.add(std::move(row));
    }
    return table;
}

Json superiorityJson(const Superiority& superiority) {
    return {{"share", superiority.share}, {"low", superiority.low}, {"high", superiority.high}};
}

Json comparisonJson(const CauseComparison& made) {
    Json object;
    object["told_apart"] = made.ranking.decided();
    object["words"] = englishText(made.verdict);
    object["closest"] = made.hypotheses[made.ranking.causes.front().hypothesis];
    object["not_told_from"] = made.alike;
    object["evidence"] = Json::array();
    for (std::size_t e = 0; e < made.evidence.size(); ++e) {
        object["evidence"].push_back(
            {{"name", made.evidence[e]}, {"kind", evidenceKindName(made.kinds[e])}, {"scatter", made.ranking.scatter[e]}});
    }
    object["ranking"] = Json::array();
    for (std::size_t r = 0; r < made.ranking.causes.size(); ++r) {
        const RankedCause& cause = made.ranking.causes[r];
        Json row{{"cause", made.hypotheses[cause.hypothesis]}, {"score", spreadJson(cause.score)}};
        row["closest_over_it"] = r == 0 ? Json() : superiorityJson(cause.bestOver);
        row["told_apart"] = r == 0 ? Json() : Json(cause.apart);
        row["departures"] = Json::array();
        row["closest_over_it_by_evidence"] = Json::array();
        for (std::size_t e = 0; e < made.evidence.size(); ++e) {
            row["departures"].push_back(spreadJson(cause.departures[e]));
            row["closest_over_it_by_evidence"].push_back(r == 0 ? Json() : superiorityJson(cause.bestOverEvidence[e]));
        }
        object["ranking"].push_back(std::move(row));
    }
    object["telling_evidence"] = made.evidence[made.telling];
    object["telling_place"] = Json();
    if (made.place) {
        object["telling_place"] = {{"x_m", made.place->middle.x()}, {"y_m", made.place->middle.y()}, {"area_m2", made.place->area}};
    }
    object["fit"] = made.fit;
    object["unexplained"] = made.unexplained;
    return object;
}

Json blindJson(const BlindTest& test) {
    return {{"evidence", evidenceKindName(test.kind)},
            {"trials", test.trials()},
            {"right", test.right()},
            {"wrong", test.wrong()},
            {"named", test.named},
            {"undecided", test.undecided},
            {"closest_right", test.closest},
            {"noticed_left_out", test.noticed}};
}

/// Causes that are to be told apart: those that the evidence could not, or all.
std::optional<TellingEvidence> furtherEvidence(const std::vector<Hypothesis>& hypotheses,
                                               const std::optional<CauseComparison>& made, const CauseEvidence& atHand,
                                               const Causes& causes, const Arguments& arguments, Session& session) {
    if (!arguments.has("--which-evidence")) {
        return {};
    }
    std::vector<std::size_t> apart(hypotheses.size());
    std::iota(apart.begin(), apart.end(), std::size_t{0});
    if (made) {
        apart = notToldApart(*made);
    }
    const EnsembleScene& scene = causes.subjects.front().scenes.front();
    const SiteSurface ground{true, scene.scenario.simulation.groundHeight, scene.inputs.terrain};
    return tellingEvidence(hypotheses, atHand, apart, ground, session.execution());
}

Json blindShareJson(const BlindShare& named) {
    return {{"trials", named.trials},       {"right", named.right},           {"wrong", named.wrong},
            {"right_share", named.share()}, {"right_share_low", named.low()}, {"right_share_high", named.high()}};
}

Json tellingJson(const TellingEvidence& telling, const std::vector<std::string>& names) {
    Json object;
    object["causes"] = Json::array();
    for (const std::size_t cause : telling.causes) {
        object["causes"].push_back(names[cause]);
    }
    object["at_hand"] = telling.atHand.trials > 0 ? blindShareJson(telling.atHand) : Json();
    object["ranked"] = Json::array();
    for (const FurtherEvidence& each : telling.ranked) {
        Json row = blindShareJson(each.named);
        row["words"] = englishText(each.words());
        row["kind"] = evidenceKindName(each.kind);
        row["part_m"] =
            each.part ? Json{each.part->min().x(), each.part->min().y(), each.part->max().x(), each.part->max().y()} : Json();
        row["accuracy_s"] = each.kind == EvidenceKind::Time ? Json(each.accuracy) : Json();
        row["from_m"] = each.from ? Json{each.from->x(), each.from->y()} : Json();
        object["ranked"].push_back(std::move(row));
    }
    return object;
}

void printTelling(std::ostream& out, const TellingEvidence& telling, const std::vector<std::string>& names) {
    constexpr std::size_t shown = 12;
    std::string list;
    for (const std::size_t cause : telling.causes) {
        list += (list.empty() ? "" : ", ") + names[cause];
    }
    printHeading(out, "Which evidence would tell " + list + " apart");
    TextTable table(
        {{"evidence", "evidence"}, {"named rightly", "right"}, {"at least", "low"}, {"at most", "high"}, {"wrongly", "wrong"}});
    const auto add = [&](const std::string& name, const BlindShare& named) {
        const auto trials = static_cast<double>(std::max<std::int64_t>(named.trials, 1));
        table.add({textCell(name), textCell(percent(named.share())), textCell(percent(named.low())),
                   textCell(percent(named.high())), textCell(percent(static_cast<double>(named.wrong) / trials))});
    };
    if (telling.atHand.trials > 0) {
        add("what is at hand", telling.atHand);
    }
    for (std::size_t k = 0; k < std::min(shown, telling.ranked.size()); ++k) {
        add((telling.atHand.trials > 0 ? "and " : "") + englishText(telling.ranked[k].words()), telling.ranked[k].named);
    }
    table.print(out);
    out << "Each of " << englishInteger(telling.ranked.empty() ? 0 : telling.ranked.front().named.trials)
        << " members in turn was what happened, seen without error, a time to its accuracy. "
        << englishInteger(static_cast<std::int64_t>(telling.ranked.size()))
        << " pieces of evidence were tried; the first of many is flattered by chance.\n";
}

void printComparison(std::ostream& out, const CauseComparison& made) {
    printHeading(out, "Which cause");
    rankTable(made).print(out);
    out << englishText(made.verdict) << '\n';
    if (made.ranking.causes.size() > 1) {
        const Superiority& best = made.ranking.causes[1].bestOverEvidence[made.telling];
        FactList facts;
        facts.add("tells most",
                  made.evidence[made.telling] + ": the closest is closer in " + percent(best.share) + " of the pairs");
        if (made.place) {
            facts.add("where", "around x = " + englishNumber(made.place->middle.x()) + " m, y = " +
                                   englishNumber(made.place->middle.y()) + " m, " + englishNumber(made.place->area) + " m2");
        }
        facts.print(out);
    }
}

void printBlind(std::ostream& out, const BlindTest& test, const std::vector<std::string>& names) {
    printHeading(out, "Blind test, " + std::string(evidenceKindName(test.kind)) + ": each member in turn is what was observed");
    blindTable(test, names).print(out);
    out << englishInteger(test.right()) << " of " << englishInteger(test.trials()) << " named rightly, "
        << englishInteger(test.wrong()) << " wrongly, the rest not told apart\n";
}

/// Has the members of all causes made elsewhere, in one list or array.
std::optional<ExitCode> haveMade(const StudyPlace& place, const Causes& causes, const EnsembleRequest& request,
                                 io::SettledFiles& files, Session& session) {
    StudyPlace::Study study;
    study.store = files.worlds().folder();
    study.islands = true;
    study.kept = [&](const WorldOrigin& origin) { return files.keeps(origin); };
    for (std::size_t h = 0; h < causes.subjects.size(); ++h) {
        const EnsembleSubject& subject = causes.subjects[h];
        std::vector<StudyTask> tasks = tasksOf(subject, request, session.execution());
        study.files.insert(study.files.end(), subject.files.begin(), subject.files.end());
        for (StudyTask& task : tasks) {
            task.name = causes.names[h] + ", " + task.name;
            study.tasks.push_back(std::move(task));
        }
    }
    return place.haveMade(std::move(study), session);
}

/// Makes one world of whichever cause has it.
ExitCode makeSingle(const StudyPlace& place, const Causes& causes, const EnsembleRequest& request, io::SettledFiles& files,
                    Session& session) {
    EnsembleOptions options = request.studyOptions(&files);
    options.choice = place.choice();
    for (std::size_t h = 0; h < causes.subjects.size(); ++h) {
        const EnsembleSubject& subject = causes.subjects[h];
        try {
            const EnsembleReport report = ensembleStudy(subject.scenes, subject.settings, options, session.execution());
            return place.endSingle(files.worlds().folder(), true, {}, report.findings, session);
        } catch (const UsageError&) {
            // Another cause may have it.
            if (h + 1 == causes.subjects.size()) {
                throw;
            }
        }
    }
    return ExitCode::Failed;
}

ExitCode compare(const Arguments& arguments, Session& session) {
    const StudyPlace place(arguments);
    const EnsembleRequest request(arguments);
    const EnsembleMaps maps(arguments, {MapLayer::Separation});
    checkCsvPath(arguments, operandsOf(arguments));
    Findings findings;
    Causes causes = openCauses(arguments, request, session);
    io::SettledFiles files(arguments.value("--cache").value_or(io::cacheFolder()));
    if (place.single()) {
        return makeSingle(place, causes, request, files, session);
    }
    const CauseEvidence evidence = readEvidence(arguments, request, causes, findings, session);
    if (place.elsewhere()) {
        if (const auto ended = haveMade(place, causes, request, files, session)) {
            return *ended;
        }
    }
    const std::vector<Hypothesis> hypotheses = simulate(causes, request, evidence, files, place.choice(), findings, session);
    std::optional<CauseComparison> made;
    if (evidence.count() > 0) {
        made = compareCauses(hypotheses, evidence);
        findings.append(made->findings);
        writeCsv(arguments, rankTable(*made));
    }
    std::vector<BlindTest> blind;
    if (arguments.has("--blind") || !made) {
        for (const EvidenceKind kind : {EvidenceKind::Footprint, EvidenceKind::Heights}) {
            blind.push_back(blindTest(hypotheses, kind, session.execution()));
            findings.append(blind.back().findings);
        }
    }
    const std::optional<TellingEvidence> telling = furtherEvidence(hypotheses, made, evidence, causes, arguments, session);
    std::vector<std::string> written;
    if (made && made->separation) {
        io::EnsembleBasis all = causes.subjects.front().basis();
        for (std::size_t h = 1; h < causes.subjects.size(); ++h) {
            all.join(causes.subjects[h].basis());
        }
        written = maps.write(*made->separation, "separation", io::separationOrigin(hypotheses, *made->separation, all),
                             io::separationCautions(hypotheses, all), made->place, session);
    }
    if (arguments.json()) {
        Json object = made ? comparisonJson(*made) : Json::object();
        object["blind_tests"] = Json::array();
        for (const BlindTest& test : blind) {
            object["blind_tests"].push_back(blindJson(test));
        }
        object["further_evidence"] = telling ? tellingJson(*telling, causes.names) : Json();
        object["causes"] = causes.names;
        object["exports"] = written;
        object["warnings"] = findingsJson(findings);
        object["findings"] = io::findingsOfCauses(findings);
        printJson(session, object);
    } else {
        if (made) {
            printComparison(session.out(), *made);
        }
        for (const BlindTest& test : blind) {
            printBlind(session.out(), test, causes.names);
        }
        if (telling) {
            printTelling(session.out(), *telling, causes.names);
        }
        for (const std::string& path : written) {
            session.out() << path << '\n';
        }
        printFindings(session.out(), findings);
    }
    return ExitCode::Ok;
}

}  // namespace

Command compareCommand() {
    const std::vector<Option> own{
        {"--against", "KIND=FILE", true,
         "evidence: footprint=POLYGONS, height=RASTER above the ground, surface=RASTER or point cloud of the surface, "
         "time=SECONDS,X,Y[,RADIUS[,ACCURACY]] at which debris reached a place, or photographs of the first case"},
        columnsOption(),
        systemOption(),
        areaOption(),
        leaveOutOption(),
        {"--blind", "", false, "let each member in turn be what was observed, and say how often its cause is found"},
        {"--which-evidence", "", false,
         "rank further evidence by how often it would name the cause rightly, beside what is at hand"},
    };
    return {"compare",
            "FE|CASE...",
            "which cause: several hypotheses of one collapse, each with its ensemble, against the same evidence",
            "Ranks supposed causes of one collapse, several cases or FE results or the scenarios of one case, by how close their "
            "debris comes to footprints, surveyed heights, times and photographs, "
            "with their spread, or says that the evidence cannot tell them apart. Without --against it says how far footprints and "
            "heights could tell them apart at all.",
            joined({own,
                    EnsembleRequest::options(),
                    EnsembleMaps::options(),
                    StudyPlace::options(),
                    simulationOptions(),
                    {csvOption("write the ranking, one row for each cause")}}),
            compare};
}

}  // namespace rubble::cli
