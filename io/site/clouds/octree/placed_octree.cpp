#include "io/site/clouds/octree/placed_octree.h"

#include "io/site/surveys/survey_placing.h"

namespace rubble::io {

PlacedOctree::PlacedOctree(const std::string& cloud, const CloudRequest& read, const Frame& frame, const Site& site,
                           const std::optional<Registration>& placed, const Execution& execution)
    : m_cloud(openCloud(cloud, read)), m_placed(placed) {
    // First whether it can be placed: that takes no time.
    m_place = std::make_unique<CloudPlace>(*m_cloud, frame, site, m_findings);
    m_opened = openOctree(cloud, read, execution);
    if (placed) {
        addPlacedFinding(m_findings, cloud, *placed);
    }
    std::vector<Vec3> corners;
    for (const OctreeNode& node : octree().nodes()) {
        for (int corner = 0; corner < 8; ++corner) {
            corners.push_back(node.box.corner(static_cast<Aabb::CornerType>(corner)));
        }
    }
    bring(corners);
    m_boxes.resize(octree().nodes().size());
    for (std::size_t c = 0; c < corners.size(); ++c) {
        if (corners[c].allFinite()) {
            m_boxes[c / 8].extend(corners[c]);
        }
    }
}

void PlacedOctree::bring(std::vector<Vec3>& places) const {
    m_place->toLocal(places);
    if (m_placed) {
        const Mat3 turn = m_placed->rotation();
        for (Vec3& place : places) {
            place = m_placed->about + m_placed->shift + turn * (place - m_placed->about);
        }
    }
}

CloudBlock PlacedOctree::read(std::size_t node) const {
    CloudBlock block = octree().read(node);
    bring(block.places);
    for (std::size_t i = 0; i < block.size(); ++i) {
        if (!block.places[i].allFinite()) {
            block.fates.resize(block.size(), PointFate::Taken);
            block.fates[i] = PointFate::NotFinite;
        }
    }
    block.keepTaken();
    return block;
}

}  // namespace rubble::io
