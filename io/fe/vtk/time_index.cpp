#include "io/fe/vtk/time_index.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/base/error.h"
#include "io/fe/pieces/place_index.h"
#include "io/fe/series/byte_window.h"
#include "io/fe/series/numbered_files.h"
#include "io/fe/vtk/grid_file.h"
#include "io/fe/vtk/index_text.h"
#include "io/fe/vtk/piece_index.h"

namespace rubble::io {

namespace {

/// A state while its index is read.
struct OpenState {
    std::optional<double> time;
    std::vector<std::pair<std::string, std::string>> parts;  // part and file
    std::vector<std::string> again;                          // files listed once more

    bool names(const std::string& file) const {
        return std::any_of(parts.begin(), parts.end(), [&](const auto& part) { return sameFile(part.second, file); });
    }
    const std::string* fileOf(const std::string& part) const {
        const auto found = std::find_if(parts.begin(), parts.end(), [&](const auto& known) { return known.first == part; });
        return found == parts.end() ? nullptr : &found->second;
    }
};

std::vector<Vec3> pointsOf(const std::string& file) {
    GridSelection selection;
    selection.cells = false;
    std::vector<Vec3> points;
    for (const std::string& grid : piecesOfState({file}).grids) {
        const std::vector<Vec3> more = readGridFile(grid, selection).points;
        points.insert(points.end(), more.begin(), more.end());
    }
    return points;
}

Aabb roomOf(const std::vector<Vec3>& points) {
    Aabb room;
    for (const Vec3& point : points) {
        room.extend(point);
    }
    return room;
}

// Whether two rooms share less than a fraction of the smaller one along an axis.
bool apart(const Aabb& a, const Aabb& b, double fraction) {
    const Vec3 size = a.sizes().cwiseMin(b.sizes());
    const Vec3 overlap = a.max().cwiseMin(b.max()) - a.min().cwiseMax(b.min());
    return (overlap.array() < fraction * size.array()).any();
}

// Some writers give all pieces of a time the part 0. Pieces of one state share an interface at most; the state written again lies
// where it lay before.
bool liesElsewhere(const std::string& file, const std::string& known) {
    try {
        const std::vector<Vec3> before = pointsOf(known), points = pointsOf(file);
        PlaceIndex places(placeTolerance(before));
        for (std::size_t i = 0; i < before.size(); ++i) {
            places.put(before[i], static_cast<std::uint32_t>(i));
        }
        std::size_t same = 0;
        for (const Vec3& point : points) {
            same += places.find(point) != PlaceIndex::nowhere ? 1 : 0;
        }
        if (points.empty() || before.empty() || 2 * same > points.size()) {
            return false;
        }
        // A state that has moved since covers much of the same room.
        return points.size() != before.size() || apart(roomOf(before), roomOf(points), 0.5);
    } catch (const std::exception&) {
        // Opening it says why.
        return false;
    }
}

// Pieces of one state without its time lie beside each other; a later state lies where the earlier did, whatever it has lost.
bool liesBeside(const std::string& file, const std::string& known) {
    constexpr double interface = 0.01;
    try {
        const std::vector<Vec3> before = pointsOf(known), points = pointsOf(file);
        return !points.empty() && !before.empty() && apart(roomOf(before), roomOf(points), interface);
    } catch (const std::exception&) {
        // Opening it says why.
        return false;
    }
}

// Times grow with the names of the files: the list is in disorder, no branch was abandoned.
bool disordered(const std::vector<OpenState>& states) {
    const auto before = [](const OpenState& a, const OpenState& b) { return a.time < b.time; };
    if (std::is_sorted(states.begin(), states.end(), before)) {
        return false;
    }
    std::vector<OpenState> byName = states;
    std::stable_sort(byName.begin(), byName.end(), [](const OpenState& a, const OpenState& b) {
        return naturallyBefore(a.parts.front().second, b.parts.front().second);
    });
    return std::adjacent_find(byName.begin(), byName.end(),
                              [](const OpenState& a, const OpenState& b) { return a.time >= b.time; }) == byName.end();
}

// Lines without times come in the order of their states: a part that comes again is that of the next state.
std::vector<OpenState> statesInOrder(const std::vector<ListedFile>& list) {
    std::vector<OpenState> states;
    for (const ListedFile& entry : list) {
        OpenState* const newest = states.empty() ? nullptr : &states.back();
        if (newest && newest->names(entry.file)) {
            newest->again.push_back(entry.file);
            continue;
        }
        const std::string* const known = newest ? newest->fileOf(entry.part) : nullptr;
        if (newest && (!known || liesBeside(entry.file, *known))) {
            newest->parts.emplace_back(entry.part, entry.file);
        } else {
            states.push_back({std::nullopt, {{entry.part, entry.file}}, {}});
        }
    }
    return states;
}

// The states in the order of their lines, a time that comes again behind the others.
std::vector<OpenState> statesByTime(const std::vector<ListedFile>& list) {
    std::vector<OpenState> open;
    std::map<std::optional<double>, std::size_t> newest;  // state of each time
    for (const ListedFile& entry : list) {
        const auto found = newest.find(entry.time);
        OpenState* const state = found == newest.end() ? nullptr : &open[found->second];
        if (state && state->names(entry.file)) {
            state->again.push_back(entry.file);
            continue;
        }
        const std::string* const known = state ? state->fileOf(entry.part) : nullptr;
        if (state && (!known || liesElsewhere(entry.file, *known))) {
            state->parts.emplace_back(entry.part, entry.file);
            continue;
        }
        newest[entry.time] = open.size();
        open.push_back({entry.time, {{entry.part, entry.file}}, {}});
    }
    if (disordered(open)) {
        std::stable_sort(open.begin(), open.end(), [](const OpenState& a, const OpenState& b) { return a.time < b.time; });
    }
    return open;
}

// A line without a time among others that have one is at 0, as other programs take it; two of them cannot both be.
void fillTimes(const std::string& path, std::vector<ListedFile>& list) {
    const auto timed = [](const ListedFile& entry) { return entry.time.has_value(); };
    if (std::none_of(list.begin(), list.end(), timed)) {
        return;
    }
    std::map<std::string, std::string> files;  // without a time, by part
    for (ListedFile& entry : list) {
        if (!entry.time && files.try_emplace(entry.part, entry.file).first->second != entry.file) {
            failIndex(path, "some of its entries have a timestep, others of one part have none");
        }
        entry.time = entry.time.value_or(0.0);
    }
}

}  // namespace

std::vector<ListedFile> listedByPvd(const std::string& path) {
    std::vector<ListedFile> list;
    const pugi::xml_document document = indexXml(path);
    for (const pugi::xml_node node : document.child("VTKFile").child("Collection").children("DataSet")) {
        const pugi::xml_attribute timestep = node.attribute("timestep");
        const std::string text = timestep.as_string();
        ListedFile entry;
        double time = 0.0;
        if (timestep && (!toReal(column(text, 0, text.size()), time) || !std::isfinite(time))) {
            failIndex(path, "the timestep \"" + text.substr(0, 40) + "\" is no number");
        }
        if (timestep) {
            entry.time = time;
        }
        entry.part = std::string(node.attribute("group").as_string()) + "/" + node.attribute("part").as_string("0");
        entry.file = namedByIndex(path, node.attribute("file").as_string());
        list.push_back(std::move(entry));
    }
    fillTimes(path, list);
    return list;
}

std::vector<ListedFile> listedBySeries(const std::string& path) {
    std::vector<ListedFile> list;
    try {
        const nlohmann::json json = nlohmann::json::parse(indexText(path));
        for (const nlohmann::json& file : json.at("files")) {
            list.push_back({file.at("time").get<double>(), {}, namedByIndex(path, file.at("name").get<std::string>())});
        }
    } catch (const nlohmann::json::exception& error) {
        failIndex(path, error.what());
    }
    return list;
}

std::vector<ListedState> statesListed(const std::vector<ListedFile>& list) {
    const bool timed = std::any_of(list.begin(), list.end(), [](const ListedFile& entry) { return entry.time.has_value(); });
    const std::vector<OpenState> open = timed ? statesByTime(list) : statesInOrder(list);
    std::vector<ListedState> states;
    for (const OpenState& state : open) {
        ListedState& listed = states.emplace_back(ListedState{state.time, {}, state.again});
        for (const auto& [part, file] : state.parts) {
            listed.files.push_back(file);
        }
    }
    return states;
}

}  // namespace rubble::io
