#include "io/site/clouds/point_cloud.h"

#include <algorithm>
#include <cmath>

#include "io/base/file_words.h"
#include "io/site/clouds/cloud_file.h"
#include "io/site/clouds/cloud_system.h"
#include "io/site/clouds/e57/e57_source.h"
#include "io/site/clouds/las/las_source.h"
#include "io/site/clouds/pcd_cloud.h"
#include "io/site/clouds/ply_cloud.h"
#include "io/site/clouds/table_cloud.h"

namespace rubble::io {

namespace {

/// Findings of what was left out, in the order of the fates.
void addFates(Findings& findings, const std::string& path, const std::array<std::uint64_t, pointFateCount>& fates) {
    const auto count = [&](PointFate fate) { return static_cast<std::int64_t>(fates[static_cast<std::size_t>(fate)]); };
    if (const std::int64_t n = count(PointFate::Invalid); n > 0) {
        addFinding(findings, path, {"cloud.invalid", "points that the file marks as invalid were left out", {}},
                   "none is needed: their scanner saw nothing there", n);
    }
    if (const std::int64_t n = count(PointFate::Withheld); n > 0) {
        addFinding(findings, path, {"cloud.withheld", "points that the file marks as withheld were left out", {}},
                   "take the mark off in a program for point clouds if they are to count", n);
    }
    if (const std::int64_t n = count(PointFate::Noise); n > 0) {
        addFinding(findings, path, {"cloud.noise", "points of the noise classes 7 and 18 were left out", {}},
                   "give them another class in a program for point clouds if they are to count", n);
    }
    if (const std::int64_t n = count(PointFate::NoReturn); n > 0) {
        addFinding(findings, path,
                   {"cloud.no_return", "points at 0, 0, 0 were left out: scanners write there what gave no echo", {}},
                   "none is needed; if they are places, shift the cloud by a whole number of metres", n);
    }
    if (const std::int64_t n = count(PointFate::NotFinite); n > 0) {
        addFinding(findings, path, {"cloud.not_finite", "points with a coordinate that is no finite number were left out", {}},
                   "none is needed if the program that wrote the file marks gaps so", n);
    }
}

/// Says where points lie beyond the bounds of the head, or leave room in them.
void compareBounds(Findings& findings, const std::string& path, const CloudHead& head, const Aabb& all) {
    if (head.stated.isEmpty() || all.isEmpty()) {
        return;
    }
    const Vec3 step = head.scale ? head.scale->cwiseAbs().eval() : Vec3::Zero().eval();
    const Vec3 size = all.min().cwiseAbs().cwiseMax(all.max().cwiseAbs());
    const Vec3 apart = (head.stated.min() - all.min()).cwiseAbs().cwiseMax((head.stated.max() - all.max()).cwiseAbs());
    const Vec3 most = 1.01 * step + 1e-9 * size;
    if ((apart.array() > most.array()).any()) {
        addFinding(
            findings, path,
            {"cloud.bounds_differ", "the bounds in the head are up to {0} units off those of the points", {apart.maxCoeff()}},
            "those of the points are used; have the head written anew if other programs need it");
    }
}

}  // namespace

PointCloud::PointCloud(std::string path, std::unique_ptr<CloudSource> source, const CloudRequest& request)
    : m_path(std::move(path)), m_source(std::move(source)) {
    describeUnits(m_path, request.crs, m_source->head(), m_findings);
}

bool PointCloud::next(CloudBlock& block, const Execution& execution) {
    if (m_ended) {
        block.clear();
        return false;
    }
    if (m_source->next(block, execution)) {
        m_read += block.size();
        mark(block);
        block.keepTaken();
        m_fates[0] += block.size();
        return true;
    }
    m_ended = true;
    std::swap(block, m_origin);
    block.fates.clear();
    m_fates[0] += block.size();
    return block.size() > 0;
}

void PointCloud::markNoise(CloudBlock& block) {
    constexpr std::uint16_t lowNoise = 7;
    constexpr std::uint16_t highNoise = 18;
    for (std::size_t i = 0; i < block.classes.size(); ++i) {
        const std::uint16_t kind = block.classes[i];
        if (kind == lowNoise || kind == highNoise) {
            block.fates.resize(block.size(), PointFate::Taken);
            if (block.fates[i] == PointFate::Taken) {
                block.fates[i] = PointFate::Noise;
            }
        }
    }
}

void PointCloud::mark(CloudBlock& block) {
    markNoise(block);
    for (std::size_t i = 0; i < block.size(); ++i) {
        const Vec3& place = block.places[i];
        PointFate fate = block.fates.empty() ? PointFate::Taken : block.fates[i];
        const bool finite = place.allFinite();
        if (finite) {
            m_all.extend(place);
        }
        if (fate == PointFate::Taken) {
            if (finite && !(place.x() == 0.0 && place.y() == 0.0 && place.z() == 0.0)) {
                continue;
            }
            fate = finite ? PointFate::NoReturn : PointFate::NotFinite;
            if (fate == PointFate::NoReturn) {
                holdBackOrigin(block, i);
            }
            block.fates.resize(block.size(), PointFate::Taken);
            block.fates[i] = fate;
            if (fate == PointFate::NoReturn) {
                continue;
            }
        }
        ++m_fates[static_cast<std::size_t>(fate)];
    }
}

void PointCloud::holdBackOrigin(const CloudBlock& block, std::size_t i) {
    std::uint64_t& left = m_fates[static_cast<std::size_t>(PointFate::NoReturn)];
    if (left > 0) {
        ++left;
    } else if (m_origin.size() == 0) {
        m_origin.add(block, i);
    } else {
        m_origin.clear();
        left = 2;
    }
}

std::vector<unsigned char> PointCloud::photograph(const CloudPhotograph& picture) const {
    // No other format holds any.
    return photographOfE57(m_path, picture);
}

double PointCloud::fraction() const {
    const std::uint64_t promised = head().promised.value_or(0);
    return promised == 0 ? 0.0 : std::min(1.0, static_cast<double>(m_read) / static_cast<double>(promised));
}

Findings PointCloud::findings() const {
    Findings all = m_findings;
    all.append(m_source->findings());
    addFates(all, m_path, m_fates);
    if (m_ended) {
        compareBounds(all, m_path, head(), m_all);
        if (m_fates[0] == 0) {
            addFinding(all, m_path, {"cloud.nothing_left", "no point is left of the cloud", {}},
                       "give a cloud that has points, and check what was left out and why");
        }
    }
    return all;
}

namespace {

/// A PCD begins with its version or its fields, behind lines of comment.
bool beginsAsPcd(std::string_view begin) {
    while (begin.starts_with('#')) {
        begin.remove_prefix(std::min(begin.find('\n'), begin.size() - 1) + 1);
    }
    return begin.starts_with("VERSION ") || begin.starts_with("FIELDS ");
}

}  // namespace

bool beginsAsCloud(const std::string& path) {
    std::array<unsigned char, 4096> start{};
    const std::size_t got = CloudFile(path).readSome(0, start.data(), start.size());
    const std::string_view begin(reinterpret_cast<const char*>(start.data()), got);
    return begin.starts_with("LASF") || begin.starts_with("ASTM-E57") || begin.starts_with("ply") || beginsAsPcd(begin);
}

std::unique_ptr<PointCloud> openCloud(const std::string& path, const CloudRequest& request) {
    std::array<unsigned char, 4096> start{};
    const CloudFile file(path);
    const std::size_t got = file.readSome(0, start.data(), start.size());
    const std::string_view begin(reinterpret_cast<const char*>(start.data()), got);
    const auto made = [&]() -> std::unique_ptr<CloudSource> {
        if (begin.starts_with("LASF")) {
            return openLas(path);
        }
        if (begin.starts_with("ASTM-E57")) {
            return openE57(path);
        }
        if (begin.starts_with("ply")) {
            return openPlyCloud(path);
        }
        if (beginsAsPcd(begin)) {
            return openPcd(path);
        }
        return openTextCloud(path, request);
    };
    return std::make_unique<PointCloud>(path, made(), request);
}

}  // namespace rubble::io
