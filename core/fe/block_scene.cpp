#include "core/fe/block_scene.h"

#include <cassert>

namespace rubble::blocks {

namespace {

/// Positions and velocities by the blocks' prescribed flight.
class FlightSource : public StateSource {
public:
    FlightSource(std::shared_ptr<const Mesh> mesh, std::vector<double> times, std::vector<Vec3> velocity,
                 std::vector<double> gravity, bool withVelocity)
        : m_mesh(std::move(mesh)),
          m_times(std::move(times)),
          m_velocity(std::move(velocity)),
          m_gravity(std::move(gravity)),
          m_withVelocity(withVelocity) {}

    FeState read(std::size_t k) const override {
        FeState state;
        const double t = state.time = m_times.at(k);
        state.positions.reserve(m_mesh->nodeCount());
        for (std::size_t n = 0; n < m_mesh->nodeCount(); ++n) {
            const Vec3 fall(0, 0, -m_gravity[n]);
            state.positions.push_back(m_mesh->nodes[n] + m_velocity[n] * t + 0.5 * fall * t * t);
            if (m_withVelocity) {
                state.velocities.push_back(m_velocity[n] + fall * t);
            }
        }
        return state;
    }

private:
    std::shared_ptr<const Mesh> m_mesh;
    std::vector<double> m_times;
    std::vector<Vec3> m_velocity;
    std::vector<double> m_gravity;
    bool m_withVelocity;
};

void addNodes(Mesh& mesh, const Block& block) {
    for (int k = 0; k <= block.cells[2]; ++k) {
        for (int j = 0; j <= block.cells[1]; ++j) {
            for (int i = 0; i <= block.cells[0]; ++i) {
                const Vec3 share(double(i) / block.cells[0], double(j) / block.cells[1], double(k) / block.cells[2]);
                mesh.nodeIds.push_back(static_cast<std::int64_t>(mesh.nodes.size()) + 1);
                mesh.nodes.push_back(block.low + share.cwiseProduct(block.size));
            }
        }
    }
}

void addElements(Mesh& mesh, const Block& block, std::uint32_t firstNode) {
    const std::uint32_t part = static_cast<std::uint32_t>(mesh.parts.size());
    mesh.parts.push_back({block.name, static_cast<std::int64_t>(part) + 1});
    const auto node = [&](int i, int j, int k) {
        return firstNode + static_cast<std::uint32_t>((k * (block.cells[1] + 1) + j) * (block.cells[0] + 1) + i);
    };
    for (int k = 0; k < block.cells[2]; ++k) {
        for (int j = 0; j < block.cells[1]; ++j) {
            for (int i = 0; i < block.cells[0]; ++i) {
                mesh.elementIds.push_back(static_cast<std::int64_t>(mesh.shapes.size()) + 1);
                mesh.shapes.push_back(ElementShape::Hexahedron);
                mesh.part.push_back(part);
                mesh.density.push_back(block.density);
                mesh.section.push_back(std::numeric_limits<double>::quiet_NaN());
                for (const std::uint32_t corner :
                     {node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k), node(i, j, k + 1),
                      node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)}) {
                    mesh.corners.push_back(corner);
                }
                mesh.offsets.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
            }
        }
    }
}

}  // namespace

std::shared_ptr<const FeResult> makeScene(const std::vector<Block>& blocks, std::size_t states, double interval,
                                          bool withVelocity) {
    assert(states > 0 && interval > 0);
    auto mesh = std::make_shared<Mesh>();
    mesh->offsets.push_back(0);
    std::vector<Vec3> velocity;
    std::vector<double> gravity;
    std::vector<std::size_t> death;
    for (const Block& block : blocks) {
        const std::size_t firstNode = mesh->nodes.size();
        const std::size_t firstElement = mesh->shapes.size();
        addNodes(*mesh, block);
        addElements(*mesh, block, static_cast<std::uint32_t>(firstNode));
        velocity.resize(mesh->nodes.size(), block.velocity);
        gravity.resize(mesh->nodes.size(), block.gravity);
        for (std::size_t e = firstElement; e < mesh->shapes.size(); ++e) {
            death.push_back(block.deathState(e - firstElement));
        }
    }

    FeResult::Contents contents;
    for (std::size_t k = 0; k < states; ++k) {
        contents.times.push_back(static_cast<double>(k) * interval);
    }
    contents.activity = Activity(states, mesh->elementCount());
    for (std::size_t k = 0; k < states; ++k) {
        for (std::size_t e = 0; e < death.size(); ++e) {
            contents.activity.set(k, idAt<ElementIndex>(e), k < death[e]);
        }
    }
    contents.hasVelocity = withVelocity;
    contents.source = std::make_shared<FlightSource>(mesh, contents.times, velocity, gravity, withVelocity);
    contents.format = "scene";
    contents.path = "scene";
    contents.activityFrom = "scene";
    Hasher hasher;
    for (const Vec3& node : mesh->nodes) {
        hasher.bytes(node.data(), sizeof(double) * 3);
    }
    hasher.values(std::span<const std::size_t>(death)).value(states).value(interval).value(withVelocity);
    contents.fingerprint = hasher.finish();
    contents.mesh = std::move(mesh);
    return std::make_shared<FeResult>(std::move(contents));
}

}  // namespace rubble::blocks
