#pragma once

#include <string>

#include "core/base/execution.h"
#include "widgets/figures/map_picture.h"
#include "widgets/figures/report/report_text.h"
#include "widgets/render/basics/scene_data.h"

namespace rubble::figures {

/// Draws the pictures of a report off screen: the arrangements of the published figures 11, 12 and 14, the map of its mass,
/// photographs and surveys.
/// @param place  of the map: origin, coordinate system
/// Throws what a Studio throws, and Cancelled.
ReportPictures drawReportPictures(const render::SceneData& data, const ReportFacts& facts, const MapPictureStyle& place,
                                  const Execution& execution);

/// Writes report.html and report.pdf into a folder, which is made if it is not there. Returns their paths.
/// @param metadata  JSON of their provenance
/// @param findings  get what the files lack; null: nobody asks
/// Throws WorldError naming the path, Cancelled; what was made for it is then gone again.
std::vector<std::string> writeReport(const std::string& folder, const ReportFacts& facts, const ReportPictures& pictures,
                                     const std::string& metadata, const Execution& execution, Findings* findings = nullptr);

}  // namespace rubble::figures
