#include "io/fe/d3plot/d3plot_activity.h"

#include <algorithm>
#include <cmath>

namespace rubble::io {

namespace {

/// Rows of values of one kind of element within a state, and which of them are stresses or forces.
struct StressRows {
    const D3plotElements* elements = nullptr;
    std::size_t first = 0;   ///< element of the first row in the mesh
    std::int64_t begin = 0;  ///< word within the state
    std::int64_t width = 0;  ///< words of a row
    std::vector<std::int64_t> places;
    bool rigidLeftOut = false;  ///< elements of rigid parts have no row
};

class ActivityReader {
public:
    ActivityReader(const D3plotFamily& family, const D3plotHeader& header, const D3plotGeometry& geometry,
                   const D3plotStateLayout& layout, const D3plotStates& states, const Execution& execution)
        : m_family(family), m_header(header), m_geometry(geometry), m_layout(layout), m_states(states), m_execution(execution) {
        m_beamsFrom = geometry.solids.count() + geometry.thickShells.count();
        m_shellsFrom = m_beamsFrom + geometry.beams.count();
        m_particlesFrom = m_shellsFrom + geometry.shells.count();
        m_result.activity = Activity(states.times.size(), m_particlesFrom + geometry.particles.count());
    }

    D3plotActivity read() {
        const Message stage{"d3plot.activity", "Reading active elements", {}};
        const std::size_t states = m_states.times.size();
        if (m_header.deletion == DeletionTable::None) {
            listStressRows();
            m_stressed.assign(m_particlesFrom, false);
        }
        for (std::size_t k = 0; k < states; ++k) {
            m_execution.report(stage, static_cast<double>(k) / static_cast<double>(states));
            readState(k);
        }
        m_execution.report(stage, 1.0);
        describe();
        return std::move(m_result);
    }

private:
    void set(std::size_t k, std::size_t element, bool active) {
        if (active) {
            m_result.activity.set(k, idAt<ElementIndex>(element), true);
        }
    }

    void readState(std::size_t k) {
        switch (m_header.deletion) {
            case DeletionTable::Elements:
                readElementTable(k);
                break;
            case DeletionTable::Nodes:
                readNodeTable(k);
                break;
            case DeletionTable::None:
                readStresses(k);
                break;
        }
        readParticles(k);
    }

    std::vector<double> table(std::size_t k, std::int64_t offset, std::int64_t count) const {
        std::vector<double> values(static_cast<std::size_t>(count));
        m_family.readFloats(m_states.begin[k] + offset, values);
        return values;
    }

    // The table has shells before beams, the numbers and the mesh beams before shells.
    void readElementTable(std::size_t k) {
        const std::vector<double> values = table(k, m_layout.deletion, static_cast<std::int64_t>(m_particlesFrom));
        const std::size_t shells = m_geometry.shells.count();
        for (std::size_t i = 0; i < values.size(); ++i) {
            std::size_t element = i;
            if (i >= m_beamsFrom) {
                element = i < m_beamsFrom + shells ? m_shellsFrom + (i - m_beamsFrom) : i - shells;
            }
            const double value = values[i];
            if (value < 0.0 || std::isnan(value)) {
                m_result.findings.add(
                    {"d3plot.odd_deletion",
                     "Entries of the deletion table are negative or no number; these elements count as dead",
                     {}},
                    {"d3plot.odd_deletion.remedy", "Check these elements; the file may be damaged.", {}},
                    "entry " + std::to_string(i) + " at state " + std::to_string(k) + ": " + englishNumber(value));
            }
            set(k, element, value > 0.0);
        }
    }

    void readNodeTable(std::size_t k) {
        const std::vector<double> visible = table(k, m_layout.deletion, m_header.nodes);
        std::size_t element = 0;
        for (const auto& [elements, width] : {std::pair{&m_geometry.solids, 8}, std::pair{&m_geometry.thickShells, 8},
                                              std::pair{&m_geometry.beams, 2}, std::pair{&m_geometry.shells, 4}}) {
            for (std::size_t e = 0; e < elements->count(); ++e, ++element) {
                bool any = false;
                for (int i = 0; i < width; ++i) {
                    const std::int64_t node = elements->nodes[e * static_cast<std::size_t>(width) + static_cast<std::size_t>(i)];
                    any |= visible[static_cast<std::size_t>(node)] > 0.0;
                }
                set(k, element, any);
            }
        }
    }

    void listStressRows() {
        const auto first = [](std::int64_t count) {
            std::vector<std::int64_t> places;
            for (std::int64_t i = 0; i < count; ++i) {
                places.push_back(i);
            }
            return places;
        };
        constexpr std::int64_t components = 6;
        m_rows.push_back(
            {&m_geometry.solids, 0, m_layout.solids, m_header.solidWords, first(std::min(components, m_header.solidWords)), false});
        m_rows.push_back({&m_geometry.thickShells, m_geometry.solids.count(), m_layout.thickShells, m_header.thickShellWords,
                          pointPlaces(m_header.thickShellWords), false});
        m_rows.push_back({&m_geometry.beams, m_beamsFrom, m_layout.beams, m_header.beamWords,
                          first(std::min(components, m_header.beamWords)), false});
        m_rows.push_back({&m_geometry.shells, m_shellsFrom, m_layout.shells, m_header.shellWords, pointPlaces(m_header.shellWords),
                          m_geometry.rigidShells > 0});
    }

    // Stresses of all points through the thickness; the resultants where these are not written.
    std::vector<std::int64_t> pointPlaces(std::int64_t width) const {
        std::vector<std::int64_t> places;
        const auto& output = m_header.shellOutput;
        const std::int64_t point = 6 * output[0] + output[1] + m_header.shellExtra;
        for (std::int64_t p = 0; output[0] && p < m_header.points; ++p) {
            for (std::int64_t i = 0; i < 6; ++i) {
                places.push_back(p * point + i);
            }
        }
        for (std::int64_t i = 0; places.empty() && output[2] && i < 8; ++i) {
            places.push_back(m_header.points * point + i);
        }
        std::erase_if(places, [width](std::int64_t place) { return place >= width; });
        return places;
    }

    void readStresses(std::size_t k) {
        constexpr std::int64_t valuesAtOnce = std::int64_t{1} << 17;
        for (const StressRows& rows : m_rows) {
            const std::int64_t atOnce = std::max<std::int64_t>(1, valuesAtOnce / std::max<std::int64_t>(1, rows.width));
            std::vector<double> values;
            std::int64_t row = 0, block = 0, blockEnd = 0;
            for (std::size_t e = 0; e < rows.elements->count(); ++e) {
                const auto part = static_cast<std::size_t>(rows.elements->part[e]);
                if (rows.places.empty() || (rows.rigidLeftOut && m_geometry.rigid[part])) {
                    set(k, rows.first + e, true);
                    continue;
                }
                if (row >= blockEnd) {
                    const std::int64_t left = static_cast<std::int64_t>(rows.elements->count() - e);
                    block = row;
                    blockEnd = row + std::min(atOnce, std::min(left, rowsOf(rows) - row));
                    if (blockEnd <= row) {
                        set(k, rows.first + e, true);
                        continue;
                    }
                    values = table(k, rows.begin + block * rows.width, (blockEnd - block) * rows.width);
                }
                const auto at = static_cast<std::size_t>((row - block) * rows.width);
                const bool zero = std::all_of(rows.places.begin(), rows.places.end(), [&](std::int64_t place) {
                    return values[at + static_cast<std::size_t>(place)] == 0.0;
                });
                setByStress(k, rows.first + e, zero);
                ++row;
            }
        }
    }

    std::int64_t rowsOf(const StressRows& rows) const {
        const auto count = static_cast<std::int64_t>(rows.elements->count());
        return rows.rigidLeftOut ? count - m_geometry.rigidShells : count;
    }

    void setByStress(std::size_t k, std::size_t element, bool zero) {
        set(k, element, !zero || !m_stressed[element]);
        if (!zero) {
            m_stressed[element] = true;
        }
    }

    // The first word of a particle is its material, zero or less once it is gone.
    void readParticles(std::size_t k) {
        const auto count = static_cast<std::int64_t>(m_geometry.particles.count());
        if (count == 0) {
            return;
        }
        const std::vector<double> values = table(k, m_layout.particles, count * m_geometry.particleWords);
        for (std::int64_t p = 0; p < count; ++p) {
            set(k, m_particlesFrom + static_cast<std::size_t>(p),
                values[static_cast<std::size_t>(p * m_geometry.particleWords)] > 0.0);
        }
    }

    void describe() {
        switch (m_header.deletion) {
            case DeletionTable::Elements:
                m_result.from = "deletion table, 0 is dead (MDLOPT 2)";
                return;
            case DeletionTable::Nodes:
                m_result.from = "deletion table of nodes: dead when all nodes are gone (MDLOPT 1)";
                m_result.findings.add(
                    {"d3plot.node_table",
                     "The file tells which nodes are gone, not which elements: dead elements whose nodes others still use "
                     "cannot be seen",
                     {}},
                    {"d3plot.node_table.remedy", "Write the d3plot with a version that deletes by element.", {}}, m_family.path());
                return;
            case DeletionTable::None:
                m_result.from = "inferred: dead when all stresses have become 0 (no deletion table, MDLOPT 0)";
                m_result.findings.add({"d3plot.inferred",
                                       "The file has no deletion table; elements whose stresses have become 0 are taken for dead",
                                       {}},
                                      {"d3plot.inferred.remedy", "Compare the deaths with the analysis.", {}}, m_family.path());
                return;
        }
    }

    const D3plotFamily& m_family;
    const D3plotHeader& m_header;
    const D3plotGeometry& m_geometry;
    const D3plotStateLayout& m_layout;
    const D3plotStates& m_states;
    const Execution& m_execution;
    std::size_t m_beamsFrom = 0, m_shellsFrom = 0, m_particlesFrom = 0;
    std::vector<StressRows> m_rows;
    std::vector<bool> m_stressed;
    D3plotActivity m_result;
};

}  // namespace

D3plotActivity readD3plotActivity(const D3plotFamily& family, const D3plotHeader& header, const D3plotGeometry& geometry,
                                  const D3plotStateLayout& layout, const D3plotStates& states, const Execution& execution) {
    return ActivityReader(family, header, geometry, layout, states, execution).read();
}

}  // namespace rubble::io
