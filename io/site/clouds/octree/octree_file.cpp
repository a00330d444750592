#include "io/site/clouds/octree/octree_file.h"

#include <sys/stat.h>

#include <cerrno>
#include <charconv>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/site/clouds/cloud_file.h"

namespace rubble::io {

namespace {

constexpr const char* checkedEnding = ".checked";

/// Of its hex digits; unset: they are none.
std::optional<Digest> digestOf(std::string_view hex) {
    Digest digest;
    if (hex.size() != 2 * digest.bytes.size()) {
        return {};
    }
    for (std::size_t i = 0; i < digest.bytes.size(); ++i) {
        const char* const at = hex.data() + 2 * i;
        if (std::from_chars(at, at + 2, digest.bytes[i], 16).ptr != at + 2) {
            return {};
        }
    }
    return digest;
}

/// Nothing lies there, or a note of ours, whole or cut short; no link leads elsewhere.
bool mayNote(const std::string& path) {
    namespace fs = std::filesystem;
    std::error_code failed;
    const fs::file_status status = fs::symlink_status(path, failed);
    if (!fs::exists(status)) {
        return true;
    }
    // Two numbers of at most twenty characters, and the digest.
    constexpr std::uintmax_t longest = 2 * 21 + 2 * std::tuple_size_v<decltype(Digest::bytes)>;
    if (!fs::is_regular_file(status) || fs::file_size(path, failed) > longest || failed) {
        return false;
    }
    const std::optional<std::string> kept = contentOf(path);
    return kept && kept->find_first_not_of("0123456789abcdef -") == std::string::npos;
}

}  // namespace

CloudStamp stampOf(const std::string& path) {
    struct stat about{};
    if (::stat(path.c_str(), &about) != 0) {
        const CloudFile missing(path);  // says what is wrong
        failToWrite(path, systemReason(errno));
    }
    return {static_cast<std::uint64_t>(about.st_size), std::int64_t{about.st_mtim.tv_sec} * 1'000'000'000 + about.st_mtim.tv_nsec};
}

Digest contentDigest(const std::string& path, const Execution& execution) {
    const CloudFile file(path);
    Hasher hasher;
    std::vector<unsigned char> block(std::size_t{1} << 16);
    for (std::uint64_t at = 0; at < file.size();) {
        const std::size_t got = file.readSome(at, block.data(), block.size());
        if (got == 0) {
            break;
        }
        hasher.bytes(block.data(), got);
        at += got;
        execution.report({"octree.digest", "Reading the cloud for its digest", {}},
                         static_cast<double>(at) / static_cast<double>(file.size()));
    }
    return hasher.finish();
}

Digest rememberedDigest(const std::string& path, const std::string& octree, const Execution& execution) {
    const CloudStamp stamp = stampOf(path);
    const std::string known = octree + checkedEnding;
    const auto textOf = [&](const std::string& digest) {
        return std::to_string(stamp.bytes) + ' ' + std::to_string(stamp.time) + ' ' + digest;
    };
    const std::string start = textOf({});
    if (const std::optional<std::string> kept = contentOf(known); kept && kept->starts_with(start)) {
        if (const std::optional<Digest> digest = digestOf(kept->substr(start.size()))) {
            return *digest;
        }
    }
    const Digest digest = contentDigest(path, execution);
    try {
        // A file that changed meanwhile is another one.
        if (stampOf(path) == stamp && mayNote(known)) {
            writeIn(known, textOf(digest.hex()));
        }
    } catch (const WorldError&) {
        // No room for it: it is read again next time.
    }
    return digest;
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
