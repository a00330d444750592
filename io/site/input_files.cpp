#include "io/site/input_files.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <pugixml.hpp>
#include <string_view>

#include "core/base/error.h"
#include "core/base/small_letters.h"
#include "io/base/files.h"
#include "io/fe/fe_reader.h"
#include "io/fe/meshes/ply_header.h"
#include "io/fe/meshes/raw_mesh_file.h"
#include "io/fe/series_digest.h"
#include "io/site/meshes/gltf_file.h"
#include "io/site/meshes/mesh_offset.h"

namespace rubble::io {

namespace fs = std::filesystem;

namespace {

/// Whether notes of GDAL hold more than what programs write that only show a raster.
bool saysMoreThanStatistics(const pugi::xml_node& notes) {
    const auto statistic = [](const pugi::xml_node& item) {
        return std::string_view(item.attribute("key").as_string()).starts_with("STATISTICS_");
    };
    return std::any_of(notes.begin(), notes.end(), [&](const pugi::xml_node& note) {
        const std::string_view name = note.name();
        if (name == "PAMRasterBand") {
            return saysMoreThanStatistics(note);
        }
        if (name == "Metadata" && std::string_view(note.attribute("domain").as_string()) != "Esri") {
            return !std::all_of(note.begin(), note.end(), statistic);
        }
        return name != "Histograms" && name != "CategoryNames" && name != "GDALRasterAttributeTable" && name != "Metadata";
    });
}

bool holdsStatisticsAlone(const fs::path& notes) {
    pugi::xml_document document;
    return document.load_file(notes.c_str()) && !saysMoreThanStatistics(document.child("PAMDataset"));
}

/// Notes of old programs; other files may end so as well.
bool isErdasFile(const fs::path& path) {
    constexpr std::string_view mark = "EHFA_HEADER_TAG";
    std::array<char, mark.size()> head{};
    std::ifstream(path, std::ios::binary).read(head.data(), head.size());
    return std::string_view(head.data(), head.size()) == mark;
}

/// What may lie beside a file of a kind: endings in small letters, in place of its own and behind its whole name.
struct EndingsBeside {
    std::vector<std::string> replaced;
    std::vector<std::string> added;
};

EndingsBeside endingsBesideRaster(const std::string& ending) {
    EndingsBeside beside{{".wld", ".prj", ".hdr", ".tab", ".ige", ".sgrd", ".aux"}, {".aux.xml", ".msk", ".hdr"}};
    if (ending.size() > 2) {
        // ".tif" has ".tfw" and ".tifw".
        beside.replaced.push_back({'.', ending[1], ending.back(), 'w'});
        beside.replaced.push_back(ending + "w");
    }
    return beside;
}

EndingsBeside endingsBeside(const std::string& path) {
    static constexpr std::array<std::string_view, 15> alone{".gltf", ".glb", ".stl", ".ply", ".gpkg", ".geojson", ".json", ".fgb",
                                                            ".kml",  ".dxf", ".las", ".laz", ".e57",  ".pcd",     ".ptx"};
    static constexpr std::array<std::string_view, 4> tables{".csv", ".txt", ".xyz", ".pts"};
    const std::string ending = inSmallLetters(fs::path(path).extension().string());
    if (ending == ".shp") {
        return {{".shx", ".dbf", ".cpg", ".prj"}, {}};
    }
    if (ending == ".obj") {
        return {{".mtl"}, {}};
    }
    if (std::find(tables.begin(), tables.end(), ending) != tables.end()) {
        return {{}, {".aux.xml"}};
    }
    return std::find(alone.begin(), alone.end(), ending) == alone.end() ? endingsBesideRaster(ending) : EndingsBeside();
}

/// Files of the folder of a file whose names are its own with one of these endings.
std::vector<fs::path> filesWithEndings(const std::string& path, const EndingsBeside& endings) {
    const std::string stem = fs::path(path).stem().string(), whole = fs::path(path).filename().string();
    const auto has = [](const std::string& name, const std::string& start, const std::vector<std::string>& list) {
        return name.starts_with(start) &&
               std::find(list.begin(), list.end(), inSmallLetters(name.substr(start.size()))) != list.end();
    };
    std::vector<fs::path> files;
    std::error_code ignored;
    for (fs::directory_iterator it(fs::absolute(path).parent_path(), ignored), end; it != end; it.increment(ignored)) {
        const std::string name = it->path().filename().string();
        if (name != whole && (has(name, stem, endings.replaced) || has(name, whole, endings.added)) &&
            it->is_regular_file(ignored)) {
            files.push_back(fs::path(path).parent_path() / name);
        }
    }
    return files;
}

bool countsInDigest(const fs::path& file) {
    const std::string name = inSmallLetters(file.filename().string());
    return name.ends_with(".aux.xml") ? !holdsStatisticsAlone(file) : !name.ends_with(".aux") || isErdasFile(file);
}

/// What a mesh is read from beside itself.
std::vector<fs::path> filesNamedByMesh(const std::string& path) {
    const bool gltf = hasEnding(path, ".gltf") || hasEnding(path, ".glb");
    if (!gltf && (!isMeshPath(path) || isPlyOfPoints(path))) {
        return {};
    }
    std::vector<fs::path> named;
    try {
        for (const std::string& buffer : gltf ? buffersOfGltf(path) : std::vector<std::string>()) {
            named.emplace_back(buffer);
        }
    } catch (const Error&) {
        // What is damaged is named by itself; its reader says why.
    }
    if (const OffsetSearch search = offsetBeside(path); search.offset) {
        named.emplace_back(search.offset->file);
    }
    return named;
}

/// Appends those that are there and none of the list yet, in the order of their names, wherever the input lies.
void appendByName(std::vector<std::string>& files, std::vector<fs::path> more) {
    const fs::path folder = fs::absolute(files.front()).lexically_normal().parent_path();
    const auto key = [&folder](const fs::path& file) {
        return std::pair(file.filename().string(),
                         fs::absolute(file).lexically_normal().lexically_relative(folder).generic_string());
    };
    std::sort(more.begin(), more.end(), [&key](const fs::path& a, const fs::path& b) { return key(a) < key(b); });
    for (const fs::path& file : more) {
        std::error_code gone;
        const bool known =
            std::any_of(files.begin(), files.end(), [&](const std::string& each) { return fs::equivalent(each, file, gone); });
        if (!known && fs::is_regular_file(file, gone)) {
            files.push_back(file.string());
        }
    }
}

}  // namespace

std::vector<std::string> filesOfInput(const std::string& path, InputRole role) {
    if (role == InputRole::Fe) {
        return feFiles(path);
    }
    std::vector<std::string> files{path};
    if (role != InputRole::Photograph) {
        std::vector<fs::path> more = filesWithEndings(path, endingsBeside(path));
        std::erase_if(more, [](const fs::path& file) { return !countsInDigest(file); });
        for (const fs::path& named : filesNamedByMesh(path)) {
            more.push_back(named);
        }
        appendByName(files, std::move(more));
    }
    return files;
}

std::vector<std::string> filesWithInput(const std::string& path, InputRole role) {
    std::vector<std::string> files = filesOfInput(path, role);
    if (role != InputRole::Fe && role != InputRole::Photograph) {
        EndingsBeside travelling{{".prj", ".rrd"}, {".ovr", ".aux.xml"}};
        if (hasEnding(path, ".csv")) {
            travelling.replaced.emplace_back(".csvt");
        }
        appendByName(files, filesWithEndings(path, travelling));
    }
    return files;
}

InputDigest digestOfInput(const std::string& path, InputRole role, const Execution& execution) {
    execution.check();
    if (role == InputRole::Fe) {
        const std::string sha256 = sha256OfFe(path, execution);
        return {sha256, sha256};
    }
    const std::vector<std::string> files = filesOfInput(path, role);
    std::vector<std::string> digests;
    for (const std::string& file : files) {
        digests.push_back(sha256OfFile(file, [&execution](std::size_t) { execution.check(); }));
    }
    return {sha256OfList(files, digests), digests.front()};
}

}  // namespace rubble::io
