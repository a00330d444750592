#include "io/fe/vtk/grid_index.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <sstream>

#include "core/base/error.h"
#include "io/fe/series/numbered_files.h"

namespace rubble::io {

namespace {

using Path = std::filesystem::path;

constexpr std::uintmax_t longestIndex = std::uintmax_t{64} << 20;

[[noreturn]] void failIndex(const std::string& path, const std::string& why) {
    throw ParseError({"vtk.index", "{0} is no index of a VTK series: {1}", {path, why}},
                     {"vtk.index.remedy", "Write it again, or give one of the series' own files.", {}});
}

std::string textOf(const std::string& path) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (!error && size > longestIndex) {
        failIndex(path, "it is larger than an index can be");
    }
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

// An entry names a file beside the index or below.
std::string besides(const std::string& index, const std::string& name) {
    if (name.empty()) {
        failIndex(index, "an entry names no file");
    }
    return (Path(index).parent_path() / name).string();
}

void requireMember(const std::string& index, const std::string& path) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) {
        throw WorldError({"vtk.member", "{0} names the file {1}, which is not there", {index, path}},
                         {"vtk.member.remedy", "Copy the whole series, or remove the entry.", {}});
    }
}

pugi::xml_document xmlOf(const std::string& path) {
    pugi::xml_document document;
    const std::string text = textOf(path);
    const auto result = document.load_buffer(text.data(), text.size());
    if (!result) {
        failIndex(path, std::string(result.description()) + " at byte " + std::to_string(result.offset));
    }
    return document;
}

std::vector<GridEntry> fromPvd(const std::string& path) {
    const pugi::xml_document document = xmlOf(path);
    std::map<double, GridEntry> byTime;
    for (const pugi::xml_node node : document.child("VTKFile").child("Collection").children("DataSet")) {
        const std::string text = node.attribute("timestep").as_string("0");
        double time = 0.0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), time);
        if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(time)) {
            failIndex(path, "the timestep \"" + text.substr(0, 40) + "\" is no number");
        }
        GridEntry& entry = byTime[time];
        entry.time = time;
        entry.files.push_back(besides(path, node.attribute("file").as_string()));
    }
    std::vector<GridEntry> entries;
    for (auto& [time, entry] : byTime) {
        entries.push_back(std::move(entry));
    }
    return entries;
}

std::vector<GridEntry> fromPieces(const std::string& path) {
    const pugi::xml_document document = xmlOf(path);
    GridEntry entry;
    for (const pugi::xml_node node : document.child("VTKFile").child("PUnstructuredGrid").children("Piece")) {
        entry.files.push_back(besides(path, node.attribute("Source").as_string()));
        requireMember(path, entry.files.back());
    }
    return {entry};
}

std::vector<GridEntry> fromSeries(const std::string& path) {
    std::vector<GridEntry> entries;
    try {
        const nlohmann::json json = nlohmann::json::parse(textOf(path));
        for (const nlohmann::json& file : json.at("files")) {
            entries.push_back({file.at("time").get<double>(), {besides(path, file.at("name").get<std::string>())}});
        }
    } catch (const nlohmann::json::exception& error) {
        failIndex(path, error.what());
    }
    std::stable_sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return *a.time < *b.time; });
    return entries;
}

std::string headOf(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string head(4096, '\0');
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(file.gcount()));
    return head;
}

bool isSeries(const std::string& head) {
    return head.find("\"file-series-version\"") != std::string::npos;
}

bool isCollection(const std::string& head) {
    return head.find("<VTKFile") != std::string::npos && head.find("type=\"Collection\"") != std::string::npos;
}

bool isIndex(const std::string& head) {
    return isSeries(head) || isCollection(head);
}

std::vector<GridEntry> entriesOf(const std::string& index, const std::string& head) {
    return isSeries(head) ? fromSeries(index) : fromPvd(index);
}

// Whether or not they are there.
std::vector<std::string> listed(const std::string& index, const std::string& head) {
    std::vector<std::string> files;
    for (const GridEntry& entry : entriesOf(index, head)) {
        files.insert(files.end(), entry.files.begin(), entry.files.end());
    }
    return files;
}

}  // namespace

std::vector<GridEntry> indexGrids(const std::string& path) {
    const std::string head = headOf(path);
    std::vector<GridEntry> entries;
    if (isIndex(head)) {
        entries = entriesOf(path, head);
    } else if (head.find("type=\"PUnstructuredGrid\"") != std::string::npos) {
        for (const std::string& sibling : numberedSiblings(path)) {
            entries.push_back(fromPieces(sibling).front());
        }
    } else if (head.starts_with("# vtk DataFile") || head.find("type=\"UnstructuredGrid\"") != std::string::npos) {
        for (const std::string& sibling : numberedSiblings(path)) {
            entries.push_back({std::nullopt, {sibling}});
        }
    } else {
        throw ParseError({"vtk.kind", "{0} is a VTK file, but no unstructured grid", {path}},
                         {"vtk.kind.remedy", "Write the result as an unstructured grid (.vtu) or a series of them (.pvd).", {}});
    }
    if (entries.empty() || entries.front().files.empty()) {
        failIndex(path, "it names no files");
    }
    for (const GridEntry& entry : entries) {
        for (const std::string& file : entry.files) {
            requireMember(path, file);
        }
    }
    return entries;
}

std::vector<std::string> numberedGrids(const std::string& path) {
    return isIndex(headOf(path)) ? std::vector<std::string>{} : numberedSiblings(path);
}

std::string canonicalIndex(const std::string& path) {
    try {
        const std::string head = headOf(path);
        const std::vector<std::string> own = isIndex(head) ? listed(path, head) : std::vector<std::string>{path};
        if (own.empty()) {
            return path;
        }
        std::vector<std::string> candidates;
        for (const std::string& other : filesBeside(path)) {
            if (other.ends_with(".pvd") || other.ends_with(".series")) {
                candidates.push_back(other);
            }
        }
        for (const std::string& candidate : candidates) {
            const std::string first = headOf(candidate);
            const std::vector<std::string> files = isIndex(first) ? listed(candidate, first) : std::vector<std::string>{};
            const bool lists = std::find(files.begin(), files.end(), own.front()) != files.end();
            if (isIndex(head) ? files == own : lists) {
                return candidate;
            }
        }
    } catch (const std::exception&) {
        // What cannot be read as an index stands for itself; opening it says why.
    }
    return path;
}

}  // namespace rubble::io
