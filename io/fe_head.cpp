#include <hdf5.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "io/exodus/trial.h"
#include "io/fe_format.h"
#include "io/native_lock.h"

namespace rubble::io {

namespace {

constexpr std::size_t headSize = 4096;
constexpr std::size_t mostNames = 64;

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

// In a child that must not lock: it inherits the lock of its parent, who is another owner to it.
std::vector<Argument> rootNames(const std::string& path) {
    std::vector<Argument> names;
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    if (file >= 0) {
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
std::vector<std::string> hdf5NamesOf(const std::string& path) {
    std::vector<std::string> names;
    try {
        const std::scoped_lock lock(nativeLibraries());
        survivesTrial([&] { throw ParseError({"fe.names", "", rootNames(path)}, {}); });
    } catch (const ParseError& answer) {
        for (const Argument& name : answer.message().arguments) {
            names.push_back(std::get<std::string>(name.value));
        }
    } catch (const std::exception&) {
        // A file that cannot be looked into has no names.
    }
    return names;
}

}  // namespace

FileHead readHead(const std::string& path) {
    using namespace std::string_view_literals;
    const Message remedy{"fe.unreadable.remedy", "Check the path and that you may read the file.", {}};
    std::error_code error;
    if (!std::filesystem::exists(path, error)) {
        throw WorldError({"fe.missing", "There is no file {0}", {path}}, remedy);
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
    } else if (head.bytes.starts_with("\x89HDF\r\n\x1a\n"sv)) {
        head.hdf5Names = hdf5NamesOf(path);
    }
    return head;
}

}  // namespace rubble::io
