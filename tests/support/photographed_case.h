#pragma once

#include <cstdint>
#include <string>

#include "core/scenario/case.h"
#include "tests/support/command_run.h"
#include "tests/support/small_collapse.h"

namespace rubble::cli {

/// An uncompressed grey TIFF of one grey.
void writeGreyTiff(const std::string& path, std::uint16_t width, std::uint16_t height);

/// Adds a photograph of the small collapse by a camera that is known, with its points and an outline; writes its file.
void addPhotograph(Case& theCase, const std::string& path);

/// A case of the small collapse, run for 2 s, with one photograph of it, taken by a camera that is known.
class PhotoOfCase : public SmallRun {
protected:
    void SetUp() override;
    std::string save();

    Case m_case;
};

}  // namespace rubble::cli
