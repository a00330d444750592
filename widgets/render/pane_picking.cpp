#include <algorithm>
#include <limits>

#include "widgets/render/pane_geometry.h"

namespace rubble::render {

std::optional<Vec3> PaneGeometry::centreOf(ElementIndex element) const {
    for (const TimeSpan& span : m_showTimes.of(element)) {
        if (span.from <= m_placedTime && m_placedTime < span.to) {
            Eigen::Vector3f sum = Eigen::Vector3f::Zero();
            const auto corners = m_data.fe->mesh().cornersOf(element);
            for (const std::uint32_t node : corners) {
                sum += placeOf(node);
            }
            return (sum / static_cast<float>(corners.size())).cast<double>();
        }
    }
    return std::nullopt;
}

std::vector<ElementIndex> PaneGeometry::elementsWhere(const std::function<bool(const Vec3&)>& inside) const {
    std::vector<ElementIndex> found;
    if (!m_placed) {
        return found;
    }
    const auto take = [&](ElementIndex element, const std::optional<Vec3>& centre) {
        if (centre && !cutAway(*centre) && inside(*centre)) {
            found.push_back(element);
        }
    };
    for (std::size_t e = 0; e < m_status.elements; ++e) {
        const ElementIndex element = idAt<ElementIndex>(e);
        if (!hidden(element)) {
            take(element, centreOf(element));
        }
    }
    for (std::size_t f = 0; m_debris && f < m_data.fragments->size(); ++f) {
        const Fragment& fragment = m_data.fragments->list[f];
        const double from = m_carried ? fragment.handOverTime : fragment.birthTime;
        if (meets(f) && from <= m_placedTime && m_placedTime < fragment.endTime) {
            take(fragment.element, m_debris->centreOf(idAt<FragmentId>(f), m_frame, m_placedTime));
        }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

std::optional<Pick> PaneGeometry::cast(const Ray& ray) const {
    const Eigen::Vector3f origin = ray.origin.cast<float>();
    const Eigen::Vector3f direction = ray.direction.cast<float>();
    const auto point = [this](std::size_t i) { return Eigen::Map<const Eigen::Vector3f>(m_points.data() + 3 * m_triangles[i]); };
    float nearest = std::numeric_limits<float>::infinity();
    std::size_t hit = m_owners.size();
    for (std::size_t i = 0; i < m_owners.size(); ++i) {
        const Eigen::Vector3f a = point(3 * i);
        const Eigen::Vector3f ab = point(3 * i + 1) - a;
        const Eigen::Vector3f ac = point(3 * i + 2) - a;
        const Eigen::Vector3f cross = direction.cross(ac);
        const float det = ab.dot(cross);
        if (!(det > 0.0f)) {
            continue;  // edge on, or seen from behind and not drawn
        }
        const Eigen::Vector3f to = origin - a;
        const float u = to.dot(cross);
        const Eigen::Vector3f q = to.cross(ab);
        const float v = direction.dot(q);
        if (u < 0.0f || v < 0.0f || u + v > det) {
            continue;
        }
        const float distance = ac.dot(q) / det;
        if (distance > 0.0f && distance < nearest && !cutAway(ray.origin + static_cast<double>(distance) * ray.direction)) {
            nearest = distance;
            hit = i;
        }
    }
    if (hit == m_owners.size()) {
        return std::nullopt;
    }
    Pick pick;
    pick.pane = m_content;
    pick.element = m_owners[hit].element;
    if (m_owners[hit].fragment != none && born(m_owners[hit].fragment)) {
        pick.fragment = idAt<FragmentId>(m_owners[hit].fragment);
    }
    pick.position = ray.origin + static_cast<double>(nearest) * ray.direction;
    pick.corner = point(3 * hit).cast<double>();
    for (std::size_t k = 1; k < 3; ++k) {
        const Vec3 corner = point(3 * hit + k).cast<double>();
        if ((corner - pick.position).squaredNorm() < (pick.corner - pick.position).squaredNorm()) {
            pick.corner = corner;
        }
    }
    return pick;
}

}  // namespace rubble::render
