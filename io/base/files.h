#pragma once

#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

namespace rubble::io {

/// SHA-256 of a file's content, lower-case hex. Throws WorldError.
/// @param advance  called after every block with its bytes; what it throws ends the reading
std::string sha256OfFile(const std::string& path, const std::function<void(std::size_t)>& advance = {});
/// SHA-256 of a text, lower-case hex.
std::string sha256OfText(std::string_view text);

/// Reason of an error number of the system, in English whatever the locale.
std::string systemReason(int error);
/// Throws the WorldError of a file that cannot be read, with the reason. @param error  of the system; 0: it is looked for
[[noreturn]] void failToRead(const std::string& path, int error = 0);
/// Throws the WorldError of a file that cannot be written.
[[noreturn]] void failToWrite(const std::string& path, const std::string& reason);

/// Writes a file so that it is either the old one or the whole new one: temporary file beside it, flush to disk, rename.
/// Throws WorldError naming the path and the remedy; nothing is left behind.
void writeAtomically(const std::string& path, const std::function<void(std::ostream&)>& write);

/// The same for a library that wants a path: `write` makes the file it is given, which does not exist yet and stands beside `path`.
void writeFileAtomically(const std::string& path, const std::function<void(const std::string&)>& write);

/// The whole content; nothing if there is no such file, or if it is larger than 4 GiB: nothing that is kept comes near that.
std::optional<std::string> contentOf(const std::string& path);

/// Makes a folder and those above it; one that is there stays. Throws WorldError naming it, the reason and the remedy.
void makeFolder(const std::string& path);
/// The folder that a file is to lie in.
void makeFolderOf(const std::string& path);

/// Writes a content atomically, and makes the folder that it lies in. Throws WorldError.
void writeIn(const std::string& path, std::string_view content);

/// A name beside a path that nobody else has, with the ending of what is not whole (".part").
std::string unfinishedName(const std::string& path);

/// Whether a path ends so, in capitals or not. @param ending  in small letters, with its point
bool hasEnding(std::string_view path, std::string_view ending);

/// Writes NAME.provenance.json beside an exported file.
void writeProvenance(const std::string& exportedPath, std::string_view text);

}  // namespace rubble::io
