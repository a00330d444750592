#pragma once

#include <cstdint>
#include <fstream>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "io/fe/vtk/stored_numbers.h"

namespace rubble::io {

/// A VTK XML file: its text, and the bytes of its arrays wherever they lie (in the text as numbers or base64, or appended behind it
/// raw or as base64; packed by zlib, LZ4 or LZMA, or as they are). Layout after the VTK file format specification. Nothing is taken
/// into memory that the file cannot hold. Not for several threads at once.
class XmlArrays {
public:
    /// Reads the text. Throws WorldError, ParseError.
    explicit XmlArrays(const std::string& path);

    const std::string& path() const { return m_path; }
    /// The element VTKFile.
    pugi::xml_node root() const { return m_document.child("VTKFile"); }

    /// All values of an array. Throws ParseError naming the array where it is cut off or is not what it says.
    std::vector<double> reals(pugi::xml_node array);
    std::vector<std::int64_t> integers(pugi::xml_node array);
    /// The texts of an array of strings.
    std::vector<std::string> texts(pugi::xml_node array);
    /// @param why  of the file or of one of its arrays, in words
    [[noreturn]] void fail(const std::string& why) const;

private:
    enum class Packing : std::uint8_t { None, Zlib, Lz4, Lzma };
    /// Bytes one after the other: in the file, or in base64.
    struct Stream {
        bool raw = false;
        std::uint64_t at = 0, end = 0;  ///< in the file; in `encoded`
        std::string_view encoded;
    };

    void readText();
    void findAppended(const std::string& head, std::size_t tag);
    void readSettings();
    NumberType typeOf(pugi::xml_node array) const;
    template <class T>
    std::vector<T> values(pugi::xml_node array);
    std::string bytesOf(pugi::xml_node array);
    Stream streamOf(pugi::xml_node array) const;
    std::string take(Stream& stream, std::uint64_t count, pugi::xml_node array);
    std::string packedBytes(Stream& stream, pugi::xml_node array);
    std::string unpacked(const std::string& block, std::uint64_t size, pugi::xml_node array) const;
    std::uint64_t most(std::uint64_t packed) const;
    [[noreturn]] void failArray(pugi::xml_node array, const std::string& why) const;

    std::string m_path;
    std::ifstream m_file;
    std::uint64_t m_size = 0;
    std::string m_text;
    pugi::xml_document m_document;
    bool m_hasAppended = false, m_raw = false;
    std::uint64_t m_appended = 0, m_appendedEnd = 0;  ///< in the file, behind the underscore
    std::string m_encoded;                            ///< what is appended as base64
    bool m_bigEndian = false;
    NumberType m_header{NumberType::Kind::Unsigned, 4};
    Packing m_packing = Packing::None;
};

}  // namespace rubble::io
