#include "core/validation/heap_form.h"

#include <limits>

#include "core/analysis/debris/box_outline.h"
#include "core/validation/box_overlap.h"

namespace rubble {

HeapSurface::HeapSurface(const std::vector<OrientedBox>& boxes, double halfX, double halfY)
    : m_halfX(halfX),
      m_halfY(halfY),
      m_nx(static_cast<std::size_t>(std::ceil(2.0 * halfX / cell))),
      m_ny(static_cast<std::size_t>(std::ceil(2.0 * halfY / cell))),
      m_top(m_nx * m_ny, -1.0) {
    const auto range = [](double at, double reach, double half, std::size_t n) {
        const double low = std::floor((at - reach + half) / cell), high = std::ceil((at + reach + half) / cell);
        const double most = static_cast<double>(n);
        return std::pair(static_cast<std::size_t>(std::clamp(low, 0.0, most)),
                         static_cast<std::size_t>(std::clamp(high, 0.0, most)));
    };
    for (const OrientedBox& box : boxes) {
        const BoxTop top(box);
        const double reach = box.halfExtents.norm();
        const auto [i0, i1] = range(box.centre.x(), reach, halfX, m_nx);
        const auto [j0, j1] = range(box.centre.y(), reach, halfY, m_ny);
        for (std::size_t j = j0; j < j1; ++j) {
            for (std::size_t i = i0; i < i1; ++i) {
                m_top[j * m_nx + i] = std::max(m_top[j * m_nx + i], top.at(x(i), y(j)).value_or(-1.0));
            }
        }
    }
}

void HeapProfile::add(double distance, double top) {
    const auto bin = static_cast<std::size_t>(distance / m_width);
    if (bin >= m_cells.size()) {
        m_cells.resize(bin + 1, 0.0);
        m_height.resize(bin + 1, 0.0);
    }
    m_cells[bin] += 1.0;
    m_height[bin] += std::max(top, 0.0);
}

void HeapProfile::finish() {
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        m_height[i] /= std::max(m_cells[i], 1.0);
    }
}

std::vector<OrientedBox> joinedBoxes(const std::vector<OrientedBox>& boxes, const Vec3& heart, double gap) {
    std::vector<OrientedBox> found;
    if (boxes.empty()) {
        return found;
    }
    std::vector<bool> in(boxes.size(), false);
    std::vector<std::size_t> edge{static_cast<std::size_t>(std::min_element(boxes.begin(), boxes.end(),
                                                                            [&](const OrientedBox& a, const OrientedBox& b) {
                                                                                return (a.centre - heart).squaredNorm() <
                                                                                       (b.centre - heart).squaredNorm();
                                                                            }) -
                                                           boxes.begin())};
    in[edge.front()] = true;
    while (!edge.empty()) {
        const OrientedBox box = boxes[edge.back()];
        edge.pop_back();
        found.push_back(box);
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const double reach = boxes[i].halfExtents.norm() + box.halfExtents.norm() + gap;
            if (!in[i] && (boxes[i].centre - box.centre).squaredNorm() < reach * reach && overlapOf(boxes[i], box) > -gap) {
                in[i] = true;
                edge.push_back(i);
            }
        }
    }
    return found;
}

PowerLaw powerLawThrough(const std::vector<std::pair<double, double>>& points) {
    double n = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
    for (const auto& [at, value] : points) {
        const double x = std::log(at), y = std::log(value);
        n += 1.0;
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    const double exponent = (n * sxy - sx * sy) / (n * sxx - sx * sx);
    return {exponent, std::exp((sy - exponent * sx) / n)};
}

double factorApart(double a, double b) {
    return a > 0.0 && b > 0.0 ? std::max(a / b, b / a) : std::numeric_limits<double>::infinity();
}

}  // namespace rubble
