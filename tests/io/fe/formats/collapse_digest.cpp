#include "tests/io/fe/formats/collapse_digest.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/fe/components.h"

namespace rubble::io {

CollapseDigest::CollapseDigest(const FeResult& fe, const std::vector<std::int64_t>& left) : m_fe(fe) {
    for (std::size_t e = 0; e < fe.mesh().elementCount(); ++e) {
        const std::int64_t number = fe.mesh().elementIds[e];
        if (std::find(left.begin(), left.end(), number) == left.end()) {
            m_places.emplace(number, e);
        }
    }
}

Digest CollapseDigest::elements() const {
    Hasher hasher;
    std::map<std::uint32_t, std::size_t> components;
    for (const auto& [number, e] : m_places) {
        const std::size_t component = components.try_emplace(m_fe.mesh().part[e], components.size()).first->second;
        hasher.value(number).value(component);
    }
    return hasher.finish();
}

Digest CollapseDigest::dead(std::size_t state) const {
    Hasher hasher;
    for (const auto& [number, e] : m_places) {
        if (!m_fe.activity().active(state, idAt<ElementIndex>(e))) {
            hasher.value(number);
        }
    }
    return hasher.finish();
}

std::size_t CollapseDigest::deadCount(std::size_t state) const {
    return static_cast<std::size_t>(std::count_if(m_places.begin(), m_places.end(), [&](const auto& place) {
        return !m_fe.activity().active(state, idAt<ElementIndex>(place.second));
    }));
}

std::size_t CollapseDigest::stateAt(double time) const {
    std::size_t k = 0;
    while (k < m_fe.stateCount() && std::abs(m_fe.times()[k] - time) > 1e-5 * std::abs(time)) {
        ++k;
    }
    return k;
}

std::map<std::int64_t, Vec3> CollapseDigest::centres(std::size_t state) const {
    const auto fields = m_fe.state(state);
    std::map<std::int64_t, Vec3> result;
    for (const auto& [number, e] : m_places) {
        const auto id = idAt<ElementIndex>(e);
        if (m_fe.activity().active(state, id)) {
            Vec3 sum = Vec3::Zero();
            for (const std::uint32_t node : m_fe.mesh().cornersOf(id)) {
                sum += fields->positions[node];
            }
            result[number] = sum / static_cast<double>(m_fe.mesh().cornersOf(id).size());
        }
    }
    return result;
}

double CollapseDigest::distance(std::size_t state, const CollapseDigest& other, std::size_t otherState) const {
    const auto own = centres(state), theirs = other.centres(otherState);
    double most = own.size() == theirs.size() ? 0.0 : std::numeric_limits<double>::infinity();
    for (const auto& [number, centre] : own) {
        const auto found = theirs.find(number);
        most = std::max(most, found == theirs.end() ? std::numeric_limits<double>::infinity() : (centre - found->second).norm());
    }
    return most;
}

std::map<std::int64_t, double> CollapseDigest::volumes() const {
    std::map<std::int64_t, double> result;
    const Mesh& mesh = m_fe.mesh();
    for (const auto& [number, e] : m_places) {
        std::vector<Vec3> corners;
        for (const std::uint32_t node : mesh.cornersOf(idAt<ElementIndex>(e))) {
            corners.push_back(mesh.nodes[node]);
        }
        result[number] = elementVolume(mesh.shapes[e], corners, mesh.section[e]);
    }
    return result;
}

std::map<std::int64_t, double> CollapseDigest::masses() const {
    std::map<std::int64_t, double> result = volumes();
    for (auto& [number, value] : result) {
        value *= m_fe.mesh().density[m_places.at(number)];
    }
    return result;
}

}  // namespace rubble::io
