#include "core/fe/loose_bodies.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <set>

#include "core/base/unknown.h"

namespace rubble {

namespace {

/// s, from the last body to the last state.
constexpr double lastSpan = 0.1;

/// Bodies that stand where they are let go, moving as they then will.
class LooseSource : public StateSource {
public:
    LooseSource(const std::vector<LooseBody>& bodies, std::vector<double> times) : m_times(std::move(times)) {
        for (const LooseBody& body : bodies) {
            for (const Vec3& corner : cornersOf(body)) {
                m_positions.push_back(corner);
                m_velocities.emplace_back(body.velocity + body.spin.cross(corner - body.pose.position));
            }
        }
    }

    FeState read(std::size_t k) const override { return {m_times.at(k), m_positions, m_velocities}; }

private:
    std::vector<double> m_times;
    std::vector<Vec3> m_positions;
    std::vector<Vec3> m_velocities;
};

/// Element numbers: the ids, where these are whole numbers and differ.
std::vector<std::int64_t> numbersOf(const std::vector<LooseBody>& bodies) {
    std::vector<std::int64_t> numbers;
    for (const LooseBody& body : bodies) {
        std::int64_t number = 0;
        const char* const end = body.id.data() + body.id.size();
        const auto [last, error] = std::from_chars(body.id.data(), end, number);
        if (error != std::errc{} || last != end || number < 0) {
            break;
        }
        numbers.push_back(number);
    }
    if (numbers.size() != bodies.size() || std::set(numbers.begin(), numbers.end()).size() != bodies.size()) {
        numbers.resize(bodies.size());
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            numbers[i] = static_cast<std::int64_t>(i) + 1;
        }
    }
    return numbers;
}

std::vector<double> timesOf(const std::vector<LooseBody>& bodies, double until) {
    std::set<double> times;
    for (const LooseBody& body : bodies) {
        times.insert(body.time);
    }
    const double last = times.empty() ? 0.0 : *times.rbegin();
    times.insert(std::max(until, last + lastSpan));
    return {times.begin(), times.end()};
}

Mesh meshOf(const std::vector<LooseBody>& bodies) {
    Mesh mesh;
    mesh.elementIds = numbersOf(bodies);
    mesh.offsets.push_back(0);
    std::map<std::string, std::uint32_t> parts;
    for (const LooseBody& body : bodies) {
        for (const Vec3& corner : cornersOf(body)) {
            mesh.corners.push_back(static_cast<std::uint32_t>(mesh.nodes.size()));
            mesh.nodes.push_back(corner);
            mesh.nodeIds.push_back(static_cast<std::int64_t>(mesh.nodes.size()));
        }
        mesh.offsets.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
        mesh.shapes.push_back(ElementShape::Hexahedron);
        const auto [part, isNew] = parts.emplace(partOf(body), static_cast<std::uint32_t>(parts.size()));
        if (isNew) {
            mesh.parts.push_back({part->first, static_cast<std::int64_t>(parts.size())});
        }
        mesh.part.push_back(part->second);
        mesh.density.push_back(body.density());
        mesh.section.push_back(unknown);
    }
    return mesh;
}

}  // namespace

std::vector<Vec3> cornersOf(const LooseBody& body) {
    std::vector<Vec3> corners;
    for (const double z : {-0.5, 0.5}) {
        for (const auto& [x, y] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
            corners.push_back(body.pose * body.sides.cwiseProduct(Vec3(x, y, z)));
        }
    }
    return corners;
}

std::string partOf(const LooseBody& body) {
    return body.material ? std::string(materialName(*body.material))
                         : std::string(materialName(materialOfDensity(body.density()))) + ", by density";
}

FeResult::Contents contentsOf(const std::vector<LooseBody>& bodies, double until) {
    FeResult::Contents contents;
    contents.mesh = std::make_shared<const Mesh>(meshOf(bodies));
    contents.times = timesOf(bodies, until);
    contents.activity = Activity(contents.times.size(), bodies.size());
    Hasher hasher;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const LooseBody& body = bodies[i];
        for (std::size_t k = 0; k < contents.times.size(); ++k) {
            contents.activity.set(k, idAt<ElementIndex>(i), contents.times[k] <= body.time);
        }
        hasher.text(body.id).text(partOf(body)).value(body.mass).value(body.time);
        for (const Vec3& v : {body.sides, body.pose.position, body.velocity, body.spin}) {
            hasher.bytes(v.data(), 3 * sizeof(double));
        }
        hasher.bytes(body.pose.orientation.coeffs().data(), 4 * sizeof(double));
    }
    contents.fingerprint = hasher.value(contents.times.back()).finish();
    contents.hasVelocity = true;
    contents.looseBodies = true;
    contents.source = std::make_shared<LooseSource>(bodies, contents.times);
    contents.activityFrom = "each body is let go at its time";
    contents.declared = FileUnits{};
    contents.unitsFrom = "by the units in the heading";
    return contents;
}

}  // namespace rubble
