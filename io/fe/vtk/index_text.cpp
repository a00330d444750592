#include "io/fe/vtk/index_text.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/base/error.h"
#include "io/fe/series/numbered_files.h"

namespace rubble::io {

namespace {

using Path = std::filesystem::path;

constexpr std::uintmax_t longestIndex = std::uintmax_t{64} << 20;

bool isFile(const Path& path) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(path, ignored);
}

}  // namespace

void failIndex(const std::string& path, const std::string& why) {
    throw ParseError({"vtk.index", "{0} is no index of a VTK series: {1}", {path, why}},
                     {"vtk.index.remedy", "Write it again, or give one of the series' own files.", {}});
}

void requireMember(const std::string& index, const std::string& path) {
    if (!isFile(path)) {
        throw WorldError({"vtk.member", "{0} names the file {1}, which is not there", {index, path}},
                         {"vtk.member.remedy", "Copy the whole series, or remove the entry.", {}});
    }
}

std::string headOfFile(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string head(4096, '\0');
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(file.gcount()));
    return head;
}

std::string vtkTypeOf(std::string_view head) {
    const std::size_t begin = head.find("<VTKFile");
    if (begin == std::string_view::npos) {
        return {};
    }
    const std::string_view tag = head.substr(begin, head.find('>', begin) - begin);
    for (std::size_t at = tag.find("type"); at != std::string_view::npos; at = tag.find("type", at + 1)) {
        const std::size_t quote = tag.find_first_not_of(" =\t\r\n", at + 4);
        const bool own = at > 0 && std::string_view(" \t\r\n").find(tag[at - 1]) != std::string_view::npos;
        if (own && quote != std::string_view::npos && (tag[quote] == '"' || tag[quote] == '\'')) {
            const std::size_t end = tag.find(tag[quote], quote + 1);
            return std::string(tag.substr(quote + 1, end == std::string_view::npos ? end : end - quote - 1));
        }
    }
    return {};
}

std::string indexText(const std::string& path) {
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

pugi::xml_document indexXml(const std::string& path) {
    pugi::xml_document document;
    const std::string text = indexText(path);
    const auto result = document.load_buffer(text.data(), text.size());
    if (!result) {
        failIndex(path, std::string(result.description()) + " at byte " + std::to_string(result.offset));
    }
    return document;
}

bool sameFile(const std::string& a, const std::string& b) {
    std::error_code ignored;
    return Path(a).filename() == Path(b).filename() &&
           std::filesystem::absolute(a, ignored).lexically_normal() == std::filesystem::absolute(b, ignored).lexically_normal();
}

std::string namedByIndex(const std::string& index, const std::string& name) {
    if (name.empty()) {
        failIndex(index, "an entry names no file");
    }
    return namedFile(index, name);
}

}  // namespace rubble::io
