#include "app/cli/frame/commands.h"
#include "app/cli/frame/ensemble_commands.h"

namespace rubble::cli {

const std::vector<Command>& commandTable() {
    static const std::vector<Command> table = [] {
        std::vector<Command> rows{
            inspectCommand(),  sizeCommand(),      effectsCommand(),     runCommand(),      dropCommand(),       influenceCommand(),
            accuracyCommand(), calibrateCommand(), convertCommand(),     cacheCommand(),    jobsCommand(),       exportCommand(),
            figureCommand(),   movieCommand(),     mapCommand(),         cameraCommand(),   photoCommand(),      evidenceCommand(),
            surveyCommand(),   cloudCommand(),     scanCommand(),        sectionCommand(),  reportCommand(),     ensembleCommand(),
            compareCommand(),  verifyCommand(),    acknowledgeCommand(), sealCommand(),     openSealedCommand(), custodyCommand(),
            addendumCommand(), timeStampCommand(), selfTestCommand(),    validateCommand(), parametersCommand()};
        for (Command& row : rows) {
            row.options.push_back(jsonOption());
            row.options.push_back(helpOption());
        }
        return rows;
    }();
    return table;
}

Option helpOption() {
    return {"--help", "", false, "print this help"};
}

Option jsonOption() {
    return {"--json", "", false, "print one JSON object instead of tables; its keys are in the manual"};
}

Option csvOption(std::string_view help) {
    return {"--csv", "FILE", false, help};
}

Option setOption() {
    return {"--set", "KEY=VALUE", true, "change a parameter (see rubble-cli parameters); preset=paper applies a preset"};
}

Option scenarioOption() {
    return {"--scenario", "ID", false, "scenario of a case, by id or name (default: its active one)"};
}

Option feOption() {
    return {"--fe", "FILE", false, "where the FE file of the run is now"};
}

Option cachedOption() {
    return {"--cached", "", false, "open the FE result through a copy in the cache folder, which is made if there is none"};
}

Option terrainOption() {
    return {"--terrain", "FILE", false,
            "raster, point cloud or mesh (STL, OBJ, PLY) that the debris falls on; takes the place of the case's"};
}

Option groundClassOption() {
    return {"--ground-class", "LIST", false,
            "classes of a point cloud whose points are the terrain, such as 2,9 (default: as the case says, else 2)"};
}

Option columnsOption(std::string_view name) {
    return {name, "LIST", false, "columns of a table in their order, such as skip,y,x,z,intensity (default: by its heading)"};
}

Option systemOption(std::string_view name) {
    return {name, "SYSTEM", false, "coordinate system of a cloud or table that names none: EPSG code, WKT or PROJ"};
}

Option meshOffsetOption() {
    return {"--mesh-offset", "E,N,H", false,
            "easting, northing and height that are added to the meshes of surroundings, m; in place of those of the case"};
}

Option runTerrainOption() {
    return {"--terrain", "FILE", false, "where the terrain of the run is now"};
}

std::vector<Option> simulationOptions() {
    return {setOption(),
            cachedOption(),
            terrainOption(),
            groundClassOption(),
            columnsOption(terrainColumns),
            systemOption(terrainSystem),
            meshOffsetOption()};
}

std::vector<Option> siteOptions() {
    return {setOption(),
            scenarioOption(),
            meshOffsetOption(),
            feOption(),
            {"--terrain", "FILE", false, "of a run where its terrain is now; of a case the terrain to take"},
            groundClassOption(),
            columnsOption(terrainColumns),
            systemOption(terrainSystem)};
}

std::vector<Option> joined(std::initializer_list<std::vector<Option>> lists) {
    std::vector<Option> all;
    for (const std::vector<Option>& list : lists) {
        all.insert(all.end(), list.begin(), list.end());
    }
    return all;
}

}  // namespace rubble::cli
