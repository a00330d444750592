#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "io/site/clouds/cloud_head.h"
#include "io/site/clouds/cloud_source.h"

namespace rubble::io {

/// A point cloud that is read block by block, whatever its format. Points that are invalid, withheld, noise, without an echo or no
/// number are left out and counted.
class PointCloud {
public:
    PointCloud(std::string path, std::unique_ptr<CloudSource> source, const CloudRequest& request);

    const std::string& path() const { return m_path; }
    const CloudHead& head() const { return m_source->head(); }
    /// Fills a block with the next points that are taken; it may be empty. @return false: there are none left
    /// Throws ParseError (the file is damaged here), WorldError, Cancelled.
    bool next(CloudBlock& block, const Execution& execution);
    /// How many points met each fate, by its number, among those read so far.
    const std::array<std::uint64_t, pointFateCount>& fates() const { return m_fates; }
    /// The bytes of one of the pictures that the head names, as a file of its kind. Throws ParseError, WorldError.
    std::vector<unsigned char> photograph(const CloudPhotograph& picture) const;
    /// Share of the promised points that were read, [0, 1].
    double fraction() const;
    /// What was met so far; complete once next() returned false.
    Findings findings() const;

private:
    static void markNoise(CloudBlock& block);
    void mark(CloudBlock& block);
    void holdBackOrigin(const CloudBlock& block, std::size_t i);

    std::string m_path;
    std::unique_ptr<CloudSource> m_source;
    Findings m_findings;
    std::array<std::uint64_t, pointFateCount> m_fates{};
    std::uint64_t m_read = 0;
    Aabb m_all;           ///< of every finite place, those left out as well
    CloudBlock m_origin;  ///< the first point at 0, 0, 0: a second one shows that both are no echoes
    bool m_ended = false;
};

/// Whether a file begins as a format does that holds points and nothing else: LAS, LAZ, E57, PLY or PCD. Throws as CloudFile.
bool beginsAsCloud(const std::string& path);

/// Opens a point cloud by what the file holds, not by its name: LAS, LAZ, E57, PLY, PCD, PTX, PTS, or a table of text.
/// Throws WorldError, ParseError (none of these, or damaged), UsageError (a system or columns that cannot be meant).
std::unique_ptr<PointCloud> openCloud(const std::string& path, const CloudRequest& request = {});

}  // namespace rubble::io
