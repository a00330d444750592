#pragma once

#include <initializer_list>
#include <vector>

#include "app/cli/frame/command.h"

namespace rubble::cli {

// One row of the command table each.
Command inspectCommand();
Command sizeCommand();
Command effectsCommand();
Command runCommand();
Command dropCommand();
Command influenceCommand();
Command accuracyCommand();
Command calibrateCommand();
Command convertCommand();
Command cacheCommand();
Command jobsCommand();
Command exportCommand();
Command figureCommand();
Command mapCommand();
Command evidenceCommand();
Command sectionCommand();
Command surveyCommand();
Command cloudCommand();
Command scanCommand();
Command movieCommand();
Command cameraCommand();
Command photoCommand();
Command verifyCommand();
Command reportCommand();
Command sealCommand();
Command openSealedCommand();
Command custodyCommand();
Command addendumCommand();
Command timeStampCommand();
Command acknowledgeCommand();
Command selfTestCommand();
Command validateCommand();
Command parametersCommand();

/// Every command, in the order in which the help lists them.
const std::vector<Command>& commandTable();

// Options that several commands share.
Option helpOption();
Option jsonOption();
Option csvOption(std::string_view help);
Option setOption();
Option scenarioOption();
Option feOption();
Option cachedOption();
Option terrainOption();
Option groundClassOption();
/// How a point cloud or a table of points is read, for takeCloudRequest().
Option columnsOption(std::string_view name = "--columns");
Option systemOption(std::string_view name = "--crs");
/// The same of a terrain.
inline constexpr std::string_view terrainColumns = "--terrain-columns";
inline constexpr std::string_view terrainSystem = "--terrain-crs";
Option meshOffsetOption();
Option runTerrainOption();
/// How a case or an FE file is simulated: parameters, kept copy, terrain, meshes.
std::vector<Option> simulationOptions();
/// The same and the scenario for a command that takes a recorded run as well.
std::vector<Option> siteOptions();
/// Lists of options, one behind the other.
std::vector<Option> joined(std::initializer_list<std::vector<Option>> lists);

}  // namespace rubble::cli
