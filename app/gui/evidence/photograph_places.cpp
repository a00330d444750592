#include "app/gui/evidence/photograph_places.h"

#include "app/gui/session/session.h"
#include "core/base/error.h"
#include "core/evidence/photographs/camera_match.h"
#include "io/case/case_file.h"

namespace rubble {

PhotographPlaces::PhotographPlaces(Session& session)
    : m_document(session.document()), m_places(&PhotographPlaces::find, [this] { emit changed(); }) {
    for (const auto signal : {&Document::replaced, &Document::photographsChanged, &Document::inputsAccepted}) {
        connect(&m_document, signal, this, &PhotographPlaces::look);
    }
    look();
}

PhotographPlaces::Asked PhotographPlaces::askedOf(const Photograph& photograph) const {
    Asked asked{{}, {}, photograph.pairs, photograph.camera, photograph.facts};
    for (const CaseInput& input : m_document.theCase().inputs) {
        if (input.id == photograph.input) {
            asked.path = io::inputPath(m_document.base().toStdString(), input);
            asked.sha256 = input.sha256;
        }
    }
    return asked;
}

PhotographPlaces::Place PhotographPlaces::of(const Photograph& photograph) const {
    const Place* place = m_places.of(askedOf(photograph));
    return place != nullptr ? *place : Place();
}

PhotographPlaces::Place PhotographPlaces::find(const Asked& asked, const Execution& execution) {
    Place place;
    place.origin = io::photographOriginOf(asked.path);
    if (asked.pairs.empty()) {
        return place;
    }
    Photograph photograph;
    photograph.pairs = asked.pairs;
    photograph.camera = asked.camera;
    photograph.facts = asked.facts;
    try {
        place.within = matchPhotograph(photograph, execution).placeRadius;
    } catch (const Cancelled&) {
        throw;
    } catch (const Error&) {
        place.within = unknown;  // why no camera is found stands in its panel
    }
    return place;
}

void PhotographPlaces::look() {
    std::vector<Asked> asked;
    for (const Photograph& photograph : m_document.theCase().photographs) {
        asked.push_back(askedOf(photograph));
    }
    m_places.ask(asked);
}

}  // namespace rubble
