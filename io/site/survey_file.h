#pragma once

#include <string>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/evidence/surveys/survey.h"
#include "core/fe/frame.h"
#include "core/scenario/cloud_request.h"
#include "core/scenario/registration.h"
#include "core/scenario/site.h"
#include "io/site/site_place.h"

namespace rubble::io {

/// A survey as it was read.
struct SurveyInput {
    Survey survey;
    std::string path;
    std::string sha256;      ///< of the file and what lies beside it (digestOfInput())
    std::string fileSha256;  ///< of the file alone
    std::string ofRun;       ///< fingerprint of the simulated run that the file was made from, hex; empty: it was measured
    std::string crs;
    Frame frame;  ///< of the case that it was brought into
    Site site;
    Findings findings;
};

/// What a survey is taken to be.
struct SurveyRequest {
    enum class Holds { Either, Outline, Heights };
    Holds holds = Holds::Either;
    bool aboveGround = false;  ///< heights count from the ground, not from the zero of the case
    bool withFallen = false;   ///< of a map of our own: fallen live structure is debris
    /// File of the terrain that debris fell on, which is then read as the survey is; empty: heights are taken above the nodes of
    /// the terrain.
    std::string ground = {};
    std::optional<Registration> registration = {};  ///< by which it is moved once its coordinates were brought to the case
    CloudRequest read = {};                         ///< of a survey that is a point cloud
    CloudRequest groundRead = {};                   ///< of a ground that is one
    bool edge = false;                              ///< measured points are the edge of the debris, in their order
    std::string run = {};  ///< fingerprint of the run that it is held against, hex; empty: of none, or several
    bool evidence = true;  ///< false: an area to be compared; who made it says nothing
};

/// Reads a surveyed height model (anything that openTerrain() reads, in the same way; gaps stay gaps) or the outline of the debris
/// (as readOutline() or readMeasuredEdge() does) into the local frame of a case. Of a debris map of our own the heights are above
/// the ground. What is assumed, resampled or left out is a counted finding.
/// @param window  of a raster that is read; outlines are read whole
/// Throws WorldError, ParseError (neither heights nor polygons, or not what was asked for; degrees in a case without a coordinate
/// system), UsageError, Cancelled.
SurveyInput readSurvey(const std::string& path, const Frame& frame, const Site& site, const SiteWindow& window,
                       const Execution& execution, const SurveyRequest& request = {});

/// What the polygons of a file cover, as an area of interest or to be left out, read as an outline of debris is.
/// Throws as readSurvey().
Outline readScope(const std::string& path, const Frame& frame, const Site& site, Findings& findings, const Execution& execution);

}  // namespace rubble::io
