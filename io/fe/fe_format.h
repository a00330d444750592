#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/execution.h"
#include "core/fe/fe_result.h"
#include "core/scenario/scenario.h"

namespace rubble::io {

/// What a format is recognised by: the beginning of a file, unpacked where the file is gzip-packed.
struct FileHead {
    std::string path;
    std::string bytes;                   ///< the first 4,096 bytes at most
    std::uint64_t size = 0;              ///< of the file as it lies there, bytes
    bool packed = false;                 ///< by gzip
    std::string hdf5Format;              ///< what an HDF5 file says of itself: the text `format` at its root; empty for others
    std::vector<std::string> hdf5Names;  ///< names of what an HDF5 file holds at its root, sorted; empty for other files
};

/// One row of the table of formats.
struct FeFormat {
    std::string_view name;     ///< "LS-DYNA d3plot"; stands in FeResult::Contents::format
    std::string_view endings;  ///< as people know its files: "d3plot, d3plot01, ..."
    std::uint32_t version;     ///< raised when the same files and settings give other contents than before

    /// Whether the content is of this format. Must not throw, whatever the bytes are.
    bool (*recognises)(const FileHead& head);
    /// All files of the series that a file belongs to, in their order; the first is the one to open. Never empty: a file that
    /// stands alone gives itself. By names alone or by an index file; must not throw. May be asked about any file whatsoever.
    std::vector<std::string> (*members)(const std::string& path);
    /// Reads mesh, times, activity and findings, and makes the source of nodal fields. `format`, `path`, `files`, `bytes`,
    /// `sha256` and `fingerprint` of what it gives are filled in by openFe(). @param path  the first of the members.
    /// Throws as openFe().
    FeResult::Contents (*read)(const std::string& path, const ImportSettings& settings, const Execution& execution);
    /// Whether a file holds a piece of each state, by its name or an index near it; nothing for formats without pieces. Must not
    /// throw.
    bool (*holdsPiece)(const std::string& path) = nullptr;
    /// The files that a file takes to be opened without the others of its series, its deck and list of deaths among them; nothing:
    /// its members, where files with other numbers are none. Must not throw.
    std::vector<std::string> (*alone)(const std::string& path) = nullptr;
};

/// All formats that can be read. The order is that of recognition, and of preference where a folder holds several.
std::span<const FeFormat> feFormats();

/// A format that is known by its content and not read, and what to do instead.
struct ForeignFormat {
    std::string_view name;
    bool (*recognises)(const FileHead& head);
    std::string_view remedy;
};

/// Formats that are out of scope, named so in the error.
std::span<const ForeignFormat> foreignFormats();

/// Whether a file begins as those of another container do, whatever the words behind that come to: HDF5, classic netCDF, zip, XML.
/// Formats without a beginning of their own must not take it for theirs.
bool hasOtherSignature(const FileHead& head);

/// Reads the beginning of a file. Throws WorldError where it cannot be read.
FileHead readHead(const std::string& path);

/// `members` of formats whose results are one file.
std::vector<std::string> standsAlone(const std::string& path);

}  // namespace rubble::io
