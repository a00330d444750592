#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "app/cli/frame/arguments.h"
#include "app/cli/frame/json_output.h"
#include "core/evidence/ensembles/cause_comparison.h"

namespace rubble::cli {

/// A place that debris may reach.
struct ReachedPlace {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();  ///< m
    double radius = 0.0;                               ///< m
};

/// What --against time= names: "SECONDS,X,Y[,RADIUS[,ACCURACY]]". Throws UsageError.
TimeEvidence parseTimeEvidence(const std::string& text);
/// What --reached names, each "X,Y[,RADIUS]". Throws UsageError.
std::vector<ReachedPlace> reachedPlaces(const Arguments& arguments);
Option reachedOption();

/// One object for each place: when debris first lay there, after the first that came down anywhere, over the members and of each.
Json reachedJson(const EnsembleReport& report, const std::vector<ReachedPlace>& places);
/// One row for each place; nothing without places.
void printReached(std::ostream& out, const EnsembleReport& report, const std::vector<ReachedPlace>& places);

}  // namespace rubble::cli
