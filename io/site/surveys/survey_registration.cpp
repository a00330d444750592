#include "io/site/surveys/survey_registration.h"

#include <algorithm>

#include "io/site/clouds/cloud_place.h"
#include "io/site/clouds/height_source.h"
#include "io/site/point_pairs.h"

namespace rubble::io {

PairFit placeByPairs(const PairsRequest& request) {
    PlacePairTable table = readPlacePairs(request.table);
    std::vector<PlacePair>& pairs = table.pairs;
    const SitePlace place(request.frame, request.site);
    std::vector<Vec3> surveyed(pairs.size());
    std::transform(pairs.begin(), pairs.end(), surveyed.begin(), [](const PlacePair& pair) { return pair.surveyed; });
    Findings findings;
    if (!table.metres && holdsCloud(request.survey)) {
        CloudPlace(*openCloud(request.survey, request.read), request.frame, request.site, findings).toLocal(surveyed);
    } else {
        const Vec3 lift(0.0, 0.0, request.site.heightShift);
        std::transform(surveyed.begin(), surveyed.end(), surveyed.begin(),
                       [&](const Vec3& at) { return place.toLocal(at + lift); });
    }
    for (std::size_t p = 0; p < pairs.size(); ++p) {
        pairs[p].surveyed = surveyed[p];
        pairs[p].placed = place.toLocal(pairs[p].placed);
        pairs[p].deviation = pairs[p].deviation ? pairs[p].deviation : request.control;
    }
    PairFit fit = fitPairs(pairs, request.around);
    findings.append(fit.findings);
    fit.findings = std::move(findings);
    return fit;
}

}  // namespace rubble::io
