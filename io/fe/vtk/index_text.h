#pragma once

#include <pugixml.hpp>
#include <string>
#include <string_view>

namespace rubble::io {

/// The beginning of a file, 4,096 bytes at most; empty where it cannot be read.
std::string headOfFile(const std::string& path);
/// What a VTK XML file says that it holds, "Collection" or "UnstructuredGrid". @param head  its beginning; empty for other files
std::string vtkTypeOf(std::string_view head);
/// The whole text of an index. Throws ParseError for one that is too large.
std::string indexText(const std::string& path);
/// The same as XML. Throws ParseError naming the place.
pugi::xml_document indexXml(const std::string& path);
/// The file that an index names, see namedFile(). Throws ParseError for no name.
std::string namedByIndex(const std::string& index, const std::string& name);
/// Whether two paths name one file, however they are spelled.
bool sameFile(const std::string& a, const std::string& b);
[[noreturn]] void failIndex(const std::string& path, const std::string& why);
/// Throws WorldError that names index and file where a named file is not there.
void requireMember(const std::string& index, const std::string& path);

}  // namespace rubble::io
