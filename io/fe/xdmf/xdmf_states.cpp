#include "io/fe/xdmf/xdmf_states.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include "io/fe/series/byte_window.h"
#include "io/fe/series/later_branch.h"
#include "io/fe/series/numbered_files.h"

namespace rubble::io {

namespace {

using Grids = std::vector<pugi::xml_node>;

/// What one collection says of the time: its grids, each with its time.
struct Timeline {
    std::vector<std::pair<double, pugi::xml_node>> grids;
    std::set<std::string> arrays;  ///< names, of all grids
    pugi::xml_node topology;       ///< of the first mesh

    std::set<double> times() const {
        std::set<double> all;
        for (const auto& [time, grid] : grids) {
            all.insert(time);
        }
        return all;
    }
};

bool isTemporal(pugi::xml_node grid) {
    return xdmfType(grid, "GridType") == "collection" &&
           xdmfLowerCase(grid.attribute("CollectionType").as_string("spatial")) == "temporal";
}

bool holdsArrays(pugi::xml_node grid) {
    return grid.child("Attribute") || std::any_of(grid.children("Grid").begin(), grid.children("Grid").end(), holdsArrays);
}

bool holdsTemporal(pugi::xml_node grid) {
    return isTemporal(grid) || std::any_of(grid.children("Grid").begin(), grid.children("Grid").end(), holdsTemporal);
}

// Names of the grids grow with their times: they are in disorder, and no branch was abandoned.
bool inDisorder(const Timeline& line) {
    const auto timeBefore = [](const auto& a, const auto& b) { return a.first < b.first; };
    const auto nameOf = [](pugi::xml_node grid) { return std::string(grid.attribute("Name").as_string()); };
    if (std::is_sorted(line.grids.begin(), line.grids.end(), timeBefore)) {
        return false;
    }
    auto byName = line.grids;
    std::stable_sort(byName.begin(), byName.end(),
                     [&](const auto& a, const auto& b) { return naturallyBefore(nameOf(a.second), nameOf(b.second)); });
    return std::adjacent_find(byName.begin(), byName.end(), [](const auto& a, const auto& b) { return a.first >= b.first; }) ==
           byName.end();
}

class StateFinder {
public:
    StateFinder(const pugi::xml_document& document, const XdmfItems& items) : m_items(items) {
        for (const pugi::xml_node domain : document.child("Xdmf").children("Domain")) {
            collect(domain);
        }
    }

    XdmfStates find() {
        for (const pugi::xml_node collection : m_collections) {
            addCollection(collection);
        }
        if (m_lines.empty()) {
            addSingles();
        }
        for (Timeline& line : m_lines) {
            keepLaterBranch(line);
        }
        if (m_lines.size() == 1) {
            for (const auto& [time, grid] : m_lines.front().grids) {
                m_states.list.push_back({time, piecesOf(grid)});
            }
        } else if (m_lines.size() > 1) {
            join();
        }
        std::erase_if(m_states.list, [](const XdmfState& state) { return state.pieces.empty(); });
        return std::move(m_states);
    }

private:
    void collect(pugi::xml_node owner) {
        for (const pugi::xml_node grid : owner.children("Grid")) {
            if (isTemporal(grid)) {
                m_collections.push_back(grid);
            } else if (holdsTemporal(grid)) {
                collect(grid);
            } else if (xdmfType(grid, "GridType") == "collection" || xdmfPart(grid, "Topology", m_items)) {
                m_singles.push_back(grid);
            }
        }
    }

    void addCollection(pugi::xml_node collection) {
        Timeline line;
        const std::vector<double> times = timesOf(collection.child("Time"));
        for (const pugi::xml_node grid : collection.children("Grid")) {
            addGrid(grid, times, line);
        }
        if (line.grids.empty()) {
            return;
        }
        const std::set<double> own = line.times();
        const auto before = std::find_if(m_lines.begin(), m_lines.end(), [&](const Timeline& other) {
            return other.arrays == line.arrays && other.times() != own && sameTopology(other.topology, line.topology);
        });
        if (before == m_lines.end()) {
            m_lines.push_back(std::move(line));
            return;
        }
        before->grids.insert(before->grids.end(), line.grids.begin(), line.grids.end());
    }

    void addGrid(pugi::xml_node grid, const std::vector<double>& times, Timeline& line) {
        const std::size_t place = line.grids.size();
        std::optional<double> time = timeOf(grid);
        if (!time && place < times.size()) {
            time = times[place];
        }
        m_states.timed = m_states.timed && time;
        line.grids.emplace_back(time.value_or(static_cast<double>(place)), grid);
        for (const Grids& piece : piecesOf(grid)) {
            for (const pugi::xml_node array : piece.front().children("Attribute")) {
                line.arrays.insert(array.attribute("Name").as_string());
            }
            if (!line.topology) {
                line.topology = xdmfPart(piece.front(), "Topology", m_items);
            }
        }
    }

    // All collections of a run have the same branches: they are said once.
    void keepLaterBranch(Timeline& line) {
        if (m_collections.empty() || inDisorder(line)) {
            std::stable_sort(line.grids.begin(), line.grids.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        }
        std::vector<double> times;
        for (const auto& [time, grid] : line.grids) {
            times.push_back(time);
        }
        Findings findings;
        std::vector<std::pair<double, pugi::xml_node>> kept;
        for (const std::size_t k : laterBranch(times, findings)) {
            kept.push_back(line.grids[k]);
        }
        line.grids = std::move(kept);
        if (&line == &m_lines.front()) {
            m_states.findings = findings;
        }
    }

    // Grids that no collection orders: what has neither time nor arrays beside others that have some is a mesh.
    void addSingles() {
        const auto timed = [&](pugi::xml_node grid) { return timeOf(grid).has_value(); };
        for (const auto& tells : {std::function<bool(pugi::xml_node)>(timed), std::function<bool(pugi::xml_node)>(holdsArrays)}) {
            if (std::any_of(m_singles.begin(), m_singles.end(), tells)) {
                std::erase_if(m_singles, [&](pugi::xml_node grid) { return !tells(grid); });
            }
        }
        std::map<double, std::size_t> atTime;
        for (const pugi::xml_node grid : m_singles) {
            const std::size_t line = atTime[timeOf(grid).value_or(0.0)]++;
            m_lines.resize(std::max(m_lines.size(), line + 1));
            addSingle(grid, m_lines[line]);
        }
    }

    void addSingle(pugi::xml_node grid, Timeline& line) {
        const std::optional<double> time = timeOf(grid);
        m_states.timed = m_states.timed && time;
        line.grids.emplace_back(time.value_or(0.0), grid);
    }

    // Of a collection of pieces, each may say it.
    std::optional<double> timeOf(pugi::xml_node grid) const {
        const pugi::xml_attribute written = grid.child("Time").attribute("Value");
        if (!written) {
            const bool inPieces = xdmfType(grid, "GridType") == "collection" && grid.child("Grid");
            return inPieces ? timeOf(grid.child("Grid")) : std::nullopt;
        }
        const std::string text = written.as_string();
        double time = 0.0;
        if (!toReal(column(text, 0, text.size()), time) || !std::isfinite(time)) {
            m_items.fail("the time \"" + text.substr(0, 40) + "\" of a grid is no number");
        }
        return time;
    }

    // A collection may say the times of its grids at once: all of them, or start, step and count.
    std::vector<double> timesOf(pugi::xml_node time) const {
        const std::string type = xdmfLowerCase(time.attribute("TimeType").as_string("single"));
        if (!time || !m_items.itemOf(time) || (type != "list" && type != "hyperslab")) {
            return {};
        }
        std::vector<double> values = m_items.reals(m_items.itemOf(time));
        if (type == "hyperslab" && values.size() == 3) {
            const double start = values[0], step = values[1];
            values.resize(static_cast<std::size_t>(std::clamp(values[2], 0.0, 1e7)));
            for (std::size_t k = 0; k < values.size(); ++k) {
                values[k] = start + step * static_cast<double>(k);
            }
        }
        if (!std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); })) {
            m_items.fail("the times of a collection are no numbers");
        }
        return values;
    }

    static std::vector<Grids> piecesOf(pugi::xml_node grid) {
        if (xdmfType(grid, "GridType") != "collection") {
            return {{grid}};
        }
        std::vector<Grids> pieces;
        for (const pugi::xml_node child : grid.children("Grid")) {
            for (Grids& piece : piecesOf(child)) {
                pieces.push_back(std::move(piece));
            }
        }
        return pieces;
    }

    // States at the times that all collections have.
    void join() {
        std::map<double, std::vector<std::size_t>> lines;
        for (std::size_t l = 0; l < m_lines.size(); ++l) {
            for (const double time : m_lines[l].times()) {
                lines[time].push_back(l);
            }
        }
        for (const auto& [time, having] : lines) {
            if (having.size() < m_lines.size() && !m_collections.empty()) {
                ++m_states.dropped;
                continue;
            }
            XdmfState& state = m_states.list.emplace_back();
            state.time = time;
            for (const std::size_t l : having) {
                addPieces(gridAt(m_lines[l], time), state);
            }
        }
        if (m_states.list.empty()) {
            m_items.fail("its temporal collections have no time in common");
        }
    }

    // The newest of those that a collection has of one time.
    static pugi::xml_node gridAt(const Timeline& line, double time) {
        const auto found =
            std::find_if(line.grids.rbegin(), line.grids.rend(), [time](const auto& grid) { return grid.first == time; });
        return found == line.grids.rend() ? pugi::xml_node() : found->second;
    }

    void addPieces(pugi::xml_node grid, XdmfState& state) const {
        const std::size_t before = state.pieces.size();
        for (Grids& piece : piecesOf(grid)) {
            const pugi::xml_node topology = xdmfPart(piece.front(), "Topology", m_items);
            const pugi::xml_node geometry = xdmfPart(piece.front(), "Geometry", m_items);
            const auto last = state.pieces.begin() + static_cast<std::ptrdiff_t>(before);
            // Pieces count their points each for itself: their cells may have the same ones.
            const auto same = std::find_if(state.pieces.begin(), last, [&](const Grids& other) {
                return !topology || (sameTopology(xdmfPart(other.front(), "Topology", m_items), topology) &&
                                     sameGeometry(xdmfPart(other.front(), "Geometry", m_items), geometry));
            });
            if (same != last) {
                same->insert(same->end(), piece.begin(), piece.end());
            } else {
                state.pieces.push_back(std::move(piece));
            }
        }
    }

    // Some writers store the mesh again with every function.
    bool sameTopology(pugi::xml_node a, pugi::xml_node b) const {
        if (sameXdmfItem(a, b, m_items)) {
            return true;
        }
        const pugi::xml_node left = a ? m_items.itemOf(a) : a, right = b ? m_items.itemOf(b) : b;
        return left && right && xdmfType(a, "TopologyType") == xdmfType(b, "TopologyType") &&
               m_items.dimensions(left) == m_items.dimensions(right) && m_items.integers(left) == m_items.integers(right);
    }

    bool sameGeometry(pugi::xml_node a, pugi::xml_node b) const {
        if (!a || !b || sameXdmfItem(a, b, m_items)) {
            return true;
        }
        const pugi::xml_node left = m_items.itemOf(a), right = m_items.itemOf(b);
        return left && right && m_items.dimensions(left) == m_items.dimensions(right) &&
               m_items.reals(left) == m_items.reals(right);
    }

    const XdmfItems& m_items;
    Grids m_collections, m_singles;
    std::vector<Timeline> m_lines;
    XdmfStates m_states;
};

}  // namespace

XdmfStates findXdmfStates(const pugi::xml_document& document, const XdmfItems& items) {
    return StateFinder(document, items).find();
}

pugi::xml_node xdmfPart(pugi::xml_node grid, const std::string& name, const XdmfItems& items) {
    if (const pugi::xml_node own = grid.child(name.c_str())) {
        return items.resolved(own);
    }
    for (const pugi::xml_node include : grid.children()) {
        const std::string_view element = include.name();
        if (element.substr(element.find(':') + 1) != "include") {
            continue;
        }
        std::string pointer = include.attribute("xpointer").as_string();
        if (pointer.starts_with("xpointer(") && pointer.ends_with(")")) {
            pointer = pointer.substr(9, pointer.size() - 10);
        }
        try {
            for (const pugi::xpath_node& found : grid.root().select_nodes(pointer.c_str())) {
                if (name == found.node().name()) {
                    return items.resolved(found.node());
                }
            }
        } catch (const pugi::xpath_exception&) {
            items.fail("the pointer \"" + pointer.substr(0, 100) + "\" cannot be followed");
        }
    }
    return {};
}

bool sameXdmfItem(pugi::xml_node a, pugi::xml_node b, const XdmfItems& items) {
    if (a == b) {
        return true;
    }
    const pugi::xml_node left = a ? items.itemOf(a) : a, right = b ? items.itemOf(b) : b;
    return left == right || (left && right && std::string_view(left.attribute("Format").as_string()) == "HDF" &&
                             std::string_view(left.child_value()) == right.child_value());
}

std::string xdmfType(pugi::xml_node node, const char* longName) {
    const pugi::xml_attribute named = node.attribute(longName);
    return xdmfLowerCase(named ? named.as_string() : node.attribute("Type").as_string());
}

std::string xdmfLowerCase(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return text;
}

}  // namespace rubble::io
