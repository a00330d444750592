#include "core/selftest/element_scene.h"

#include <limits>

namespace rubble::selftest {

namespace {

class SceneSource : public StateSource {
public:
    SceneSource(const ElementScene& scene, std::shared_ptr<const Mesh> mesh, std::vector<double> times,
                std::shared_ptr<std::vector<std::size_t>> reads)
        : m_position(scene.position),
          m_velocity(scene.velocity),
          m_damage(scene.damage),
          m_mesh(std::move(mesh)),
          m_times(std::move(times)),
          m_reads(std::move(reads)) {}

    FeState read(std::size_t k) const override {
        m_reads->push_back(k);
        FeState state;
        state.time = m_times.at(k);
        for (const Vec3& node : m_mesh->nodes) {
            state.positions.push_back(m_position(node, state.time));
            if (m_velocity) {
                state.velocities.push_back(m_velocity(node, state.time));
            }
        }
        if (m_damage) {
            m_damage(k, state);
        }
        return state;
    }

private:
    ElementScene::Motion m_position;
    ElementScene::Motion m_velocity;
    std::function<void(std::size_t, FeState&)> m_damage;
    std::shared_ptr<const Mesh> m_mesh;
    std::vector<double> m_times;
    std::shared_ptr<std::vector<std::size_t>> m_reads;
};

}  // namespace

ElementScene::ElementScene() : m_reads(std::make_shared<std::vector<std::size_t>>()) {
    m_mesh.offsets.push_back(0);
    m_mesh.parts.push_back({"rubble", 1});
}

ElementScene& ElementScene::element(ElementShape shape, const std::vector<Vec3>& corners, const std::string& activity,
                                    double section, double density) {
    std::vector<std::uint32_t> nodes;
    for (const Vec3& corner : corners) {
        nodes.push_back(static_cast<std::uint32_t>(m_mesh.nodes.size()));
        m_mesh.nodes.push_back(corner);
        m_mesh.nodeIds.push_back(static_cast<std::int64_t>(m_mesh.nodes.size()));
    }
    return between(shape, nodes, activity, section, density);
}

ElementScene& ElementScene::between(ElementShape shape, const std::vector<std::uint32_t>& nodes, const std::string& activity,
                                    double section, double density) {
    m_mesh.elementIds.push_back(1001 + static_cast<std::int64_t>(m_mesh.shapes.size()));
    m_mesh.shapes.push_back(shape);
    m_mesh.part.push_back(static_cast<std::uint32_t>(m_mesh.parts.size()) - 1);
    m_mesh.corners.insert(m_mesh.corners.end(), nodes.begin(), nodes.end());
    m_mesh.offsets.push_back(static_cast<std::uint32_t>(m_mesh.corners.size()));
    m_mesh.density.push_back(density);
    m_mesh.section.push_back(isSolid(shape) ? std::numeric_limits<double>::quiet_NaN() : section);
    m_activity.push_back(activity);
    return *this;
}

ElementScene& ElementScene::part(const std::string& name) {
    m_mesh.parts.push_back({name, static_cast<std::int64_t>(m_mesh.parts.size()) + 1});
    return *this;
}

void ElementScene::transformNodes(const std::function<Vec3(const Vec3&)>& transform) {
    for (Vec3& node : m_mesh.nodes) {
        node = transform(node);
    }
}

ElementScene ElementScene::reordered(const std::vector<std::size_t>& order) const {
    ElementScene copy = *this;
    Mesh& mesh = copy.m_mesh;
    mesh.offsets.assign(1, 0);
    mesh.corners.clear();
    for (std::size_t i = 0; i < order.size(); ++i) {
        const ElementIndex from = idAt<ElementIndex>(order[i]);
        const auto corners = m_mesh.cornersOf(from);
        mesh.corners.insert(mesh.corners.end(), corners.begin(), corners.end());
        mesh.offsets.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
        mesh.elementIds[i] = m_mesh.elementIds[order[i]];
        mesh.shapes[i] = m_mesh.shapes[order[i]];
        mesh.part[i] = m_mesh.part[order[i]];
        mesh.density[i] = m_mesh.density[order[i]];
        mesh.section[i] = m_mesh.section[order[i]];
        copy.m_activity[i] = m_activity[order[i]];
        if (!deathTimes.empty()) {
            copy.deathTimes[i] = deathTimes[order[i]];
        }
    }
    return copy;
}

std::shared_ptr<const FeResult> ElementScene::result() const {
    FeResult::Contents contents;
    const auto mesh = std::make_shared<const Mesh>(m_mesh);
    const std::size_t states = m_activity.front().size();
    contents.times = times;
    for (std::size_t k = contents.times.size(); k < states; ++k) {
        contents.times.push_back(static_cast<double>(k));
    }
    contents.activity = Activity(states, m_activity.size());
    for (std::size_t e = 0; e < m_activity.size(); ++e) {
        for (std::size_t k = 0; k < states; ++k) {
            contents.activity.set(k, idAt<ElementIndex>(e), m_activity[e].at(k) == '1');
        }
    }
    contents.mesh = mesh;
    contents.deathTime = deathTimes;
    contents.hasVelocity = static_cast<bool>(velocity);
    contents.path = "scene";
    contents.source = std::make_shared<SceneSource>(*this, mesh, contents.times, m_reads);
    return std::make_shared<FeResult>(std::move(contents));
}

Components ElementScene::components(const FeResult& fe) {
    return groupComponents(fe.mesh(), {}, {}, {});
}

}  // namespace rubble::selftest
