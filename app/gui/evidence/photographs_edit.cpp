#include "app/gui/evidence/photographs_edit.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <algorithm>

namespace rubble {

namespace {

/// An id that no input has.
std::string freeId(const std::vector<CaseInput>& inputs) {
    for (int number = 1;; ++number) {
        const std::string id = "photograph-" + std::to_string(number);
        if (std::none_of(inputs.begin(), inputs.end(), [&](const CaseInput& input) { return input.id == id; })) {
            return id;
        }
    }
}

}  // namespace

PhotographsEdit withFound(const Case& theCase, const QString& base, const std::vector<FoundPhotos::Photo>& found) {
    PhotographsEdit edit{theCase.photographs, theCase.inputs, {}, {}};
    const QDir folder = QFileInfo(base).absoluteDir();
    for (const FoundPhotos::Photo& photo : found) {
        const QString name = QFileInfo(photo.path).fileName();
        const bool known = std::any_of(edit.inputs.begin(), edit.inputs.end(), [&](const CaseInput& input) {
            return input.role == InputRole::Photograph && input.sha256 == photo.sha256;
        });
        if (known) {
            edit.known << name;
            continue;
        }
        const std::string id = freeId(edit.inputs);
        edit.inputs.push_back({id, InputRole::Photograph, folder.relativeFilePath(photo.path).toStdString(), photo.sha256});
        Photograph& added = edit.photographs.emplace_back();
        added.input = id;
        added.facts = photo.facts;
        added.camera.width = photo.facts.width;
        added.camera.height = photo.facts.height;
        added.camera.freePrincipal = cropped(photo.facts);
        edit.what = [name] { return QCoreApplication::translate("photographs", "photograph %1 added").arg(name); };
    }
    if (const std::size_t count = edit.photographs.size() - theCase.photographs.size(); count > 1) {
        edit.what = [count] { return QCoreApplication::translate("photographs", "%1 photographs added").arg(count); };
    }
    return edit;
}

PhotographsEdit withoutPhotograph(const Case& theCase, int photograph) {
    PhotographsEdit edit{
        theCase.photographs, theCase.inputs, [] { return QCoreApplication::translate("photographs", "photograph removed"); }, {}};
    const std::string id = edit.photographs.at(static_cast<std::size_t>(photograph)).input;
    edit.photographs.erase(edit.photographs.begin() + photograph);
    std::erase_if(edit.inputs, [&](const CaseInput& input) { return input.id == id; });
    return edit;
}

PhotographsEdit withEdited(const Case& theCase, int photograph, const Photograph& after, const widgets::Wording& what) {
    PhotographsEdit edit{theCase.photographs, theCase.inputs, what, {}};
    edit.photographs.at(static_cast<std::size_t>(photograph)) = after;
    return edit;
}

}  // namespace rubble
