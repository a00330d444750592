#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <stdexcept>

#include "core/base/build.h"
#include "core/base/error.h"
#include "core/fe/mesh.h"
#include "io/base/files.h"
#include "io/exports/exports.h"
#include "io/exports/gltf/body_motion.h"
#include "io/exports/gltf/glb_file.h"
#include "io/exports/gltf/island_mesh.h"
#include "io/run/fragment_places.h"
#include "io/run/shown_span.h"
#include "io/site/site_place.h"

namespace rubble::io {

namespace {

/// Recorded places that are held at a time, at most.
constexpr std::size_t motionBytes = std::size_t{128} << 20;

// glTF has y up and looks along -z: (x, y, z) becomes (x, z, -y).
template <class Vector>
std::array<float, 3> yUp(const Vector& v) {
    return {static_cast<float>(v.x()), static_cast<float>(v.z()), static_cast<float>(-v.y())};
}

std::array<float, 4> yUp(const Eigen::Quaternionf& q) {
    return {q.x(), q.z(), -q.y(), q.w()};
}

/// What a body carries, and when it is to be seen.
struct Load {
    std::vector<const Carrier*> carriers;
    const IslandRecord* island = nullptr;  ///< live structure instead
    double from = std::numeric_limits<double>::infinity();
    double to = 0.0;
};

std::vector<Load> loadsOf(const std::vector<BodyRecord>& bodies, const std::vector<Carrier>& carriers, const FragmentSet& fragments,
                          const std::vector<IslandRecord>& islands) {
    std::vector<Load> loads(bodies.size());
    std::set<ElementIndex> inIslands;
    for (const IslandRecord& island : islands) {
        const BodyRecord& body = bodies[at(island.body)];
        loads[at(island.body)] = {{}, &island, body.from, body.to};
        inIslands.insert(island.elements.begin(), island.elements.end());
    }
    for (const Carrier& carrier : carriers) {
        const Fragment& fragment = fragments.list[at(carrier.fragment)];
        Load& load = loads[at(carrier.body)];
        load.carriers.push_back(&carrier);
        const ShownSpan span = shownSpan(carrier, fragment, bodies[at(carrier.body)], inIslands.contains(fragment.element));
        load.from = std::min(load.from, span.from);
        load.to = std::max(load.to, span.to);
    }
    return loads;
}

/// Colour of a component: hues a golden angle apart, none of them loud.
nlohmann::json materialOf(const std::string& name, std::size_t index) {
    const double hue = 6.0 * std::fmod(0.08 + 0.618034 * static_cast<double>(index), 1.0);
    const auto channel = [&](double shift) {
        const double k = std::fmod(shift + hue, 6.0);
        return 0.55 - 0.25 * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0);
    };
    return {{"name", name},
            {"pbrMetallicRoughness",
             {{"baseColorFactor", {channel(5.0), channel(3.0), channel(1.0), 1.0}},
              {"metallicFactor", 0.0},
              {"roughnessFactor", 0.9}}}};
}

class GltfScene {
public:
    /// @param fe  null: live structure is left out
    GltfScene(const RunReader& run, const std::shared_ptr<const FragmentSet>& fragments, const FeResult* fe)
        : m_run(run), m_fragments(*fragments), m_fe(fe), m_bodies(run.bodies()), m_carriers(run.carriers()) {
        if (fe) {
            const Scenario& scenario = run.origin().scenario;
            m_componentOf = groupComponents(fe->mesh(), scenario.regrouping, scenario.components, scenario.assumptions).of;
            m_islands = run.islands();
            std::erase_if(m_islands, [&](const IslandRecord& island) {
                return at(island.body) >= m_bodies.size() ||
                       std::ranges::any_of(island.elements, [&](ElementIndex e) { return at(e) >= m_componentOf.size(); });
            });
        }
        m_loads = loadsOf(m_bodies, m_carriers, m_fragments, m_islands);
        const double first = run.frameCount() > 0 ? run.frameTime(0) : 0.0;
        const double entry = m_bodies.empty() ? first : m_bodies.front().from;
        // Times of an animation are never below zero.
        m_timeOffset = std::min({0.0, first, entry});
    }

    void addBodies(const std::string& path, const Execution& execution);
    void write(const std::string& path);

private:
    void addBody(std::size_t body, const std::vector<MotionKey>& keys);
    std::size_t addMesh(const Load& load);
    std::optional<std::size_t> addIslandMesh(const IslandRecord& island);
    void addIsland(std::size_t body, const std::vector<MotionKey>& keys);
    void addNode(nlohmann::json node, const Load& load, const std::vector<MotionKey>& keys);
    void addChannel(std::size_t node, const char* what, std::size_t times, std::size_t values, const char* interpolation);
    void addMotion(std::size_t node, const std::vector<MotionKey>& keys);
    void addVisibility(std::size_t node, const Load& load);
    float clock(double time) const { return static_cast<float>(time - m_timeOffset); }
    nlohmann::json originJson() const;

    const RunReader& m_run;
    const FragmentSet& m_fragments;
    const FeResult* m_fe;
    std::vector<BodyRecord> m_bodies;
    std::vector<Carrier> m_carriers;
    std::vector<IslandRecord> m_islands;
    std::vector<ComponentId> m_componentOf;  ///< of each element
    std::vector<Load> m_loads;
    double m_timeOffset = 0.0;
    GlbFile m_file;
    nlohmann::json m_nodes = nlohmann::json::array({nlohmann::json::object()});
    nlohmann::json m_children = nlohmann::json::array();
    nlohmann::json m_meshes = nlohmann::json::array();
    nlohmann::json m_samplers = nlohmann::json::array();
    nlohmann::json m_channels = nlohmann::json::array();
};

void GltfScene::addBodies(const std::string& path, const Execution& execution) {
    const Message stage{"io.export.gltf", "Writing {0}", {path}};
    const std::size_t perBody = std::max<std::size_t>(1, m_run.frameCount()) * sizeof(MotionKey);
    const std::size_t atOnce = std::max<std::size_t>(1, motionBytes / perBody);
    const auto all = static_cast<double>(std::max<std::size_t>(1, m_bodies.size()));
    for (std::size_t first = 0; first < m_bodies.size(); first += atOnce) {
        const std::size_t last = std::min(m_bodies.size(), first + atOnce);
        const auto motion = recordedMotion(m_run, m_bodies, first, last, [&](double share) {
            execution.report(stage, (static_cast<double>(first) + share * static_cast<double>(last - first)) / all * 0.95);
        });
        for (std::size_t b = first; b < last; ++b) {
            if (m_loads[b].island) {
                addIsland(b, fewerKeys(motion[b - first], {}));
            } else if (!m_loads[b].carriers.empty()) {
                addBody(b, fewerKeys(motion[b - first], {}));
            }
        }
    }
    if (m_meshes.empty()) {
        throw UsageError(Message{"io.gltf.nothing", "{0}: the run has no fragments that could be written as glTF", {path}},
                         Message{"io.gltf.nothing.remedy", "Choose a run in which elements were deactivated.", {}});
    }
}

std::size_t GltfScene::addMesh(const Load& load) {
    std::vector<float> positions;
    std::vector<std::uint32_t> corners;
    for (const Carrier* carrier : load.carriers) {
        const auto firstVertex = static_cast<std::uint32_t>(positions.size() / 3);
        for (const Vec3& vertex : m_fragments.verticesOf(carrier->fragment)) {
            const std::array<float, 3> p = yUp(Vec3(carrier->handOverToBody * vertex));
            positions.insert(positions.end(), p.begin(), p.end());
        }
        for (const auto& face : facesOf(m_fragments.solid[at(carrier->fragment)])) {
            const auto corner = [&](int c) { return firstVertex + static_cast<std::uint32_t>(face[static_cast<std::size_t>(c)]); };
            corners.insert(corners.end(), {corner(0), corner(1), corner(2)});
            if (face[3] >= 0) {
                corners.insert(corners.end(), {corner(0), corner(2), corner(3)});
            }
        }
    }
    const std::size_t component = at(m_fragments.list[at(load.carriers.front()->fragment)].component);
    const std::size_t vertices = m_file.addPositions(positions);
    m_meshes.push_back(
        {{"primitives",
          {{{"attributes", {{"POSITION", vertices}}}, {"indices", m_file.addTriangles(corners)}, {"material", component}}}}});
    return m_meshes.size() - 1;
}

void GltfScene::addChannel(std::size_t node, const char* what, std::size_t times, std::size_t values, const char* interpolation) {
    m_channels.push_back({{"sampler", m_samplers.size()}, {"target", {{"node", node}, {"path", what}}}});
    m_samplers.push_back({{"input", times}, {"output", values}, {"interpolation", interpolation}});
}

void GltfScene::addMotion(std::size_t node, const std::vector<MotionKey>& keys) {
    std::vector<float> times;
    std::vector<float> places;
    std::vector<float> turns;
    for (const MotionKey& key : keys) {
        // Two instants that single precision cannot tell apart are one.
        if (!times.empty() && clock(key.time) <= times.back()) {
            continue;
        }
        times.push_back(clock(key.time));
        const auto place = yUp(key.position);
        const auto turn = yUp(key.orientation);
        places.insert(places.end(), place.begin(), place.end());
        turns.insert(turns.end(), turn.begin(), turn.end());
    }
    if (times.size() < 2) {
        return;
    }
    const std::size_t input = m_file.addTimes(times);
    addChannel(node, "translation", input, m_file.addValues(places, 3), "LINEAR");
    addChannel(node, "rotation", input, m_file.addValues(turns, 4), "LINEAR");
}

// A node that is not there yet, or no longer, has the scale 0: what glTF 2.0 (section 3.11) gives for visibility over time.
void GltfScene::addVisibility(std::size_t node, const Load& load) {
    std::vector<float> times;
    std::vector<float> scales;
    const auto add = [&](double time, float scale) {
        const float t = std::max(0.0f, clock(time));
        if (!times.empty() && t <= times.back()) {
            times.pop_back();
            scales.resize(scales.size() - 3);
        }
        times.push_back(t);
        scales.insert(scales.end(), 3, scale);
    };
    add(m_timeOffset, 0.0f);
    add(load.from, 1.0f);
    if (std::isfinite(load.to)) {
        add(load.to, 0.0f);
    }
    const std::size_t input = m_file.addTimes(times);
    addChannel(node, "scale", input, m_file.addValues(scales, 3), "STEP");
}

void GltfScene::addBody(std::size_t body, const std::vector<MotionKey>& keys) {
    const Load& load = m_loads[body];
    double mass = 0.0;
    for (const Carrier* carrier : load.carriers) {
        mass += m_fragments.list[at(carrier->fragment)].mass;
    }
    nlohmann::json node{{"name", "body " + std::to_string(body)},
                        {"mesh", addMesh(load)},
                        {"translation", yUp(keys.front().position)},
                        {"rotation", yUp(keys.front().orientation)},
                        {"extras", {{"fragments", load.carriers.size()}, {"mass_kg", mass}, {"visible_from_s", load.from}}}};
    addNode(std::move(node), load, keys);
}

void GltfScene::addNode(nlohmann::json node, const Load& load, const std::vector<MotionKey>& keys) {
    const std::size_t index = m_nodes.size();
    m_children.push_back(index);
    m_nodes.push_back(std::move(node));
    addMotion(index, keys);
    addVisibility(index, load);
}

std::optional<std::size_t> GltfScene::addIslandMesh(const IslandRecord& island) {
    nlohmann::json primitives = nlohmann::json::array();
    for (const auto& [component, part] : islandSurface(island, *m_fe, m_componentOf)) {
        std::vector<float> positions;
        for (const Vec3& point : part.points) {
            const std::array<float, 3> p = yUp(point);
            positions.insert(positions.end(), p.begin(), p.end());
        }
        const std::size_t vertices = m_file.addPositions(positions);
        primitives.push_back({{"attributes", {{"POSITION", vertices}}},
                              {"indices", m_file.addTriangles(part.corners)},
                              {"material", at(component)}});
    }
    if (primitives.empty()) {
        return std::nullopt;
    }
    m_meshes.push_back({{"primitives", std::move(primitives)}});
    return m_meshes.size() - 1;
}

void GltfScene::addIsland(std::size_t body, const std::vector<MotionKey>& keys) {
    const Load& load = m_loads[body];
    const std::optional<std::size_t> mesh = addIslandMesh(*load.island);
    if (!mesh) {
        return;
    }
    addNode(
        {{"name", "island " + std::to_string(body)},
         {"mesh", *mesh},
         {"translation", yUp(keys.front().position)},
         {"rotation", yUp(keys.front().orientation)},
         {"extras", {{"elements", load.island->elements.size()}, {"mass_kg", m_bodies[body].mass}, {"visible_from_s", load.from}}}},
        load, keys);
}

nlohmann::json GltfScene::originJson() const {
    const SitePlace site(m_run.origin().frame, m_run.origin().site);
    const Vec3 zero = site.toWorld(Vec3::Zero());
    nlohmann::json origin{
        {"origin_m", {zero.x(), zero.y(), zero.z()}},      {"time_offset_s", m_timeOffset}, {"fe_sha256", m_run.origin().feSha256},
        {"fingerprint", m_run.origin().fingerprint.hex()}, {"build", m_run.origin().build}, {"complete", m_run.complete()}};
    if (!site.upright()) {
        origin["turn_rad"] = site.transform().angle;
        origin["scale"] = site.transform().scale;
    }
    return origin;
}

void GltfScene::write(const std::string& path) {
    nlohmann::json& asset = m_file.asset();
    asset["asset"] = {{"version", "2.0"}, {"generator", "Rubble " + std::string(versionText())}, {"extras", originJson()}};
    m_nodes[0] = {{"name", "fragments"}, {"children", std::move(m_children)}};
    asset["scene"] = 0;
    asset["scenes"] = nlohmann::json::array({{{"name", m_run.origin().scenarioName}, {"nodes", {0}}}});
    asset["nodes"] = std::move(m_nodes);
    asset["meshes"] = std::move(m_meshes);
    asset["materials"] = nlohmann::json::array();
    const std::vector<std::string> names = m_run.componentNames();
    for (std::size_t c = 0; c < names.size(); ++c) {
        asset["materials"].push_back(materialOf(names[c], c));
    }
    asset["animations"] =
        nlohmann::json::array({{{"name", "collapse"}, {"samplers", std::move(m_samplers)}, {"channels", std::move(m_channels)}}});
    try {
        writeAtomically(path, [&](std::ostream& out) { m_file.write(out); });
    } catch (const std::length_error&) {
        throw UsageError(
            Message{"io.gltf.large", "{0}: the run is too large for one glTF file: {1} GB", {path, m_file.binaryBytes() * 1e-9}},
            Message{"io.gltf.large.remedy", "Use clusters (multiple), or export the series for ParaView.", {}});
    }
}

}  // namespace

void exportGltf(const std::string& path, const RunReader& run, const FeResult* fe, const Execution& execution) {
    const std::shared_ptr<const FragmentSet> fragments = run.fragments();
    if (!fragments) {
        FragmentPlaces places(run);  // says why there are none
    }
    GltfScene scene(run, fragments, fe);
    scene.addBodies(path, execution);
    scene.write(path);
    writeProvenance(path, provenanceText(run));
    execution.report(Message{"io.export.gltf", "Writing {0}", {path}}, 1.0);
}

}  // namespace rubble::io
