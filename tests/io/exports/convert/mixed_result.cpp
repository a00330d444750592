#include "tests/io/exports/convert/mixed_result.h"
#include <gtest/gtest.h>

#include "core/base/unknown.h"

#include <bit>
#include <cmath>

namespace rubble::io {

namespace {

const std::vector<double> times{0.0, 0.1, 0.25, 1.0 / 3.0, 0.5};

/// Moves every node by its own vector, so that no two values are alike.
class MovingSource : public StateSource {
public:
    MovingSource(std::shared_ptr<const Mesh> mesh, std::shared_ptr<std::vector<std::size_t>> reads,
                 std::function<void(std::size_t)> atRead)
        : m_mesh(std::move(mesh)), m_reads(std::move(reads)), m_atRead(std::move(atRead)) {}

    FeState read(std::size_t k) const override {
        m_reads->push_back(k);
        if (m_atRead) {
            m_atRead(k);
        }
        FeState state;
        state.time = times[k];
        for (std::size_t n = 0; n < m_mesh->nodeCount(); ++n) {
            const auto i = static_cast<double>(n);
            const Vec3 velocity(std::sin(i + 1.0), std::cos(i), -9.81 * times[k]);
            state.velocities.push_back(velocity);
            state.positions.push_back(m_mesh->nodes[n] + 0.01 * static_cast<double>(k + 1) * velocity);
        }
        return state;
    }

private:
    std::shared_ptr<const Mesh> m_mesh;
    std::shared_ptr<std::vector<std::size_t>> m_reads;
    std::function<void(std::size_t)> m_atRead;
};

/// Puts elements of all shapes side by side, each with nodes of its own.
struct MixedMesh {
    Mesh mesh;

    MixedMesh() {
        mesh.offsets.push_back(0);
        mesh.parts = {{"pier, north", 7}, {"deck \"B\" <1>", 3}, {"Stäbe", 12}};
    }
    void add(ElementShape shape, std::uint32_t part, std::int64_t number, double density, double section) {
        static const std::vector<Vec3> hexahedron{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                                  {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
        static const std::vector<Vec3> wedge{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
        static const std::vector<Vec3> pyramid{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}};
        const std::vector<Vec3>& corners = shape == ElementShape::Wedge     ? wedge
                                           : shape == ElementShape::Pyramid ? pyramid
                                                                            : hexahedron;
        const double x = 2.0 * static_cast<double>(mesh.elementCount()) + 1.0 / 3.0;
        for (int c = 0; c < cornerCount(shape); ++c) {
            // A tetrahedron and a triangle are the corner of a cube.
            const int corner = shape == ElementShape::Tetrahedron && c >= 2 ? c + 1 : c;
            mesh.corners.push_back(static_cast<std::uint32_t>(mesh.nodes.size()));
            mesh.nodeIds.push_back(1000 - static_cast<std::int64_t>(mesh.nodes.size()));
            mesh.nodes.push_back(corners[static_cast<std::size_t>(corner)] + Vec3(x, 0.1, 0.7));
        }
        mesh.offsets.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
        mesh.shapes.push_back(shape);
        mesh.part.push_back(part);
        mesh.elementIds.push_back(number);
        mesh.density.push_back(density);
        mesh.section.push_back(section);
    }
};

}  // namespace

MixedResult::MixedResult(std::size_t extraNodes, std::function<void(std::size_t)> atRead)
    : m_reads(std::make_shared<std::vector<std::size_t>>()) {
    MixedMesh made;
    made.add(ElementShape::Hexahedron, 0, 11, 2400.0, unknown);
    made.add(ElementShape::Quadrilateral, 1, 40, 7850.0, 0.02);
    made.add(ElementShape::Wedge, 0, 12, 2400.0, unknown);
    made.add(ElementShape::Beam, 2, 5'000'000'000, 7850.0, 0.0004);
    made.add(ElementShape::Pyramid, 0, 2, unknown, unknown);
    made.add(ElementShape::Triangle, 1, 41, 7850.0, unknown);
    made.add(ElementShape::Tetrahedron, 0, 14, 1800.0 / 7.0, unknown);
    made.add(ElementShape::Hexahedron, 1, 39, unknown, unknown);
    for (std::size_t n = 0; n < extraNodes; ++n) {
        made.mesh.nodeIds.push_back(100'000 + static_cast<std::int64_t>(n));
        made.mesh.nodes.emplace_back(static_cast<double>(n) / 3.0, 5.0, 1.0);
    }
    FeResult::Contents contents;
    contents.mesh = std::make_shared<const Mesh>(std::move(made.mesh));
    contents.times = times;
    contents.activity = Activity(times.size(), 8);
    for (std::size_t k = 0; k < times.size(); ++k) {
        for (std::size_t e = 0; e < 8; ++e) {
            const bool dead = (e == 2 && k >= 1) || (e == 1 && k >= 3) || (e == 3 && k == 2);
            contents.activity.set(k, idAt<ElementIndex>(e), !dead);
        }
    }
    contents.deathTime.assign(8, unknown);
    contents.deathTime[2] = 0.07;
    contents.deathTime[1] = 0.2999;
    contents.hasVelocity = true;
    contents.format = "none";
    contents.path = "memory";
    contents.files = {"memory"};
    contents.sha256 = "0123";
    contents.activityFrom = "this test";
    contents.findings.add({"test.finding", "Found {0} of {1}", {3, {0.5, "m"}}}, {"test.remedy", "None", {}}, "an example", 4);
    contents.source = std::make_shared<const MovingSource>(contents.mesh, m_reads, std::move(atRead));
    m_fe = std::make_shared<const FeResult>(std::move(contents));
}

namespace {

// NaN is equal to NaN here.
void expectSameBits(const std::vector<double>& expected, const std::vector<double>& found, const char* what) {
    ASSERT_EQ(expected.size(), found.size()) << what;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_TRUE(std::bit_cast<std::uint64_t>(expected[i]) == std::bit_cast<std::uint64_t>(found[i]) ||
                    (std::isnan(expected[i]) && std::isnan(found[i])))
            << what << " " << i << ": " << expected[i] << " became " << found[i];
    }
}

}  // namespace

void expectSameResult(const FeResult& expected, const FeResult& found) {
    const Mesh &a = expected.mesh(), &b = found.mesh();
    EXPECT_EQ(a.nodeIds, b.nodeIds);
    EXPECT_EQ(a.nodes, b.nodes);
    EXPECT_EQ(a.elementIds, b.elementIds);
    EXPECT_EQ(a.shapes, b.shapes);
    EXPECT_EQ(a.part, b.part);
    EXPECT_EQ(a.offsets, b.offsets);
    EXPECT_EQ(a.corners, b.corners);
    expectSameBits(a.density, b.density, "density");
    expectSameBits(a.section, b.section, "section");
    ASSERT_EQ(a.parts.size(), b.parts.size());
    for (std::size_t p = 0; p < a.parts.size(); ++p) {
        EXPECT_EQ(a.parts[p].name, b.parts[p].name);
        EXPECT_EQ(a.parts[p].fileId, b.parts[p].fileId);
    }
    ASSERT_EQ(expected.times(), found.times());
    expectSameBits(expected.contents().deathTime, found.contents().deathTime, "death time");
    EXPECT_EQ(expected.contents().hasVelocity, found.contents().hasVelocity);
    for (std::size_t k = 0; k < expected.stateCount(); ++k) {
        for (std::size_t e = 0; e < a.elementCount(); ++e) {
            const auto id = idAt<ElementIndex>(e);
            ASSERT_EQ(expected.activity().active(k, id), found.activity().active(k, id)) << "element " << e << " at state " << k;
        }
        const auto left = expected.state(k), right = found.state(k);
        EXPECT_EQ(left->time, right->time);
        EXPECT_EQ(left->positions, right->positions) << "state " << k;
        EXPECT_EQ(left->velocities, right->velocities) << "state " << k;
    }
}

}  // namespace rubble::io
