#pragma once

#include <span>

#include "core/validation/validate.h"

namespace rubble {

/// A set whose measurements are numbers of a publication or of a closed form: what is simulated is a scene of its own, in pieces
/// that know nothing of each other.
struct SceneSet {
    ValidationSet about;  ///< without bodies; its variants say what is simulated
    /// Pieces of each variant.
    std::size_t (*pieces)(const ValidationOptions& options);
    /// What came of one piece of a variant. @param variant  index into those of `about`
    std::vector<double> (*simulate)(std::size_t variant, std::size_t piece, const ValidationOptions& options,
                                    const Execution& execution);
    /// Figures of a variant. @param found  [pieces] of simulate()
    std::vector<SetFigure> (*figures)(std::size_t variant, const std::vector<std::vector<double>>& found);
};

/// Poured packings of dice, blocks and walls on a tilting table, and columns of grains.
std::span<const SceneSet> sceneSets();

/// Simulates all variants of a scene, several pieces at a time where there are threads for it, and judges them. The same options
/// give the same numbers. Throws Cancelled.
SetResult validateScene(const SceneSet& scene, const ValidationOptions& options, const Execution& execution);

}  // namespace rubble
