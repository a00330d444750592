#include "io/fe/d3plot/d3plot_geometry.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>

#include "core/base/error.h"
#include "io/fe/d3plot/d3plot_titles.h"

namespace rubble::io {

namespace {

constexpr std::int64_t rigidMaterial = 20;

/// What is added up cannot overflow: counts are bounded by the words of the family, which has at most 2^60.
class GeometryReader {
public:
    GeometryReader(const D3plotFamily& family, const D3plotHeader& header, const Execution& execution)
        : m_family(family), m_header(header), m_execution(execution), m_word(header.words) {}

    D3plotGeometry read() {
        const Message stage{"d3plot.geometry", "Reading the mesh", {}};
        m_execution.report(stage, 0.0);
        readMaterialTypes();
        skip(m_header.fluidMaterials, "fluid materials");
        readParticleFlags();
        readAirbagFlags();
        readNodes();
        m_execution.report(stage, 0.4);
        readElements(m_geometry.solids, m_header.solids, 8, 8, "solids");
        readElements(m_geometry.thickShells, m_header.thickShells, 8, 8, "thick shells");
        readElements(m_geometry.beams, m_header.beams, 5, 2, "beams");
        readElements(m_geometry.shells, m_header.shells, 4, 4, "shells");
        m_execution.report(stage, 0.8);
        skipCopyOfExtraNodes();
        readNumbers();
        skip(2 * m_header.adapted, "adapted elements");
        readParticles();
        skip(m_airbagGeometry * m_bags, "airbags");
        readRoad();
        skip((m_header.tenNodes ? 2 * m_header.solids : 0) + 5 * m_header.eightNodeShells + 13 * m_header.twentyNodeSolids,
             "further nodes of elements");
        settleNumbers();
        findStates();
        m_execution.report(stage, 1.0);
        return std::move(m_geometry);
    }

private:
    // All reading goes through here: nothing is allocated for what the files do not hold.
    void require(std::int64_t words, const std::string& what) const {
        if (words > m_family.words() - m_word) {
            throw ParseError({"d3plot.cut_geometry",
                              "{0} is cut off: {1} take {2} bytes from {3} on, and {4} bytes are left",
                              {m_family.path(), what, words * m_family.format().bytes, m_family.placeOf(m_word),
                               (m_family.words() - m_word) * m_family.format().bytes}},
                             {"d3plot.cut.remedy", "Copy the file again, or wait until the analysis has written it.", {}});
        }
    }

    void skip(std::int64_t words, const std::string& what) {
        require(words, what);
        m_word += words;
    }

    std::vector<std::int64_t> integers(std::int64_t count, const std::string& what) {
        require(count, what);
        std::vector<std::int64_t> values(static_cast<std::size_t>(count));
        m_family.readIntegers(m_word, values);
        m_word += count;
        return values;
    }

    // A length that the geometry itself gives; the rest of the family bounds it.
    std::int64_t length(std::int64_t value, const std::string& what) const {
        if (value < 0 || value > m_family.words()) {
            throw ParseError({"d3plot.bad_length",
                              "{0}: the length of the {1} before {2} is {3}; expected: 0 to {4}, the words of all files",
                              {m_family.path(), what, m_family.placeOf(m_word), value, m_family.words()}},
                             {"d3plot.bad_word.remedy", "The file is damaged, or no d3plot: copy it again.", {}});
        }
        return value;
    }

    void readMaterialTypes() {
        if (!m_header.hasMaterialTypes()) {
            return;
        }
        const std::vector<std::int64_t> counts = integers(2, "material types");
        m_geometry.rigidShells = length(counts[0], "rigid shells");
        const std::vector<std::int64_t> types = integers(length(counts[1], "material types"), "material types");
        for (const std::int64_t type : types) {
            m_geometry.rigid.push_back(type == rigidMaterial);
        }
        if (m_geometry.rigidShells > m_header.shells) {
            throw ParseError({"d3plot.rigid_shells",
                              "{0}: {1} shells are said to be rigid, of {2}",
                              {m_family.path(), m_geometry.rigidShells, m_header.shells}},
                             {"d3plot.bad_word.remedy", "The file is damaged, or no d3plot: copy it again.", {}});
        }
    }

    // Flag i is the number of words of the i-th value of a particle: radius, pressure, stress, plastic strain, density, ...
    void readParticleFlags() {
        if (m_header.particles == 0) {
            return;
        }
        constexpr std::size_t density = 5;
        const std::int64_t count = length(integers(1, "flags of particles").front(), "flags of particles");
        m_word -= 1;
        const std::vector<std::int64_t> flags = integers(std::max<std::int64_t>(count, 1), "flags of particles");
        m_geometry.particleWords = 1;
        for (std::size_t i = 1; i < flags.size(); ++i) {
            if (i == density && flags[i] == 1) {
                m_geometry.particleDensity = m_geometry.particleWords;
            }
            m_geometry.particleWords += length(std::abs(std::max(flags[i], -m_family.words() - 1)), "flags of particles");
        }
    }

    void readAirbagFlags() {
        if (m_header.airbags == 0) {
            return;
        }
        const std::int64_t subversion = m_header.airbags / 1000;
        m_bags = m_header.airbags % 1000;
        const std::vector<std::int64_t> flags = integers(subversion == 4 ? 5 : 4, "flags of airbags");
        m_airbagGeometry = length(flags[0], "airbags");
        const std::int64_t values = length(flags[1], "airbags"), particles = length(flags[2], "airbags"),
                           bagValues = length(flags[3], "airbags");
        skip(9 * (m_airbagGeometry + values + bagValues), "airbags");
        std::int64_t words = 0;
        if (__builtin_mul_overflow(particles, values, &words)) {
            words = m_family.words() + 1;
        }
        m_geometry.airbagWords = length(words, "airbags") + m_bags * bagValues;
        m_airbagGeometry = length(m_airbagGeometry, "airbags");
    }

    void readNodes() {
        const std::int64_t count = m_header.nodes;
        if (count == 0) {
            throw ParseError({"d3plot.no_nodes", "{0} has no nodes", {m_family.path()}},
                             {"fe.no_elements.remedy", "Give an analysis whose structure is made of such elements.", {}});
        }
        require(3 * count, "coordinates of " + englishInteger(count) + " nodes");
        std::vector<double> values(static_cast<std::size_t>(3 * count));
        m_family.readFloats(m_word, values);
        m_word += 3 * count;
        m_geometry.nodes.resize(static_cast<std::size_t>(count));
        for (std::size_t n = 0; n < m_geometry.nodes.size(); ++n) {
            m_geometry.nodes[n] = Vec3(values[3 * n], values[3 * n + 1], values[3 * n + 2]);
        }
    }

    // Rows of `width` words and the part; the first `kept` words are nodes.
    void readElements(D3plotElements& elements, std::int64_t count, std::int64_t width, std::int64_t kept,
                      const std::string& kind) {
        require(count * (width + 1), englishInteger(count) + " " + kind);
        constexpr std::int64_t rowsAtOnce = 65536;
        std::vector<std::int64_t> rows;
        elements.nodes.reserve(static_cast<std::size_t>(count * kept));
        elements.part.reserve(static_cast<std::size_t>(count));
        for (std::int64_t done = 0; done < count;) {
            const std::int64_t block = std::min(rowsAtOnce, count - done);
            const std::int64_t from = m_word;
            rows = integers(block * (width + 1), kind);
            for (std::int64_t row = 0; row < block; ++row) {
                const auto first = static_cast<std::size_t>(row * (width + 1));
                for (std::int64_t i = 0; i < kept; ++i) {
                    elements.nodes.push_back(
                        checked(rows[first + static_cast<std::size_t>(i)], m_header.nodes, "node", kind, done + row, from));
                }
                elements.part.push_back(checked(rows[first + static_cast<std::size_t>(width)],
                                                std::max<std::int64_t>(m_header.parts, 1), "part", kind, done + row, from));
            }
            done += block;
        }
    }

    std::int64_t checked(std::int64_t value, std::int64_t count, const char* what, const std::string& kind, std::int64_t row,
                         std::int64_t word) const {
        if (value < 1 || value > count) {
            throw ParseError({"d3plot.bad_index",
                              "{0}: number {1} of the {2} (after {3}) uses {4} {5} of {6}",
                              {m_family.path(), row + 1, kind, m_family.placeOf(word), what, value, count}},
                             {"d3plot.bad_word.remedy", "The file is damaged, or no d3plot: copy it again.", {}});
        }
        return value - 1;
    }

    // Some writers put the two further nodes of ten-node solids here as well.
    void skipCopyOfExtraNodes() {
        constexpr std::int64_t nodeCountWord = 5;
        if (!m_header.tenNodes || m_header.idWords == 0) {
            return;
        }
        const auto counts = [&](std::int64_t from) {
            return from + nodeCountWord < m_family.words() && m_family.readInteger(from + nodeCountWord) == m_header.nodes;
        };
        if (!counts(m_word) && counts(m_word + 2 * m_header.solids)) {
            m_word += 2 * m_header.solids;
        }
    }

    void readNumbers();
    void readPartNumbers(std::vector<std::int64_t>::const_iterator from);
    void settleNumbers();

    void readParticles() {
        const std::vector<std::int64_t> rows = integers(2 * m_header.particles, "particles");
        for (std::size_t i = 0; i + 1 < rows.size(); i += 2) {
            const auto row = static_cast<std::int64_t>(i / 2);
            m_geometry.particles.nodes.push_back(checked(rows[i], m_header.nodes, "node", "particles", row, m_word));
            m_geometry.particles.part.push_back(
                checked(rows[i + 1], std::max<std::int64_t>(m_header.parts, 1), "part", "particles", row, m_word));
        }
    }

    void readRoad() {
        if (!m_header.hasRoad()) {
            return;
        }
        const std::vector<std::int64_t> counts = integers(4, "the rigid road");
        const std::int64_t nodes = length(counts[0], "rigid road"), surfaces = length(counts[2], "rigid road");
        skip(4 * nodes, "nodes of the rigid road");
        for (std::int64_t s = 0; s < surfaces; ++s) {
            const std::int64_t segments = length(integers(2, "a surface of the rigid road")[1], "rigid road");
            skip(4 * segments, "segments of the rigid road");
        }
        m_geometry.roadWords = counts[3] != 0 ? 6 * surfaces : 0;
    }

    void findStates() {
        m_geometry.end = m_word;
        if (m_word < m_family.words() && isEndMark(m_family.readFloat(m_word))) {
            m_geometry.partTitles = readD3plotTitles(m_family, m_word + 1, m_titleIds);
            m_geometry.end = m_family.firstWord(m_family.fileOf(m_word) + 1);
        }
        m_geometry.partTitles.resize(m_geometry.partIds.size());
        if (!m_hasPartIds) {
            for (std::size_t p = 0; p < std::min(m_titleIds.size(), m_geometry.partIds.size()); ++p) {
                m_geometry.partIds[p] = m_titleIds[p];
            }
        }
    }

    const D3plotFamily& m_family;
    const D3plotHeader& m_header;
    const Execution& m_execution;
    std::int64_t m_word;
    std::int64_t m_bags = 0, m_airbagGeometry = 0;
    bool m_hasPartIds = false;
    std::vector<std::int64_t> m_titleIds;
    D3plotGeometry m_geometry;
};

// Nodes, solids, beams, shells, thick shells, and the parts in their internal order.
void GeometryReader::readNumbers() {
    const std::int64_t start = m_word;
    skip(m_header.idWords, "user's numbers");
    if (m_header.idWords == 0) {
        return;
    }
    const std::array<std::int64_t, 5> counts{m_header.nodes, m_header.solids, m_header.beams, m_header.shells,
                                             m_header.thickShells};
    const std::int64_t all = std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
    // Numbers of eight bytes in a family of four are two words each.
    const bool wide = m_header.wideIds && m_family.format().bytes == 4;
    std::vector<std::int64_t> words;
    if (!wide) {
        words.resize(static_cast<std::size_t>(m_header.idWords));
        m_family.readIntegers(start, words);
    } else {
        skip(m_header.idWords, "user's numbers of 8 bytes");
    }
    constexpr std::size_t counted = 5;
    const bool fits = words.size() >= 10 &&
                      std::equal(counts.begin(), counts.end(), words.begin() + counted, [](auto a, auto b) { return a == b; });
    const std::size_t header = fits && words[0] < 0 ? 16 : 10;
    if (!fits || words.size() < header + static_cast<std::size_t>(all)) {
        m_geometry.findings.add(
            {"d3plot.no_numbers", "The user's numbers cannot be read; elements are numbered as they stand in the file", {}},
            {"d3plot.no_numbers.remedy", "Nothing to do if you do not need the numbers.", {}}, m_family.placeOf(start));
        return;
    }
    auto from = words.begin() + static_cast<std::ptrdiff_t>(header);
    for (auto [list, count] : {std::pair{&m_geometry.nodeIds, counts[0]}, std::pair{&m_geometry.solids.ids, counts[1]},
                               std::pair{&m_geometry.beams.ids, counts[2]}, std::pair{&m_geometry.shells.ids, counts[3]},
                               std::pair{&m_geometry.thickShells.ids, counts[4]}}) {
        list->assign(from, from + count);
        from += count;
    }
    if (words[0] < 0 && words.end() - from >= m_header.parts) {
        m_geometry.partIds.assign(from, from + m_header.parts);
        m_hasPartIds = true;
    }
}

// What the file does not number is numbered as it stands there.
void GeometryReader::settleNumbers() {
    const auto settle = [](std::vector<std::int64_t>& ids, std::size_t count) {
        if (ids.size() != count) {
            ids.resize(count);
            std::iota(ids.begin(), ids.end(), std::int64_t{1});
        }
    };
    settle(m_geometry.nodeIds, m_geometry.nodes.size());
    for (D3plotElements* elements : {&m_geometry.solids, &m_geometry.thickShells, &m_geometry.beams, &m_geometry.shells}) {
        settle(elements->ids, elements->count());
    }
    // A particle is known by its node.
    for (const std::int64_t node : m_geometry.particles.nodes) {
        m_geometry.particles.ids.push_back(m_geometry.nodeIds[static_cast<std::size_t>(node)]);
    }
    settle(m_geometry.partIds, static_cast<std::size_t>(std::max<std::int64_t>(m_header.parts, 1)));
    m_geometry.rigid.resize(m_geometry.partIds.size(), false);
}

}  // namespace

D3plotGeometry readD3plotGeometry(const D3plotFamily& family, const D3plotHeader& header, const Execution& execution) {
    return GeometryReader(family, header, execution).read();
}

bool isEndMark(double word) {
    return word == -999999.0;
}

}  // namespace rubble::io
