#pragma once

#include <QString>
#include <cstddef>
#include <vector>

#include "core/scenario/photograph.h"

class QWidget;

namespace rubble {

class Session;

/// Adds the point pairs of a table. Where it names points of a total station instead of places, those that the case holds
/// as control are taken where there are any, else their file is asked for. They are brought to the local frame; what was found is
/// told.
/// @return how many; none: no file was named. Throws as readPointPairs() and readNamedPoints().
std::size_t addPairsOfTable(QWidget* window, const QString& path, Session& session, std::vector<PointPair>& pairs);

}  // namespace rubble
