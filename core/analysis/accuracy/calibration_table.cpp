#include "core/analysis/accuracy/calibration_table.h"

#include "core/base/csv_text.h"

namespace rubble {

void writeCalibrationCsv(const Calibration& calibration, std::ostream& out) {
    out << "pile,bodies,physics_fps,drawing_fps,live_fps\n";
    for (const CalibrationPoint& point : calibration.points) {
        out << pileName(point.pile) << ',' << point.bodies;
        for (const LiveLoad load : {LiveLoad::Physics, LiveLoad::Drawing, LiveLoad::Both}) {
            out << ',' << exactNumber(point.fps(load));
        }
        out << '\n';
    }
}

}  // namespace rubble
