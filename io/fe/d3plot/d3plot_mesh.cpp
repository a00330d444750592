#include "io/fe/d3plot/d3plot_mesh.h"

#include <algorithm>
#include <cmath>

#include "core/base/unknown.h"
#include "core/fe/components.h"
#include "io/fe/mesh_builder.h"
#include "io/fe/one_point_volume.h"

namespace rubble::io {

namespace {

/// Adds the elements kind by kind and settles what they are made of.
class MeshMaker {
public:
    MeshMaker(const D3plotFamily& family, const D3plotHeader& header, const D3plotGeometry& geometry,
              const D3plotStateLayout& layout, const D3plotStates& states, const Activity& activity,
              const std::map<std::int64_t, KeywordPart>& deck)
        : m_family(family),
          m_header(header),
          m_geometry(geometry),
          m_layout(layout),
          m_begin(states.begin.front()),
          m_activity(activity),
          m_deck(deck),
          m_builder(family.path()) {}

    D3plotMesh make() {
        m_masses = d3plotPartMasses(m_family, m_header, m_begin);
        sizeParticles();
        std::vector<Vec3> nodes = m_geometry.nodes;
        std::vector<std::int64_t> ids = m_geometry.nodeIds;
        m_result.particles.appendCorners(nodes);
        m_result.particles.appendIds(ids);
        m_builder.setNodes(std::move(ids), std::move(nodes));
        for (std::size_t p = 0; p < m_geometry.partIds.size(); ++p) {
            m_builder.addPart(m_geometry.partTitles[p], m_geometry.partIds[p]);
        }
        addElements();
        settleSections();
        settleDensities();
        m_result.mesh = m_builder.finish(m_result.findings);
        return std::move(m_result);
    }

private:
    void addElements() {
        for (const D3plotElements* solids : {&m_geometry.solids, &m_geometry.thickShells}) {
            for (std::size_t e = 0; e < solids->count(); ++e) {
                m_builder.addSolid(solids->ids[e], partOf(*solids, e), std::span(solids->nodes).subspan(8 * e, 8));
            }
        }
        const D3plotElements& beams = m_geometry.beams;
        for (std::size_t e = 0; e < beams.count(); ++e) {
            m_builder.addBeam(beams.ids[e], partOf(beams, e), std::span(beams.nodes).subspan(2 * e, 2), unknown);
        }
        const D3plotElements& shells = m_geometry.shells;
        const std::vector<double> thickness = shellThickness();
        for (std::size_t e = 0; e < shells.count(); ++e) {
            m_builder.addShell(shells.ids[e], partOf(shells, e), std::span(shells.nodes).subspan(4 * e, 4), thickness[e]);
        }
        const D3plotElements& particles = m_geometry.particles;
        for (std::size_t e = 0; e < particles.count(); ++e) {
            m_builder.addSolid(particles.ids[e], partOf(particles, e), Particles::cornersOf(e, m_geometry.nodes.size()));
        }
    }

    static std::uint32_t partOf(const D3plotElements& elements, std::size_t e) {
        return static_cast<std::uint32_t>(elements.part[e]);
    }

    // Behind the points and the resultants stand thickness, two variables of the element, and its energy.
    std::vector<double> shellThickness() const {
        const D3plotElements& shells = m_geometry.shells;
        std::vector<double> thickness(shells.count(), unknown);
        const auto& output = m_header.shellOutput;
        const std::int64_t place = m_header.points * (6 * output[0] + output[1] + m_header.shellExtra) + 8 * output[2];
        if (!output[3] || place >= m_header.shellWords) {
            return thickness;
        }
        const std::vector<double> written =
            column(m_layout.shells, static_cast<std::int64_t>(shells.count()) - m_geometry.rigidShells, m_header.shellWords, place);
        std::size_t row = 0;
        for (std::size_t e = 0; e < shells.count() && row < written.size(); ++e) {
            if (m_geometry.rigidShells > 0 && m_geometry.rigid[static_cast<std::size_t>(shells.part[e])]) {
                continue;
            }
            const double value = written[row++];
            thickness[e] = value > 0.0 && usableLength(value) ? value : unknown;
        }
        return thickness;
    }

    // One value of every row of a block of the first state.
    std::vector<double> column(std::int64_t begin, std::int64_t rows, std::int64_t width, std::int64_t place) const {
        constexpr std::int64_t valuesAtOnce = std::int64_t{1} << 17;
        const std::int64_t atOnce = std::max<std::int64_t>(1, valuesAtOnce / width);
        std::vector<double> values, result;
        for (std::int64_t done = 0; done < rows; done += atOnce) {
            const std::int64_t block = std::min(atOnce, rows - done);
            values.resize(static_cast<std::size_t>(block * width));
            m_family.readFloats(m_begin + begin + done * width, values);
            for (std::int64_t i = 0; i < block; ++i) {
                result.push_back(values[static_cast<std::size_t>(i * width + place)]);
            }
        }
        return result;
    }

    // The volume that the solver's own density belongs to; NaN where it cannot be known.
    double volumeOf(std::size_t e) const {
        const std::vector<Vec3> corners = m_builder.cornersOf(e);
        const ElementShape shape = m_builder.shape(e);
        if (shape == ElementShape::Hexahedron) {
            return std::abs(onePointVolume(corners));
        }
        return std::abs(elementVolume(shape, corners, m_builder.section(e)));
    }

    KeywordPart deckOf(std::size_t e) const {
        const auto found = m_deck.find(m_geometry.partIds[m_builder.part(e)]);
        return found == m_deck.end() ? KeywordPart{unknown, unknown, unknown} : found->second;
    }

    void settleSections() {
        for (std::size_t e = 0; e < m_builder.elementCount(); ++e) {
            const ElementShape shape = m_builder.shape(e);
            if (!isSolid(shape) && std::isnan(m_builder.section(e))) {
                m_builder.setSection(e, isShell(shape) ? deckOf(e).thickness : deckOf(e).area);
            }
        }
    }

    void settleDensities() {
        const std::size_t parts = m_geometry.partIds.size();
        const std::size_t known = m_builder.elementCount();
        std::vector<double> volume(parts, 0.0);
        for (std::size_t e = 0; e < known; ++e) {
            if (m_activity.active(0, idAt<ElementIndex>(e))) {
                volume[m_builder.part(e)] += volumeOf(e);
            }
        }
        for (std::size_t e = 0; e < known; ++e) {
            const std::size_t part = m_builder.part(e);
            const double density = m_masses.empty() ? unknown : m_masses[part] / volume[part];
            m_builder.setDensity(e, std::isfinite(density) && density > 0.0 ? density : deckOf(e).density);
        }
    }

    // A particle's volume is its share of its part's mass over its density; else the space there is for each.
    void sizeParticles() {
        const D3plotElements& particles = m_geometry.particles;
        if (particles.count() == 0) {
            return;
        }
        std::vector<std::size_t> count(m_geometry.partIds.size(), 0);
        std::vector<Aabb> bounds(count.size());
        for (std::size_t e = 0; e < particles.count(); ++e) {
            ++count[partOf(particles, e)];
            const Vec3& node = m_geometry.nodes[static_cast<std::size_t>(particles.nodes[e])];
            bounds[partOf(particles, e)].extend(node);
        }
        bool assumed = false;
        std::vector<double> densities;
        if (!m_masses.empty() && m_geometry.particleDensity >= 0) {
            densities = column(m_layout.particles, static_cast<std::int64_t>(particles.count()), m_geometry.particleWords,
                               m_geometry.particleDensity);
        }
        for (std::size_t e = 0; e < particles.count(); ++e) {
            const std::size_t part = partOf(particles, e);
            const double share = 1.0 / static_cast<double>(count[part]);
            double volume = densities.empty() ? unknown : m_masses[part] * share / densities[e];
            if (!(volume > 0.0) || !usableLength(std::cbrt(volume))) {
                volume = spacingVolume(bounds[part], count[part]);
                assumed = true;
            }
            m_result.particles.add(particles.nodes[e], volume);
        }
        m_result.findings.add({"fe.particles", "Particles are shown and dropped as cubes of their volume", {}},
                              {"fe.particles.remedy", "Nothing to do.", {}},
                              assumed ? "volume from the space between them" : "volume from mass and density",
                              static_cast<std::int64_t>(particles.count()));
    }

    const D3plotFamily& m_family;
    const D3plotHeader& m_header;
    const D3plotGeometry& m_geometry;
    const D3plotStateLayout& m_layout;
    const std::int64_t m_begin;
    const Activity& m_activity;
    const std::map<std::int64_t, KeywordPart>& m_deck;
    MeshBuilder m_builder;
    std::vector<double> m_masses;
    D3plotMesh m_result;
};

}  // namespace

D3plotMesh makeD3plotMesh(const D3plotFamily& family, const D3plotHeader& header, const D3plotGeometry& geometry,
                          const D3plotStateLayout& layout, const D3plotStates& states, const Activity& activity,
                          const std::map<std::int64_t, KeywordPart>& deck) {
    return MeshMaker(family, header, geometry, layout, states, activity, deck).make();
}

// Globals: kinetic, internal and total energy, velocity (6); then of every part internal and kinetic energy, velocity, mass and
// hourglass energy, each as a row over the parts.
std::vector<double> d3plotPartMasses(const D3plotFamily& family, const D3plotHeader& header, std::int64_t stateBegin) {
    const std::int64_t parts = header.parts;
    if (parts == 0 || parts > header.globals / 7 || header.globals < 6 + 7 * parts) {
        return {};
    }
    std::vector<double> masses(static_cast<std::size_t>(parts));
    family.readFloats(stateBegin + 1 + 6 + 5 * parts, masses);
    return masses;
}

}  // namespace rubble::io
