#include "tests/core/fragments/element_scene.h"

#include <limits>

namespace rubble::test {

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

std::vector<Vec3> regularElement(ElementShape shape) {
    const Vec3 a(0, 0, 0), b(1, 0, 0), c(1, 1, 0), d(0, 1, 0), up(0, 0, 1);
    switch (shape) {
        case ElementShape::Hexahedron:
            return {a, b, c, d, a + up, b + up, c + up, d + up};
        case ElementShape::Wedge:
            return {a, b, d, a + up, b + up, d + up};
        case ElementShape::Pyramid:
            return {a, b, c, d, Vec3(0.5, 0.5, 1)};
        case ElementShape::Tetrahedron:
            return {a, b, d, up};
        case ElementShape::Quadrilateral:
            return {a, b, c, d};
        case ElementShape::Triangle:
            return {a, b, d};
        case ElementShape::Beam:
            return {a, b};
    }
    return {};
}

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
    m_mesh.part.push_back(0);
    m_mesh.corners.insert(m_mesh.corners.end(), nodes.begin(), nodes.end());
    m_mesh.offsets.push_back(static_cast<std::uint32_t>(m_mesh.corners.size()));
    m_mesh.density.push_back(density);
    m_mesh.section.push_back(isSolid(shape) ? std::numeric_limits<double>::quiet_NaN() : section);
    m_activity.push_back(activity);
    return *this;
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

std::vector<Vec3> randomElement(ElementShape shape, std::mt19937& random, double size, double distortion) {
    std::uniform_real_distribution<double> stretch(0.5, 1.5);
    const Vec3 scale = size * Vec3(stretch(random), stretch(random), stretch(random));
    const Mat3 turn = randomRotation(random);
    const Vec3 place = randomVector(random, 30.0);
    std::vector<Vec3> corners = regularElement(shape);
    for (Vec3& corner : corners) {
        corner = place + turn * scale.cwiseProduct(corner + randomVector(random, distortion * 0.5));
    }
    return corners;
}

Vec3 randomVector(std::mt19937& random, double length) {
    std::uniform_real_distribution<double> coordinate(-length, length);
    const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
    return {x, y, z};
}

Mat3 randomRotation(std::mt19937& random) {
    std::normal_distribution<double> normal;
    const double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
    return Quat(w, x, y, z).normalized().toRotationMatrix();
}

}  // namespace rubble::test
