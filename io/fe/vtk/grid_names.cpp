#include "io/fe/vtk/grid_names.h"

#include <string_view>

#include "core/base/error.h"
#include "core/base/nearest_names.h"
#include "io/fe/exodus/exodus_names.h"

namespace rubble::io {

namespace {

std::vector<std::string> namesOf(const std::vector<GridArray>& arrays, std::size_t components) {
    std::vector<std::string> names;
    for (const GridArray& array : arrays) {
        if (array.components == components) {
            names.push_back(array.name);
        }
    }
    return names;
}

std::string choose(const std::vector<std::string>& names, const std::vector<std::string_view>& known) {
    const int found = findAny(names, known);
    return found < 0 ? "" : names[static_cast<std::size_t>(found)];
}

void chooseFlag(const std::vector<std::string>& scalars, const ImportSettings& settings, const std::string& path,
                GridNames& names) {
    names.flag.choices = scalars;
    if (const auto status = findStatus(scalars, settings.statusVariable)) {
        names.flag.name = status->name;
        names.flag.activeByName = status->activeByName;
        // The converter of Radioss animation files writes 1 for alive and 0 for both rigid and eroded.
        if (findAny({status->name}, {"erosion_status"}) == 0) {
            names.flag.activeByName = 1;
            names.flag.alwaysZeroIsRigid = true;
        }
    } else if (!settings.statusVariable.empty()) {
        throw UsageError({"vtk.unknown_status", "{0} has no cell array \"{1}\"", {path, settings.statusVariable}},
                         {"vtk.unknown_status.remedy", "Cell arrays with one component: {0}", {quotedList(scalars, 100)}});
    } else {
        names.flag.name = choose(scalars, {"isdeleted", "vtkghosttype"});
        names.flag.activeByName = names.flag.name.empty() ? std::nullopt : std::optional(0);
    }
    names.ghostFlag = findAny({names.flag.name}, {"vtkghosttype"}) == 0;
    names.ghostNamed = names.ghostFlag && !settings.statusVariable.empty();
    names.ghost = choose(scalars, {"vtkghosttype", "vtkghostlevels", "ghostrank"});
    if (names.ghostFlag) {
        names.flag.activeByName = 0;
    }
}

void chooseVectors(const std::vector<std::string>& vectors, const ImportSettings& settings, const std::string& path,
                   GridNames& names) {
    names.velocity = choose(vectors, {"velocity", "velocities", "vel", "v"});
    if (settings.displacement == "none") {
        return;
    }
    if (settings.displacement.empty()) {
        names.displacement = choose(vectors, {"displacement", "displacements", "displ", "disp", "u"});
        return;
    }
    names.displacement = choose(vectors, {settings.displacement});
    for (const std::string& name : vectors) {
        if (name == settings.displacement) {
            names.displacement = name;
        }
    }
    if (names.displacement.empty()) {
        throw UsageError(
            {"vtk.unknown_displacement", "{0} has no point array \"{1}\" with three components", {path, settings.displacement}},
            {"vtk.unknown_displacement.remedy",
             "Name one of these: {0}; displacement=none if the points are where the nodes are.",
             {quotedList(vectors, 100)}});
    }
}

}  // namespace

GridNames chooseGridNames(const Grid& grid, const ImportSettings& settings, const std::string& path) {
    GridNames names;
    const std::vector<std::string> cells = namesOf(grid.cellData, 1), points = namesOf(grid.pointData, 1);
    chooseFlag(cells, settings, path, names);
    chooseVectors(namesOf(grid.pointData, 3), settings, path, names);
    names.element = choose(cells, {"element_id", "elementid", "element_ids", "globalelementid", "globalids", "elementtag",
                                   "global_ids", "cell_ids", "eid", "element", "id", "ids"});
    names.node = choose(points, {"node_id", "nodeid", "node_ids", "globalnodeid", "globalids", "nodetag", "global_ids", "nid",
                                 "node", "id", "ids"});
    names.part = choose(cells, {"part_id", "partid", "part", "parts", "objectid", "blockid", "block_id", "material_id",
                                "materialids", "material", "mat", "gmsh:physical"});
    names.component = grid.componentNames.empty() ? "" : choose(cells, {"component"});
    names.atRest = choose(namesOf(grid.pointData, 3), {"initial_position"});
    names.density = choose(cells, {"density", "rho", "mass_density"});
    names.thickness = choose(cells, {"thickness", "shell_thickness", "thick"});
    names.area = choose(cells, {"area", "cross_section", "section_area"});
    names.deathTime =
        choose(cells, {"death_time", "deathtime", "time_of_death", "time_deletion_element", "time_deletion", "deletion_time"});
    return names;
}

}  // namespace rubble::io
