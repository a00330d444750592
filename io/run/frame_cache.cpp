#include "io/run/frame_cache.h"

namespace rubble::io {

namespace {

std::size_t bytesOf(const TrajectoryFrame& frame) {
    return sizeof frame +
           frame.bodies() * (sizeof(Eigen::Vector3f) + sizeof(Eigen::Quaternionf) + sizeof(float) + sizeof(BodyState));
}

}  // namespace

std::shared_ptr<const TrajectoryFrame> FrameCache::find(std::size_t index) {
    const auto place = m_places.find(index);
    if (place == m_places.end()) {
        return nullptr;
    }
    m_entries.splice(m_entries.begin(), m_entries, place->second);
    return place->second->frame;
}

void FrameCache::add(std::size_t index, std::shared_ptr<const TrajectoryFrame> frame) {
    if (find(index)) {
        return;
    }
    m_bytes += bytesOf(*frame);
    m_entries.push_front({index, std::move(frame)});
    m_places[index] = m_entries.begin();
    while (m_bytes > m_byteLimit && m_entries.size() > 2) {
        m_bytes -= bytesOf(*m_entries.back().frame);
        m_places.erase(m_entries.back().index);
        m_entries.pop_back();
    }
}

}  // namespace rubble::io
