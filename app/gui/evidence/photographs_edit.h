#pragma once

#include <QString>
#include <vector>

#include "app/gui/evidence/evidence_work.h"
#include "core/scenario/case.h"
#include "widgets/basics/wording.h"

namespace rubble {

/// Photographs of a case and their files after an edit.
struct PhotographsEdit {
    std::vector<Photograph> photographs;
    std::vector<CaseInput> inputs;
    widgets::Wording what;  ///< names the edit for undo; none: nothing changes
    QStringList known;      ///< files that the case has already
};

/// A case with the photographs that were found. A file that it has already, by its content, is passed over.
/// @param base  the file that inputs are relative to
PhotographsEdit withFound(const Case& theCase, const QString& base, const std::vector<FoundPhotos::Photo>& found);
/// A case without one of its photographs.
PhotographsEdit withoutPhotograph(const Case& theCase, int photograph);
/// A case with one of its photographs edited.
PhotographsEdit withEdited(const Case& theCase, int photograph, const Photograph& after, const widgets::Wording& what);

}  // namespace rubble
