#pragma once

#include <span>

#include "core/validation/validate.h"

namespace rubble {

/// A set whose measurements are numbers of a publication or of a closed form: what is simulated is a scene of its own.
struct SceneSet {
    ValidationSet about;  ///< without bodies; its variants say what is simulated
    /// Simulates one variant and gives its figures. @param variant  index into those of `about`
    std::vector<SetFigure> (*figures)(std::size_t variant, const ValidationOptions& options, const Execution& execution);
};

/// Poured packings of dice, blocks and walls on a tilting table, and columns of grains.
std::span<const SceneSet> sceneSets();

/// Simulates all variants of a scene and judges them. The same options give the same numbers. Throws Cancelled.
SetResult validateScene(const SceneSet& scene, const ValidationOptions& options, const Execution& execution);

}  // namespace rubble
