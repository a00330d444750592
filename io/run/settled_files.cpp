#include "io/run/settled_files.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/json/json_cursor.h"

namespace rubble::io {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr int formatVersion = 3;

json islandsJson(const WorldOrigin& origin, const SettledWorld& settled) {
    json list = json::array();
    for (const CarriedIsland& island : settled.islands) {
        json elements = json::array();
        for (const ElementIndex e : island.elements) {
            elements.push_back(at(e));
        }
        const Quat& turn = island.moved.orientation;
        list.push_back({{"position", jsonVector(island.moved.position)},
                        {"turn", {jsonNumber(turn.w()), jsonNumber(turn.x()), jsonNumber(turn.y()), jsonNumber(turn.z())}},
                        {"state", island.state},
                        {"elements", std::move(elements)}});
    }
    json rows = json::array(), columns = json::array(), times = json::array();
    for (const DebrisArrival& arrival : settled.arrivals.squares) {
        rows.push_back(arrival.j);
        columns.push_back(arrival.i);
        times.push_back(jsonNumber(arrival.time));
    }
    return {{"version", formatVersion},
            {"world", origin.key.hex()},
            {"trajectory", settled.world.trajectoryHash.hex()},
            {"islands", std::move(list)},
            {"arrivals", {{"rows", std::move(rows)}, {"columns", std::move(columns)}, {"times", std::move(times)}}}};
}

std::int32_t squareFrom(const JsonCursor& cursor) {
    const std::int64_t index = cursor.integer();
    if (index < std::numeric_limits<std::int32_t>::min() || index > std::numeric_limits<std::int32_t>::max()) {
        cursor.fail("the index of a square");
    }
    return static_cast<std::int32_t>(index);
}

DebrisArrivals arrivalsFrom(const JsonCursor& cursor) {
    const std::vector<JsonCursor> rows = cursor["rows"].elements(), columns = cursor["columns"].elements(),
                                  times = cursor["times"].elements();
    if (rows.size() != columns.size() || rows.size() != times.size()) {
        cursor.fail("as many rows, columns and times");
    }
    DebrisArrivals arrivals;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        arrivals.squares.push_back({squareFrom(rows[k]), squareFrom(columns[k]), times[k].number()});
    }
    return arrivals;
}

std::vector<CarriedIsland> islandsFrom(const JsonCursor& cursor, const WorldOrigin& origin, const SimulatedWorld& world) {
    if (cursor["version"].integer() != formatVersion || cursor["world"].text() != origin.key.hex() ||
        cursor["trajectory"].text() != world.trajectoryHash.hex()) {
        cursor.fail("the islands of this world");
    }
    std::vector<CarriedIsland> islands;
    for (const JsonCursor& each : cursor["islands"].elements()) {
        CarriedIsland& island = islands.emplace_back();
        island.moved.position = each["position"].vector();
        const std::vector<JsonCursor> turn = each["turn"].elements();
        if (turn.size() != 4) {
            each["turn"].fail("four numbers");
        }
        island.moved.orientation = Quat(turn[0].number(), turn[1].number(), turn[2].number(), turn[3].number());
        const std::int64_t state = each["state"].integer();
        if (state < 0 || state > 0xffffffff) {
            each["state"].fail("the index of a state");
        }
        island.state = static_cast<std::uint32_t>(state);
        for (const JsonCursor& element : each["elements"].elements()) {
            const std::int64_t index = element.integer();
            if (index < 0 || index > 0xffffffff) {
                element.fail("the index of an element");
            }
            island.elements.push_back(idAt<ElementIndex>(static_cast<std::size_t>(index)));
        }
    }
    return islands;
}

}  // namespace

std::string SettledFiles::islandsPath(const WorldOrigin& origin) const {
    return (fs::path(m_worlds.folder()) / "islands" / (origin.key.hex() + ".json")).string();
}

std::optional<SettledWorld> SettledFiles::settled(const WorldOrigin& origin, Findings& findings) {
    const std::string path = islandsPath(origin);
    std::ifstream stream(path, std::ios::binary);
    if (!stream) {
        return {};
    }
    std::optional<SimulatedWorld> world = m_worlds.world(origin, findings);
    if (!world) {
        return {};
    }
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    try {
        const json document = parseJson(text, path);
        SettledWorld settled;
        settled.islands = islandsFrom(JsonCursor(document, path), origin, *world);
        settled.arrivals = arrivalsFrom(JsonCursor(document, path)["arrivals"]);
        settled.world = std::move(*world);
        return settled;
    } catch (const ParseError& error) {
        findings.add({"study.damaged", "What was kept of an earlier study is damaged and is made again.", {}},
                     {"study.damaged.remedy", "Delete the file named, if this is said each time.", {}}, error.what());
        return {};
    }
}

bool SettledFiles::keeps(const WorldOrigin& origin) {
    Findings ignored;
    return settled(origin, ignored).has_value();
}

void SettledFiles::keep(const WorldOrigin& origin, const SettledWorld& settled) {
    writeIn(islandsPath(origin), islandsJson(origin, settled).dump());
    m_worlds.keep(origin, settled.world);
}

}  // namespace rubble::io
