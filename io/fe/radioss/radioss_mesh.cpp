#include "io/fe/radioss/radioss_mesh.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/unknown.h"
#include "core/fe/components.h"
#include "io/fe/mesh_builder.h"
#include "io/fe/one_point_volume.h"

namespace rubble::io {

namespace {

bool positive(double value) {
    return value > 0.0 && std::isfinite(value);
}

/// Adds the elements kind by kind and settles what they are made of.
class MeshMaker {
public:
    MeshMaker(const std::string& path, const AnimState& first, const std::map<std::int64_t, DeckPart>& deck)
        : m_first(first), m_deck(deck), m_builder(path) {}

    RadiossMesh make() {
        m_result.fileNodes = m_first.positions.size();
        sizeParticles();
        std::vector<Vec3> nodes = m_first.positions;
        std::vector<std::int64_t> ids = m_first.nodeIds;
        if (ids.size() != nodes.size()) {
            ids.resize(nodes.size());
            for (std::size_t n = 0; n < ids.size(); ++n) {
                ids[n] = static_cast<std::int64_t>(n + 1);
            }
        }
        m_result.particles.appendCorners(nodes);
        m_result.particles.appendIds(ids);
        m_builder.setNodes(std::move(ids), std::move(nodes));
        for (std::size_t kind = 0; kind < animKinds; ++kind) {
            addKind(static_cast<AnimKind>(kind));
        }
        settleMaterials();
        m_result.mesh = m_builder.finish(m_result.findings);
        return std::move(m_result);
    }

private:
    void addKind(AnimKind kind) {
        const AnimElements& elements = m_first.of(kind);
        // Parts without elements of their own, as those of links, take nobody's name.
        std::vector<std::optional<std::uint32_t>> parts(elements.parts.size());
        const std::size_t width = animWidth(kind);
        const bool numbered = elements.ids.size() == elements.count;
        for (std::size_t e = 0; e < elements.count; ++e) {
            const std::int64_t id = numbered ? elements.ids[e] : static_cast<std::int64_t>(e + 1);
            if (kind == AnimKind::Beam && numbered && id == 0) {
                m_result.findings.add({"anim.links", "Links of rigid bodies were left out: they are no elements", {}},
                                      {"anim.links.remedy", "Nothing to do.", {}},
                                      "rigid body " + std::to_string(elements.parts[elements.part[e]].id));
                continue;
            }
            std::optional<std::uint32_t>& part = parts[elements.part[e]];
            if (!part) {
                part = m_builder.addPart(elements.parts[elements.part[e]].name, elements.parts[elements.part[e]].id);
                m_partIds.push_back(elements.parts[elements.part[e]].id);
            }
            add(kind, id, *part, e, std::span(elements.nodes).subspan(width * e, width));
        }
    }

    void add(AnimKind kind, std::int64_t id, std::uint32_t part, std::size_t e, std::span<const std::int64_t> corners) {
        switch (kind) {
            case AnimKind::Solid:
                m_builder.addSolid(id, part, corners);
                break;
            case AnimKind::Shell:
                m_builder.addShell(id, part, corners, unknown);
                break;
            case AnimKind::Beam:
                m_builder.addBeam(id, part, corners, unknown);
                break;
            case AnimKind::Particle:
                m_builder.addSolid(id, part, Particles::cornersOf(e, m_result.fileNodes));
                break;
        }
        m_result.places.emplace_back(kind, e);
    }

    static double valueOf(const std::vector<double>& values, std::size_t e) {
        return e < values.size() && positive(values[e]) ? values[e] : unknown;
    }

    DeckPart deckOf(std::size_t e) const {
        const auto found = m_deck.find(m_partIds[m_builder.part(e)]);
        return found == m_deck.end() ? DeckPart{unknown, unknown, unknown} : found->second;
    }

    // The solver's own volume of a brick is by one point.
    double sizeOf(std::size_t e) const {
        const std::vector<Vec3> corners = m_builder.cornersOf(e);
        const ElementShape shape = m_builder.shape(e);
        return shape == ElementShape::Hexahedron ? std::abs(onePointVolume(corners)) : std::abs(elementVolume(shape, corners, 1.0));
    }

    void settleMaterials() {
        struct Sum {
            double mass = 0.0;
            double volume = 0.0;
        };
        std::vector<Sum> parts(m_partIds.size());
        for (std::size_t e = 0; e < m_result.places.size(); ++e) {
            const auto& [kind, place] = m_result.places[e];
            const AnimElements& elements = m_first.of(kind);
            const DeckPart deck = deckOf(e);
            const double own = valueOf(elements.mass, place), size = sizeOf(e);
            if (!isSolid(m_builder.shape(e))) {
                m_builder.setSection(e, sectionOf(kind, elements, place, deck, size));
            }
            const double section = isSolid(m_builder.shape(e)) ? 1.0 : m_builder.section(e);
            if (positive(own) && positive(size * section)) {
                parts[m_builder.part(e)].mass += own;
                parts[m_builder.part(e)].volume += size * section;
            }
        }
        for (std::size_t e = 0; e < m_result.places.size(); ++e) {
            const auto& [kind, place] = m_result.places[e];
            const Sum& part = parts[m_builder.part(e)];
            double density = part.mass / part.volume;
            if (!positive(density)) {
                density = valueOf(m_first.of(kind).density, place);
            }
            m_builder.setDensity(e, positive(density) ? density : deckOf(e).density);
        }
    }

    static double sectionOf(AnimKind kind, const AnimElements& elements, std::size_t place, const DeckPart& deck, double size) {
        const double written = valueOf(elements.thickness, place);
        if (positive(written)) {
            return written;
        }
        const double density = valueOf(elements.density, place);
        const double fromMass = valueOf(elements.mass, place) / ((positive(density) ? density : deck.density) * size);
        return positive(fromMass) ? fromMass : kind == AnimKind::Shell ? deck.thickness : deck.area;
    }

    void sizeParticles() {
        const AnimElements& particles = m_first.of(AnimKind::Particle);
        if (particles.count == 0) {
            return;
        }
        Aabb bounds;
        for (const std::int64_t node : particles.nodes) {
            bounds.extend(m_first.positions[static_cast<std::size_t>(node)]);
        }
        const double spacing = spacingVolume(bounds, particles.count);
        for (std::size_t e = 0; e < particles.count; ++e) {
            const double volume = valueOf(particles.mass, e) / valueOf(particles.density, e);
            m_result.particles.add(particles.nodes[e], positive(volume) ? volume : spacing);
        }
        m_result.findings.add({"fe.particles", "Particles are shown and dropped as cubes of their volume", {}},
                              {"fe.particles.remedy", "Nothing to do.", {}},
                              "volume from mass and density, or from the space between them",
                              static_cast<std::int64_t>(particles.count));
    }

    const AnimState& m_first;
    const std::map<std::int64_t, DeckPart>& m_deck;
    MeshBuilder m_builder;
    std::vector<std::int64_t> m_partIds;  // by part of the mesh
    RadiossMesh m_result;
};

}  // namespace

RadiossMesh makeRadiossMesh(const std::string& path, const AnimState& first, const std::map<std::int64_t, DeckPart>& deck) {
    return MeshMaker(path, first, deck).make();
}

}  // namespace rubble::io
