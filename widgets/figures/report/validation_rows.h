#pragma once

#include <QString>
#include <vector>

#include "core/validation/validation_record.h"

namespace rubble::figures {

/// A figure of a set of measured falls as tables of report and window show it; what there is not is a dash. Numbers are HTML.
struct ValidationRow {
    QString set;        ///< "tosses, blind"
    QString figure;     ///< "run-out, Plate [m]"
    QString measured;   ///< D, mean ± scatter
    QString simulated;  ///< S, the same; of a figure without measurement its value with its interval
    QString error;      ///< E = S - D with its interval
    QString area;       ///< between the cumulative curves, and by chance
    QString lost;       ///< falls of which it is not known
    QString asked;      ///< what is asked of it, and whether it holds
};
std::vector<ValidationRow> validationRows(const ValidationRecord& record);

/// A setting of a variant with its source.
struct ValidationParameterRow {
    QString set;
    QString setting;  ///< "friction = 0.18"
    QString source;
};
std::vector<ValidationParameterRow> validationParameters(const ValidationRecord& record);

/// "tosses: 285 bodies, 0 still moving, 0 left the terrain, 0 lost" over all variants.
QString validationSummary(const ValidationRecord& record);

/// What the terms mean, for report and window.
QString validationTerms();

}  // namespace rubble::figures
