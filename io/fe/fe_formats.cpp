#include <array>

#include "io/fe/abaqus/fil_reader.h"
#include "io/fe/ansys/cdb_reader.h"
#include "io/fe/ansys/rst_reader.h"
#include "io/fe/bodies/bodies_reader.h"
#include "io/fe/bodies/body_meshes.h"
#include "io/fe/calculix/frd_reader.h"
#include "io/fe/d3plot/d3plot_header.h"
#include "io/fe/d3plot/d3plot_reader.h"
#include "io/fe/exodus/exodus_reader.h"
#include "io/fe/fe_copy/copy_reader.h"
#include "io/fe/fe_format.h"
#include "io/fe/marc/marc_reader.h"
#include "io/fe/med/med_reader.h"
#include "io/fe/opensees/mpco_reader.h"
#include "io/fe/radioss/anim_reader.h"
#include "io/fe/series/byte_window.h"
#include "io/fe/unread_formats.h"
#include "io/fe/vtk/vtk_reader.h"
#include "io/fe/vtk/vtkhdf_reader.h"
#include "io/fe/xdmf/xdmf_reader.h"

namespace rubble::io {

namespace {

// The collapse recorder writes lines "<time> Elem <tag>" and "<time> Node <tag>".
bool recognisesCollapseLog(const FileHead& head) {
    const std::string line = head.bytes.substr(0, head.bytes.find('\n'));
    const std::size_t word = line.find_first_not_of("0123456789.+-eE ");
    return word != std::string::npos && word > 0 &&
           (line.substr(word).starts_with("lem ") || line.substr(word).starts_with("Node ")) &&
           line.find_first_of("0123456789") == 0;
}

// Of Abaqus, CalculiX, LS-DYNA or OpenRadioss: text that begins with a keyword or a comment of theirs.
bool recognisesDeck(const FileHead& head) {
    const std::string line = upperCase(head.bytes.substr(0, head.bytes.find_first_of("\r\n")));
    return line.starts_with("**") || line.starts_with("*HEADING") || line.starts_with("*KEYWORD") || line.starts_with("*NODE") ||
           line.starts_with("*INCLUDE") || line.starts_with("#RADIOSS") || line.starts_with("/VERS/") || line.starts_with("/RUN/");
}

// Records of Fortran: a title of 84 bytes, then one of 80 that names the program.
bool recognisesTimeHistory(const FileHead& head) {
    using namespace std::string_view_literals;
    constexpr std::size_t behindTitle = 4 + 84;
    const std::string_view bytes = head.bytes;
    return bytes.size() > behindTitle && bytes.starts_with("\0\0\0\x54"sv) &&
           bytes.substr(behindTitle).starts_with("\0\0\0\x54"sv) && bytes.find("RADIOSS") != std::string_view::npos;
}

// Of OpenRadioss or CalculiX.
bool recognisesListing(const FileHead& head) {
    const auto begins = [&head](std::size_t within, std::string_view words) {
        return std::string_view(head.bytes).substr(0, within).find(words) != std::string_view::npos;
    };
    return (begins(1024, "OpenRadioss") && (begins(1024, "Starter") || begins(1024, "Engine"))) ||
           begins(64, "SUMMARY OF JOB INFORMATION") || (begins(256, " for set ") && begins(256, " and time "));
}

bool recognisesMacro(const FileHead& head) {
    const std::string text = '\n' + upperCase(head.bytes);
    return text.find("\nEKILL,") != std::string::npos || text.find("\nEALIVE,") != std::string::npos;
}

// A row a format. Files of HDF5 that nobody else claims are taken for Exodus II, whose reader says what they lack.
constexpr std::array formats{
    FeFormat{"OpenRadioss animation", "RUNA001, RUNA002, ..., also .gz", 1, recognisesAnim, animMembers, readAnim, nullptr,
             animFilesAlone},
    FeFormat{"OpenRadioss animation converted to VTK", "RUN_001.vtk, ...", 1, recognisesConvertedAnim, convertedAnimMembers,
             readConvertedAnim, nullptr, convertedAnimFilesAlone},
    FeFormat{"LS-DYNA d3plot", "d3plot, d3plot01, ...", 1, recognisesD3plot, d3plotFiles, readD3plot},
    FeFormat{"VTK XML", ".vtu, .pvtu, .vtm, .pvd, .vtu.series", 3, recognisesVtkXml, vtkMembers, readVtk, isVtkPiece,
             vtkFilesAlone},
    FeFormat{"VTK legacy", ".vtk, .vtk.series", 3, recognisesVtkLegacy, vtkMembers, readVtk, isVtkPiece, vtkFilesAlone},
    FeFormat{"Abaqus results file", ".fil with its .inp", 2, recognisesFil, filMembers, readFil},
    FeFormat{"CalculiX results", ".frd with its .inp", 2, recognisesFrd, frdMembers, readFrd},
    FeFormat{"MSC Marc post file", ".t19", 2, recognisesMarc, aloneWithDeathList, readMarc},
    FeFormat{"Ansys coded database", ".cdb, with its .mac", 2, recognisesCdb, cdbMembers, readCdbs, nullptr, cdbFilesAlone},
    FeFormat{"Ansys results", ".rst with a list of deaths", 2, recognisesRst, rstMembers, readRst, isRstPiece, aloneWithDeathList},
    FeFormat{"XDMF", ".xdmf, .xmf", 3, recognisesXdmf, xdmfMembers, readXdmf},
    FeFormat{"Table of bodies", ".csv", 1, recognisesBodies, filesOfBodies, readBodies},
    FeFormat{"Rubble copy", ".h5, made by rubble-cli convert", 1, recognisesFeCopy, standsAlone, readFeCopy},
    FeFormat{"VTKHDF", ".vtkhdf, .hdf", 3, recognisesVtkHdf, aloneWithDeathList, readVtkHdf},
    FeFormat{"MED", ".med, .rmed of Salome and code_aster", 1, recognisesMed, aloneWithDeathList, readMed},
    FeFormat{"OpenSees MPCO", ".mpco, .part-0.mpco, ...", 2, recognisesMpco, mpcoMembers, readMpco, isMpcoPiece,
             aloneWithDeathList},
    FeFormat{"Exodus II", ".exo, .e, .e-s0002, .ex2", 2, recognisesExodus, exodusMembers, readExodus, isExodusPiece,
             aloneWithDeathList},
};

constexpr std::array outOfScope{
    ForeignFormat{"an input deck", recognisesDeck,
                  "Give the result that the analysis has written from it; a deck that lies beside the result is read with it."},
    ForeignFormat{"a time history of OpenRadioss", recognisesTimeHistory,
                  "Give the animation files of the run (RUNA001, RUNA002, ...): curves over time have no mesh."},
    ForeignFormat{"a listing that the analysis has printed", recognisesListing,
                  "Give the result that lies beside it: the animation files of OpenRadioss, the .frd of CalculiX."},
    ForeignFormat{"a macro of Ansys that kills elements", recognisesMacro,
                  "Give the .cdb with the mesh; a macro of the same name beside it is read with it."},
    ForeignFormat{
        "a collapse log of OpenSees", recognisesCollapseLog,
        "It says which elements were removed and when, but has no mesh: record the analysis with \"recorder mpco\", \"recorder "
        "vtkhdf\" or \"recorder pvd\" as well and give that file."},
};

}  // namespace

std::span<const FeFormat> feFormats() {
    return formats;
}

std::span<const ForeignFormat> foreignFormats() {
    static const std::vector<ForeignFormat> all = [] {
        std::vector<ForeignFormat> list(outOfScope.begin(), outOfScope.end());
        list.insert(list.end(), unreadFormats().begin(), unreadFormats().end());
        return list;
    }();
    return all;
}

std::vector<std::string> standsAlone(const std::string& path) {
    return {path};
}

}  // namespace rubble::io
