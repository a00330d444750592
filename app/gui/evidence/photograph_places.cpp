#include "app/gui/evidence/photograph_places.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "app/gui/session/session.h"
#include "core/base/error.h"
#include "core/evidence/photographs/camera_match.h"
#include "io/case/case_file.h"

namespace rubble {

PhotographPlaces::PhotographPlaces(Session& session) : m_document(session.document()) {
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
    const auto found = std::find_if(m_known.begin(), m_known.end(),
                                    [asked = askedOf(photograph)](const Known& each) { return each.asked == asked; });
    return found != m_known.end() ? found->place : Place();
}

PhotographPlaces::Place PhotographPlaces::find(const Photograph& photograph, const std::string& path, const Execution& execution) {
    Place place;
    place.origin = io::photographOriginOf(path);
    if (photograph.pairs.empty()) {
        return place;
    }
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
    std::vector<Known> still;
    std::vector<Asked> wanted;
    std::vector<Photograph> photographs;
    for (const Photograph& photograph : m_document.theCase().photographs) {
        Asked asked = askedOf(photograph);
        const auto found = std::find_if(m_known.begin(), m_known.end(), [&](const Known& each) { return each.asked == asked; });
        if (found != m_known.end()) {
            still.push_back(*found);
        } else {
            wanted.push_back(std::move(asked));
            photographs.push_back(photograph);
        }
    }
    m_known = std::move(still);
    if (wanted == m_asking) {
        return;
    }
    m_asking = wanted;
    if (wanted.empty()) {
        m_worker.cancel();
        return;
    }
    auto made = std::make_shared<std::vector<Known>>();
    m_worker.start({Worker::Kind::Study,
                    [made, wanted, photographs](const Execution& execution) {
                        for (std::size_t k = 0; k < wanted.size(); ++k) {
                            made->push_back({wanted[k], find(photographs[k], wanted[k].path, execution)});
                        }
                    },
                    [this, made, wanted](const std::exception_ptr& thrown) {
                        if (thrown == nullptr && wanted == m_asking) {
                            m_asking.clear();
                            m_known.insert(m_known.end(), made->begin(), made->end());
                            emit changed();
                        }
                    }});
}

}  // namespace rubble
