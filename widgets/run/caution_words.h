#pragma once

#include <QString>
#include <vector>

#include "core/evidence/cautions.h"
#include "widgets/basics/panel.h"

namespace rubble::widgets {

/// What pictures and panels show of cautions, in one line; empty: none.
QString cautionWords(const std::vector<Caution>& cautions);

/// The amber line of a dialog that makes pictures: what will stand below them. Hides itself where there is nothing to say.
/// @param cautions  as cautionWords()
void showCautions(Notice& line, const QString& cautions);

}  // namespace rubble::widgets
