#include "io/site/clouds/octree/point_sorter.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include "io/base/files.h"

namespace rubble::io {

namespace {

constexpr std::size_t pointBytes = sizeof(OctreePoint);

bool before(const OctreePoint& one, const OctreePoint& other) {
    return std::pair(one.key, one.rest) < std::pair(other.key, other.rest);
}

}  // namespace

/// A run that is read back bit by bit.
struct PointSorter::Run {
    std::uint64_t at = 0;    ///< of what was not read yet, in points of the file
    std::uint64_t left = 0;  ///< points
    std::vector<OctreePoint> points = {};
    std::size_t next = 0;

    /// @return false: there are none left
    bool fill(int file, const std::string& path) {
        constexpr std::uint64_t most = 32'768;
        if (next < points.size()) {
            return true;
        }
        points.resize(static_cast<std::size_t>(std::min(most, left)));
        next = 0;
        std::size_t done = 0;
        auto* bytes = reinterpret_cast<char*>(points.data());
        while (done < points.size() * pointBytes) {
            const ssize_t got =
                ::pread(file, bytes + done, points.size() * pointBytes - done, static_cast<off_t>(at * pointBytes + done));
            if (got == 0 || (got < 0 && errno != EINTR)) {
                failToWrite(path, systemReason(got < 0 ? errno : EIO));
            }
            done += got > 0 ? static_cast<std::size_t>(got) : 0;
        }
        at += points.size();
        left -= points.size();
        return !points.empty();
    }
    const OctreePoint& front() const { return points[next]; }
};

PointSorter::PointSorter(std::string beside, std::size_t runPoints) : m_beside(std::move(beside)), m_runPoints(runPoints) {}

PointSorter::~PointSorter() {
    if (m_work.valid()) {
        m_work.wait();
    }
    if (m_file >= 0) {
        ::close(m_file);
    }
}

void PointSorter::putAway() {
    if (m_work.valid()) {
        m_work.get();
    }
    if (m_file < 0) {
        const std::string path = unfinishedName(m_beside);
        m_file = ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
        if (m_file < 0) {
            failToWrite(path, systemReason(errno));
        }
        ::unlink(path.c_str());
    }
    std::swap(m_filling, m_sorting);
    m_filling.clear();
    m_filling.reserve(m_runPoints);
    const std::uint64_t at = m_kept;
    m_runs.push_back(m_sorting.size());
    m_kept += m_sorting.size();
    m_work = std::async(std::launch::async, [this, at] {
        std::sort(m_sorting.begin(), m_sorting.end(), before);
        writeRun(m_sorting, at);
    });
}

void PointSorter::writeRun(const std::vector<OctreePoint>& points, std::uint64_t at) {
    const auto* bytes = reinterpret_cast<const char*>(points.data());
    std::size_t done = 0;
    while (done < points.size() * pointBytes) {
        const ssize_t put =
            ::pwrite(m_file, bytes + done, points.size() * pointBytes - done, static_cast<off_t>(at * pointBytes + done));
        if (put == 0 || (put < 0 && errno != EINTR)) {
            failToWrite(m_beside, systemReason(put < 0 ? errno : ENOSPC));
        }
        done += put > 0 ? static_cast<std::size_t>(put) : 0;
    }
}

void PointSorter::forEach(const Execution& execution, const std::function<void(const OctreePoint&)>& visit) {
    if (m_runs.empty()) {
        std::sort(m_filling.begin(), m_filling.end(), before);
        std::for_each(m_filling.begin(), m_filling.end(), visit);
        return;
    }
    if (!m_filling.empty()) {
        putAway();
    }
    m_work.get();
    m_filling = {};
    m_sorting = {};
    merge(execution, visit);
}

void PointSorter::merge(const Execution& execution, const std::function<void(const OctreePoint&)>& visit) {
    std::vector<Run> runs;
    std::uint64_t at = 0;
    for (const std::uint64_t points : m_runs) {
        runs.push_back({at, points});
        at += points;
    }
    std::vector<std::size_t> heap;
    const auto later = [&](std::size_t one, std::size_t other) {
        const OctreePoint& a = runs[one].front();
        const OctreePoint& b = runs[other].front();
        return before(b, a) || (!before(a, b) && other < one);
    };
    for (std::size_t r = 0; r < runs.size(); ++r) {
        if (runs[r].fill(m_file, m_beside)) {
            heap.push_back(r);
        }
    }
    std::make_heap(heap.begin(), heap.end(), later);
    for (std::uint64_t done = 0; !heap.empty(); ++done) {
        if (done % 1'000'000 == 0) {
            execution.report({"octree.building", "Laying points into levels", {}},
                             static_cast<double>(done) / static_cast<double>(m_kept));
        }
        std::pop_heap(heap.begin(), heap.end(), later);
        Run& run = runs[heap.back()];
        visit(run.front());
        ++run.next;
        if (run.fill(m_file, m_beside)) {
            std::push_heap(heap.begin(), heap.end(), later);
        } else {
            heap.pop_back();
        }
    }
}

}  // namespace rubble::io
