#include "bench/refined_result.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <unordered_map>

namespace rubble {

namespace {

/// A node as a sum of nodes of the file: nodes in ascending order with their integer weights.
struct Blend {
    std::array<std::uint32_t, 8> nodes{};
    std::array<std::uint16_t, 8> weights{};
    int terms = 0;

    void add(std::uint32_t node, int weight) {
        if (weight > 0) {
            nodes[static_cast<std::size_t>(terms)] = node;
            weights[static_cast<std::size_t>(terms)] = static_cast<std::uint16_t>(weight);
            ++terms;
        }
    }
    Vec3 of(const std::vector<Vec3>& values) const {
        Vec3 sum = Vec3::Zero();
        double all = 0.0;
        for (int t = 0; t < terms; ++t) {
            const auto i = static_cast<std::size_t>(t);
            sum += weights[i] * values[nodes[i]];
            all += weights[i];
        }
        return sum / all;
    }
    /// Neighbours that share a face name its nodes alike.
    Digest key() const {
        std::vector<std::pair<std::uint32_t, std::uint16_t>> sorted;
        int shared = 0;
        for (std::size_t i = 0; i < static_cast<std::size_t>(terms); ++i) {
            sorted.emplace_back(nodes[i], weights[i]);
            shared = std::gcd(shared, int{weights[i]});
        }
        std::sort(sorted.begin(), sorted.end());
        Hasher hasher;
        for (const auto& [node, weight] : sorted) {
            hasher.value(node).value(weight / shared);
        }
        return hasher.finish();
    }
};

class RefinedSource : public StateSource {
public:
    RefinedSource(std::shared_ptr<const FeResult> coarse, std::vector<Blend> blends)
        : m_coarse(std::move(coarse)), m_blends(std::move(blends)) {}

    FeState read(std::size_t k) const override {
        const std::shared_ptr<const FeState> from = m_coarse->state(k);
        FeState state;
        state.time = from->time;
        state.positions.reserve(m_blends.size());
        for (const Blend& blend : m_blends) {
            state.positions.push_back(blend.of(from->positions));
        }
        for (const Blend& blend : m_blends) {
            if (!from->velocities.empty()) {
                state.velocities.push_back(blend.of(from->velocities));
            }
        }
        return state;
    }

private:
    std::shared_ptr<const FeResult> m_coarse;
    std::vector<Blend> m_blends;
};

/// Pieces along the three axes of a brick's own numbering: the most along its longest side.
std::array<int, 3> splitOf(const Mesh& mesh, std::span<const std::uint32_t> corners, std::array<int, 3> split) {
    const auto length = [&](std::size_t to) { return (mesh.nodes[corners[to]] - mesh.nodes[corners[0]]).norm(); };
    const std::array<double, 3> lengths{length(1), length(3), length(4)};
    std::array<std::size_t, 3> order{0, 1, 2};
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return lengths[a] > lengths[b]; });
    std::sort(split.rbegin(), split.rend());
    std::array<int, 3> own{};
    for (std::size_t i = 0; i < 3; ++i) {
        own[order[i]] = split[i];
    }
    return own;
}

/// A refined mesh while it is made.
class Refining {
public:
    Refining(const FeResult& coarse, std::array<int, 3> split, std::size_t states)
        : m_coarse(coarse), m_split(split), m_activity(states, coarse.mesh().elementCount() * pieces()) {
        m_mesh.parts = coarse.mesh().parts;
        m_mesh.offsets.push_back(0);
        for (std::size_t e = 0; e < coarse.mesh().elementCount(); ++e) {
            splitElement(idAt<ElementIndex>(e));
        }
    }
    std::size_t pieces() const { return static_cast<std::size_t>(m_split[0] * m_split[1] * m_split[2]); }

    Mesh m_mesh;
    std::vector<Blend> m_blends;

    Activity&& takeActivity() { return std::move(m_activity); }

private:
    struct DigestHash {
        std::size_t operator()(const Digest& digest) const {
            std::size_t value = 0;
            std::copy_n(digest.bytes.begin(), sizeof value, reinterpret_cast<std::uint8_t*>(&value));
            return value;
        }
    };

    std::uint32_t nodeAt(std::span<const std::uint32_t> corners, const std::array<int, 3>& of, const std::array<int, 3>& at) {
        // Corner numbers by their place along the three axes, as in Exodus II.
        static constexpr std::array<std::array<std::array<std::size_t, 2>, 2>, 2> corner{{{{{0, 4}, {3, 7}}}, {{{1, 5}, {2, 6}}}}};
        Blend blend;
        for (std::size_t x = 0; x < 2; ++x) {
            for (std::size_t y = 0; y < 2; ++y) {
                for (std::size_t z = 0; z < 2; ++z) {
                    const int weight = (x ? at[0] : of[0] - at[0]) * (y ? at[1] : of[1] - at[1]) * (z ? at[2] : of[2] - at[2]);
                    blend.add(corners[corner[x][y][z]], weight);
                }
            }
        }
        const auto [found, added] = m_numbers.try_emplace(blend.key(), static_cast<std::uint32_t>(m_blends.size()));
        if (added) {
            m_blends.push_back(blend);
            m_mesh.nodes.push_back(blend.of(m_coarse.mesh().nodes));
            m_mesh.nodeIds.push_back(static_cast<std::int64_t>(m_blends.size()));
        }
        return found->second;
    }

    void splitElement(ElementIndex e) {
        const Mesh& from = m_coarse.mesh();
        const std::span<const std::uint32_t> corners = from.cornersOf(e);
        const std::array<int, 3> of = splitOf(from, corners, m_split);
        static constexpr std::array<std::array<int, 3>, 8> around{
            {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
        for (int x = 0; x < of[0]; ++x) {
            for (int y = 0; y < of[1]; ++y) {
                for (int z = 0; z < of[2]; ++z) {
                    for (const auto& [dx, dy, dz] : around) {
                        m_mesh.corners.push_back(nodeAt(corners, of, {x + dx, y + dy, z + dz}));
                    }
                    addPiece(e);
                }
            }
        }
    }

    void addPiece(ElementIndex e) {
        const Mesh& from = m_coarse.mesh();
        const auto piece = idAt<ElementIndex>(m_mesh.shapes.size());
        m_mesh.shapes.push_back(ElementShape::Hexahedron);
        m_mesh.elementIds.push_back(static_cast<std::int64_t>(m_mesh.shapes.size()));
        m_mesh.part.push_back(from.part[at(e)]);
        m_mesh.density.push_back(from.density[at(e)]);
        m_mesh.section.push_back(from.section[at(e)]);
        m_mesh.offsets.push_back(static_cast<std::uint32_t>(m_mesh.corners.size()));
        const std::size_t states = m_activity.states();
        std::size_t death = 0;
        while (death < m_coarse.stateCount() && m_coarse.activity().active(death, e)) {
            ++death;
        }
        if (death < m_coarse.stateCount() && pieces() > 1) {
            const std::uint8_t chance = Hasher().text("scatter of deaths").value(at(piece)).finish().bytes[0];
            const std::size_t earlier = chance < 64 ? 2 : chance < 128 ? 1 : 0;
            death = std::max<std::size_t>(1, death - std::min(death, earlier));
        }
        for (std::size_t k = 0; k < std::min(death, states); ++k) {
            m_activity.set(k, piece, true);
        }
    }

    const FeResult& m_coarse;
    std::array<int, 3> m_split;
    Activity m_activity;
    std::unordered_map<Digest, std::uint32_t, DigestHash> m_numbers;
};

}  // namespace

std::shared_ptr<const FeResult> refinedResult(std::shared_ptr<const FeResult> coarse, std::array<int, 3> split,
                                              std::size_t states) {
    states = std::min(states, coarse->stateCount());
    Refining refining(*coarse, split, states);
    FeResult::Contents contents;
    contents.mesh = std::make_shared<const Mesh>(std::move(refining.m_mesh));
    contents.times.assign(coarse->times().begin(), coarse->times().begin() + static_cast<std::ptrdiff_t>(states));
    contents.activity = refining.takeActivity();
    contents.hasVelocity = coarse->contents().hasVelocity;
    contents.source = std::make_shared<RefinedSource>(coarse, std::move(refining.m_blends));
    contents.format = coarse->contents().format;
    contents.path = coarse->contents().path;
    contents.files = coarse->contents().files;
    contents.sha256 = coarse->contents().sha256;
    contents.activityFrom = coarse->contents().activityFrom + ", refined by a benchmark";
    contents.units = coarse->contents().units;
    contents.frame = coarse->contents().frame;
    contents.unitsFrom = coarse->contents().unitsFrom;
    contents.fingerprint =
        Hasher().text("refined").digest(coarse->contents().fingerprint).value(refining.pieces()).value(states).finish();
    return std::make_shared<const FeResult>(std::move(contents));
}

}  // namespace rubble
