#include "app/cli/evidence/ensemble_output.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/cli/exports/map_request.h"
#include "app/cli/frame/option_value.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/picture_options.h"
#include "app/cli/frame/text_output.h"
#include "core/base/error.h"
#include "core/evidence/ensembles/member_doubts.h"
#include "io/base/files.h"
#include "io/run/run_cautions.h"
#include "io/site/site_place.h"
#include "widgets/figures/figure_file.h"
#include "widgets/figures/map_picture.h"

namespace rubble::cli {

namespace {

namespace fs = std::filesystem;

bool isFolder(const std::string& path) {
    std::error_code ignored;
    // A name without an ending is none of a map: the folder is made.
    return path.ends_with('/') || !fs::path(path).has_extension() || fs::is_directory(path, ignored);
}

std::string drawnText(const DrawnValues& drawn) {
    std::string text;
    for (const auto& [key, value] : drawn) {
        text += (text.empty() ? "" : " ") + key + '=' + value;
    }
    return text;
}

std::string unitSuffix(const MemberMeasureRow& row) {
    return " [" + std::string(row.unit) + "]";
}

}  // namespace

TextTable spreadTable(const EnsembleReport& report) {
    TextTable table({{"figure", "figure"},
                     {"members", "members"},
                     {"mean", "mean"},
                     {"± of members", "deviation"},
                     {"± of the mean", "standard_error"},
                     {"5 %", "p05"},
                     {"median", "p50"},
                     {"95 %", "p95"}});
    for (std::size_t k = 0; k < memberMeasureCount; ++k) {
        const auto measure = static_cast<MemberMeasure>(k);
        const MemberMeasureRow& row = memberMeasureRow(measure);
        const FigureSpread spread = spreadOf(report, measure);
        Cell name = textCell(std::string(row.key));
        name.shown = std::string(row.name) + unitSuffix(row);
        table.add({name, integerCell(static_cast<std::int64_t>(spread.count)), numberCell(spread.mean),
                   numberCell(spread.deviation), numberCell(spread.standardError), numberCell(spread.low),
                   numberCell(spread.middle), numberCell(spread.high)});
    }
    return table;
}

TextTable memberTable(const EnsembleReport& report) {
    std::vector<TextTable::Column> columns{{"member", "member"}, {"drawn", "drawn"}, {"done", "done"}};
    for (std::size_t k = 0; k < memberMeasureCount; ++k) {
        const MemberMeasureRow& row = memberMeasureRow(static_cast<MemberMeasure>(k));
        columns.push_back({std::string(row.name) + unitSuffix(row), std::string(row.key)});
    }
    columns.push_back({"breaches", "health_breaches"});
    columns.push_back({"trajectory", "trajectory_hash"});
    TextTable table(std::move(columns));
    for (const EnsembleMember& member : report.members) {
        std::vector<Cell> row{integerCell(member.number), textCell(drawnText(member.drawn)),
                              textCell(member.done ? (member.kept ? "kept" : "yes") : "no")};
        for (std::size_t k = 0; k < memberMeasureCount; ++k) {
            row.push_back(numberCell(member.done ? member.figures[k] : std::nan("")));
        }
        row.push_back(member.done ? integerCell(member.breaches) : textCell(""));
        row.push_back(textCell(member.done ? member.trajectoryHash.hex() : ""));
        table.add(std::move(row));
    }
    return table;
}

TextTable convergenceTable(const EnsembleReport& report) {
    std::vector<TextTable::Column> columns{
        {"members", "members"}, {"probability ±", "probability_error_mean"}, {"at most ±", "probability_error_most"}};
    const std::array shown{MemberMeasure::Footprint, MemberMeasure::PileVolume, MemberMeasure::RunOut};
    for (const MemberMeasure measure : shown) {
        const MemberMeasureRow& row = memberMeasureRow(measure);
        columns.push_back({std::string(row.name) + unitSuffix(row), std::string(row.key) + "_mean"});
        columns.push_back({"±", std::string(row.key) + "_standard_error"});
    }
    TextTable table(std::move(columns));
    for (const ConvergenceRow& row : convergenceOf(report)) {
        std::vector<Cell> cells{integerCell(static_cast<std::int64_t>(row.members)), numberCell(row.probabilityError),
                                numberCell(row.worstError)};
        for (const MemberMeasure measure : shown) {
            cells.push_back(numberCell(row.figures[static_cast<std::size_t>(measure)].mean));
            cells.push_back(numberCell(row.figures[static_cast<std::size_t>(measure)].standardError));
        }
        table.add(std::move(cells));
    }
    return table;
}

Json spreadJson(const FigureSpread& spread) {
    return {{"members", spread.count},
            {"mean", spread.mean},
            {"deviation", spread.deviation},
            {"standard_error", spread.standardError},
            {"p05", spread.low},
            {"p50", spread.middle},
            {"p95", spread.high}};
}

Json ensembleJson(const EnsembleReport& report, const DebrisMap* map) {
    Json object;
    object["members"] = report.members.size();
    object["done"] = report.done().size();
    object["complete"] = report.complete;
    object["seed"] = report.settings.seed;
    object["varied"] = Json::array();
    for (const VariedSetting& varied : report.settings.varied) {
        object["varied"].push_back({{"key", varied.key}, {"distribution", variationText(varied)}});
    }
    object["cell_m"] = report.surface.cell;
    object["fallen_structure"] = report.surface.withFallen;
    object["instant"] = report.instant == DebrisInstant::AtRest ? "rest" : "fe_end";
    object["figures"] = Json::object();
    for (std::size_t k = 0; k < memberMeasureCount; ++k) {
        const auto measure = static_cast<MemberMeasure>(k);
        object["figures"][std::string(memberMeasureRow(measure).key)] = spreadJson(spreadOf(report, measure));
    }
    object["convergence"] = Json::array();
    for (const ConvergenceRow& row : convergenceOf(report)) {
        Json each{
            {"members", row.members}, {"probability_error_mean", row.probabilityError}, {"probability_error_most", row.worstError}};
        for (std::size_t k = 0; k < memberMeasureCount; ++k) {
            each[std::string(memberMeasureRow(static_cast<MemberMeasure>(k)).key)] = {
                {"mean", row.figures[k].mean}, {"standard_error", row.figures[k].standardError}};
        }
        object["convergence"].push_back(std::move(each));
    }
    object["list"] = Json::array();
    for (const EnsembleMember& member : report.members) {
        Json drawn = Json::object();
        for (const auto& [key, value] : member.drawn) {
            drawn[key] = value;
        }
        object["list"].push_back({{"member", member.number},
                                  {"drawn", std::move(drawn)},
                                  {"done", member.done},
                                  {"kept", member.kept},
                                  {"failure", member.failure.empty() ? Json() : Json(englishText(member.failure))},
                                  {"trajectory_hash", member.done ? Json(member.trajectoryHash.hex()) : Json()},
                                  {"health_breaches", member.breaches}});
    }
    object["cells"] = map != nullptr ? Json(map->cells.size()) : Json();
    return object;
}

void printEnsemble(std::ostream& out, const EnsembleReport& report) {
    printHeading(out, "Ensemble");
    FactList facts;
    facts.add("members", englishInteger(static_cast<std::int64_t>(report.done().size())) + " of " +
                             englishInteger(static_cast<std::int64_t>(report.members.size())) + " done");
    for (const VariedSetting& varied : report.settings.varied) {
        facts.add(varied.key, variationText(varied));
    }
    facts.add("debris", std::string(report.instant != DebrisInstant::AtRest ? "at the last FE state"
                                    : allAtRest(report)                     ? "at rest"
                                                                            : "where each member ended, not all at rest") +
                            (report.surface.withFallen ? ", fallen live structure with it" : ", fallen live structure apart") +
                            ", cells of " + englishNumber(report.surface.cell) + " m");
    facts.print(out);
    printHeading(out, "Spread over the members");
    spreadTable(report).print(out);
    printHeading(out, "How far that may be off, by the number of members");
    convergenceTable(report).print(out);
}

std::vector<Option> EnsembleMaps::options() {
    return {
        {"--out", "FILE|FOLDER", true, "a map to write: .tif, .csv or .png; into a folder, whose name has no ending, all of them"},
        {"--layers", "A,B", false, "layers of the map, by the names in the manual (default: all); a picture shows the first"},
        {"--size", "WxH", false, "pixels of a picture (default: 1600x1000, less where the map is of another shape)"}};
}

EnsembleMaps::EnsembleMaps(const Arguments& arguments, std::vector<MapLayer> pictured)
    : m_paths(arguments.values("--out")), m_pictured(std::move(pictured)) {
    for (const std::string& path : m_paths) {
        if (isFolder(path)) {
            continue;
        }
        const bool known = io::hasEnding(path, ".tif") || io::hasEnding(path, ".csv") || io::hasEnding(path, ".png");
        if (!known) {
            throw wrongValue(
                "--out", path,
                "a path that ends in .tif, .csv or .png (a map of an ensemble has no fragments), or a folder, whose name "
                "has no ending");
        }
        checkOutputPath(path, operandsOf(arguments));
    }
    if (const auto layers = arguments.value("--layers")) {
        m_layers = parseLayers(*layers, true);
    }
    if (const auto size = arguments.value("--size")) {
        m_pixels = parsePictureSize(*size);
    }
}

std::vector<std::string> EnsembleMaps::folders() const {
    std::vector<std::string> list;
    std::copy_if(m_paths.begin(), m_paths.end(), std::back_inserter(list), isFolder);
    return list;
}

void EnsembleMaps::writeOne(const std::string& path, const DebrisMap& map, const std::vector<MapLayer>& layers,
                            const io::MapOrigin& origin, const std::vector<Caution>& cautions,
                            const std::optional<TellingPlace>& place, Session& session) const {
    if (io::hasEnding(path, ".csv")) {
        io::writeMapCsv(path, map, layers, origin, session.execution());
    } else if (io::hasEnding(path, ".png")) {
        quietQt();
        figures::ensureGuiApplication();
        figures::MapPictureStyle style;
        style.pixels = m_pixels.value_or(style.pixels);
        style.fitted = !m_pixels;
        style.subject = origin.subject;
        style.place = io::SitePlace(origin.frame, origin.site).transform();
        style.system = origin.frame.crs;
        style.shown = origin.facts.front().second;
        style.provenance = io::inputsLine(origin);
        style.cautions = pictureCautions(cautions);
        if (place) {
            style.ring = figures::MapRing{place->middle, place->radius()};
        }
        figures::writePng(path, figures::mapPicture(map, layers.front(), style));
        io::writeMapProvenance(path, origin);
    } else {
        io::writeMapTiff(path, map, layers, origin, session.execution());
    }
}

std::vector<std::string> EnsembleMaps::write(const DebrisMap& map, const std::string& name, const io::MapOrigin& origin,
                                             const std::vector<Caution>& cautions, const std::optional<TellingPlace>& place,
                                             Session& session) const {
    std::vector<MapLayer> layers = m_layers.empty() ? map.present() : m_layers;
    for (const MapLayer layer : layers) {
        if (!map.has(layer)) {
            throw wrongValue("--layers", std::string(mapLayerRow(layer).key), "layers that this map has");
        }
    }
    std::vector<std::string> written;
    const auto one = [&](const std::string& path, const std::vector<MapLayer>& of) {
        writeOne(path, map, of, origin, cautions, place, session);
        written.push_back(path);
    };
    for (const std::string& path : m_paths) {
        if (!isFolder(path)) {
            one(path, layers);
            continue;
        }
        std::error_code failed;
        fs::create_directories(path, failed);
        if (failed) {
            throw WorldError({"cli.folder", "The folder {0} cannot be made: {1}", {path, failed.message()}},
                             {"cli.folder.remedy", "Name another folder, or check its rights.", {}});
        }
        const std::string base = (fs::path(path) / name).string();
        one(base + ".tif", layers);
        one(base + ".csv", layers);
        for (const MapLayer layer : m_pictured) {
            one(base + '-' + std::string(mapLayerRow(layer).key) + ".png", {layer});
        }
    }
    return written;
}

}  // namespace rubble::cli
