#include "io/fe/ansys/rst_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <unordered_map>
#include <unordered_set>

#include "core/base/error.h"
#include "io/fe/ansys/ansys_elements.h"
#include "io/fe/ansys/rst_records.h"
#include "io/fe/pieces/stacked_series.h"
#include "io/fe/series/numbered_files.h"
#include "io/fe/series/series_result.h"
#include "io/fe/straight_edges.h"

namespace rubble::io {

namespace {

constexpr std::uint64_t headerWord = 103;
constexpr std::uint64_t mostHeader = 100'000;
constexpr std::size_t elementHeader = 10;  // fields before the nodes
constexpr std::size_t listedWord = 64;     // of the header of the geometry: element types stand in a table
constexpr double undefined = 1e29;         // the file writes 2^100
constexpr std::size_t oldHeader = 40;      // words of the headers of results and geometry in old releases

// Analyses whose sets are no states of a course of time, by the code of ANTYPE.
const char* untimedAnalysis(std::int64_t code) {
    switch (code) {
        case 1:
            return "an eigenvalue buckling analysis";
        case 2:
            return "a modal analysis";
        case 3:
            return "a harmonic analysis";
        case 7:
            return "a substructure analysis";
        case 8:
            return "a spectrum analysis";
        default:
            return nullptr;
    }
}

class RstSeries : public MeshSeries {
public:
    explicit RstSeries(const std::string& path) : m_path(path), m_records(path) {
        const std::vector<std::int64_t> header = m_records.integers(headerWord, mostHeader);
        require(header.size() >= oldHeader, "its header has " + std::to_string(header.size()) + " words");
        if (const char* const analysis = untimedAnalysis(header[7])) {
            throw ParseError(
                {"rst.analysis", "{0} is {1} of Ansys, whose sets are no states of a course of time", {path, analysis}},
                {"rst.analysis.remedy", "Give the results of the collapse: a static or a transient analysis.", {}});
        }
        readSets(header);
        const std::uint64_t geometry = pointer(header, 15, 46);
        readMesh(geometry);
        m_order = m_records.integers(pointer(header, 14, 45), m_records.words());
        for (std::size_t n = 0; n < m_mesh.nodeIds.size(); ++n) {
            m_nodes.emplace(m_mesh.nodeIds[n], n);
        }
        dropUnfinished();
        noteUnset();
    }

    const std::vector<std::int64_t>& nodeNumbers() const { return m_mesh.nodeIds; }

    SeriesStep step(std::size_t k) override {
        SeriesStep step;
        if (k == 0) {
            step.mesh = m_mesh;
        }
        return step;
    }

    SeriesFields fields(std::size_t k) const override {
        SeriesFields fields;
        fields.positions.assign(m_mesh.nodeCount(), Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
        visit(k, [&](std::size_t node, const Vec3& moved, bool) {
            fields.positions[node] = m_mesh.nodes[node] + axesOf(node) * moved;
        });
        return fields;
    }

private:
    // Calls back for each node that a set has: its displacement in its own axes, and whether a component of it is not set.
    template <class Each>
    void visit(std::size_t k, const Each& each) const {
        const std::scoped_lock lock(m_mutex);
        const std::vector<std::int64_t> header = m_records.integers(m_sets[k], mostHeader);
        require(header.size() > 124, "the header of a set is short");
        const std::int64_t nodes = header[2], freedoms = header[19];
        require(nodes >= 0 && freedoms > 0 && freedoms <= 30 && static_cast<std::size_t>(nodes) <= m_order.size(),
                "a set has " + std::to_string(nodes) + " nodes of " + std::to_string(m_order.size()));
        const std::uint64_t low = static_cast<std::uint32_t>(header[104]);
        const std::uint64_t offset = low != 0 || header[105] != 0 ? low | static_cast<std::uint64_t>(header[105]) << 32
                                                                  : static_cast<std::uint32_t>(header[10]);
        const auto count = static_cast<std::uint64_t>(nodes * freedoms);
        const std::vector<double> values = m_records.reals(m_sets[k] + offset, count);
        require(values.size() == count, "a set has " + std::to_string(values.size()) + " nodal values");
        for (std::size_t n = 0; n < static_cast<std::size_t>(nodes); ++n) {
            const auto found = m_nodes.find(m_order[n]);
            if (found == m_nodes.end()) {
                continue;
            }
            Vec3 moved = Vec3::Zero();
            bool unset = false;
            for (std::size_t i = 0; i < static_cast<std::size_t>(freedoms); ++i) {
                const std::int64_t freedom = header[20 + i];
                const double value = values[n * static_cast<std::size_t>(freedoms) + i];
                if (freedom < 1 || freedom > 3) {
                    continue;
                }
                if (std::abs(value) > undefined) {
                    unset = true;
                } else {
                    moved[static_cast<Eigen::Index>(freedom - 1)] = value;
                }
            }
            each(found->second, moved, unset);
        }
    }

    void require(bool right, const std::string& what) const {
        if (!right) {
            throw ParseError({"rst.layout", "{0}: {1}", {m_path, what}},
                             {"rst.broken.remedy",
                              "The file is damaged or not yet whole: copy it again or let the analysis write it again.",
                              {}});
        }
    }

    // Headers of old releases end before the high halves.
    static std::uint64_t pointer(const std::vector<std::int64_t>& header, std::size_t low, std::size_t high) {
        const std::uint64_t upper = high < header.size() ? static_cast<std::uint32_t>(header[high]) : 0;
        return static_cast<std::uint32_t>(header[low]) | upper << 32;
    }

    void readSets(const std::vector<std::int64_t>& header) {
        const std::int64_t most = header[3], sets = header[8];
        require(most > 0 && sets >= 0 && sets <= most && static_cast<std::uint64_t>(most) < m_records.words(),
                "it says that it has " + std::to_string(sets) + " sets of at most " + std::to_string(most));
        const auto limit = static_cast<std::uint64_t>(most);
        const std::vector<std::int64_t> index = m_records.integers(pointer(header, 10, 40), 2 * limit);
        const std::vector<double> times = m_records.reals(pointer(header, 11, 41), limit);
        require(index.size() == 2 * limit && times.size() == limit, "the table of its sets is short");
        for (std::size_t s = 0; s < static_cast<std::size_t>(sets); ++s) {
            m_sets.push_back(static_cast<std::uint32_t>(index[s]) |
                             static_cast<std::uint64_t>(static_cast<std::uint32_t>(index[s + limit])) << 32);
            m_facts.times.push_back(times[s]);
        }
    }

    // The last sets may be cut off, or not yet written; the tables that name them stand before them.
    void dropUnfinished() {
        const auto isWhole = [this](std::size_t k) {
            try {
                fields(k);
                return true;
            } catch (const ParseError&) {
                return false;
            }
        };
        while (m_sets.size() > 1 && !isWhole(m_sets.size() - 1)) {
            m_sets.pop_back();
            m_facts.times.pop_back();
            m_facts.findings.add({"fe.unfinished", "The last state is not whole and was left out", {}},
                                 {"fe.unfinished.remedy", "Open the result again once the analysis has gone on.", {}}, m_path);
        }
        for (const std::uint64_t begin : m_sets) {
            const std::vector<std::int64_t> set = m_records.integers(begin, mostHeader);
            if (set.size() > 122 && set[122] != 0) {
                m_facts.findings.add(
                    {"rst.dead", "Sets have a list of dead elements whose meaning nobody has verified; it was not used", {}},
                    {"rst.dead.remedy", "Put a list of deaths (element,time) beside the file.", {}}, m_path);
            }
        }
    }

    // A direction in which no element holds a node has no value: the node does not move along it.
    void noteUnset() {
        std::vector<bool> unset(m_mesh.nodeCount(), false);
        for (std::size_t k = 0; k < m_sets.size(); k += std::max<std::size_t>(m_sets.size() - 1, 1)) {
            visit(k, [&](std::size_t node, const Vec3&, bool missing) { unset[node] = unset[node] || missing; });
        }
        for (const std::uint32_t node : m_mesh.corners) {
            if (unset[node]) {
                unset[node] = false;
                m_facts.findings.add(
                    {"rst.unset", "Nodes of elements have no displacement along some axes: they were left at rest along them", {}},
                    {"rst.unset.remedy", "Nothing to do if no element resists there, as trusses and plane models do not.", {}},
                    "node " + englishInteger(m_mesh.nodeIds[node]) + " (" + m_path + ")");
            }
        }
    }

    void readMesh(std::uint64_t word) {
        const std::vector<std::int64_t> geometry = m_records.integers(word, mostHeader);
        require(geometry.size() >= oldHeader, "the header of its geometry is short");
        const auto nodes = static_cast<std::uint64_t>(std::max<std::int64_t>(geometry[3], 0));
        const auto elements = static_cast<std::uint64_t>(std::max<std::int64_t>(geometry[4], 0));
        require(nodes < m_records.words() && elements < m_records.words(),
                "it says that it has " + std::to_string(nodes) + " nodes and " + std::to_string(elements) + " elements");
        const auto at = [&](std::size_t plain, std::size_t low) {
            return geometry[plain] != 0 ? static_cast<std::uint64_t>(static_cast<std::uint32_t>(geometry[plain]))
                                        : pointer(geometry, low, low + 1);
        };
        readNodes(at(8, 26), nodes);
        readTypes(at(6, 20), geometry.size() > listedWord && geometry[listedWord] == 1);
        readElements(at(10, 28), elements);
    }

    // A record a node: number, place, angles of its axes in degrees.
    void readNodes(std::uint64_t word, std::uint64_t count) {
        for (std::uint64_t n = 0; n < count; ++n) {
            std::vector<double> values = m_records.reals(word, 7);
            values.resize(7, 0.0);
            require(std::abs(values[0]) < 4e9, "a node has the number " + englishNumber(values[0]));
            m_mesh.nodeIds.push_back(static_cast<std::int64_t>(values[0]));
            m_mesh.nodes.emplace_back(values[1], values[2], values[3]);
            m_angles.emplace_back(values[4], values[5], values[6]);
            word = m_records.next(word);
        }
    }

    void readTypes(std::uint64_t word, bool listed) {
        std::vector<std::int64_t> places = m_records.integers(word, mostHeader);
        std::vector<std::int64_t> numbers;
        if (listed) {
            numbers = places;
            places = m_records.integers(m_records.next(word), mostHeader);
        }
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (places[i] > 0) {
                const std::vector<std::int64_t> type = m_records.integers(word + static_cast<std::uint64_t>(places[i]), mostHeader);
                m_types[i < numbers.size() ? numbers[i] : static_cast<std::int64_t>(i) + 1] = type.size() > 1 ? type[1] : 0;
            }
        }
    }

    void readElements(std::uint64_t word, std::uint64_t count) {
        std::vector<std::int64_t> index = m_records.integers(word, 2 * count);
        const bool wide = index.size() == 2 * count;
        require(wide || index.size() == count, "the table of its elements is short");
        m_mesh.offsets.push_back(0);
        std::unordered_map<std::int64_t, std::uint32_t> places;
        for (std::size_t n = 0; n < m_mesh.nodeIds.size(); ++n) {
            places.emplace(m_mesh.nodeIds[n], static_cast<std::uint32_t>(n));
        }
        for (std::size_t e = 0; e < count; ++e) {
            const std::uint64_t offset = wide ? pointer(index, 2 * e, 2 * e + 1) : static_cast<std::uint32_t>(index[e]);
            addElement(m_records.integers(word + offset, 1000), places);
        }
        m_straight.note(m_facts.findings);
    }

    void addElement(const std::vector<std::int64_t>& values, const std::unordered_map<std::int64_t, std::uint32_t>& places) {
        require(values.size() > elementHeader, "an element is short");
        const auto type = m_types.find(values[1]);
        const auto shape = type == m_types.end() ? std::nullopt : shapeOfAnsys(type->second, values.size() - elementHeader);
        if (!shape) {
            m_facts.findings.add(
                {"fe.skipped", "Elements of a type that makes no fragment were left out", {}},
                {"fe.skipped.remedy", "Nothing to do if they are masses, springs, contacts or rigid surfaces.", {}},
                "element " + englishInteger(values[8]) + " of type " +
                    (type == m_types.end() ? "(none)" : std::to_string(type->second)));
            return;
        }
        for (std::size_t c = 0; c < static_cast<std::size_t>(cornerCount(*shape)); ++c) {
            const auto found = elementHeader + c < values.size() ? places.find(values[elementHeader + c]) : places.end();
            require(found != places.end(), "element " + std::to_string(values[8]) + " uses a node that is not there");
            m_mesh.corners.push_back(found->second);
        }
        if (*shape != ElementShape::Beam) {
            m_straight.add(*shape, EdgeOrder::TopBeforeSides,
                           placesOfNodes(std::span(values).subspan(elementHeader), places, m_mesh.nodes),
                           "element " + englishInteger(values[8]));
        }
        std::uint32_t part = 0;
        while (part < m_mesh.parts.size() && m_mesh.parts[part].fileId != values[0]) {
            ++part;
        }
        if (part == m_mesh.parts.size()) {
            m_mesh.parts.push_back({"material " + std::to_string(values[0]), values[0]});
        }
        m_mesh.part.push_back(part);
        m_mesh.elementIds.push_back(values[8]);
        m_mesh.shapes.push_back(*shape);
        m_mesh.offsets.push_back(static_cast<std::uint32_t>(m_mesh.corners.size()));
    }

    // Displacements stand in the axes of the node: turned about z, then about its x, then about its y.
    Mat3 axesOf(std::size_t node) const {
        constexpr double degree = 3.14159265358979323846 / 180.0;
        const Vec3& angles = m_angles[node];
        if (angles.isZero()) {
            return Mat3::Identity();
        }
        return (Eigen::AngleAxisd(angles.x() * degree, Vec3::UnitZ()) * Eigen::AngleAxisd(angles.y() * degree, Vec3::UnitX()) *
                Eigen::AngleAxisd(angles.z() * degree, Vec3::UnitY()))
            .toRotationMatrix();
    }

    std::string m_path;
    mutable std::mutex m_mutex;
    mutable RstRecords m_records;
    Mesh m_mesh;
    StraightEdges m_straight;
    std::vector<Vec3> m_angles;                             // of the axes of the nodes, degrees
    std::map<std::int64_t, std::int64_t> m_types;           // routine by reference number
    std::vector<std::int64_t> m_order;                      // numbers of the nodes in the order of the values
    std::unordered_map<std::int64_t, std::size_t> m_nodes;  // by number
    std::vector<std::uint64_t> m_sets;
};

constexpr std::size_t nodesWord = 2, modelNodesWord = 48;

// Nodes of the whole model, where the file holds those of one process alone; 0 for a whole result, nothing for one that ends before
// it says so. Never throws.
std::optional<std::int64_t> modelNodes(const std::string& path) {
    try {
        RstRecords records(path);
        const std::vector<std::int64_t> header = records.integers(headerWord, mostHeader);
        return header.size() > modelNodesWord && header[modelNodesWord] > header[nodesWord] ? header[modelNodesWord] : 0;
    } catch (const Error&) {
        return std::nullopt;
    }
}

bool isRst(const std::string& path) {
    try {
        return recognisesRst(readHead(path));
    } catch (const Error&) {
        return false;
    }
}

// NAME0.rst, NAME1.rst, ... of a distributed analysis; none where the file is no such piece.
std::vector<std::string> processFiles(const std::string& path) {
    const std::int64_t nodes = modelNodes(path).value_or(0);
    std::vector<std::string> files;
    if (nodes == 0) {
        return files;
    }
    for (const std::string& sibling : numberedSiblings(path)) {
        // One that is cut off belongs to them: reading it says so.
        if (sibling == path || (isRst(sibling) && modelNodes(sibling).value_or(nodes) == nodes)) {
            files.push_back(sibling);
        }
    }
    return files;
}

void requireAllPieces(const std::string& path, const std::vector<std::string>& files, const std::vector<SeriesPiece>& pieces,
                      const std::unordered_set<std::int64_t>& nodes) {
    std::string missing;
    for (std::size_t i = 0; i < files.size() && missing.empty(); ++i) {
        const std::string digits = std::to_string(i);
        const std::string stem = std::filesystem::path(files[i]).stem().string();
        if (!stem.ends_with(digits)) {
            missing = stem.substr(0, stem.find_last_not_of("0123456789") + 1) + digits + ".rst";
        }
    }
    const std::int64_t all = modelNodes(path).value_or(0);
    if (!missing.empty() || static_cast<std::int64_t>(nodes.size()) < all) {
        throw ParseError({"rst.piece_missing",
                          "{0} is a piece of a distributed analysis: {1} files hold {2} of {3} nodes; not there: {4}",
                          {path, pieces.size(), nodes.size(), all, missing.empty() ? "the files behind the last number" : missing}},
                         {"rst.piece_missing.remedy",
                          "Put the files of all processes (NAME0.rst, NAME1.rst, ...) beside each other, or let Ansys combine them "
                          "(COMBINE).",
                          {}});
    }
}

std::shared_ptr<MeshSeries> stackedProcesses(const std::string& path, const std::vector<std::string>& files) {
    std::vector<SeriesPiece> pieces;
    std::unordered_set<std::int64_t> nodes;
    for (const std::string& file : files) {
        const auto series = std::make_shared<RstSeries>(file);
        nodes.insert(series->nodeNumbers().begin(), series->nodeNumbers().end());
        pieces.push_back({file, series});
    }
    requireAllPieces(path, files, pieces, nodes);
    return std::make_shared<StackedSeries>(std::move(pieces));
}

}  // namespace

std::vector<std::string> rstMembers(const std::string& path) {
    const std::vector<std::string> files = processFiles(path);
    return withDeathList(files.empty() ? std::vector<std::string>{path} : files);
}

bool isRstPiece(const std::string& path) {
    return modelNodes(path).value_or(0) > 0;
}

bool recognisesRst(const FileHead& head) {
    std::array<std::uint32_t, 3> words{};
    if (head.packed || head.bytes.size() < 424) {
        return false;
    }
    // The standard header of a binary file has 100 integers; 12 is the unit of results.
    std::memcpy(words.data(), head.bytes.data(), sizeof words);
    return words[0] == 100 && words[1] >> 24 == 0x80 && words[2] == 12;
}

FeResult::Contents readRst(const std::string& path, const ImportSettings& settings, const Execution& execution) {
    const std::vector<std::string> files = settings.onlyThisFile ? std::vector<std::string>{} : processFiles(path);
    if (!files.empty()) {
        return readSeries(path, stackedProcesses(path, files), settings, execution);
    }
    return readSeries(path, std::make_shared<RstSeries>(path), settings, execution);
}

}  // namespace rubble::io
