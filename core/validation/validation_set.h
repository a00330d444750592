#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/fe/loose_bodies.h"
#include "core/fe/terrain_grid.h"
#include "core/scenario/ensemble.h"

namespace rubble {

/// A setting that a set is simulated with, and where its value comes from.
struct SetParameter {
    std::string key;  ///< of the parameter table
    std::string value;
    std::string source;
};

/// A setting that is drawn anew in every repeat, and where its distribution comes from.
struct SetVaried {
    VariedSetting setting;
    std::string source;
};

/// A setting that is fitted on each half of the bodies, every second one, and judged on the other.
struct FittedParameter {
    std::string key;
    double low = 0.0;
    double high = 0.0;
};

/// How often a set may ask for its bodies to be let go.
inline constexpr std::int64_t mostSetRepeats = 1000;

/// One way in which a set is simulated.
struct SetVariant {
    std::string name;   ///< "blind"
    std::string words;  ///< what it is, in a sentence
    std::vector<SetParameter> parameters;
    std::vector<FittedParameter> fitted = {};  ///< empty: nothing is fitted
    std::vector<SetVaried> varied = {};        ///< empty: nothing is drawn but orientations
    std::optional<std::int64_t> repeats = {};  ///< unset: those of the set
};

/// What somebody asks of a figure of a variant.
struct SetCriterion {
    std::string variant;
    std::string figure;  ///< "run_out_m.error", "run_out_m[Plate].simulated"
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    std::string below;  ///< another figure that it must be less than; empty: none
};

/// Things that really fell: how they were let go, and where they came to lie.
struct ValidationSet {
    std::string id;
    std::string title;
    std::string source;
    std::string licence;                         ///< name of it, or first line of its file
    std::string folder;                          ///< that its tables were read from
    std::vector<LooseBody> bodies;               ///< in the axes of its tables
    std::vector<MeasuredEnd> measured;           ///< [bodies]
    std::shared_ptr<const TerrainGrid> terrain;  ///< null: level ground at zero
    bool turned = false;                         ///< orientations were not measured: they are drawn at random
    bool lifted = false;                         ///< bodies are lifted out of the ground in which they begin
    std::int64_t repeats = 1;
    std::vector<SetVariant> variants;
    std::vector<SetCriterion> criteria;
    Findings findings;
};

}  // namespace rubble
