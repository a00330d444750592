#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/seal/zip_container.h"

namespace rubble::io {

/// Names of the files of a bag (BagIt 1.0, RFC 8493), below its folder.
namespace bag {
inline constexpr const char* declaration = "bagit.txt";
inline constexpr const char* about = "bag-info.txt";
inline constexpr const char* manifest = "manifest-sha256.txt";
inline constexpr const char* tagManifest = "tagmanifest-sha256.txt";
inline constexpr const char* readme = "README.txt";
inline constexpr const char* statement = "seal/seal.json";
inline constexpr const char* signature = "seal/seal.sig";
inline constexpr const char* publicKey = "seal/public-key.pem";
inline constexpr const char* certificates = "seal/signer.pem";
inline constexpr const char* stampRequest = "seal/seal.tsq";
inline constexpr const char* stampAnswer = "seal/seal.tsr";
inline constexpr const char* payload = "data/";
inline constexpr const char* records = "records/";
}  // namespace bag

/// A file's place in the bag and its SHA-256 in hex.
using Manifest = std::map<std::string, std::string>;

/// As sha256sum writes it.
std::string manifestText(const Manifest& manifest);
/// Nothing if a line is none of a manifest, or a place stands twice.
std::optional<Manifest> manifestOf(const std::string& text);

/// bagit.txt of this version.
std::string bagDeclaration();

/// Whether a place lies within the bag, in names that every system takes and sha256sum writes as they are.
bool isBagPlace(const std::string& place);
/// A name of a file with what is not taken in a place replaced.
std::string bagName(const std::string& name);

/// A bag in its container, opened for reading.
class PackedBag {
public:
    /// Throws WorldError, ParseError (no container, cut short, no bag in one folder).
    explicit PackedBag(const std::string& path);

    const std::string& path() const { return m_zip.path(); }
    const std::string& folder() const { return m_folder; }  ///< that holds the bag, with its slash
    /// All entries in the order of the container; their names begin with the folder unless somebody put others in.
    const std::vector<ZipReader::Entry>& entries() const { return m_zip.entries(); }
    /// Place of an entry in the bag; empty: outside of its folder.
    std::string placeOf(const ZipReader::Entry& entry) const;
    /// Null: there is none.
    const ZipReader::Entry* find(const std::string& place) const;
    /// The text of a tag file; nothing if there is none. Throws ParseError if it is damaged.
    std::optional<std::string> text(const std::string& place);
    ZipReader& zip() { return m_zip; }

private:
    ZipReader m_zip;
    std::string m_folder;
    std::map<std::string, std::size_t> m_places;
};

}  // namespace rubble::io
