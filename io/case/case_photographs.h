#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/scenario/case.h"

namespace rubble::io {

/// Adds a photograph and its file to a case, with what its file says; a cropped one has its principal point found. Returns the id
/// of the file, which no other input has; nothing if the case has a photograph with this content already.
/// @param casePath  the file that inputs are relative to
std::optional<std::string> addPhotograph(Case& theCase, const std::string& casePath, const std::string& path,
                                         const PhotoFacts& facts, const std::string& sha256);

/// Pictures that were written beside a case: they are taken away again unless the case keeps them.
struct WrittenPictures {
    std::vector<std::string> paths;
    bool kept = false;

    WrittenPictures() = default;
    WrittenPictures(const WrittenPictures&) = delete;
    WrittenPictures& operator=(const WrittenPictures&) = delete;
    ~WrittenPictures();
};

/// Photographs of a case that lie in a cloud.
struct AddedPhotographs {
    std::vector<std::string> ids;              ///< of those that were added
    std::size_t known = 0;                     ///< that the case had already
    std::shared_ptr<WrittenPictures> written;  ///< set `kept` once the case that has them is taken
};

/// Adds the pictures of a cloud that have a pinhole and a pose (placedPhotographs()) as photographs with that camera. Their files
/// are written into a folder beside the case, named after the cloud. Throws as placedPhotographs(), WorldError, Cancelled: then the
/// case is as it was, and so is the folder.
/// @param frame  of the case as it is open
AddedPhotographs addPhotographsOfCloud(Case& theCase, const std::string& casePath, const std::string& cloud, const Frame& frame,
                                       Findings& findings, const Execution& execution = Execution());

}  // namespace rubble::io
