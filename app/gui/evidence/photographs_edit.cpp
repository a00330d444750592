#include "app/gui/evidence/photographs_edit.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <algorithm>

#include "io/case/case_photographs.h"

namespace rubble {

PhotographsEdit withFound(const Case& theCase, const QString& base, const std::vector<FoundPhotos::Photo>& found) {
    Case with = theCase;
    PhotographsEdit edit;
    for (const FoundPhotos::Photo& photo : found) {
        const QString name = QFileInfo(photo.path).fileName();
        if (!io::addPhotograph(with, base.toStdString(), photo.path.toStdString(), photo.facts, photo.sha256)) {
            edit.known << name;
            continue;
        }
        edit.what = [name] { return QCoreApplication::translate("photographs", "photograph %1 added").arg(name); };
    }
    edit.photographs = std::move(with.photographs);
    edit.inputs = std::move(with.inputs);
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
