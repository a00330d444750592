#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/fe/components.h"
#include "core/fe/fe_result.h"
#include "core/fragments/fragment_set.h"

namespace rubble::arches {

/// A sample collapse up to its fragments, with default settings.
struct Arch {
    std::shared_ptr<const FeResult> fe;
    Components components;
    FragmentSet fragments;

    const Mesh& mesh() const { return fe->mesh(); }
};

/// The samples; read once per process.
const Arch& stoneArch();
const Arch& rcArch();
/// The stone arch with its failing strips merged into their rings, as the sample case has it.
const Arch& mergedStoneArch();

}  // namespace rubble::arches
