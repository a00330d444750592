#include <cmath>
#include <string>
#include <vector>

#include "io/site/clouds/cloud_summary.h"
#include "io/site/clouds/e57/e57_pages.h"
#include "tests/fuzz/fuzzed_file.h"

using namespace rubble;

namespace {

/// An E57 with other bytes has other checksums: they are put right, so that what lies behind them is read.
std::vector<std::uint8_t> withChecksums(const std::uint8_t* bytes, std::size_t size) {
    std::vector<std::uint8_t> all(bytes, bytes + size);
    if (size < 48 || std::string(all.begin(), all.begin() + 8) != "ASTM-E57") {
        return all;
    }
    const auto page = io::littleAt<std::uint64_t>(&all[40]);
    for (std::size_t at = 0; page >= 64 && page <= size - at; at += static_cast<std::size_t>(page)) {
        const std::uint32_t sum = io::crc32c(&all[at], static_cast<std::size_t>(page) - 4);
        for (std::size_t k = 0; k < 4; ++k) {
            all[at + static_cast<std::size_t>(page) - 4 + k] = static_cast<std::uint8_t>(sum >> (24 - 8 * k));
        }
    }
    return all;
}

}  // namespace

/// Reads any bytes as a point cloud of any format; what is taken is finite, and every column is as long as the others.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    // A head of a few bytes may honestly promise more points than a round has time for.
    constexpr std::uint64_t enough = 2'000'000;
    const std::vector<std::uint8_t> file = withChecksums(bytes, size);
    const std::string path = layDown(file.data(), file.size(), "cloud");
    try {
        const std::unique_ptr<io::PointCloud> cloud = io::openCloud(path);
        io::CloudBlock block;
        const io::CloudColumns& columns = cloud->head().columns;
        while (cloud->next(block, fuzzExecution()) && cloud->fates()[0] < enough) {
            const std::size_t points = block.size();
            const bool whole = block.intensity.size() == (columns.intensity ? points : 0) &&
                               block.colours.size() == (columns.colour ? points : 0) &&
                               block.classes.size() == (columns.classes ? points : 0) &&
                               block.times.size() == (columns.times ? points : 0);
            for (const Vec3& place : block.places) {
                if (!place.allFinite()) {
                    __builtin_trap();
                }
            }
            for (const std::uint16_t scan : block.scans) {
                if (scan >= cloud->head().scans.size()) {
                    __builtin_trap();
                }
            }
            if (!whole || points > io::cloudBlockPoints) {
                __builtin_trap();
            }
        }
        cloud->findings();
        for (const io::CloudPhotograph& photograph : cloud->head().photographs) {
            cloud->photograph(photograph);
        }
    } catch (const Error&) {
    }
    return 0;
}
