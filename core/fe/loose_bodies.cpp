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

/// Corners, and behind those of a hull its centre.
std::vector<Vec3> nodesOf(const LooseBody& body) {
    std::vector<Vec3> nodes = cornersOf(body);
    if (body.hull) {
        nodes.push_back(body.pose.position);
    }
    return nodes;
}

/// Nodes of each element of a body, counted within it.
std::vector<std::vector<std::uint32_t>> elementsOf(const LooseBody& body) {
    if (!body.hull) {
        return {{0, 1, 2, 3, 4, 5, 6, 7}};
    }
    std::vector<std::vector<std::uint32_t>> elements;
    const auto middle = static_cast<std::uint32_t>(body.hull->corners.size());
    for (const auto& [a, b, c] : body.hull->triangles) {
        elements.push_back({a, c, b, middle});
    }
    return elements;
}

std::size_t elementCountOf(const LooseBody& body) {
    return body.hull ? body.hull->triangles.size() : 1;
}

/// Bodies that stand where they are let go, moving as they then will.
class LooseSource : public StateSource {
public:
    LooseSource(const std::vector<LooseBody>& bodies, std::vector<double> times) : m_times(std::move(times)) {
        for (const LooseBody& body : bodies) {
            for (const Vec3& node : nodesOf(body)) {
                m_positions.push_back(node);
                m_velocities.emplace_back(body.velocity + body.spin.cross(node - body.pose.position));
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
    std::size_t elements = 0;
    for (const LooseBody& body : bodies) {
        elements += elementCountOf(body);
    }
    for (const LooseBody& body : bodies) {
        std::int64_t number = 0;
        const char* const end = body.id.data() + body.id.size();
        const auto [last, error] = std::from_chars(body.id.data(), end, number);
        if (error != std::errc{} || last != end || number < 0) {
            break;
        }
        numbers.push_back(number);
    }
    const bool hulls = std::any_of(bodies.begin(), bodies.end(), [](const LooseBody& body) { return body.hull != nullptr; });
    if (hulls || numbers.size() != bodies.size() || std::set(numbers.begin(), numbers.end()).size() != bodies.size()) {
        numbers.resize(elements);
        for (std::size_t i = 0; i < elements; ++i) {
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
        const auto first = static_cast<std::uint32_t>(mesh.nodes.size());
        for (const Vec3& node : nodesOf(body)) {
            mesh.nodes.push_back(node);
            mesh.nodeIds.push_back(static_cast<std::int64_t>(mesh.nodes.size()));
        }
        const auto [part, isNew] = parts.emplace(partOf(body), static_cast<std::uint32_t>(parts.size()));
        if (isNew) {
            mesh.parts.push_back({part->first, static_cast<std::int64_t>(parts.size())});
        }
        for (const std::vector<std::uint32_t>& element : elementsOf(body)) {
            for (const std::uint32_t node : element) {
                mesh.corners.push_back(first + node);
            }
            mesh.offsets.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
            mesh.shapes.push_back(body.hull ? ElementShape::Tetrahedron : ElementShape::Hexahedron);
            mesh.part.push_back(part->second);
            mesh.density.push_back(body.density());
            mesh.section.push_back(unknown);
        }
    }
    return mesh;
}

}  // namespace

std::vector<Vec3> cornersOf(const LooseBody& body) {
    std::vector<Vec3> corners;
    if (body.hull) {
        for (const Vec3& corner : body.hull->corners) {
            corners.push_back(body.pose * corner);
        }
        return corners;
    }
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
    contents.activity = Activity(contents.times.size(), contents.mesh->elementCount());
    Hasher hasher;
    std::size_t element = 0;
    for (const LooseBody& body : bodies) {
        for (const std::size_t last = element + elementCountOf(body); element < last; ++element) {
            for (std::size_t k = 0; k < contents.times.size(); ++k) {
                contents.activity.set(k, idAt<ElementIndex>(element), contents.times[k] <= body.time);
            }
        }
        hasher.text(body.id).text(partOf(body)).value(body.mass).value(body.time);
        for (const Vec3& v : {body.sides, body.pose.position, body.velocity, body.spin}) {
            hasher.bytes(v.data(), 3 * sizeof(double));
        }
        hasher.bytes(body.pose.orientation.coeffs().data(), 4 * sizeof(double));
        if (body.hull) {
            for (const Vec3& corner : body.hull->corners) {
                hasher.bytes(corner.data(), 3 * sizeof(double));
            }
        }
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

std::vector<std::uint32_t> bodiesOfTable(const FeResult& fe) {
    std::vector<std::uint32_t> bodies;
    const Mesh& mesh = fe.mesh();
    if (!fe.contents().looseBodies || mesh.elementCount() == 0) {
        return bodies;
    }
    std::uint32_t latest = 0;
    std::uint32_t body = 0;
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        const auto corners = mesh.cornersOf(idAt<ElementIndex>(e));
        body += e > 0 && std::ranges::min(corners) > latest ? 1 : 0;
        latest = std::max(latest, std::ranges::max(corners));
        bodies.push_back(body);
    }
    if (std::size_t{body} + 1 == bodies.size()) {
        bodies.clear();
    }
    return bodies;
}

}  // namespace rubble
