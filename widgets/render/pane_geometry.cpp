#include "widgets/render/pane_geometry.h"

#include <algorithm>
#include <cmath>

#include "core/analysis/debris/debris_measures.h"
#include "widgets/render/basics/colour_choice.h"
#include "widgets/render/shapes/vertex_cells.h"

namespace rubble::render {
namespace {

constexpr double sameInstant = 0.01;  // of the interval between two states

/// A time close to an FE state is that state: solvers write it at 5.7602 s when 5.76 s was asked for.
double snapped(const FeResult& fe, double time) {
    const auto& times = fe.times();
    const auto next = std::lower_bound(times.begin(), times.end(), time);
    for (const auto state : {next, next == times.begin() ? next : next - 1}) {
        if (state == times.end()) {
            continue;
        }
        const auto k = static_cast<std::size_t>(state - times.begin());
        const double before = k > 0 ? times[k] - times[k - 1] : 0.0;
        const double after = k + 1 < times.size() ? times[k + 1] - times[k] : before;
        const double interval = k > 0 ? std::min(before, after) : after;
        if (std::abs(*state - time) <= std::max(sameTime, sameInstant * interval)) {
            return *state;
        }
    }
    return time;
}

/// The times of the elements that are not hidden; the others have none.
ShowTimes without(const ShowTimes& times, const std::vector<std::uint8_t>& hidden) {
    ShowTimes left;
    left.offsets.push_back(0);
    for (std::size_t e = 0; e + 1 < times.offsets.size(); ++e) {
        if (hidden[e] == 0) {
            const auto own = times.of(idAt<ElementIndex>(e));
            left.spans.insert(left.spans.end(), own.begin(), own.end());
        }
        left.offsets.push_back(static_cast<std::uint32_t>(left.spans.size()));
    }
    return left;
}

}  // namespace

PaneGeometry::PaneGeometry(PaneContent content, const SceneData& data, bool allFaces, std::shared_ptr<StateReadAhead> states)
    : m_content(content),
      m_data(data),
      m_allFaces(allFaces),
      m_motion(data.fe, states ? std::move(states) : std::make_shared<StateReadAhead>(data.fe)),
      m_islands(data.fe) {
    if (content == PaneContent::Fe) {
        m_data.fragments = nullptr;
        m_data.clustering = nullptr;
        m_data.trajectory = nullptr;
    }
    m_status.states = static_cast<std::uint32_t>(data.fe->stateCount());
    m_status.elements = data.fe->mesh().elementCount();
    m_status.looseBodies = data.fe->contents().looseBodies;
    makeFaces(m_data.fragments && m_data.trajectory && m_data.trajectory->frameCount() > 0);
}

void PaneGeometry::makeFaces(bool carried) {
    m_carried = carried;
    const bool hideInner = !m_allFaces && !m_clip;
    m_showTimes = m_data.fragments ? showTimes(*m_data.fe, *m_data.fragments, carried) : showTimes(*m_data.fe);
    m_structure = std::make_unique<StructureFaces>(m_data.fe->mesh(),
                                                   m_hidden.empty() ? m_showTimes : without(m_showTimes, m_hidden), hideInner);
    if (m_data.fragments) {
        std::vector<std::uint8_t> left(m_hidden.empty() ? 0 : m_data.fragments->size(), 0);
        for (std::size_t f = 0; f < left.size(); ++f) {
            left[f] = m_hidden[at(m_data.fragments->list[f].element)];
        }
        // A fragment that is left out opens its cluster.
        m_debris =
            std::make_unique<DebrisGeometry>(*m_data.fragments, m_data.clustering.get(), hideInner && m_filter.empty(), left);
        m_boundBodies = 0;
    }
    m_elementCounts = std::make_unique<ElementCounts>(m_showTimes);
    if (m_data.fragments) {
        m_slots = std::make_unique<FragmentSlots>(*m_data.fragments, m_data.clustering.get(),
                                                  m_data.components ? m_data.components->list.size() : 0, carried);
    }
    m_visible.clear();
    m_structureSlot = m_debrisSlot = ~std::uint64_t{0};
    m_placed = false;
    m_coarse.reset();
    m_cellsWanted.reset();
    m_cells = {};
}

void PaneGeometry::setHidden(std::vector<std::uint8_t> hidden) {
    if (hidden != m_hidden) {
        m_hidden = std::move(hidden);
        makeFaces(m_carried);
    }
}

void PaneGeometry::setClip(const std::optional<ClipPlane>& clip) {
    const bool opened = clip.has_value() != m_clip.has_value();
    m_clip = clip;
    if (opened && !m_allFaces) {
        makeFaces(m_carried);
    }
}

void PaneGeometry::followTrajectory() {
    if (!m_data.trajectory || !m_debris) {
        return;
    }
    if (!m_carried && m_data.trajectory->frameCount() > 0) {
        makeFaces(true);
    }
}

void PaneGeometry::bindBodies() {
    const std::vector<Carrier> carriers = m_data.trajectory->carriers();
    m_debris->bind(carriers);
    m_boundBodies = m_frame.bodies();
    for (const Carrier& carrier : carriers) {
        m_boundBodies = std::max(m_boundBodies, at(carrier.body) + 1);
    }
    bindIslands();
    m_debrisSlot = ~std::uint64_t{0};
    m_coarse.reset();
    m_cells = {};
}

void PaneGeometry::bindIslands() {
    const bool grows = !m_data.trajectory->complete();
    const std::vector<BodyRecord> bodies = m_data.trajectory->bodies();
    std::vector<IslandRecord> islands = m_data.trajectory->islands();
    // A run that grows may have added the body of an island, and not yet the island.
    std::vector<std::uint8_t> named(bodies.size(), 0);
    for (const IslandRecord& island : islands) {
        if (at(island.body) < named.size()) {
            named[at(island.body)] = 1;
        }
    }
    for (std::size_t b = 0; grows && b < bodies.size(); ++b) {
        if (bodies[b].isIsland() && named[b] == 0) {
            m_boundBodies = std::min(m_boundBodies, b);
        }
    }
    m_wasAfloat.assign(islands.empty() ? 0 : m_status.elements, 0);
    for (const IslandRecord& island : islands) {
        for (const ElementIndex element : island.elements) {
            if (at(element) < m_wasAfloat.size()) {
                m_wasAfloat[at(element)] = 1;
            }
        }
    }
    m_islands.bind(std::move(islands), bodies);
}

double PaneGeometry::shownTime(double time) {
    const double feEnd = m_data.fe->times().back();
    m_status.waitsForRun = false;
    m_status.simulated = m_carried;
    double shown = snapped(*m_data.fe, time);
    if (m_carried) {
        const double end = m_data.trajectory->frameTime(m_data.trajectory->frameCount() - 1);
        if (shown > end + sameTime) {
            m_status.waitsForRun = !m_data.trajectory->complete();
            shown = snapped(*m_data.fe, end);
        }
    } else {
        shown = std::min(shown, feEnd);
    }
    m_status.afterFeEnd = time > feEnd + sameTime;
    m_status.time = shown;
    return shown;
}

void PaneGeometry::update(double time, ColourBy colourBy, const ColourScale& scale, const std::vector<ElementIndex>& selection) {
    followTrajectory();
    const double shown = shownTime(time);
    const bool moved = !m_placed || shown != m_placedTime || (!m_simplify && !m_motion.exact());
    if (moved) {
        m_motion.moveTo(shown, !m_simplify);
        if (m_carried) {
            m_frame = frameAtTime(*m_data.trajectory, shown);
            if (m_frame.bodies() > m_boundBodies) {
                bindBodies();
            }
            m_islands.moveTo(m_frame, shown);
        }
    }
    m_status.state = static_cast<std::uint32_t>(m_motion.state());
    m_status.statesApart = m_motion.statesApart();
    m_status.interpolated = m_carried ? m_frame.kind == FrameKind::Interpolated : m_motion.interpolated();
    m_status.kind = m_carried ? m_frame.kind : (m_motion.interpolated() ? FrameKind::Interpolated : FrameKind::Fe);

    const bool otherStyle = settleLooks(scale, colourBy);
    const bool otherLooks = settleIslands(shown, colourBy, scale) || otherStyle;
    const std::size_t structureSlot = m_structure->slotAt(shown);
    const std::size_t debrisSlot = m_slots ? m_slots->slotAt(shown) : 0;
    const bool otherIslands = m_islands.version() != m_islandsDrawn;
    const bool otherDetail = settleDetail();
    const bool otherFilter = settleFilter();
    const bool changed =
        otherLooks || otherDetail || otherIslands || otherFilter || structureSlot != m_structureSlot || debrisSlot != m_debrisSlot;
    if (changed) {
        findVisible(structureSlot);
        m_debrisSlot = debrisSlot;
        m_islandsDrawn = m_islands.version();
        rebuildTriangles();
        countShown(shown);
    }
    m_status.ahead = m_slots ? countAhead() : 0;
    if (changed || moved) {
        place(shown);
        m_placedTime = shown;
        m_placed = true;
        m_coloured = m_coloured && !changed && colourBy != ColourBy::Speed && colourBy != ColourBy::Error;
    }
    const bool otherSteps = colourBy == ColourBy::Error && scale.errorSteps != m_colouredSteps;
    if (!m_coloured || colourBy != m_colourBy || otherSteps || !(scale.colours == m_colouredWith)) {
        colour(colourBy, scale);
        m_coloured = true;
    }
    if (changed || selection != m_selection) {
        select(selection);
    }
}

/// Which components look alike while they are active: by grey, by a colour of their own, or by material. True if that has changed.
bool PaneGeometry::settleLooks(const ColourScale& scale, ColourBy colourBy) {
    const std::size_t components = m_data.components ? m_data.components->list.size() : m_data.fe->mesh().parts.size();
    std::vector<std::uint32_t> lookOf(components, 0);
    std::vector<Rgb> custom(components);
    std::vector<std::uint8_t> hasCustom(components, 0);
    m_looks.clear();
    if (scale.style == Style::Presentation) {
        m_looks.assign(scale.colours.materials.begin(), scale.colours.materials.end());
        for (std::size_t c = 0; c < components && m_data.components; ++c) {
            lookOf[c] = static_cast<std::uint32_t>(m_data.components->list[c].material);
        }
    } else {
        for (std::uint32_t grey = 0; grey < colour_choice::greys; ++grey) {
            m_looks.push_back(colour_choice::structure(scale.colours, grey));
        }
        for (std::size_t c = 0; c < components; ++c) {
            lookOf[c] = static_cast<std::uint32_t>(c) % colour_choice::greys;
            const auto chosen = m_data.components && colourBy != ColourBy::Island
                                    ? scale.componentColours.find(m_data.components->list[c].name)
                                    : scale.componentColours.end();
            if (chosen != scale.componentColours.end()) {
                lookOf[c] = static_cast<std::uint32_t>(m_looks.size());
                m_looks.push_back(chosen->second);
                custom[c] = chosen->second;
                hasCustom[c] = 1;
            }
        }
    }
    const bool changed = lookOf != m_lookOf || custom != m_customColours || hasCustom != m_hasCustom || scale.style != m_style;
    m_lookOf = std::move(lookOf);
    m_customColours = std::move(custom);
    m_hasCustom = std::move(hasCustom);
    m_style = scale.style;
    return changed;
}

std::uint32_t PaneGeometry::componentOf(ElementIndex element) const {
    return m_data.components ? static_cast<std::uint32_t>(m_data.components->of[at(element)]) : m_data.fe->mesh().part[at(element)];
}

/// Faces of the structure that can be seen in a slot; from one to a near one by what changes between them.
void PaneGeometry::findVisible(std::size_t slot) {
    constexpr std::size_t near = 8;
    const bool known = m_structureSlot < m_structure->slotCount();
    if (known && std::max(slot, m_structureSlot) - std::min(slot, m_structureSlot) <= near) {
        m_structure->follow(m_visible, m_structureSlot, slot);
    } else {
        m_visible = m_structure->visible(slot);
    }
    m_structureSlot = slot;
}

void PaneGeometry::rebuildTriangles() {
    m_triangles.clear();
    m_lines.clear();
    m_owners.clear();
    m_structurePoints.clear();
    m_groupsShown = 0;
    m_debrisPoints = 0;
    if (m_debris) {
        addDebris();
    }
    addStructure();
    ++m_trianglesVersion;
}

void PaneGeometry::addDebris() {
    const auto& list = m_data.fragments->list;
    const auto groups = drawnDebris().groups();
    std::uint32_t lastVertex = 0;
    for (const auto& face : drawnDebris().faces()) {
        if (!m_slots->drawn(at(face.fragment), m_debrisSlot) || !meets(at(face.fragment))) {
            continue;
        }
        const Owner owner{list[at(face.fragment)].element, static_cast<std::uint32_t>(face.fragment)};
        const auto& v = face.vertices;
        m_triangles.insert(m_triangles.end(),
                           {static_cast<std::int32_t>(v[0]), static_cast<std::int32_t>(v[1]), static_cast<std::int32_t>(v[2])});
        m_owners.push_back(owner);
        if (v[3] != none) {
            m_triangles.insert(m_triangles.end(),
                               {static_cast<std::int32_t>(v[0]), static_cast<std::int32_t>(v[2]), static_cast<std::int32_t>(v[3])});
            m_owners.push_back(owner);
        }
        lastVertex = std::max({lastVertex, v[0], v[1], v[2]});
    }
    if (m_triangles.empty()) {
        return;
    }
    const auto after = std::upper_bound(groups.begin(), groups.end(), lastVertex,
                                        [](std::uint32_t vertex, const auto& group) { return vertex < group.firstVertex; });
    m_groupsShown = static_cast<std::size_t>(after - groups.begin());
    m_debrisPoints = groups[m_groupsShown - 1].firstVertex + groups[m_groupsShown - 1].vertexCount;
    m_groupOfPoint.resize(m_debrisPoints);
    for (std::size_t g = 0; g < m_groupsShown; ++g) {
        std::fill_n(m_groupOfPoint.begin() + groups[g].firstVertex, groups[g].vertexCount, static_cast<std::uint32_t>(g));
    }
}

void PaneGeometry::addStructure() {
    // One point for each node and look, so that components keep crisp borders.
    m_pointOf.resize(m_data.fe->mesh().nodeCount(), -1);
    const auto pointFor = [&](std::uint32_t node, std::uint32_t look) {
        std::int32_t point = m_pointOf[node];
        while (point >= 0 && m_structurePoints[static_cast<std::size_t>(point)].look != look) {
            point = m_structurePoints[static_cast<std::size_t>(point)].next;
        }
        if (point < 0) {
            point = static_cast<std::int32_t>(m_structurePoints.size());
            m_structurePoints.push_back({node, look, afloat(node), m_pointOf[node]});
            m_pointOf[node] = point;
        }
        return static_cast<std::int32_t>(m_debrisPoints) + point;
    };
    const bool join = m_cells.structure > 0.0;
    if (join) {
        joinNodes();
    }
    for (const std::uint32_t index : m_visible) {
        StructureFaces::Face face = m_structure->faces()[index];
        if (join && face.nodes[2] != StructureFaces::none) {
            for (std::uint32_t& node : face.nodes) {
                if (node != StructureFaces::none) {
                    node = m_joined[node];
                }
            }
            if (!withoutRepeats(face.nodes, StructureFaces::none)) {
                continue;
            }
        }
        const std::uint32_t look = lookOf(face.element);
        std::array<std::int32_t, 4> p{};
        std::size_t n = 0;
        for (; n < 4 && face.nodes[n] != StructureFaces::none; ++n) {
            p[n] = pointFor(face.nodes[n], look);
        }
        if (n == 2) {
            m_lines.insert(m_lines.end(), {p[0], p[1]});
            continue;
        }
        m_triangles.insert(m_triangles.end(), {p[0], p[1], p[2]});
        m_owners.push_back({face.element, none});
        if (n == 4) {
            m_triangles.insert(m_triangles.end(), {p[0], p[2], p[3]});
            m_owners.push_back({face.element, none});
        }
    }
    for (const StructurePoint& point : m_structurePoints) {
        m_pointOf[point.node] = -1;
    }
}

void PaneGeometry::place(double time) {
    m_points.resize(3 * (m_debrisPoints + m_structurePoints.size()));
    if (m_groupsShown > 0) {
        drawnDebris().place(m_frame, time, m_groupsShown, m_points.data());
    }
    float* p = m_points.data() + 3 * m_debrisPoints;
    for (const StructurePoint& point : m_structurePoints) {
        const Eigen::Vector3f x = placeOf(point.node);
        p[0] = x.x();
        p[1] = x.y();
        p[2] = x.z();
        p += 3;
    }
    ++m_pointsVersion;
}

Rgb PaneGeometry::debrisColour(FragmentId fragment, std::size_t group, const std::vector<float>& speeds, ColourBy colourBy,
                               const ColourScale& scale) const {
    const Fragment& f = m_data.fragments->list[at(fragment)];
    if (scale.style != Style::Presentation && colourBy != ColourBy::Island && leavesIsland(at(fragment))) {
        return scale.colours.released;
    }
    if (!born(at(fragment))) {
        return m_looks[lookOf(f.element)];
    }
    if (scale.style == Style::Presentation && (colourBy == ColourBy::Highlight || colourBy == ColourBy::Island)) {
        return m_looks[m_lookOf[at(f.component)]];
    }
    switch (colourBy) {
        case ColourBy::Component:
            return m_hasCustom[at(f.component)] ? m_customColours[at(f.component)]
                                                : colour_choice::category(scale.colours, at(f.component));
        case ColourBy::Cluster:
            return m_data.clustering ? colour_choice::clusterColour(scale.colours, m_data.clustering->of[at(fragment)])
                                     : scale.colours.fragment;
        case ColourBy::BirthTime:
            return colour_choice::onRamp(scale.colours.birthRamp, scale.firstBirth, scale.lastBirth, f.birthTime);
        case ColourBy::Speed:
            return colour_choice::onRamp(scale.colours.speedRamp, 0.0, scale.speedTop,
                                         m_carried ? static_cast<double>(speeds[group]) : f.velocity.norm());
        case ColourBy::Error:
            return errorColour(fragment, scale);
        case ColourBy::Highlight:
        case ColourBy::Island:
            break;
    }
    return scale.colours.fragment;
}

/// How far each fragment is from where the reference has it at the same time.
void PaneGeometry::takeErrors() {
    m_errors.clear();
    if (!m_carried || !m_data.reference || !m_data.components || m_data.reference->frameCount() == 0) {
        return;
    }
    if (m_referenceCarriers.empty() || !m_data.reference->complete()) {
        m_referenceCarriers = m_data.reference->carriers();
    }
    const Debris own = debrisOf(*m_data.fragments, *m_data.components, m_data.trajectory->carriers(), m_frame);
    const Debris there =
        debrisOf(*m_data.fragments, *m_data.components, m_referenceCarriers, frameAtTime(*m_data.reference, m_placedTime));
    m_errors = fragmentErrors(own, there);
}

void PaneGeometry::countErrors(const ColourScale& scale) {
    m_status.errors.clear();
    m_status.errorsUnknown = 0;
    if (m_errors.empty()) {
        return;
    }
    m_status.errors.assign(scale.errorSteps.size() + 1, 0);
    for (std::size_t f = 0; f < m_errors.size(); ++f) {
        if (!born(f)) {
            continue;
        }
        if (std::isfinite(m_errors[f])) {
            ++m_status.errors[colour_choice::errorStep(scale.errorSteps, m_errors[f])];
        } else {
            ++m_status.errorsUnknown;
        }
    }
}

Rgb PaneGeometry::errorColour(FragmentId fragment, const ColourScale& scale) const {
    if (m_errors.empty()) {
        return scale.colours.fragment;
    }
    const double error = m_errors[at(fragment)];
    return std::isfinite(error) ? colour_choice::errorColour(scale.colours, scale.errorSteps, error) : scale.colours.unknown;
}

void PaneGeometry::colour(ColourBy colourBy, const ColourScale& scale) {
    m_colourBy = colourBy;
    m_colouredWith = scale.colours;
    m_colouredSteps = scale.errorSteps;
    m_errors.clear();
    if (m_groupsShown > 0 && colourBy == ColourBy::Error) {
        takeErrors();
    }
    countErrors(scale);
    m_colours.resize(4 * (m_debrisPoints + m_structurePoints.size()));
    std::uint8_t* out = m_colours.data();
    const auto put = [&out](const Rgb& c) {
        out[0] = c.r;
        out[1] = c.g;
        out[2] = c.b;
        out[3] = 255;
        out += 4;
    };
    std::vector<float> speeds;
    if (m_groupsShown > 0 && colourBy == ColourBy::Speed) {
        speeds = drawnDebris().speeds(m_frame, m_placedTime, m_groupsShown);
    }
    for (std::size_t i = 0; i < m_debrisPoints; ++i) {
        put(debrisColour(drawnDebris().vertices()[i].fragment, m_groupOfPoint[i], speeds, colourBy, scale));
    }
    for (const StructurePoint& point : m_structurePoints) {
        const bool plain = !point.carried || scale.style == Style::Presentation || point.look >= m_firstIslandLook;
        put(plain ? m_looks[point.look] : scale.colours.released);
    }
    takeGrain();
    ++m_coloursVersion;
}

/// Structure and debris take the grain of the place at rest, so that an element looks the same before and after its death.
void PaneGeometry::takeGrain() {
    m_grain.clear();
    if (m_style != Style::Presentation) {
        return;
    }
    // Rough to smooth, by Material: stone, concrete, steel, masonry, soil, water bed.
    constexpr std::array<float, materialCount> roughness{1.0f, 0.55f, 0.2f, 0.85f, 0.8f, 0.3f};
    const Mesh& mesh = m_data.fe->mesh();
    m_grain.reserve(4 * (m_debrisPoints + m_structurePoints.size()));
    const auto put = [&](std::uint32_t node, std::uint32_t look) {
        const Vec3& p = mesh.nodes[node];
        m_grain.insert(m_grain.end(), {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()),
                                       roughness[std::min<std::size_t>(look, materialCount - 1)]});
    };
    for (std::size_t i = 0; i < m_debrisPoints; ++i) {
        const DebrisGeometry::Vertex& vertex = drawnDebris().vertices()[i];
        const Fragment& f = m_data.fragments->list[at(vertex.fragment)];
        const auto corners = mesh.cornersOf(f.element);
        put(corners[vertex.corner % corners.size()], m_lookOf[at(f.component)]);
    }
    for (const StructurePoint& point : m_structurePoints) {
        put(point.node, point.look);
    }
}

void PaneGeometry::select(const std::vector<ElementIndex>& selection) {
    m_selection = selection;
    m_selected.clear();
    std::vector<std::uint8_t> wanted(selection.empty() ? 0 : m_status.elements, 0);
    for (const ElementIndex element : selection) {
        if (at(element) < wanted.size()) {
            wanted[at(element)] = 1;
        }
    }
    for (std::size_t i = 0; !wanted.empty() && i < m_owners.size(); ++i) {
        if (wanted[at(m_owners[i].element)] != 0) {
            m_selected.insert(m_selected.end(), m_triangles.begin() + static_cast<std::ptrdiff_t>(3 * i),
                              m_triangles.begin() + static_cast<std::ptrdiff_t>(3 * i + 3));
        }
    }
    ++m_selectionVersion;
}

std::size_t PaneGeometry::countAhead() {
    const std::pair now(m_debrisSlot, m_status.state);
    if (now != m_aheadOf) {
        m_aheadOf = now;
        m_ahead = 0;
        const Activity& activity = m_data.fe->activity();
        for (std::size_t f = 0; f < m_data.fragments->size(); ++f) {
            m_ahead += activity.active(m_status.state, m_data.fragments->list[f].element) && born(f) ? 1 : 0;
        }
    }
    return m_ahead;
}

void PaneGeometry::countShown(double time) {
    m_status.fragments = m_status.clusters = 0;
    m_status.meeting.reset();
    m_status.released = m_islands.elements();
    m_status.bornByComponent.clear();
    m_status.faces = m_triangles.size() / 3;
    m_status.hidden = static_cast<std::size_t>(std::count(m_hidden.begin(), m_hidden.end(), 1));
    m_status.active = m_elementCounts->at(time);
    m_status.active -= std::min(m_status.active, m_status.released);
    if (!m_slots) {
        return;
    }
    const FragmentSlots::Counts& counts = m_slots->countsAt(m_debrisSlot);
    // An element on its way from hand-over to birth still counts as the structure that it was.
    std::size_t left = 0;
    for (std::size_t f = 0; counts.onTheWay > 0 && f < m_data.fragments->size(); ++f) {
        left += leavesIsland(f) ? 1 : 0;
    }
    m_status.released += left;
    m_status.active += counts.onTheWay - left;
    m_status.fragments = counts.born;
    m_status.bornByComponent = counts.bornByComponent;
    m_status.clusters = counts.clusters;
    if (!m_meets.empty()) {
        m_status.meeting = 0;
        for (std::size_t f = 0; f < m_meets.size(); ++f) {
            *m_status.meeting += m_meets[f] != 0 && born(f) ? 1 : 0;
        }
    }
}

}  // namespace rubble::render
