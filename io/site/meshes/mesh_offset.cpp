#include "io/site/meshes/mesh_offset.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <pugixml.hpp>
#include <vector>

#include "io/base/files.h"
#include "io/base/trimmed.h"

namespace rubble::io {

namespace {

namespace fs = std::filesystem;

/// Bytes of an offset file that are looked at; those with more hold lists of cameras behind the offset.
constexpr std::size_t headMax = 4096;

std::string headOf(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::string head(headMax, '\0');
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
    return head;
}

std::vector<std::string> wordsOf(const std::string& text) {
    std::vector<std::string> words(1);
    for (const char c : text) {
        if (c == ' ' || c == '\t' || c == ',' || c == ';' || c == '\r' || c == '\n') {
            words.emplace_back();
        } else {
            words.back().push_back(c);
        }
    }
    std::erase(words, std::string());
    return words;
}

std::vector<double> numbersOf(const std::vector<std::string>& words) {
    std::vector<double> numbers;
    for (const std::string& word : words) {
        double number = 0.0;
        const auto end = std::from_chars(word.data(), word.data() + word.size(), number);
        if (end.ec == std::errc{} && end.ptr == word.data() + word.size() && std::isfinite(number)) {
            numbers.push_back(number);
        }
    }
    return numbers;
}

/// Three numbers, on one line or each on its own; a word with letters may name the system.
std::optional<MeshOffset> threeNumbers(const fs::path& path) {
    const std::vector<std::string> words = wordsOf(headOf(path));
    const std::vector<double> numbers = numbersOf(words);
    if (numbers.size() != 3) {
        return std::nullopt;
    }
    MeshOffset offset{Vec3(numbers[0], numbers[1], numbers[2]), path.string(), {}};
    if (!words.empty() && words.front().find(':') != std::string::npos && words.front().back() != ':') {
        offset.system = words.front();
    }
    return offset;
}

/// A line with the system, then one with easting and northing; lists of cameras follow.
std::optional<MeshOffset> systemAndTwoNumbers(const fs::path& path) {
    const std::string head = headOf(path);
    const std::size_t end = head.find('\n');
    if (end == std::string::npos) {
        return std::nullopt;
    }
    const std::string second = head.substr(end + 1, head.find('\n', end + 1) - end - 1);
    const std::vector<std::string> words = wordsOf(second);
    const std::vector<double> numbers = numbersOf(words);
    if (numbers.size() != 2 || words.size() != 2) {
        return std::nullopt;
    }
    return MeshOffset{Vec3(numbers[0], numbers[1], 0.0), path.string(), std::string(trimmed(head.substr(0, end)))};
}

/// <ModelMetadata><SRS>EPSG:32632</SRS><SRSOrigin>x,y,z</SRSOrigin></ModelMetadata>
std::optional<MeshOffset> metadata(const fs::path& path) {
    pugi::xml_document document;
    std::error_code error;
    constexpr std::uintmax_t sizeMax = 1 << 20;
    if (fs::file_size(path, error) > sizeMax || error || !document.load_file(path.c_str())) {
        return std::nullopt;
    }
    const pugi::xml_node top = document.child("ModelMetadata");
    const std::string system = top.child("SRS").text().as_string();
    const std::vector<double> numbers = numbersOf(wordsOf(top.child("SRSOrigin").text().as_string()));
    // About a place on the ellipsoid ("ENU:51.4,6.9") the axes are none of a projection.
    if (numbers.size() != 3 || system.starts_with("ENU")) {
        return std::nullopt;
    }
    return MeshOffset{Vec3(numbers[0], numbers[1], numbers[2]), path.string(), system};
}

struct Candidate {
    fs::path path;
    std::optional<MeshOffset> (*read)(const fs::path&);
};

/// Files of a folder whose names end so, in the order of their names.
void addEnding(std::vector<Candidate>& list, const fs::path& folder, std::string_view ending) {
    std::error_code ignored;
    std::vector<fs::path> found;
    for (fs::directory_iterator it(folder, ignored), end; it != end; it.increment(ignored)) {
        if (hasEnding(it->path().filename().string(), ending)) {
            found.push_back(it->path());
        }
    }
    std::sort(found.begin(), found.end());
    for (const fs::path& path : found) {
        list.push_back({path, threeNumbers});
    }
}

std::vector<Candidate> candidatesFor(const fs::path& mesh) {
    const fs::path folder = mesh.parent_path();
    const std::string stem = mesh.stem().string();
    std::vector<Candidate> list;
    for (const char* ending : {"_offset.xyz", "_offset.txt"}) {
        list.push_back({folder / (stem + ending), threeNumbers});
    }
    for (const char* name : {"offset.xyz", "offset.txt", "SHIFT.txt"}) {
        list.push_back({folder / name, threeNumbers});
    }
    for (const char* place : {".", "../params", "../../1_initial/params"}) {
        addEnding(list, (folder / place).lexically_normal(), "_offset.xyz");
    }
    for (const char* place : {".", "../odm_georeferencing", "odm_georeferencing"}) {
        for (const char* name : {"odm_georeferencing_model_geo.txt", "coords.txt"}) {
            list.push_back({(folder / place / name).lexically_normal(), systemAndTwoNumbers});
        }
    }
    for (const char* place : {"metadata.xml", "../metadata.xml"}) {
        list.push_back({(folder / place).lexically_normal(), metadata});
    }
    return list;
}

}  // namespace

OffsetSearch offsetBeside(const std::string& meshPath) {
    OffsetSearch search;
    for (const Candidate& candidate : candidatesFor(fs::absolute(meshPath))) {
        std::error_code ignored;
        if (!fs::is_regular_file(candidate.path, ignored)) {
            continue;
        }
        search.offset = candidate.read(candidate.path);
        if (search.offset) {
            return search;
        }
        if (search.unread.empty()) {
            search.unread = candidate.path.string();
        }
    }
    return search;
}

}  // namespace rubble::io
