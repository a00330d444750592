#include <hdf5.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "core/base/error.h"
#include "io/base/hdf5_extent.h"
#include "io/base/native_lock.h"
#include "io/base/trial.h"
#include "io/fe/fe_format.h"

namespace rubble::io {

namespace {

using namespace std::string_view_literals;

constexpr std::size_t headSize = 4096;
constexpr std::size_t mostNames = 64;
constexpr std::size_t longestFormat = 64;

// The beginning of a gzip-packed file, unpacked; empty if it is none after all.
std::string unpackedHead(const std::string& path) {
    std::string bytes(headSize, '\0');
    const gzFile file = gzopen(path.c_str(), "rb");
    if (!file) {
        return {};
    }
    const int got = gzread(file, bytes.data(), static_cast<unsigned>(bytes.size()));
    gzclose(file);
    bytes.resize(static_cast<std::size_t>(std::max(got, 0)));
    return bytes;
}

// A short text of fixed length, as our own files have it.
std::string rootFormat(hid_t file) {
    std::string text;
    const hid_t attribute = H5Aexists(file, "format") > 0 ? H5Aopen(file, "format", H5P_DEFAULT) : H5I_INVALID_HID;
    const hid_t type = attribute >= 0 ? H5Aget_type(attribute) : H5I_INVALID_HID;
    const hid_t space = attribute >= 0 ? H5Aget_space(attribute) : H5I_INVALID_HID;
    const bool fixed = type >= 0 && H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0;
    if (fixed && H5Sget_simple_extent_npoints(space) == 1 && H5Tget_size(type) <= longestFormat) {
        text.resize(H5Tget_size(type));
        text = H5Aread(attribute, type, text.data()) >= 0 ? std::string(text.c_str()) : "";
    }
    return text;
}

// In a child that must not lock: it inherits the lock of its parent, who is another owner to it. The format comes first.
std::vector<Argument> rootNames(const std::string& path) {
    std::vector<Argument> names;
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    if (file >= 0) {
        names.emplace_back(rootFormat(file));
        const auto collect = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
            auto& found = *static_cast<std::vector<Argument>*>(list);
            found.emplace_back(name);
            return found.size() >= mostNames ? 1 : 0;
        };
        H5Literate(file, H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &names);
    }
    return names;
}

// In a child process: the packaged HDF5 can crash on a damaged file. The names come back as the arguments of an error.
void lookIntoHdf5(FileHead& head) {
    const std::string& path = head.path;
    const auto names = [&]() -> std::vector<std::string> {
        std::vector<std::string> found;
        try {
            survivesTrial([&] { throw ParseError({"fe.names", "", rootNames(path)}, {}); });
        } catch (const ParseError& answer) {
            for (const Argument& name : answer.message().arguments) {
                found.push_back(std::get<std::string>(name.value));
            }
        } catch (const std::exception&) {
            // A file that cannot be looked into has no names.
        }
        return found;
    };
    const std::scoped_lock lock(nativeLibraries());
    static TriedFiles<std::vector<std::string>> tried;
    head.hdf5Names = tried.of(path, names);
    if (!head.hdf5Names.empty()) {
        head.hdf5Format = head.hdf5Names.front();
        head.hdf5Names.erase(head.hdf5Names.begin());
    }
}

}  // namespace

bool hasOtherSignature(const FileHead& head) {
    constexpr std::array signatures{hdf5Signature, "CDF\x01"sv, "CDF\x02"sv, "CDF\x05"sv, "PK\x03\x04"sv, "<?xml"sv};
    return std::any_of(signatures.begin(), signatures.end(),
                       [&](std::string_view signature) { return head.bytes.starts_with(signature); });
}

FileHead readHead(const std::string& path) {
    const Message remedy{"fe.unreadable.remedy", "Check the path and that you may read the file.", {}};
    std::error_code error;
    if (!std::filesystem::exists(path, error)) {
        throw WorldError({"fe.missing", "There is no file {0}", {path}}, remedy);
    }
    // Opening a pipe would wait for somebody to write into it.
    if (!std::filesystem::is_regular_file(path, error)) {
        throw WorldError({"fe.no_file", "{0} is no regular file", {path}},
                         {"fe.no_file.remedy", "Give a file or a folder; pipes and devices hold no result.", {}});
    }
    FileHead head;
    head.path = path;
    std::ifstream file(path, std::ios::binary);
    head.bytes.resize(headSize);
    if (!file || (!file.read(head.bytes.data(), static_cast<std::streamsize>(headSize)) && file.bad())) {
        throw WorldError({"fe.unreadable", "{0} cannot be read", {path}}, remedy);
    }
    head.bytes.resize(static_cast<std::size_t>(file.gcount()));
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    head.size = error ? head.bytes.size() : size;
    if (head.bytes.starts_with("\x1f\x8b"sv)) {
        if (std::string unpacked = unpackedHead(path); !unpacked.empty()) {
            head.bytes = std::move(unpacked);
            head.packed = true;
        }
    } else if (head.bytes.starts_with(hdf5Signature)) {
        lookIntoHdf5(head);
    }
    return head;
}

}  // namespace rubble::io
