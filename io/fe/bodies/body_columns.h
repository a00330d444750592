#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rubble::io {

/// What a column of a table of bodies can hold.
enum class Quantity { Text, Length, Mass, Speed, Spin, Angle, Time, Number };

/// A column by its name without unit: "side_x".
struct TableColumn {
    std::string_view name;
    Quantity quantity;
};
std::span<const TableColumn> bodyColumns();

/// Units of a quantity as they stand in a heading, between commas: "m, cm, mm, km, ft, in".
std::string unitsOf(Quantity quantity);

/// What a heading says of a column.
struct ReadColumn {
    const TableColumn* column = nullptr;  ///< null: not known
    double unit = 1.0;                    ///< what one is in SI
    std::string_view unknownUnit;         ///< a unit that this quantity does not have
    bool withoutUnit = false;             ///< it needs one and has none
    bool withoutFrame = false;            ///< a spin that does not say of which axes
};
/// @param heading  "side_x_mm", in capitals or not
ReadColumn columnNamed(const std::string& heading);

}  // namespace rubble::io
