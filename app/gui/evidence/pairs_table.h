#pragma once

#include <QString>
#include <cstddef>
#include <vector>

#include "core/scenario/photograph.h"

class QWidget;

namespace rubble {

class Session;

/// Adds the point pairs of a table. Where it names points of a total station instead of places, their file is asked for, and they
/// are brought to the local frame; what was found in it is told.
/// @return how many; none: no file was named. Throws as readPointPairs() and readNamedPoints().
std::size_t addPairsOfTable(QWidget* window, const QString& path, Session& session, std::vector<PointPair>& pairs);

}  // namespace rubble
