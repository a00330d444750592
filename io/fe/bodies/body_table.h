#pragma once

#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/fe/loose_bodies.h"
#include "io/base/delimited_table.h"

namespace rubble::io {

/// A table of bodies, in SI, in its own axes with z up.
struct BodyTable {
    std::vector<LooseBody> bodies;
    std::vector<MeasuredEnd> measured;  ///< [bodies]
    std::vector<std::size_t> lines;     ///< [bodies] of the file
    bool turned = false;                ///< it has orientations
    bool spins = false;                 ///< it has spins
    Findings findings;
};

/// A table with names for its columns, before anything is understood of it.
struct NamedColumns {
    std::string path;
    DelimitedTable table;            ///< rows without the heading
    std::vector<std::string> names;  ///< of its columns, as bodyTableOf() knows them
    /// What stands in every row: name and text.
    std::vector<std::pair<std::string, std::string>> constants;
};

/// Whether a heading is that of a table of bodies: it names a mass, and a side or a mesh.
bool isBodyHeading(const std::string& line);

/// Reads bodies from a table. Columns are named QUANTITY_UNIT: id, mass, side_x .. side_z, mesh, x .. z, vx .. vz, wx_world or
/// wx_body and so on, qw .. qz or roll, pitch and yaw, material, time. What is not there and assumed (at rest, without spin, along
/// the axes, material by density) and columns that nobody knows are counted findings. Throws ParseError naming file, line and
/// remedy: a quantity without unit or with an unknown one, spin without its frame or in both, a column that is missing, stands
/// twice or holds no number, a mass or side that is not positive, an orientation that is none, an unknown material, an id that
/// stands twice, no shape, no bodies; and as BodyMeshes.
BodyTable bodyTableOf(const NamedColumns& columns);

/// The same of a file. Throws WorldError if it cannot be read.
BodyTable readBodyTable(const std::string& path);

}  // namespace rubble::io
