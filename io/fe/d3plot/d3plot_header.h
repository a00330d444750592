#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/fe/d3plot/d3plot_family.h"

namespace rubble::io {

struct FileHead;

/// Where the deletion of elements stands in a family (option MDLOPT of the control block).
enum class DeletionTable : std::uint8_t {
    None,     ///< nowhere: elements whose stress has become zero are dead
    Nodes,    ///< a word a node: elements whose nodes are all gone are dead
    Elements  ///< a word an element: zero is dead
};

/// The control block of a d3plot file: counts as they stand in the file, none negative. A word of a state means a real.
struct D3plotHeader {
    std::string title;
    std::int64_t words = 64;  ///< of the control block with its extension
    std::int64_t fileType = 1;
    std::int64_t dimension = 4;  ///< word NDIM
    std::int64_t nodes = 0;
    std::int64_t globals = 0;
    std::int64_t thermal = 0;      ///< word IT
    std::int64_t coordinates = 1;  ///< word IU: 0 none, 1 current places, 2 displacements
    bool velocities = false, accelerations = false;
    std::int64_t solids = 0, thickShells = 0, beams = 0, shells = 0, particles = 0;
    bool tenNodes = false;  ///< solids have two more nodes
    std::int64_t solidWords = 0, thickShellWords = 0, beamWords = 0, shellWords = 0;
    std::int64_t solidExtra = 0, shellExtra = 0;  ///< history variables of a solid, of a point of a shell
    std::int64_t points = 0;                      ///< through the thickness
    DeletionTable deletion = DeletionTable::None;
    std::int64_t idWords = 0;
    std::array<bool, 4> shellOutput{};  ///< stress, plastic strain, resultants, thickness and energy
    std::int64_t fluidMaterials = 0, adapted = 0, parts = 0, airbags = 0, eightNodeShells = 0, derivatives = 0;
    std::int64_t twentyNodeSolids = 0, solidThermal = 0;
    std::int64_t penetration = 0;
    bool contactEnergy = false, kineticEnergy = false;
    bool discreteSpheres = false;  ///< there are discrete elements, which are not read
    bool wideIds = false;          ///< user's numbers of 8 bytes

    bool hasMaterialTypes() const { return dimension == 5 || dimension == 7; }
    bool hasRoad() const { return dimension == 6 || dimension == 7; }
};

/// Whether these are the first bytes of a d3plot root, or of a relative of one that is named in the error. See FeFormat.
bool recognisesD3plot(const FileHead& head);

/// Word size and byte order of a root; nothing if it is no d3plot.
std::optional<WordFormat> d3plotWordFormat(const FileHead& head);

/// Reads and checks the control block. Throws ParseError for kinds and options that are not read, by name.
D3plotHeader readD3plotHeader(const D3plotFamily& family);

}  // namespace rubble::io
