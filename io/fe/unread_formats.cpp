#include "io/fe/unread_formats.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "io/fe/series/byte_window.h"

namespace rubble::io {

namespace {

using namespace std::string_view_literals;

std::string_view viewOf(const FileHead& head) {
    return head.bytes;
}

// The first line that is not blank, without blanks around it.
std::string firstLine(const FileHead& head) {
    const std::size_t first = std::min(head.bytes.find_first_not_of(" \t\r\n"), head.bytes.size());
    return column(head.bytes.substr(first, head.bytes.find_first_of("\r\n", first) - first), 0, head.bytes.size());
}

bool isPlainText(const FileHead& head) {
    return std::all_of(head.bytes.begin(), head.bytes.end(),
                       [](char c) { return static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\r' || c == '\t'; });
}

bool hasLine(const FileHead& head, std::string_view line) {
    const std::string text = '\n' + head.bytes;
    return text.find('\n' + std::string(line)) != std::string::npos;
}

bool isOdb(const FileHead& head) {
    return viewOf(head).starts_with("HKSRD0"sv);
}

// The label of the tape stands behind the date.
bool isOp2(const FileHead& head) {
    return viewOf(head).substr(0, 256).find("NASTRAN FORT TAPE ID CODE") != std::string_view::npos;
}

bool isBulkData(const FileHead& head) {
    return isPlainText(head) &&
           (hasLine(head, "BEGIN BULK") || hasLine(head, "SOL ") || hasLine(head, "GRID,") || hasLine(head, "GRID  "));
}

bool isPunch(const FileHead& head) {
    return viewOf(head).starts_with("$TITLE   ="sv);
}

bool isGmsh(const FileHead& head) {
    return firstLine(head) == "$MeshFormat" || firstLine(head) == "$NOD" || firstLine(head) == "$Comments";
}

// The text that names the files, or one of them in binary.
bool isEnsight(const FileHead& head) {
    const std::string line = upperCase(firstLine(head));
    return (line.starts_with("FORMAT") && hasLine(head, "type:") && upperCase(head.bytes).find("ENSIGHT") != std::string::npos) ||
           (hasLine(head, "FORMAT") && upperCase(head.bytes.substr(0, 512)).find("ENSIGHT") != std::string::npos) ||
           viewOf(head).starts_with("C Binary"sv) || viewOf(head).starts_with("Fortran Binary"sv);
}

// Sections stand between lines that hold -1 alone, each with its number.
bool isUniversal(const FileHead& head) {
    std::string_view rest = head.bytes;
    if (!isPlainText(head) || firstLine(head) != "-1") {
        return false;
    }
    rest.remove_prefix(rest.find("-1") + 2);
    const std::size_t digit = rest.find_first_not_of(" \t\r\n");
    const std::string section = digit == std::string_view::npos ? "" : column(std::string(rest.substr(digit, 6)), 0, 6);
    std::int64_t number = 0;
    return toInteger(section.substr(0, section.find_first_of("\r\nbB ")), number) && number > 0;
}

bool isGid(const FileHead& head) {
    const std::string line = upperCase(firstLine(head));
    return line.starts_with("GID POST RESULTS FILE") || (line.starts_with("MESH ") && line.find("DIMENSION") != std::string::npos);
}

bool isLfsPointer(const FileHead& head) {
    return viewOf(head).starts_with("version https://git-lfs"sv);
}

bool isAnnexPointer(const FileHead& head) {
    return viewOf(head).starts_with("/annex/objects/"sv);
}

bool isArchive(const FileHead& head) {
    constexpr std::size_t tarMark = 257;
    const std::string_view bytes = head.bytes;
    return bytes.starts_with("PK\x03\x04"sv) || bytes.starts_with("PK\x05\x06"sv) || bytes.starts_with("7z\xbc\xaf\x27\x1c"sv) ||
           bytes.starts_with("Rar!\x1a\x07"sv) || bytes.starts_with("BZh"sv) || bytes.starts_with("\xfd\x37zXZ\0"sv) ||
           bytes.starts_with("\x28\xb5\x2f\xfd"sv) || (bytes.size() > tarMark && bytes.substr(tarMark).starts_with("ustar"sv));
}

bool isCgns(const FileHead& head) {
    return std::find(head.hdf5Names.begin(), head.hdf5Names.end(), "CGNSLibraryVersion") != head.hdf5Names.end() ||
           viewOf(head).starts_with("@(#)ADF Database"sv);
}

bool isHyperView(const FileHead& head) {
    return viewOf(head).substr(0, 64).find("Altair Binary") != std::string_view::npos;
}

bool isTecplot(const FileHead& head) {
    const std::string line = upperCase(firstLine(head));
    return viewOf(head).starts_with("#!TDV"sv) || viewOf(head).starts_with("#!SZPLT"sv) ||
           ((line.starts_with("TITLE") || line.starts_with("VARIABLES")) &&
            upperCase(head.bytes).find("\nZONE") != std::string::npos);
}

bool isSurface(const FileHead& head) {
    const std::string line = firstLine(head);
    return isPlainText(head) && (line.starts_with("solid ") || line == "ply" || line == "OFF" || hasLine(head, "v ")) &&
           (hasLine(head, "  facet") || hasLine(head, "facet") || line == "ply" || line == "OFF" || hasLine(head, "f ") ||
            hasLine(head, "vn "));
}

bool isWebPage(const FileHead& head) {
    const std::string line = upperCase(firstLine(head));
    return line.starts_with("<!DOCTYPE HTML") || line.starts_with("<HTML");
}

constexpr std::string_view asVtu =
    "Convert it to .vtu files with a .pvd, or to Exodus II, with the dead cells left out or flagged.";

constexpr std::array unread{
    ForeignFormat{"an output database of Abaqus (.odb)", isOdb,
                  "Let Abaqus write it as a results file: abaqus python odb_to_fil.py JOB.odb (in share/rubble of "
                  "the installation, resources/abaqus of the sources), then give JOB-rubble.fil."},
    ForeignFormat{"a result of Nastran (.op2)", isOp2, asVtu},
    ForeignFormat{"a punch file of Nastran", isPunch, asVtu},
    ForeignFormat{"an input deck of Nastran", isBulkData,
                  "Give the result of the analysis as .vtu, Exodus II or another format that is read."},
    ForeignFormat{"a mesh of Gmsh (.msh)", isGmsh, "Give the result of the analysis; Gmsh writes results as .vtk or .med."},
    ForeignFormat{"a result in EnSight format", isEnsight, asVtu},
    ForeignFormat{"a universal file (.unv)", isUniversal, asVtu},
    ForeignFormat{"a result of GiD", isGid, asVtu},
    ForeignFormat{"a result in CGNS", isCgns, asVtu},
    ForeignFormat{"a result of HyperView (.h3d)", isHyperView,
                  "Give the result of the solver itself: d3plot, the animation files of OpenRadioss, or the .odb as .fil."},
    ForeignFormat{"a file of Tecplot", isTecplot, asVtu},
    ForeignFormat{"a surface mesh", isSurface, "Give the result of an FE analysis; surroundings are added to the case as meshes."},
    ForeignFormat{"a pointer of Git LFS, not the file itself", isLfsPointer, "Fetch the file: git lfs pull."},
    ForeignFormat{"a pointer of git-annex, not the file itself", isAnnexPointer, "Fetch the file: git annex get."},
    ForeignFormat{"an archive or a compressed file", isArchive, "Unpack it, then give the result in it."},
    ForeignFormat{"a web page", isWebPage, "The download was not the file: log in or follow the link to the file itself."},
};

}  // namespace

std::span<const ForeignFormat> unreadFormats() {
    return unread;
}

}  // namespace rubble::io
