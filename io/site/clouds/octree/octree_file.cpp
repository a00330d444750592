#include "io/site/clouds/octree/octree_file.h"

#include <sys/stat.h>

#include <cerrno>
#include <vector>

#include "io/base/files.h"
#include "io/site/clouds/cloud_file.h"

namespace rubble::io {

CloudStamp stampOf(const std::string& path) {
    struct stat about{};
    if (::stat(path.c_str(), &about) != 0) {
        const CloudFile missing(path);  // says what is wrong
        failToWrite(path, systemReason(errno));
    }
    return {static_cast<std::uint64_t>(about.st_size), std::int64_t{about.st_mtim.tv_sec} * 1'000'000'000 + about.st_mtim.tv_nsec};
}

Digest contentDigest(const std::string& path) {
    const CloudFile file(path);
    Hasher hasher;
    std::vector<unsigned char> block(std::size_t{1} << 20);
    for (std::uint64_t at = 0; at < file.size();) {
        const std::size_t got = file.readSome(at, block.data(), block.size());
        if (got == 0) {
            break;
        }
        hasher.bytes(block.data(), got);
        at += got;
    }
    return hasher.finish();
}

Digest requestDigest(const CloudRequest& request) {
    Hasher hasher;
    hasher.text(request.crs);
    for (const std::string& column : request.columns) {
        hasher.text(column);
    }
    return hasher.finish();
}

}  // namespace rubble::io
