#include "widgets/render/pane_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/analysis/debris_measures.h"
#include "widgets/render/colour_choice.h"

namespace rubble::render {
namespace {

constexpr double sameTime = 1e-6;     // s
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

std::size_t slotAt(const std::vector<double>& events, double time) {
    return static_cast<std::size_t>(std::upper_bound(events.begin(), events.end(), time) - events.begin());
}

}  // namespace

PaneGeometry::PaneGeometry(PaneContent content, const SceneData& data, bool allFaces)
    : m_content(content), m_data(data), m_allFaces(allFaces), m_motion(data.fe) {
    if (content == PaneContent::Fe) {
        m_data.fragments = nullptr;
        m_data.clustering = nullptr;
        m_data.trajectory = nullptr;
    }
    if (m_data.fragments) {
        m_debris = std::make_unique<DebrisGeometry>(*m_data.fragments, m_data.clustering.get(), !allFaces);
    }
    m_status.states = static_cast<std::uint32_t>(data.fe->stateCount());
    m_status.elements = data.fe->mesh().elementCount();
    makeFaces(m_data.fragments && m_data.trajectory && m_data.trajectory->frameCount() > 0);
}

void PaneGeometry::makeFaces(bool carried) {
    m_carried = carried;
    m_showTimes = m_data.fragments ? showTimes(*m_data.fe, *m_data.fragments, carried) : showTimes(*m_data.fe);
    m_structure = std::make_unique<StructureFaces>(m_data.fe->mesh(), m_showTimes, !m_allFaces);
    std::set<double> events;
    if (m_data.fragments) {
        for (const Fragment& f : m_data.fragments->list) {
            events.insert({carried ? f.handOverTime : f.birthTime, f.birthTime, f.endTime});
        }
    }
    m_debrisEvents.assign(events.begin(), events.end());
    m_structureSlot = m_debrisSlot = ~std::uint64_t{0};
    m_placed = false;
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
    m_islands.bind(m_data.fe->mesh(), m_data.trajectory->islands(), m_data.trajectory->bodies());
    if (!m_islands.empty()) {
        const auto place = std::lower_bound(m_debrisEvents.begin(), m_debrisEvents.end(), m_islands.from());
        if (place == m_debrisEvents.end() || *place != m_islands.from()) {
            m_debrisEvents.insert(place, m_islands.from());
        }
    }
    m_debrisSlot = ~std::uint64_t{0};
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
    if (!m_placed || shown != m_placedTime) {
        m_motion.moveTo(shown);
        if (m_carried) {
            m_frame = frameAtTime(*m_data.trajectory, shown);
            if (m_frame.bodies() > m_boundBodies) {
                bindBodies();
            }
            m_islands.moveTo(m_frame);
        }
    }
    m_status.state = static_cast<std::uint32_t>(m_motion.state());
    m_status.interpolated = m_carried ? m_frame.kind == FrameKind::Interpolated : m_motion.interpolated();
    m_status.kind = m_carried ? m_frame.kind : (m_motion.interpolated() ? FrameKind::Interpolated : FrameKind::Fe);

    const std::size_t structureSlot = m_structure->slotAt(shown);
    const std::size_t debrisSlot = slotAt(m_debrisEvents, shown);
    const bool changed = structureSlot != m_structureSlot || debrisSlot != m_debrisSlot;
    if (changed) {
        m_structureSlot = structureSlot;
        m_debrisSlot = debrisSlot;
        rebuildTriangles(shown);
        countShown(shown);
    }
    if (changed || !m_placed || shown != m_placedTime) {
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

std::uint32_t PaneGeometry::componentOf(ElementIndex element) const {
    return m_data.components ? static_cast<std::uint32_t>(m_data.components->of[at(element)]) : m_data.fe->mesh().part[at(element)];
}

void PaneGeometry::rebuildTriangles(double time) {
    m_triangles.clear();
    m_lines.clear();
    m_owners.clear();
    m_structurePoints.clear();
    m_groupsShown = 0;
    m_debrisPoints = 0;
    if (m_debris) {
        addDebris(time);
    }
    addStructure(time);
    ++m_trianglesVersion;
}

void PaneGeometry::addDebris(double time) {
    const auto& list = m_data.fragments->list;
    std::vector<std::uint8_t> shown(list.size(), 0);
    m_born.assign(list.size(), 0);
    for (std::size_t f = 0; f < list.size(); ++f) {
        const double from = m_carried ? list[f].handOverTime : list[f].birthTime;
        shown[f] = from <= time && time < list[f].endTime;
        m_born[f] = list[f].birthTime <= time && time < list[f].endTime;
    }
    const auto groups = m_debris->groups();
    std::uint32_t lastVertex = 0;
    for (const auto& face : m_debris->faces()) {
        if (!shown[at(face.fragment)]) {
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

void PaneGeometry::addStructure(double time) {
    // One point for each node and grey, so that components keep crisp borders.
    constexpr std::uint32_t greys = colour_choice::greys;
    const bool afloat = released(time);
    std::vector<std::int32_t> pointOf(m_data.fe->mesh().nodeCount() * greys, -1);
    const auto pointFor = [&](std::uint32_t node, std::uint32_t grey) {
        std::int32_t& point = pointOf[std::size_t{node} * greys + grey];
        if (point < 0) {
            point = static_cast<std::int32_t>(m_debrisPoints + m_structurePoints.size());
            m_structurePoints.push_back({node, grey, afloat ? m_islands.of(node) : IslandMotion::none});
        }
        return point;
    };
    for (const std::uint32_t index : m_structure->visible(m_structureSlot)) {
        const StructureFaces::Face& face = m_structure->faces()[index];
        const std::uint32_t grey = componentOf(face.element) % greys;
        std::array<std::int32_t, 4> p{};
        std::size_t n = 0;
        for (; n < 4 && face.nodes[n] != StructureFaces::none; ++n) {
            p[n] = pointFor(face.nodes[n], grey);
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
}

void PaneGeometry::place(double time) {
    m_points.resize(3 * (m_debrisPoints + m_structurePoints.size()));
    if (m_groupsShown > 0) {
        m_debris->place(m_frame, time, m_groupsShown, m_points.data());
    }
    float* p = m_points.data() + 3 * m_debrisPoints;
    for (const StructurePoint& point : m_structurePoints) {
        Eigen::Vector3f x = m_motion[point.node];
        if (point.island != IslandMotion::none) {
            x = m_islands.place(point.island, x);
        }
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
    if (!m_born[at(fragment)]) {
        return colour_choice::structure(scale.colours, static_cast<std::uint32_t>(f.component));
    }
    switch (colourBy) {
        case ColourBy::Component:
            return colour_choice::category(scale.colours, at(f.component));
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
        if (!m_born[f]) {
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
        speeds = m_debris->speeds(m_frame, m_placedTime, m_groupsShown);
    }
    for (std::size_t i = 0; i < m_debrisPoints; ++i) {
        put(debrisColour(m_debris->vertices()[i].fragment, m_groupOfPoint[i], speeds, colourBy, scale));
    }
    for (const StructurePoint& point : m_structurePoints) {
        put(point.island == IslandMotion::none ? colour_choice::structure(scale.colours, point.grey) : scale.colours.released);
    }
    ++m_coloursVersion;
}

void PaneGeometry::select(const std::vector<ElementIndex>& selection) {
    m_selection = selection;
    m_selected.clear();
    const std::set<ElementIndex> wanted(selection.begin(), selection.end());
    for (std::size_t i = 0; !wanted.empty() && i < m_owners.size(); ++i) {
        if (wanted.contains(m_owners[i].element)) {
            m_selected.insert(m_selected.end(), m_triangles.begin() + static_cast<std::ptrdiff_t>(3 * i),
                              m_triangles.begin() + static_cast<std::ptrdiff_t>(3 * i + 3));
        }
    }
    ++m_selectionVersion;
}

void PaneGeometry::countShown(double time) {
    m_status.active = m_status.fragments = m_status.clusters = 0;
    m_status.released = released(time) ? m_islands.elements() : 0;
    m_status.bornByComponent.clear();
    m_status.faces = m_triangles.size() / 3;
    for (std::size_t e = 0; e < m_status.elements; ++e) {
        for (const TimeSpan& span : m_showTimes.of(idAt<ElementIndex>(e))) {
            m_status.active += span.from <= time && time < span.to;
        }
    }
    m_status.active -= std::min(m_status.active, m_status.released);
    if (!m_data.fragments) {
        return;
    }
    const auto& list = m_data.fragments->list;
    m_status.bornByComponent.assign(m_data.components ? m_data.components->list.size() : 0, 0);
    std::vector<std::uint8_t> clusterBorn(m_data.clustering ? m_data.clustering->list.size() : 0, 0);
    for (std::size_t f = 0; f < list.size(); ++f) {
        // An element on its way from hand-over to birth still counts as structure.
        m_status.active += m_carried && !m_born[f] && list[f].handOverTime <= time && time < list[f].birthTime;
        if (!m_born[f]) {
            continue;
        }
        ++m_status.fragments;
        if (at(list[f].component) < m_status.bornByComponent.size()) {
            ++m_status.bornByComponent[at(list[f].component)];
        }
        if (m_data.clustering) {
            clusterBorn[at(m_data.clustering->of[f])] = 1;
        }
    }
    m_status.clusters = static_cast<std::size_t>(std::count(clusterBorn.begin(), clusterBorn.end(), 1));
}

std::optional<Pick> PaneGeometry::cast(const Ray& ray) const {
    const Eigen::Vector3f origin = ray.origin.cast<float>();
    const Eigen::Vector3f direction = ray.direction.cast<float>();
    const auto point = [this](std::size_t i) { return Eigen::Map<const Eigen::Vector3f>(m_points.data() + 3 * m_triangles[i]); };
    float nearest = std::numeric_limits<float>::infinity();
    std::size_t hit = m_owners.size();
    for (std::size_t i = 0; i < m_owners.size(); ++i) {
        const Eigen::Vector3f a = point(3 * i);
        const Eigen::Vector3f ab = point(3 * i + 1) - a;
        const Eigen::Vector3f ac = point(3 * i + 2) - a;
        const Eigen::Vector3f cross = direction.cross(ac);
        const float det = ab.dot(cross);
        if (!(det > 0.0f)) {
            continue;  // edge on, or seen from behind and not drawn
        }
        const Eigen::Vector3f to = origin - a;
        const float u = to.dot(cross);
        const Eigen::Vector3f q = to.cross(ab);
        const float v = direction.dot(q);
        if (u < 0.0f || v < 0.0f || u + v > det) {
            continue;
        }
        const float distance = ac.dot(q) / det;
        if (distance > 0.0f && distance < nearest) {
            nearest = distance;
            hit = i;
        }
    }
    if (hit == m_owners.size()) {
        return std::nullopt;
    }
    Pick pick;
    pick.pane = m_content;
    pick.element = m_owners[hit].element;
    if (m_owners[hit].fragment != none && m_born[m_owners[hit].fragment]) {
        pick.fragment = idAt<FragmentId>(m_owners[hit].fragment);
    }
    pick.position = ray.origin + static_cast<double>(nearest) * ray.direction;
    return pick;
}

}  // namespace rubble::render
