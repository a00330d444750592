#include "core/simulation/effects/box_tree.h"

#include <algorithm>

namespace rubble {

namespace {

constexpr std::uint32_t leafSize = 8;

}  // namespace

double gapBetween(const Aabb& a, const Aabb& b) {
    const Vec3 apart = (a.min() - b.max()).cwiseMax(b.min() - a.max());
    return apart.maxCoeff() <= 0.0 ? apart.maxCoeff() : apart.cwiseMax(0.0).norm();
}

BoxTree::BoxTree(std::vector<TimedBox> boxes) : m_boxes(std::move(boxes)) {
    if (!m_boxes.empty()) {
        build(0, static_cast<std::uint32_t>(m_boxes.size()));
    }
}

void BoxTree::build(std::uint32_t first, std::uint32_t count) {
    const std::size_t here = m_nodes.size();
    Node node;
    node.first = first;
    node.count = count;
    Aabb centres;
    for (std::uint32_t i = first; i < first + count; ++i) {
        node.bounds.extend(m_boxes[i].box);
        node.until = std::max(node.until, m_boxes[i].until);
        centres.extend(m_boxes[i].box.center());
    }
    m_nodes.push_back(node);
    if (count <= leafSize) {
        return;
    }
    Eigen::Index axis = 0;
    centres.sizes().maxCoeff(&axis);
    const auto begin = m_boxes.begin() + first;
    std::nth_element(begin, begin + count / 2, begin + count, [axis](const TimedBox& a, const TimedBox& b) {
        const double x = a.box.center()[axis], y = b.box.center()[axis];
        return x < y || (x == y && a.tag < b.tag);
    });
    build(first, count / 2);
    m_nodes[here].right = static_cast<std::uint32_t>(m_nodes.size());
    build(first + count / 2, count - count / 2);
}

BoxTree::Nearest BoxTree::nearest(const Aabb& box, std::int64_t after, std::size_t except, double enough, Nearest best) const {
    std::vector<std::size_t> open;
    if (!m_nodes.empty()) {
        open.push_back(0);
    }
    while (!open.empty() && best.gap >= -enough) {
        const std::size_t at = open.back();
        open.pop_back();
        const Node& node = m_nodes[at];
        if (node.until <= after || gapBetween(box, node.bounds) >= best.gap) {
            continue;
        }
        if (node.right == 0) {
            for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
                const double gap = gapBetween(box, m_boxes[i].box);
                if (m_boxes[i].until > after && m_boxes[i].tag != except && gap < best.gap) {
                    best = {gap, m_boxes[i].tag};
                }
            }
            continue;
        }
        // The nearer child is looked at first: it lies on top.
        const bool leftNearer = gapBetween(box, m_nodes[at + 1].bounds) <= gapBetween(box, m_nodes[node.right].bounds);
        open.push_back(leftNearer ? node.right : at + 1);
        open.push_back(leftNearer ? at + 1 : node.right);
    }
    return best;
}

}  // namespace rubble
