#pragma once

#include <QString>

#include "core/clusters/sizing.h"
#include "core/fe/components.h"

namespace rubble::widgets {

/// Why a size of the Basic Grid is not what the multiple asks for, or lies where it makes no sense: one sentence, empty if nothing
/// bites. @param name  of the axis: x, y or z
/// @param byComponents  the smallest component is a bound (boundByComponents())
QString axisReason(char name, const AxisSizing& axis, bool byHand, bool byComponents, const Components* components);
/// Why the multiple decides nothing, or less than all; empty if it decides all three sizes.
QString multipleReason(const GridSettings& settings);
/// Why the search stopped where it did.
QString stopReason(const Sizing& sizing);

}  // namespace rubble::widgets
