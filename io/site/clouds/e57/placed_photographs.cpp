#include "io/site/clouds/e57/placed_photographs.h"

#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include "core/evidence/cautions.h"
#include "io/base/file_words.h"
#include "io/site/clouds/cloud_place.h"
#include "io/site/clouds/point_cloud.h"

namespace rubble::io {

namespace {

/// Places on rays through the picture, in the numbers of the file: nine pixels, at three distances so that they lie in no plane.
std::vector<PointPair> raysOf(const CloudPhotograph& picture, double metres) {
    constexpr std::array<double, 3> depths{8.0, 20.0, 13.0};  // m
    std::vector<PointPair> pairs;
    for (std::size_t k = 0; k < 9; ++k) {
        const std::size_t column = k % 3, row = k / 3;
        const double u = (0.1 + 0.4 * static_cast<double>(column)) * static_cast<double>(picture.width);
        const double v = (0.1 + 0.4 * static_cast<double>(row)) * static_cast<double>(picture.height);
        // It looks along -z with y up; pictures count downwards.
        const Vec3 along((u - picture.principal.x()) / picture.focal, -(v - picture.principal.y()) / picture.focal, -1.0);
        const double depth = depths[(k + row) % depths.size()] / metres;
        const Pose& pose = picture.pose;
        PointPair pair{std::string(statedPairName), {u, v}, pose * (depth * along)};
        pair.name.append(1, ' ').append(std::to_string(k + 1));
        pairs.push_back(std::move(pair));
    }
    return pairs;
}

}  // namespace

std::string photographFileName(const CloudPhotograph& picture, std::size_t number) {
    std::string name = std::to_string(number + 1);
    name.append(picture.name.empty() ? 0 : 1, '-');
    for (const char c : picture.name.substr(0, 60)) {
        const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
        name += plain ? c : '_';
    }
    return name.append(1, '.').append(picture.kind);
}

bool hasPlace(const CloudPhotograph& picture) {
    return picture.projection == "pinhole" && picture.pose.stated && picture.focal > 0.0 && picture.width > 0 && picture.height > 0;
}

std::vector<PlacedPhotograph> placedPhotographs(const std::string& cloud, const CloudRequest& read, const Frame& frame,
                                                const Site& site, const std::optional<Registration>& placed, Findings& findings,
                                                const Execution& execution) {
    const std::unique_ptr<PointCloud> opened = openCloud(cloud, read);
    const CloudPlace place(*opened, frame, site, findings);
    std::vector<PlacedPhotograph> made;
    const std::vector<CloudPhotograph>& pictures = opened->head().photographs;
    std::int64_t without = 0;
    for (std::size_t k = 0; k < pictures.size(); ++k) {
        execution.report({"cloud.photographs_reading", "Reading photographs of the cloud", {}},
                         static_cast<double>(k) / static_cast<double>(pictures.size()));
        const CloudPhotograph& picture = pictures[k];
        if (!hasPlace(picture)) {
            ++without;
            continue;
        }
        PlacedPhotograph photograph;
        photograph.name = photographFileName(picture, k);
        photograph.bytes = opened->photograph(picture);
        photograph.camera.width = static_cast<int>(picture.width);
        photograph.camera.height = static_cast<int>(picture.height);
        photograph.camera.focal = picture.focal;
        photograph.camera.principal = picture.principal;
        photograph.camera.radialTerms = 0;
        const double metres = opened->head().units.metres;
        photograph.pairs = raysOf(picture, std::isfinite(metres) ? metres : 1.0);
        std::vector<Vec3> places;
        for (const PointPair& pair : photograph.pairs) {
            places.push_back(pair.model);
        }
        place.toLocal(places);
        for (std::size_t p = 0; p < places.size(); ++p) {
            photograph.pairs[p].model = placed ? (*placed)(places[p]) : places[p];
        }
        made.push_back(std::move(photograph));
    }
    if (without > 0) {
        addFinding(findings, cloud, {"cloud.photographs_without_place", "pictures without a pinhole and a pose were left out", {}},
                   "write them out with rubble-cli cloud --photographs and place them by pairs of points", without);
    }
    return made;
}

}  // namespace rubble::io
