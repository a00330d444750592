#pragma once

#include <QImage>

#include "core/evidence/report_facts.h"

namespace rubble::figures {

/// A photograph with what was drawn on it (white) and the outline of the simulated debris (vermilion, where it was compared), at a
/// width [px] with lines for print; null if it has no pixels.
QImage photographPicture(const ReportPhoto& photo, int width);

}  // namespace rubble::figures
