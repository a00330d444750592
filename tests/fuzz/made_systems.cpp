#include "io/site/clouds/cloud_system.h"
#include "io/site/clouds/las/las_system.h"

namespace rubble::io {

// Stand in for GDAL and PROJ.
bool knowsSystem(const std::string& text) {
    return !text.empty();
}

void describeUnits(const std::string&, const std::string&, CloudHead&, Findings&) {}

void takeLasSystem(const CloudFile& file, const LasHead& las, CloudHead&) {
    if (const LasRecord* record = las.record("LASF_Projection", 34735)) {
        file.bytes(record->start, record->bytes);
    }
}

}  // namespace rubble::io
