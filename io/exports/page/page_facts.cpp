#include "io/exports/page/page_facts.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>

#include "core/base/build.h"
#include "core/fe/north.h"
#include "core/scenario/differences.h"
#include "core/scenario/setting_names.h"
#include "core/simulation/health/passed_limits.h"
#include "core/simulation/run/acknowledgement.h"
#include "io/run/acknowledgements.h"
#include "io/run/run_cautions.h"
#include "io/site/site_place.h"

namespace rubble::io {

namespace {

using nlohmann::json;

/// Nodes of a terrain along one side that a page draws, at most.
constexpr std::size_t terrainSide = 240;

json numberOrNull(double number) {
    return std::isfinite(number) ? json(number) : json(nullptr);
}

class PageTexts {
public:
    explicit PageTexts(const PageExtras& extras) : m_chinese(extras.chinese) {}

    json operator()(const Message& message) const {
        if (message.empty()) {
            return nullptr;
        }
        // Whoever reads a page has neither files nor command line before him: settings have names.
        Message named = message;
        named.pattern = withSettingNames(message.pattern);
        const std::string english = englishText(named);
        return {{"en", english}, {"zh", m_chinese ? m_chinese(message) : english}};
    }
    /// A word of a table, such as the name of a setting.
    json word(std::string_view english) const { return (*this)({"page.word", std::string(english), {}}); }

private:
    std::function<std::string(const Message&)> m_chinese;
};

/// Switches and choices are words; numbers and texts stand as in the case.
json valueFact(const Parameter& row, const ParameterValue& value, const PageTexts& text) {
    if (std::holds_alternative<std::monostate>(value)) {
        return text.word("auto");
    }
    if (const auto* on = std::get_if<bool>(&value)) {
        return text.word(*on ? "on" : "off");
    }
    std::string words = valueText(value);
    if (row.kind != ParameterKind::Choice) {
        return {{"en", words}, {"zh", words}};
    }
    std::ranges::replace(words, '_', ' ');
    return text.word(words);
}

json healthFacts(const RunReader& run, const PageTexts& text) {
    const Taint taint = taintOf(run);
    const auto result = run.result();
    json facts = {{"tainted", taint.tainted()}, {"acknowledged", nullptr}, {"limits", json::array()}};
    if (taint.acknowledgement) {
        facts["acknowledged"] = {
            {"by", taint.acknowledgement->by}, {"when", taint.acknowledgement->when}, {"note", taint.acknowledgement->note}};
    }
    const std::vector<HealthBreach> breaches = result ? result->health.breaches : run.breaches();
    for (const PassedLimit& limit : passedLimits(breaches)) {
        const HealthBreach& breach = breaches[limit.worst];
        json times = json::array();
        for (const std::size_t i : limit.breaches) {
            times.push_back({breaches[i].from, breaches[i].to});
        }
        facts["limits"].push_back({{"check", text(healthCheckTitle(breach.check))},
                                   {"grade", healthGradeName(limit.grade)},
                                   {"gradeWord", text.word(healthGradeName(limit.grade))},
                                   {"times", times},
                                   {"what", text(breach.what)},
                                   {"why", text(gradeReason(breach))}});
    }
    if (result) {
        facts["energyGain"] = numberOrNull(result->energy.drift);
        facts["penetration"] = numberOrNull(result->health.penetrationSustained);
        facts["penetrationShare"] = numberOrNull(result->health.penetrationShare);
        facts["fastest"] = numberOrNull(result->health.fastestOverLimit);
        facts["farthest"] = numberOrNull(result->health.farthest);
    }
    return facts;
}

/// What must be known beside all figures of the page: what pictures of the run say as well.
json cautionFacts(const RunReader& run, const PageTexts& text) {
    json facts = json::array();
    for (const Caution& caution : runCautions(standingOf(run))) {
        if (caution.inPictures()) {
            facts.push_back({{"key", caution.key}, {"grade", healthGradeName(caution.grade)}, {"what", text(caution.what)}});
        }
    }
    return facts;
}

/// "run-out, Plate": the quantity is a word, its group a name.
json quantityName(const std::string& title, const PageTexts& text) {
    const std::size_t comma = title.find(", ");
    json name = text.word(title.substr(0, comma));
    if (comma != std::string::npos) {
        for (json& words : name) {
            words = words.get<std::string>() + title.substr(comma);
        }
    }
    return name;
}

json variantFacts(const ValidationRecord& record, const VariantRecord& variant, const PageTexts& text) {
    json quantities = json::array();
    for (const QuantityRecord& quantity : variant.quantities) {
        const SampleComparison& c = quantity.comparison;
        quantities.push_back({{"name", quantityName(quantity.title, text)},
                              {"unit", text.word(quantity.unit)},
                              {"measured", numberOrNull(c.measured.mean)},
                              {"simulated", numberOrNull(c.simulated.mean)},
                              {"error", numberOrNull(c.error.value)},
                              {"low", numberOrNull(c.error.low)},
                              {"high", numberOrNull(c.error.high)}});
    }
    return {{"set", text.word(record.title)},   {"variant", text.word(variant.name)},
            {"falls", variant.falls},           {"lost", variant.moving + variant.left + variant.lost},
            {"asked", variant.verdicts.size()}, {"holds", std::ranges::count(variant.verdicts, true, &VerdictRecord::within)},
            {"quantities", quantities}};
}

/// How the build that simulated fares against measured falls; null: nobody knows here.
json validationFacts(const RunReader& run, const PageExtras& extras, const PageTexts& text) {
    if (run.origin().build != buildText() || extras.validation.empty()) {
        return nullptr;
    }
    json facts = json::array();
    for (const ValidationRecord& record : extras.validation) {
        for (const VariantRecord& variant : record.variants) {
            facts.push_back(variantFacts(record, variant, text));
        }
    }
    return facts;
}

json outcomeFacts(const RunReader& run, const FeResult& fe) {
    double mass = 0.0;
    for (const Fragment& fragment : run.fragments()->list) {
        mass += fragment.mass;
    }
    json facts = {{"fragments", run.fragments()->size()},
                  {"fragmentMass", mass},
                  {"bodies", run.bodies().size() - run.islands().size()},
                  {"feStates", fe.stateCount()},
                  {"feEnd", fe.times().back()},
                  {"end", run.frameTime(run.frameCount() - 1)},
                  {"frames", run.frameCount()},
                  {"complete", run.complete()}};
    if (const auto result = run.result()) {
        facts["bodies"] = result->bodiesPeak;
        facts["atRest"] = result->asleepAtEnd;
        facts["stillMoving"] = result->stillMoving;
        facts["maxSpeed"] = result->maxSpeed;
        facts["massError"] = result->ledger.mass;
        facts["momentumError"] = result->ledger.momentum;
        facts["islands"] = result->carried.islands + result->islands.released;
    }
    return facts;
}

json chapterFacts(const RunReader& run, const FeResult& fe, const PageExtras& extras) {
    json chapters = json::array();
    const double end = run.frameTime(run.frameCount() - 1);
    chapters.push_back({{"time", fe.times().front()}, {"kind", "start"}});
    double firstBirth = end;
    for (const Fragment& fragment : run.fragments()->list) {
        firstBirth = std::min(firstBirth, fragment.birthTime);
    }
    chapters.push_back({{"time", firstBirth}, {"kind", "first"}});
    if (fe.times().back() <= end) {
        chapters.push_back({{"time", fe.times().back()}, {"kind", "feEnd"}});
    }
    chapters.push_back({{"time", end}, {"kind", "end"}});
    for (const Bookmark& bookmark : extras.theCase != nullptr ? extras.theCase->bookmarks : std::vector<Bookmark>()) {
        chapters.push_back({{"time", bookmark.time}, {"kind", "note"}, {"note", bookmark.note}});
        if (bookmark.time < fe.times().front() || bookmark.time > end) {
            chapters.back()["outside"] = true;
        }
    }
    std::stable_sort(chapters.begin(), chapters.end(),
                     [](const json& a, const json& b) { return a["time"].get<double>() < b["time"].get<double>(); });
    return chapters;
}

json fileFacts(const std::string& role, const std::string& path, const std::string& sha256) {
    // The other side has other folders.
    return {{"role", role}, {"name", std::filesystem::path(path).filename().string()}, {"sha256", sha256}};
}

json provenanceFacts(const RunReader& run, const PageExtras& extras, const PageTexts& text) {
    const RunOrigin& origin = run.origin();
    json files = json::array({fileFacts("fe", origin.fePath, origin.feSha256)});
    if (!origin.terrainPath.empty()) {
        files.push_back(fileFacts("terrain", origin.terrainPath, origin.terrainSha256));
    }
    for (const RecordedInput& mesh : origin.surroundings) {
        files.push_back(fileFacts("surroundings", mesh.path, mesh.sha256));
    }
    for (const CaseInput& input : extras.theCase != nullptr ? extras.theCase->inputs : std::vector<CaseInput>()) {
        if (input.role == InputRole::Photograph || input.role == InputRole::Survey) {
            files.push_back(fileFacts(input.role == InputRole::Survey ? "survey" : "photograph", input.path, input.sha256));
        }
    }
    json settings = json::array();
    for (const SharedDifference& difference : sharedDifferences(differencesBetween(Scenario{}, origin.scenario))) {
        const Parameter& row = *difference.change.row;
        settings.push_back({{"key", difference.key()},
                            {"label", text.word(row.label)},
                            {"delivered", valueFact(row, difference.change.first, text)},
                            {"run", valueFact(row, difference.change.second, text)},
                            {"unit", text.word(row.unit)}});
    }
    json facts = {{"files", files},
                  {"settings", settings},
                  {"runBuild", origin.build},
                  {"pageBuild", buildText()},
                  {"fingerprint", origin.fingerprint.hex()},
                  {"coordinates", text.word(SitePlace(origin.frame, origin.site).words())},
                  {"made", utcNow()}};
    if (const auto result = run.result()) {
        facts["trajectory"] = result->trajectoryHash.hex();
    }
    return facts;
}

/// Rad from y of the page's frame, clockwise.
json northFact(const RunOrigin& origin) {
    const std::optional<double> north = northOf(SitePlace(origin.frame, origin.site).transform(), origin.frame.crs);
    return north ? json(*north) : json();
}

json groundFacts(const RunReader& run, const PageExtras& extras) {
    const Scenario& scenario = run.origin().scenario;
    json facts = {{"height", scenario.simulation.groundHeight}, {"terrain", nullptr}, {"water", nullptr}};
    const auto result = run.result();
    const auto water = static_cast<std::size_t>(EffectKind::Water);
    const bool wet = result && water < result->effects.size() ? result->effects[water].decision.on
                                                              : scenario.effects.of(EffectKind::Water) != EffectSwitch::Off;
    if (wet && scenario.effects.waterLevel) {
        facts["water"] = *scenario.effects.waterLevel;
    }
    if (extras.terrain == nullptr) {
        return facts;
    }
    const TerrainGrid& terrain = *extras.terrain;
    const std::size_t stride = std::max<std::size_t>(1, (std::max(terrain.nx(), terrain.ny()) + terrainSide - 1) / terrainSide);
    json heights = json::array();
    const std::size_t nx = (terrain.nx() - 1) / stride + 1;
    const std::size_t ny = (terrain.ny() - 1) / stride + 1;
    for (std::size_t j = 0; j < ny; ++j) {
        for (std::size_t i = 0; i < nx; ++i) {
            heights.push_back(std::round(1000.0 * terrain.node(i * stride, j * stride)) / 1000.0);
        }
    }
    facts["terrain"] = {{"x0", terrain.x0()}, {"y0", terrain.y0()}, {"cell", terrain.cell() * static_cast<double>(stride)},
                        {"nx", nx},           {"ny", ny},           {"ownCell", terrain.cell()},
                        {"heights", heights}};
    return facts;
}

json findingFacts(const RunReader& run, const FeResult& fe, const Findings& site, const PageTexts& text) {
    Findings findings = fe.contents().findings;
    findings.append(site);
    findings.append(run.findings());
    json facts = json::array();
    for (const Finding& finding : findings.list()) {
        facts.push_back({{"what", text(finding.what)}, {"remedy", text(finding.remedy)}, {"count", finding.count}});
    }
    return facts;
}

bool hasGroundPicture(const PageExtras& extras) {
    return extras.orthophoto != nullptr && std::ranges::count(extras.pictures, PagePictureKind::Ground, &PagePicture::kind) > 0;
}

/// Files around the structure that the views of a page do not draw; `fallenOn`: debris may lie on some of them; `large`: a page
/// does not take as many triangles.
json aroundFacts(const RunReader& run, const PageExtras& extras, const PageScene& scene) {
    std::set<std::string> drawn, names;
    const auto nameOf = [](const std::string& path) { return std::filesystem::path(path).filename().string(); };
    for (const ShownFile& file : extras.around) {
        const bool seen = file.role == "orthophoto" ? hasGroundPicture(extras) : scene.siteTriangles > 0;
        (seen ? drawn : names).insert(nameOf(file.path));
    }
    bool fallenOn = false;
    for (const RecordedInput& mesh : run.origin().surroundings) {
        if (!drawn.contains(nameOf(mesh.path))) {
            names.insert(nameOf(mesh.path));
            fallenOn = true;
        }
    }
    return {{"names", names}, {"fallenOn", fallenOn}, {"large", scene.siteLeftOut}};
}

/// Where the picture of the ground lies, m, and the sides of its pixels on the page and in its file; null: there is none.
json groundPictureFacts(const PageExtras& extras) {
    if (!hasGroundPicture(extras)) {
        return nullptr;
    }
    const Orthophoto& photo = *extras.orthophoto;
    const double coarser = std::max(1.0, static_cast<double>(std::max(photo.width, photo.height)) / pageGroundPixels);
    return {{"x0", photo.x0},
            {"y0", photo.y0},
            {"width", photo.right() - photo.x0},
            {"height", photo.top() - photo.y0},
            {"pixel", coarser * photo.pixel},
            {"ownPixel", photo.pixel}};
}

/// How many the case has; null: there is no case.
json photographFact(const PageExtras& extras) {
    if (extras.theCase == nullptr) {
        return nullptr;
    }
    return std::ranges::count(extras.theCase->inputs, InputRole::Photograph, &CaseInput::role);
}

json mapFacts(const PageExtras& extras) {
    if (extras.map == nullptr) {
        return nullptr;
    }
    const MapLedger& ledger = extras.map->ledger;
    return {{"cell", extras.map->cell},
            {"fragments", ledger.fragments},
            {"mass", ledger.mass},
            {"area", ledger.footprintArea},
            {"liveMass", ledger.liveMass},
            {"liveElements", ledger.liveElements},
            {"liveThreshold", extras.map->liveThreshold}};
}

}  // namespace

json pageFacts(const RunReader& run, const FeResult& fe, const PageExtras& extras, const PageScene& scene) {
    const PageTexts text(extras);
    const RunOrigin& origin = run.origin();
    json facts;
    facts["title"] = extras.title.empty() ? std::filesystem::path(origin.fePath).stem().string() : extras.title;
    facts["scenario"] = origin.scenarioName;
    facts["program"] = "Rubble " + std::string(versionText());
    facts["outcome"] = outcomeFacts(run, fe);
    facts["health"] = healthFacts(run, text);
    facts["cautions"] = cautionFacts(run, text);
    facts["validation"] = validationFacts(run, extras, text);
    facts["findings"] = findingFacts(run, fe, extras.siteFindings, text);
    facts["chapters"] = chapterFacts(run, fe, extras);
    facts["provenance"] = provenanceFacts(run, extras, text);
    facts["ground"] = groundFacts(run, extras);
    facts["north"] = northFact(origin);
    facts["map"] = mapFacts(extras);
    facts["ground"]["picture"] = groundPictureFacts(extras);
    facts["around"] = aroundFacts(run, extras, scene);
    facts["photographs"] = photographFact(extras);
    facts["precision"] = {
        {"place", scene.placeError},           {"node", scene.nodeError},          {"nodeBetween", scene.nodeErrorBetween},
        {"statesKept", scene.statesKept},      {"statesThere", scene.statesThere}, {"site", scene.siteError},
        {"siteTriangles", scene.siteTriangles}};
    return facts;
}

}  // namespace rubble::io
