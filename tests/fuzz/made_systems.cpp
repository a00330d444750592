#include "io/site/clouds/cloud_system.h"
#include "io/site/clouds/height_source.h"
#include "io/site/clouds/las/las_system.h"
#include "io/site/clouds/point_cloud.h"

namespace rubble::io {

// Stand in for GDAL and PROJ.
bool holdsCloud(const std::string& path, const CloudRequest&) {
    return beginsAsCloud(path);
}

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
