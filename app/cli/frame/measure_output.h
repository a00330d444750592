#pragma once

#include <ostream>
#include <string>
#include <string_view>

#include "app/cli/frame/json_output.h"
#include "core/analysis/accuracy/repeat_floor.h"

namespace rubble::cli {

/// Title of a measure for people, with its unit.
std::string_view measureTitle(Measure measure);

/// Calls visit(measure, its number) for each in the order in which they are listed.
template <class Visit>
void forEachMeasure(Visit visit) {
    for (std::size_t m = 0; m < measureCount; ++m) {
        visit(static_cast<Measure>(m), m);
    }
}

/// Four digits, or a dash where there is no number.
std::string numberOrDash(double number);
/// A share in per cent, or a dash.
std::string percentOrDash(double share);

Json differenceJson(const DebrisDifference& difference);
Json figuresJson(const DebrisFigures& figures);
Json floorJson(const RepeatFloor& floor, double birthShift);

/// The floor as a table, one row for each repeat.
void printFloor(std::ostream& out, const RepeatFloor& floor, double birthShift);
/// Figures of the run that the floor is of.
void printFigures(std::ostream& out, const RepeatFloor& floor);

}  // namespace rubble::cli
