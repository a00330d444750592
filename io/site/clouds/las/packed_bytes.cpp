#include "io/site/clouds/las/packed_bytes.h"

namespace rubble::io {

void PackedBytes::refill() {
    constexpr std::size_t windowBytes = std::size_t{1} << 16;
    const std::uint64_t left = m_end - std::min(m_end, m_from);
    m_window.resize(static_cast<std::size_t>(std::clamp<std::uint64_t>(left, 1, windowBytes)));
    std::size_t got = left > 0 ? m_file->readSome(m_from, m_window.data(), m_window.size()) : 0;
    m_from += got;
    if (got == 0) {
        m_window.assign(windowBytes, 0);
        got = windowBytes;
        m_from += got;
        m_beyond += got;
    }
    m_at = m_window.data();
    m_filled = m_at + got;
}

}  // namespace rubble::io
