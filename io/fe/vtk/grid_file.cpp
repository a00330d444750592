#include "io/fe/vtk/grid_file.h"

#include <fstream>

#include "io/base/files.h"
#include "io/fe/series/numbered_files.h"
#include "io/fe/vtk/legacy_grid.h"
#include "io/fe/vtk/xml_grid.h"

namespace rubble::io {

namespace {

bool isLegacy(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string head(64, '\0');
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(file.gcount()));
    if (head.empty()) {
        requireNotEmpty(path);
        failToRead(path);
    }
    return head.starts_with("# vtk DataFile");
}

}  // namespace

Grid readGridFile(const std::string& path, const GridSelection& selection) {
    return isLegacy(path) ? readLegacyGrid(path, selection) : readXmlGrid(path, selection);
}

std::optional<double> timeOfGridFile(const std::string& path) {
    return isLegacy(path) ? timeOfLegacyGrid(path) : timeOfXmlGrid(path);
}

void requireWholeGrid(const std::string& path) {
    GridSelection structure;
    structure.points = false;
    structure.cells = false;
    readGridFile(path, structure);
}

}  // namespace rubble::io
