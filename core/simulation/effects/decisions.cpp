#include "core/simulation/effects/decisions.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/unknown.h"
#include "core/engine/world/body_shapes.h"
#include "core/engine/world/collider.h"
#include "core/fe/loose_structure.h"
#include "core/fragments/birth_windows.h"
#include "core/simulation/bodies/cluster_shape.h"
#include "core/simulation/effects/box_tree.h"
#include "core/simulation/effects/island_reach.h"
#include "core/simulation/effects/reach.h"

namespace rubble {

namespace {

/// Weight over drag at the highest possible speed below which a landing point moves by 1 % of its travel (1 / (6 R)).
constexpr double dragMatters = 17.0;
/// m. Boxes that overlap by no more only touch.
constexpr double touching = 1e-3;

/// No box is left out.
constexpr std::size_t noTag = std::numeric_limits<std::size_t>::max();

/// What the test of one effect says, whatever the user asked for.
struct Verdict {
    bool on = false;
    Message reason;
    double measure = unknown;
    double threshold = unknown;
    bool possible = true;  ///< false: nothing is there that the effect could act with
};

Verdict impossible(Message reason) {
    return {false, std::move(reason), unknown, unknown, false};
}

/// All of a terrain but its roughness: debris that runs on leaves the window about the structure. Empty: there is none.
Aabb wholeOf(const TerrainGrid* terrain) {
    if (terrain == nullptr) {
        return {};
    }
    double lowest = unknown, highest = unknown;
    for (const double height : terrain->grid().heights) {
        // Where the terrain has none, the other one stays.
        lowest = std::fmin(lowest, height);
        highest = std::fmax(highest, height);
    }
    const auto end = [&](double first, std::size_t count) { return first + terrain->cell() * static_cast<double>(count - 1); };
    return {Vec3(terrain->x0(), terrain->y0(), lowest),
            Vec3(end(terrain->x0(), terrain->nx()), end(terrain->y0(), terrain->ny()), highest)};
}

/// "element 12 (deck)"
std::string placeOf(const EffectScene& scene, ElementIndex e) {
    return "element " + englishInteger(scene.fe.mesh().elementIds[at(e)]) + " (" +
           scene.components.list[at(scene.components.of[at(e)])].name + ")";
}

std::string placeOf(const EffectScene& scene, ClusterId c) {
    return placeOf(scene, scene.fragments.list[at(scene.clustering.membersOf(c).front())].element);
}

/// The tests of one scene; later ones build on earlier ones.
class Decider {
public:
    explicit Decider(const EffectScene& scene);
    EffectDecisions decide();
    /// The engine moves loose structure, and there is some.
    bool carriesLoose();

private:
    void findSite(EffectDecisions& decisions);
    Verdict ground() const;
    Verdict terrain() const;
    Verdict structureContact() const;
    Verdict fragmentContact() const;
    Verdict water() const;
    Verdict airDrag() const;
    Verdict ties() const;
    Verdict breakUp() const;

    FallLimits limits() const;
    SiteSurface surface() const;
    BoxTree structure() const;
    double lowestUnder(const Aabb& box) const;
    bool releasedMeet(const std::vector<TimedBox>& columns) const;
    std::optional<double> weightOverDrag(ClusterId c) const;
    bool asked(EffectKind kind, EffectSwitch state) const { return m_effects.of(kind) == state; }
    EffectDecision settled(EffectKind kind, Verdict verdict) const;

    const EffectScene& m_scene;
    const EffectSettings& m_effects;
    const Aabb m_terrain;  ///< m, all of it; empty: there is none
    bool m_terrainOn = false, m_groundOn = false;
    bool m_carriesLoose = false;
    std::vector<Reach> m_reach;  ///< [clusters]
    LiveReach m_live;
    Aabb m_site;  ///< of all that falls
};

Decider::Decider(const EffectScene& scene) : m_scene(scene), m_effects(scene.scenario.effects), m_terrain(wholeOf(scene.terrain)) {}

FallLimits Decider::limits() const {
    const SimulationSettings& s = m_scene.scenario.simulation;
    FallLimits limits;
    limits.gravity = s.gravity;
    limits.end = m_scene.fe.times().back() + s.settleTime;
    if (m_terrainOn) {
        limits.surface = m_terrain.min().z();
    } else if (m_groundOn) {
        limits.surface = s.groundHeight;
    }
    return limits;
}

SiteSurface Decider::surface() const {
    SiteSurface surface{m_groundOn, m_scene.scenario.simulation.groundHeight, nullptr};
    if (m_terrainOn) {
        surface.terrain = {std::shared_ptr<const void>(), m_scene.terrain};
    }
    return surface;
}

EffectDecision Decider::settled(EffectKind kind, Verdict verdict) const {
    EffectDecision decision;
    decision.kind = kind;
    decision.asked = m_effects.of(kind);
    decision.measure = verdict.measure;
    decision.threshold = verdict.threshold;
    decision.on = decision.asked == EffectSwitch::Auto ? verdict.on : decision.asked == EffectSwitch::On && verdict.possible;
    decision.reason = std::move(verdict.reason);
    const auto preface = [&decision](const char* id, const char* words) {
        decision.reason.id += id;
        decision.reason.pattern = words + decision.reason.pattern;
    };
    if (decision.asked == EffectSwitch::Off) {
        preface(".set_off", verdict.on ? "set off; auto would be on: " : "set off, as auto would: ");
    } else if (decision.asked == EffectSwitch::On && !verdict.possible) {
        preface(".set_on_in_vain", "set on, but cannot be: ");
    } else if (decision.asked == EffectSwitch::On) {
        preface(".set_on", verdict.on ? "set on, as auto would: " : "set on; auto would be off: ");
    }
    return decision;
}

/// What the others build on.
void Decider::findSite(EffectDecisions& decisions) {
    const auto settle = [&](EffectKind kind, Verdict verdict) {
        return decisions[static_cast<std::size_t>(kind)] = settled(kind, std::move(verdict));
    };
    m_terrainOn = settle(EffectKind::Terrain, terrain()).on;
    m_groundOn = settle(EffectKind::Ground, ground()).on;
    m_carriesLoose = m_effects.loose != LooseStructurePolicy::Fe &&
                     comesLoose(m_scene.fe, simulatedActivity(m_scene.fe, m_scene.scenario.fragments), surface());
}

bool Decider::carriesLoose() {
    EffectDecisions decisions;
    findSite(decisions);
    return m_carriesLoose;
}

EffectDecisions Decider::decide() {
    EffectDecisions decisions;
    const auto settle = [&](EffectKind kind, Verdict verdict) {
        return decisions[static_cast<std::size_t>(kind)] = settled(kind, std::move(verdict));
    };
    findSite(decisions);
    m_reach = reaches(m_scene, limits());
    m_live = liveReach(m_scene, surface(), limits());
    m_site = m_live.site;
    for (const Reach& reach : m_reach) {
        m_site.extend(reach.box);
    }
    settle(EffectKind::StructureContact, structureContact());
    settle(EffectKind::FragmentContact, fragmentContact());
    settle(EffectKind::Water, water());
    settle(EffectKind::AirDrag, airDrag());
    settle(EffectKind::Ties, ties());
    settle(EffectKind::BreakUp, breakUp());
    return decisions;
}

Verdict Decider::ground() const {
    const double height = m_scene.scenario.simulation.groundHeight;
    if (m_terrainOn) {
        return impossible({"effect.ground.terrain", "the terrain takes its place, and goes on level beyond its edges", {}});
    }
    return {true, {"effect.ground.on", "level ground at {0} carries the debris; there is no terrain", {{height, "m"}}}};
}

Verdict Decider::terrain() const {
    const TerrainGrid* terrain = m_scene.terrain;
    if (terrain == nullptr) {
        return impossible({"effect.terrain.none", "the case has no terrain", {}});
    }
    const double lowest = m_terrain.min().z();
    const double highest = m_terrain.max().z();
    FallLimits limits = this->limits();
    limits.surface =
        asked(EffectKind::Ground, EffectSwitch::Off) ? lowest : std::min(lowest, m_scene.scenario.simulation.groundHeight);
    Aabb site = liveReach(m_scene, surface(), limits).site;
    for (const Reach& reach : reaches(m_scene, limits)) {
        site.extend(reach.box);
    }
    if (site.isEmpty()) {
        return {false, {"effect.terrain.nothing", "nothing falls on it", {}}};
    }
    // Only what lies beside or above the debris is out of reach: the terrain is solid below its surface.
    Aabb below = m_terrain;
    below.min().z() = std::min(site.min().z(), lowest);
    Aabb column = site;
    column.extend(Vec3(site.center().x(), site.center().y(), below.min().z()));
    const double aside = gapBetween(below, column);
    if (aside > 0.0) {
        return {false, {"effect.terrain.aside", "the terrain ends {0} beside all that falls", {{aside, "m"}}}, aside, 0.0};
    }
    const double above = lowest - site.max().z();
    if (above > 0.0) {
        return {false, {"effect.terrain.above", "the terrain lies {0} above all that falls", {{above, "m"}}}, above, 0.0};
    }
    return {
        true,
        {"effect.terrain.on", "debris can fall on the terrain, which lies between {0} and {1}", {{lowest, "m"}, {highest, "m"}}},
        std::max(aside, above),
        0.0};
}

/// Every element that a piece can hold: its box at rest with that of the last state it is active at.
BoxTree Decider::structure() const {
    const FeResult& fe = m_scene.fe;
    const Mesh& mesh = fe.mesh();
    const Activity activity = simulatedActivity(fe, m_scene.scenario.fragments);
    const std::shared_ptr<const FeState> last = fe.state(fe.stateCount() - 1);
    std::vector<Aabb> died(mesh.elementCount());
    for (const Fragment& fragment : m_scene.fragments.list) {
        died[at(fragment.element)].extend(fragment.bounds);
    }
    std::vector<TimedBox> boxes;
    for (std::size_t i = 0; i < mesh.elementCount(); ++i) {
        const ElementIndex e = idAt<ElementIndex>(i);
        std::size_t until = fe.stateCount();
        while (until > 0 && !activity.active(until - 1, e)) {
            --until;
        }
        Aabb box = died[i];
        const double section = m_scene.components.section[i];
        const Vec3 half = Vec3::Constant(isShell(mesh.shapes[i]) ? 0.5 * section : 0.5 * std::sqrt(section));
        for (const std::uint32_t node : mesh.cornersOf(e)) {
            for (const Vec3& place : {mesh.nodes[node], until == fe.stateCount() ? last->positions[node] : mesh.nodes[node]}) {
                box.extend(place - half);
                box.extend(place + half);
            }
        }
        if (until > 0 && box.min().allFinite() && box.max().allFinite()) {
            boxes.push_back({box, static_cast<std::uint32_t>(until - 1), i});
        }
    }
    return BoxTree(std::move(boxes));
}

Verdict Decider::structureContact() const {
    if (m_scene.scenario.simulation.pieces == PieceKind::None) {
        return impossible(
            {"effect.structure_contact.no_pieces", "pieces = none leaves the structure without collision shapes", {}});
    }
    if (m_carriesLoose) {
        return {true, {"effect.structure_contact.loose", "the engine moves loose structure, which can fall on what stands", {}}};
    }
    const BoxTree tree = structure();
    BoxTree::Nearest best;
    std::size_t falling = 0;
    for (std::size_t c = 0; c < m_reach.size() && best.gap >= -touching; ++c) {
        const double before = best.gap;
        if (!m_reach[c].box.isEmpty()) {
            best = tree.nearest(m_reach[c].box, m_scene.clustering.list[c].handOverState, noTag, touching, best);
        }
        if (best.gap < before) {
            falling = c;
        }
    }
    const double released = deepestOverlap(m_live.released, m_live.standing);
    if (best.gap >= -touching && released > touching) {
        return {true,
                {"effect.structure_contact.islands",
                 "live structure that is released at the end of the FE result can fall on what stands (islands: {0}, by {1})",
                 {m_live.released.size(), {released, "m"}}},
                -released,
                -touching};
    }
    if (!std::isfinite(best.gap)) {
        return {false, {"effect.structure_contact.none", "no element is active once a fragment has been handed over", {}}};
    }
    const std::string element = placeOf(m_scene, idAt<ElementIndex>(best.tag)),
                      fragment = placeOf(m_scene, idAt<ClusterId>(falling));
    if (best.gap < -touching) {
        return {
            true,
            {"effect.structure_contact.on", "{0} is active within the ballistic reach of the fragment of {1}", {element, fragment}},
            best.gap,
            -touching};
    }
    return {false,
            {"effect.structure_contact.off",
             "the active structure stays {0} outside the ballistic reach of every fragment (nearest: {1} to the fragment of {2})",
             {{std::max(0.0, best.gap), "m"}, element, fragment}},
            best.gap,
            -touching};
}

/// A released island can meet a fragment or another island.
bool Decider::releasedMeet(const std::vector<TimedBox>& columns) const {
    std::vector<Aabb> others;
    for (const TimedBox& column : columns) {
        others.push_back(column.box);
    }
    for (const Reach& reach : m_live.released) {
        if (deepestOverlap({reach}, others) > touching) {
            return true;
        }
        others.push_back(reach.box);
    }
    return false;
}

Verdict Decider::fragmentContact() const {
    if (m_carriesLoose) {
        return {true, {"effect.fragment_contact.loose", "the engine moves loose structure, which can meet debris", {}}};
    }
    std::vector<TimedBox> columns;
    for (std::size_t c = 0; c < m_reach.size(); ++c) {
        if (!m_reach[c].box.isEmpty()) {
            columns.push_back({m_reach[c].box, 0, c});
        }
    }
    const std::vector<TimedBox>& each = columns;
    const BoxTree tree(columns);
    BoxTree::Nearest best;
    std::size_t other = 0;
    for (const TimedBox& column : each) {
        const double before = best.gap;
        best = tree.nearest(column.box, -1, column.tag, touching, best);
        if (best.gap < before) {
            other = column.tag;
        }
        if (best.gap < -touching) {
            break;
        }
    }
    if (best.gap >= -touching && releasedMeet(columns)) {
        return {true,
                {"effect.fragment_contact.islands",
                 "live structure that is released at the end of the FE result can meet other bodies (islands: {0})",
                 {m_live.released.size()}}};
    }
    if (columns.size() < 2) {
        return impossible({"effect.fragment_contact.alone", "no two bodies fall", {}});
    }
    const std::string a = placeOf(m_scene, idAt<ClusterId>(other)), b = placeOf(m_scene, idAt<ClusterId>(best.tag));
    if (best.gap < -touching) {
        return {true,
                {"effect.fragment_contact.on",
                 "bodies can meet: the fall columns of {0} and {1} overlap by {2}",
                 {a, b, {-best.gap, "m"}}},
                best.gap,
                -touching};
    }
    return {false,
            {"effect.fragment_contact.off",
             "no two of {0} fall columns overlap; the nearest, of {1} and {2}, are {3} apart",
             {each.size(), a, b, {std::max(0.0, best.gap), "m"}}},
            best.gap,
            -touching};
}

/// m. The lowest place that things can fall to within a rectangle; minus infinity where there is no ground.
double Decider::lowestUnder(const Aabb& box) const {
    if (!m_terrainOn) {
        return m_groundOn ? m_scene.scenario.simulation.groundHeight : -std::numeric_limits<double>::infinity();
    }
    const TerrainGrid& terrain = *m_scene.terrain;
    double lowest = std::numeric_limits<double>::infinity();
    for (const double x : {box.min().x(), box.max().x()}) {
        for (const double y : {box.min().y(), box.max().y()}) {
            lowest = std::min(lowest, terrain.height(x, y));
        }
    }
    const auto range = [](double low, double high, double origin, double cell, std::size_t count) {
        const double last = static_cast<double>(count - 1);
        return std::pair(static_cast<std::size_t>(std::clamp(std::floor((low - origin) / cell), 0.0, last)),
                         static_cast<std::size_t>(std::clamp(std::ceil((high - origin) / cell), 0.0, last)));
    };
    const auto [i0, i1] = range(box.min().x(), box.max().x(), terrain.x0(), terrain.cell(), terrain.nx());
    const auto [j0, j1] = range(box.min().y(), box.max().y(), terrain.y0(), terrain.cell(), terrain.ny());
    for (std::size_t j = j0; j <= j1; ++j) {
        for (std::size_t i = i0; i <= i1; ++i) {
            lowest = std::min(lowest, terrain.node(i, j));
        }
    }
    return lowest;
}

Verdict Decider::water() const {
    if (!m_effects.waterLevel) {
        return impossible({"effect.water.none", "no level of water is given (water_level)", {}});
    }
    const double level = *m_effects.waterLevel;
    if (m_site.isEmpty()) {
        return {false, {"effect.water.nothing", "nothing falls into it", {}}};
    }
    const double bottom = std::max(lowestUnder(m_site), m_site.min().z());
    const double deep = level - bottom;
    if (deep <= 0.0) {
        return {false,
                {"effect.water.dry",
                 "the water at {0} stays {1} below the lowest place that debris can reach",
                 {{level, "m"}, {-deep, "m"}}},
                deep,
                0.0};
    }
    return {true,
            {"effect.water.on", "debris can reach {0} below the level of the water at {1}", {{deep, "m"}, {level, "m"}}},
            deep,
            0.0};
}

std::optional<double> Decider::weightOverDrag(ClusterId c) const {
    const Cluster& cluster = m_scene.clustering.list[at(c)];
    if (!(cluster.mass > 0.0) || !cluster.inertia.allFinite() || m_reach[at(c)].box.isEmpty()) {
        return std::nullopt;
    }
    const Scenario& scenario = m_scene.scenario;
    const OrientedBox box = boxAround(clusterShape(m_scene.fragments, m_scene.clustering.membersOf(c), bodyFrame(cluster).pose,
                                                   shapeOfCluster(m_scene.fe, scenario, cluster.memberCount),
                                                   scenario.simulation.boxBulking, scenario.fragments));
    const Vec3 side = 2.0 * box.halfExtents;
    const double face = side.prod() / side.minCoeff();
    const double v = m_reach[at(c)].speed;
    return 2.0 * cluster.mass * scenario.simulation.gravity / (m_effects.airDensity * m_effects.airDrag * face * v * v);
}

Verdict Decider::airDrag() const {
    double least = std::numeric_limits<double>::infinity();
    std::size_t worst = 0;
    for (std::size_t c = 0; c < m_reach.size(); ++c) {
        const std::optional<double> ratio = weightOverDrag(idAt<ClusterId>(c));
        if (ratio && *ratio < least) {
            least = *ratio;
            worst = c;
        }
    }
    if (!std::isfinite(least)) {
        return {false, {"effect.air_drag.none", "nothing moves through the air, or the air has no density", {}}};
    }
    const Argument speed(m_reach[worst].speed, "m/s");
    const std::string place = placeOf(m_scene, idAt<ClusterId>(worst));
    if (least < dragMatters) {
        return {true,
                {"effect.air_drag.on",
                 "at {0}, the highest speed that the fragment of {2} can have, its weight is only {1} times its drag, below {3}",
                 {speed, least, place, dragMatters}},
                least,
                dragMatters};
    }
    return {
        false,
        {"effect.air_drag.off",
         "no fragment weighs less than {1} times its drag (that of {2}, at {0}, the highest speed that it can have); below {3} a "
         "landing would move by 1 %",
         {speed, least, place, dragMatters}},
        least,
        dragMatters};
}

Verdict Decider::ties() const {
    const std::vector<Component>& components = m_scene.components.list;
    if (std::none_of(components.begin(), components.end(), [](const Component& c) { return c.reinforced; })) {
        return impossible({"effect.ties.none", "no component is marked as reinforced (component[NAME].reinforced)", {}});
    }
    std::vector<std::int64_t> clusters(components.size(), 0);
    for (std::size_t c = 0; c < m_scene.clustering.list.size(); ++c) {
        std::vector<ComponentId> parts;
        for (const FragmentId f : m_scene.clustering.membersOf(idAt<ClusterId>(c))) {
            parts.push_back(m_scene.fragments.list[at(f)].component);
        }
        std::sort(parts.begin(), parts.end());
        parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
        for (const ComponentId part : parts) {
            clusters[at(part)] += components[at(part)].reinforced;
        }
    }
    const std::size_t most = static_cast<std::size_t>(std::max_element(clusters.begin(), clusters.end()) - clusters.begin());
    const bool on = clusters[most] >= 2;
    return {
        on,
        {on ? "effect.ties.on" : "effect.ties.off",
         on ? "the reinforced component \"{0}\" falls in {1} clusters" : "no reinforced component falls in two or more clusters",
         {components[most].name, clusters[most]}},
        static_cast<double>(clusters[most]),
        2.0,
        on};
}

Verdict Decider::breakUp() const {
    double fastest = 0.0;
    std::size_t candidates = 0, worst = 0, bodies = m_reach.size();
    for (std::size_t c = 0; c < m_reach.size(); ++c) {
        const Cluster& cluster = m_scene.clustering.list[c];
        const Component& component = m_scene.components.list[at(cluster.component)];
        if (cluster.memberCount < 2 || m_scene.fe.contents().looseBodies || !fallsApart(component.material) ||
            component.reinforced) {
            continue;
        }
        ++candidates;
        if (m_reach[c].speed > fastest) {
            fastest = m_reach[c].speed;
            worst = c;
        }
        bodies += m_reach[c].speed >= m_effects.breakUpSpeed ? cluster.memberCount - 1 : 0;
    }
    if (candidates == 0) {
        return impossible(
            {"effect.break_up.none", "no cluster of two or more fragments is of stone or masonry without reinforcement", {}});
    }
    const Argument limit(m_effects.breakUpSpeed, "m/s"), speed(fastest, "m/s");
    if (fastest < m_effects.breakUpSpeed) {
        return {false,
                {"effect.break_up.slow",
                 "no cluster of two or more fragments can be faster than {0}; the assumed threshold is {1}",
                 {speed, limit}},
                fastest,
                m_effects.breakUpSpeed};
    }
    const std::int64_t most = m_scene.scenario.grid.bodiesMax;
    if (static_cast<std::int64_t>(bodies) > most) {
        return {false,
                {"effect.break_up.bodies",
                 "clusters can hit at {0}, above the assumed threshold of {1}, but would leave {2} bodies where {3} are allowed "
                 "(bodies_max)",
                 {speed, limit, bodies, most}},
                static_cast<double>(bodies),
                static_cast<double>(most)};
    }
    return {true,
            {"effect.break_up.on",
             "the cluster of {0} can hit at {1}, above the assumed threshold of {2}; at most {3} bodies result",
             {placeOf(m_scene, idAt<ClusterId>(worst)), speed, limit, bodies}},
            fastest,
            m_effects.breakUpSpeed};
}

}  // namespace

std::string_view effectName(EffectKind kind) {
    static constexpr std::array<std::string_view, effectCount> names{
        "ground", "terrain", "structure_contact", "fragment_contact", "water", "air_drag", "ties", "break_up"};
    return names[static_cast<std::size_t>(kind)];
}

EffectDecisions decideEffects(const EffectScene& scene) {
    return Decider(scene).decide();
}

Scenario settledScenario(const EffectScene& scene) {
    Scenario settled = scene.scenario;
    if (settled.effects.loose != LooseStructurePolicy::Fe && !Decider(scene).carriesLoose()) {
        settled.effects.loose = LooseStructurePolicy::Fe;
    }
    return settled;
}

}  // namespace rubble
