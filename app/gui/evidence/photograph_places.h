#pragma once

#include <QObject>
#include <string>
#include <vector>

#include "app/gui/session/background_answers.h"
#include "core/base/unknown.h"
#include "core/scenario/case.h"
#include "io/site/surveys/evidence_origin.h"

namespace rubble {

class Document;
class Session;

/// How well the place of each photograph of the open case is known, and whether its file shows a run. Neither depends on a run that
/// is shown. Found in the background as soon as one is added, or its points or camera are edited.
class PhotographPlaces : public QObject {
    Q_OBJECT

public:
    explicit PhotographPlaces(Session& session);

    struct Place {
        double within = unknown;  ///< m, with 95 %; NaN: not known, or not yet
        io::EvidenceOrigin origin;
    };
    Place of(const Photograph& photograph) const;
    bool busy() const { return m_places.busy(); }

signals:
    /// More is known.
    void changed();

private:
    /// All that the answer depends on.
    struct Asked {
        std::string path;
        std::string sha256;
        std::vector<PointPair> pairs;
        CameraKnowledge camera;
        PhotoFacts facts;
        bool operator==(const Asked&) const = default;
    };
    static Place find(const Asked& asked, const Execution& execution);
    Asked askedOf(const Photograph& photograph) const;
    void look();

    Document& m_document;
    BackgroundAnswers<Asked, Place> m_places;
};

}  // namespace rubble
