#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/fe/vtk/stored_numbers.h"
#include "io/site/clouds/cloud_block.h"
#include "io/site/clouds/cloud_head.h"

namespace rubble::io {

/// What a column of a PLY, a PCD or a table holds.
enum class ColumnRole : std::uint8_t {
    Unread,
    X,
    Y,
    Z,
    Intensity,
    Red,
    Green,
    Blue,
    PackedColour,  ///< 0xRRGGBB in one number
    Class,
    Return,
    Returns,
    Time
};

/// The role of a column by the names that programs give it, in capitals or not.
ColumnRole columnRole(std::string_view name);

/// What the heading of a column says, which may name a unit behind a coordinate: "Easting (m)", "x_ft", "Northing [US ft]".
struct ColumnHeading {
    ColumnRole role = ColumnRole::Unread;
    std::string unit = {};                        ///< as it is written; empty: none is named
    std::optional<double> metres = std::nullopt;  ///< in it
};
/// @param path  of the table. Throws ParseError: what stands in brackets behind a coordinate is no unit that is known.
ColumnHeading columnHeading(const std::string& path, std::string_view heading);

/// The columns of a file in their order, and how their numbers become points.
class ColumnPlan {
public:
    void add(ColumnRole role, std::string_view name);
    std::size_t size() const { return m_roles.size(); }
    ColumnRole role(std::size_t column) const { return m_roles[column]; }
    bool has(ColumnRole role) const;
    bool hasPlaces() const { return has(ColumnRole::X) && has(ColumnRole::Y) && has(ColumnRole::Z); }
    /// Says in the head which columns are there and which are not read.
    void describe(CloudHead& head) const;
    /// Puts a number into point i of a block. @param fullColour  what the file has for full brightness
    static void put(CloudBlock& block, std::size_t i, ColumnRole role, double number, double colourScale);

private:
    std::vector<ColumnRole> m_roles;
    std::vector<std::string> m_unread;
};

/// A number as it lies in bytes.
double numberAt(const unsigned char* bytes, NumberType type, bool bigEndian);

/// How finely places of single precision are told apart, at the largest coordinate of a block.
double stepOfBlock(const CloudBlock& block);

}  // namespace rubble::io
