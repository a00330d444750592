#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "io/json/json_cursor.h"

namespace rubble::io {

/// The document of a glTF 2.0 and the numbers of its accessors.
class GltfFile {
public:
    /// Throws WorldError, ParseError (no glTF 2.0, a buffer that is missing or too short).
    explicit GltfFile(const std::string& path);
    ~GltfFile();
    GltfFile(const GltfFile&) = delete;
    GltfFile& operator=(const GltfFile&) = delete;

    JsonCursor top() const;
    /// An entry of a list of the document ("meshes", "nodes"). Throws ParseError if there is none.
    /// @param index  a number that names it
    JsonCursor entry(std::string_view list, const JsonCursor& index) const;

    struct Numbers {
        std::vector<double> values;  ///< [count * width], normalised ones as fractions
        std::size_t width = 1;
        bool single = false;  ///< they are kept in single precision
    };
    /// The numbers of an accessor, those that a sparse one replaces included.
    Numbers numbers(const JsonCursor& index) const;

private:
    std::string_view view(const JsonCursor& index) const;
    std::vector<double> stored(const JsonCursor& accessor, const JsonCursor& place, std::size_t width, std::size_t count) const;
    void replaceSparse(const JsonCursor& accessor, Numbers& numbers, std::size_t count) const;
    void readBuffers(const std::string& path, std::string binary);

    std::string m_path;
    std::unique_ptr<nlohmann::json> m_document;
    std::vector<std::string> m_buffers;
};

/// Files of their own that the buffers of a glTF lie in, as it names them; they are not looked at.
/// Throws WorldError, ParseError (no glTF).
std::vector<std::string> buffersOfGltf(const std::string& path);

}  // namespace rubble::io
