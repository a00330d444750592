#include "io/validation/set_folder.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/scenario/parameters.h"
#include "core/validation/release.h"
#include "io/base/files.h"
#include "io/base/trimmed.h"
#include "io/case/terrain_reader.h"
#include "io/json/json_cursor.h"
#include "io/validation/set_table.h"

namespace rubble::io {

namespace {

namespace fs = std::filesystem;

constexpr const char* definitionName = "set.json";
/// m. A centre that was measured farther than this above or below the terrain, and than its body is large, lies elsewhere.
constexpr double farFromGround = 1.0;

nlohmann::json definitionAt(const std::string& path) {
    const std::optional<std::string> text = contentOf(path);
    if (!text) {
        failToRead(path);
    }
    return parseJson(*text, path);
}

bool exists(const std::string& folder, const std::string& name) {
    std::error_code ignored;
    return fs::is_regular_file(fs::path(folder) / name, ignored);
}

std::vector<std::string> foldersIn(const std::string& folder) {
    std::vector<std::string> found;
    std::error_code ignored;
    for (fs::directory_iterator it(folder, ignored), end; it != end; it.increment(ignored)) {
        if (it->is_directory(ignored)) {
            found.push_back(it->path().string());
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

/// Whether all tables that a definition names lie in a folder.
bool holdsTablesOf(const std::string& folder, const std::string& definition) {
    const nlohmann::json document = definitionAt(definition);
    const JsonCursor cursor(document, definition);
    bool all = exists(folder, cursor["table"].text());
    if (cursor.has("join")) {
        for (const JsonCursor& other : cursor["join"].elements()) {
            all = all && exists(folder, other["table"].text());
        }
    }
    return all;
}

std::optional<SetPlace> setAt(const std::string& folder) {
    const std::string id = fs::path(folder).lexically_normal().filename().string();
    if (exists(folder, definitionName)) {
        return SetPlace{id, folder, (fs::path(folder) / definitionName).string()};
    }
    for (const std::string& shipped : foldersIn(shippedSets())) {
        const std::string definition = (fs::path(shipped) / definitionName).string();
        if (exists(shipped, definitionName) && holdsTablesOf(folder, definition)) {
            return SetPlace{fs::path(shipped).filename().string(), folder, definition};
        }
    }
    return std::nullopt;
}

std::string firstLineOf(const std::string& text) {
    return std::string(trimmed(text.substr(0, text.find('\n'))));
}

/// Licence of a set: a file of that name, else what a description of the data says.
std::string licenceOf(const std::string& folder) {
    std::vector<std::string> names;
    std::error_code ignored;
    for (fs::directory_iterator it(folder, ignored), end; it != end; it.increment(ignored)) {
        names.push_back(it->path().filename().string());
    }
    std::sort(names.begin(), names.end());
    for (const std::string& name : names) {
        std::string upper = name;
        std::transform(upper.begin(), upper.end(), upper.begin(),
                       [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
        if (upper.starts_with("LICENSE") || upper.starts_with("LICENCE") || upper.starts_with("COPYING")) {
            const std::string text = std::string(trimmed(contentOf((fs::path(folder) / name).string()).value_or("")));
            if (!text.empty()) {
                return firstLineOf(text);
            }
        }
    }
    for (const char* name : {"metadata.json", definitionName}) {
        const std::string path = (fs::path(folder) / name).string();
        if (exists(folder, name)) {
            const nlohmann::json document = definitionAt(path);
            for (const char* key : {"licence", "license"}) {
                if (document.is_object() && document.contains(key) && document[key].is_string() && !document[key].empty()) {
                    return document[key].get<std::string>();
                }
            }
        }
    }
    throw ParseError({"validation.no_licence", "The set {0} has no licence: nobody knows whether it may be used", {folder}},
                     {"validation.no_licence.remedy", "Put the licence of the data beside it, as a file LICENSE.", {}});
}

std::int64_t repeatsOf(const JsonCursor& cursor) {
    const std::int64_t repeats = cursor.integer();
    if (repeats < 1 || repeats > mostSetRepeats) {
        cursor.fail("a number of repeats, 1 to " + englishInteger(mostSetRepeats));
    }
    return repeats;
}

std::vector<SetVariant> variantsOf(const JsonCursor& list) {
    std::vector<SetVariant> variants;
    for (const JsonCursor& item : list.elements()) {
        item.allowOnly({"name", "words", "parameters", "varied", "fitted", "repeats"});
        SetVariant variant{item["name"].text(), item["words"].text(), {}};
        for (const JsonCursor& parameter : item["parameters"].elements()) {
            parameter.allowOnly({"key", "value", "source"});
            variant.parameters.push_back({parameter["key"].text(), parameter["value"].text(), parameter["source"].text()});
            Scenario unused;
            setParameterText(unused, variant.parameters.back().key, variant.parameters.back().value);
        }
        if (item.has("varied")) {
            for (const JsonCursor& varied : item["varied"].elements()) {
                varied.allowOnly({"key", "distribution", "source"});
                variant.varied.push_back(
                    {variationFrom(varied["key"].text(), varied["distribution"].text()), varied["source"].text()});
            }
        }
        if (item.has("fitted")) {
            for (const JsonCursor& fitted : item["fitted"].elements()) {
                fitted.allowOnly({"key", "low", "high"});
                variant.fitted.push_back({fitted["key"].text(), fitted["low"].number(), fitted["high"].number()});
                findParameter(variant.fitted.back().key);
            }
        }
        if (item.has("repeats")) {
            variant.repeats = repeatsOf(item["repeats"]);
        }
        variants.push_back(std::move(variant));
    }
    if (variants.empty()) {
        list.fail("a variant");
    }
    return variants;
}

std::vector<SetCriterion> criteriaOf(const JsonCursor& list) {
    std::vector<SetCriterion> criteria;
    for (const JsonCursor& item : list.elements()) {
        item.allowOnly({"variant", "figure", "low", "high", "below"});
        SetCriterion criterion;
        criterion.variant = item["variant"].text();
        criterion.figure = item["figure"].text();
        if (item.has("low")) {
            criterion.low = item["low"].number();
        }
        if (item.has("high")) {
            criterion.high = item["high"].number();
        }
        if (item.has("below")) {
            criterion.below = item["below"].text();
        }
        criteria.push_back(std::move(criterion));
    }
    return criteria;
}

/// Reads one set, part by part.
class SetReading {
public:
    SetReading(const SetPlace& place, const Execution& execution)
        : m_place(place),
          m_execution(execution),
          m_document(definitionAt(place.definition)),
          m_definition(m_document, place.definition) {}

    ValidationSet read() {
        m_definition.allowOnly({"title", "source", "licence", "table", "join", "columns", "constants", "terrain", "turned",
                                "lifted", "repeats", "variants", "criteria"});
        m_set.id = m_place.id;
        m_set.folder = m_place.folder;
        m_set.title = m_definition["title"].text();
        m_set.source = m_definition["source"].text();
        m_set.licence = licenceOf(m_place.folder);
        noteReadme();
        m_set.turned = m_definition.has("turned") && m_definition["turned"].flag();
        takeTable();
        m_set.lifted = m_definition.has("lifted") && m_definition["lifted"].flag();
        m_set.repeats = m_definition.has("repeats") ? repeatsOf(m_definition["repeats"]) : 1;
        m_set.variants = variantsOf(m_definition["variants"]);
        if (m_definition.has("criteria")) {
            m_set.criteria = criteriaOf(m_definition["criteria"]);
        }
        takeTerrain();
        checkPlaces();
        return std::move(m_set);
    }

private:
    void noteReadme() {
        if (!exists(m_place.folder, "README.md")) {
            m_set.findings.add({"validation.no_readme", "the set has no README.md that says where it comes from", {}},
                               {"validation.no_readme.remedy", "write one: source, how it was measured, what a row is", {}},
                               m_place.folder);
        }
    }

    void takeTable() {
        BodyTable table = bodyTableOf(joinedTable(m_definition, m_place.folder));
        m_set.bodies = std::move(table.bodies);
        m_set.measured = std::move(table.measured);
        m_lines = std::move(table.lines);
        takeFindings(table);
        if (!m_set.measured.front().place) {
            m_definition.refuse("there is no column measured_x_m, so nothing can be compared",
                                "Name the columns of the measured places under columns.");
        }
    }

    /// Orientations that are drawn do not lie along the axes.
    void takeFindings(const BodyTable& table) {
        for (const Finding& finding : table.findings.list()) {
            if (!m_set.turned || finding.what.id != "bodies.along_axes") {
                m_set.findings.add(finding.what, finding.remedy, finding.example, finding.count);
            }
        }
        if (m_set.turned) {
            const auto count = static_cast<std::int64_t>(m_set.bodies.size());
            m_set.findings.add({"validation.turned",
                                "orientations of {0} bodies were not measured: they are drawn at random, anew in every repeat",
                                {count}},
                               {"validation.turned.remedy", "none is needed; more repeats narrow what comes of it", {}},
                               m_place.folder, count);
        }
    }

    void takeTerrain() {
        if (!m_definition.has("terrain")) {
            return;
        }
        Aabb around;
        for (std::size_t i = 0; i < m_set.bodies.size(); ++i) {
            around.extend(m_set.bodies[i].pose.position);
            around.extend(*m_set.measured[i].place);
        }
        m_terrainPath = (fs::path(m_place.folder) / m_definition["terrain"].text()).string();
        TerrainInput input = openTerrain(m_terrainPath, Frame(), around, m_execution);
        m_set.terrain = input.grid;
        m_set.findings.append(input.findings);
    }

    std::string nameOf(std::size_t body) const { return m_set.bodies[body].id + " (line " + std::to_string(m_lines[body]) + ")"; }

    void checkPlaces() {
        const SiteSurface surface{true, 0.0, m_set.terrain};
        const ReleaseCheck check = checkRelease(m_set.bodies, surface);
        if (check.outside.count > 0) {
            throw ParseError(
                {"drop.outside",
                 "{0}: {1} bodies begin where the terrain {2} has no heights; one is {3}",
                 {m_place.folder, check.outside.count, m_terrainPath, nameOf(check.outside.worst)}},
                {"drop.outside.remedy", "Give a terrain that covers them, in the same coordinates, or correct their x and y.", {}});
        }
        if (check.below.count > 0 && !m_set.lifted) {
            throw ParseError({"drop.below",
                              "{0}: {1} bodies begin with their centre below the surface, {2} by {3}",
                              {m_place.folder, check.below.count, nameOf(check.below.worst), {check.below.measure, "m"}}},
                             {"validation.below.remedy",
                              "Correct z, or the datum of one of the two, or write \"lifted\": true into set.json.",
                              {}});
        }
        std::int64_t away = 0;
        std::size_t worst = 0;
        double most = 0.0;
        for (std::size_t i = 0; i < m_set.bodies.size(); ++i) {
            const double above = -surface.depth(*m_set.measured[i].place);
            const double size = m_set.bodies[i].sides.maxCoeff();
            if (std::abs(above) > std::max(farFromGround, size)) {
                ++away;
                if (std::abs(above) > std::abs(most)) {
                    most = above;
                    worst = i;
                }
            }
        }
        if (away > 0) {
            m_set.findings.add({"validation.far_from_ground",
                                "{0} measured places lie more than a metre from the surface, the farthest {1} above it",
                                {away, {most, "m"}}},
                               {"validation.far_from_ground.remedy",
                                "look at heights and datum of the table and the terrain; falls hold that difference too",
                                {}},
                               nameOf(worst), away);
        }
    }

    const SetPlace& m_place;
    const Execution& m_execution;
    nlohmann::json m_document;
    JsonCursor m_definition;
    std::vector<std::size_t> m_lines;
    std::string m_terrainPath;
    ValidationSet m_set;
};

}  // namespace

std::string shippedSets() {
    std::error_code failed;
    const fs::path own = fs::read_symlink("/proc/self/exe", failed);
    return (own.parent_path() / ".." / "share" / "rubble" / "validation").lexically_normal().string();
}

std::vector<SetPlace> setsIn(const std::string& folder) {
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored)) {
        throw WorldError({"validation.no_folder", "There is no folder {0}", {folder}},
                         {"validation.no_folder.remedy", "Name the folder of a set, or one that holds such folders.", {}});
    }
    if (const auto own = setAt(folder)) {
        return {*own};
    }
    std::vector<SetPlace> sets;
    for (const std::string& inner : foldersIn(folder)) {
        if (const auto set = setAt(inner)) {
            sets.push_back(*set);
        }
    }
    if (sets.empty()) {
        throw UsageError({"validation.no_set", "{0} holds no set of measured falls", {folder}},
                         {"validation.no_set.remedy",
                          "A set is a folder with README.md, LICENSE, a table, and set.json that says what its columns mean; the "
                          "manual has an example.",
                          {}});
    }
    return sets;
}

ValidationSet readSet(const SetPlace& place, const Execution& execution) {
    return SetReading(place, execution).read();
}

}  // namespace rubble::io
