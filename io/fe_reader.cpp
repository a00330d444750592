#include "io/fe_reader.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "io/exodus/exodus_reader.h"

namespace rubble::io {

namespace {

std::string readHead(const std::string& path) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    const Message remedy{"fe.unreadable.remedy", "Check the path and that you may read the file.", {}};
    if (!std::filesystem::exists(status)) {
        throw WorldError({"fe.missing", "There is no file {0}", {path}}, remedy);
    }
    if (std::filesystem::is_directory(status)) {
        throw WorldError({"fe.folder", "{0} is a folder", {path}}, {"fe.folder.remedy", "Give the result file inside it.", {}});
    }
    std::ifstream file(path, std::ios::binary);
    std::array<char, 64> head{};
    if (!file || (!file.read(head.data(), head.size()) && file.bad())) {
        throw WorldError({"fe.unreadable", "{0} cannot be read", {path}}, remedy);
    }
    return {head.data(), static_cast<std::size_t>(file.gcount())};
}

// What a user may have given instead, said in words.
std::string kindOf(const std::string& head) {
    bool text = true;
    for (const char c : head) {
        text &= static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\r' || c == '\t';
    }
    if (!text) {
        return "a binary file of another format";
    }
    if (head.find_first_not_of(" \t\r\n") != std::string::npos && head[head.find_first_not_of(" \t\r\n")] == '{') {
        return "a JSON text, perhaps a case";
    }
    if (head.starts_with("# vtk DataFile")) {
        return "a VTK legacy file";
    }
    if (head.starts_with("<?xml") || head.starts_with("<VTKFile")) {
        return "an XML text";
    }
    return "a text";
}

}  // namespace

std::shared_ptr<const FeResult> openFe(const std::string& path, const ImportSettings& settings, const Frame& frame,
                                       const Execution& execution) {
    const std::string head = readHead(path);
    if (head.empty()) {
        throw ParseError({"fe.empty", "{0} is empty", {path}},
                         {"fe.empty.remedy", "Wait until the analysis has written it, or copy it again.", {}});
    }
    if (looksLikeExodus(head)) {
        return openExodus(path, settings, frame, execution);
    }
    throw ParseError({"fe.unknown_format", "{0} is no FE result that can be read: it is {1}", {path, kindOf(head)}},
                     {"fe.unknown_format.remedy", "Give an Exodus II file (.exo, .e, .ex2, netCDF or netCDF-4).", {}});
}

}  // namespace rubble::io
