#pragma once

#include <QObject>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/gui/session/worker.h"
#include "app/gui/studies/answer.h"
#include "core/fe/frame.h"
#include "core/scenario/case.h"
#include "io/case/case_photographs.h"
#include "io/site/clouds/octree/far_sites.h"
#include "io/site/clouds/octree/placed_octree.h"
#include "io/site/clouds/run_distance.h"
#include "widgets/render/basics/site_points.h"
#include "widgets/render/panes.h"

namespace rubble {

/// Points that views draw at most.
inline constexpr std::uint64_t pointsBudget = 1'500'000;

/// Reads points of clouds and measures their distances, whoever shows them.
class PointsWork : public QObject {
    Q_OBJECT

public:
    /// Where a cloud lies, and how.
    struct Cloud {
        std::string id;  ///< of the input
        std::string path;
        Frame frame;
        Site site;
        std::optional<Registration> placed;
        CloudRequest read = {};
        friend bool operator==(const Cloud&, const Cloud&) = default;
    };
    /// A cloud that is open, and what was read of it.
    struct Opened {
        std::unique_ptr<io::PlacedOctree> octree;
        io::FarSites farSites;
        render::SitePoints::Source source;
        bool far = false;                   ///< far points are looked at, and the bulk is not
        std::pair<double, double> heights;  ///< m, of nearly all points of that part
        render::PointColour colour = render::PointColour::Own;
        std::map<std::size_t, std::shared_ptr<const render::SitePoints::Patch>> read;
        std::map<int, render::Rgb> classes;  ///< that were met

        /// Coarsest node of the part that is looked at.
        std::size_t root() const;
    };
    /// From where it is looked at.
    struct Look {
        std::vector<std::pair<render::Pane, render::Camera>> panes;
        render::PointColour colour = render::PointColour::Own;
    };
    /// What distances are measured of.
    struct Measured {
        Cloud cloud;
        CaseInput survey;  ///< its scope without what had been removed by then
        std::shared_ptr<const void> run;
        CloudDistanceSettings settings;
        double cell = 0.0;  ///< m, of the volumes; 0: none are taken
        Findings said;      ///< of what the case says of the survey
        /// What can be chosen is the same.
        bool operator==(const Measured& other) const;
    };
    struct Distances {
        io::RunDistance made;
        std::vector<Vec3> cores;  ///< m, local
        double time = 0.0;        ///< s, on the file's clock, of the site
        render::SitePoints::Source source;
        /// Made when they are first drawn.
        std::shared_ptr<const render::SitePoints> points;
    };

    /// Photographs of a cloud that are added to a case.
    struct Pictures {
        Case before;
        Case after;
        QString base;  ///< of the case
        Frame frame;
        io::AddedPhotographs added;
        Findings findings;
        std::optional<Failure> failure;
        bool done = false;
    };

    explicit PointsWork(QObject* parent = nullptr);

    void open(const Cloud& cloud);
    void close();
    void look(const Look& look);

    std::optional<Cloud> cloud;  ///< that is open or being opened
    std::shared_ptr<Opened> opened;
    std::optional<Failure> failure;
    std::shared_ptr<const render::SitePoints> points;
    bool whole = true;  ///< nothing was left out for the budget
    double fraction = 0.0;
    Answer<Measured, Distances> distances;
    std::shared_ptr<const Distances> making;     ///< what is measured is for this; null: for nobody any more
    std::optional<CloudDistanceSettings> asked;  ///< what the fields asked for when a window went
    std::optional<double> cell;
    Worker worker;
    Worker measuring;
    Worker pictures;
    double picturesFraction = 0.0;
    std::shared_ptr<Pictures> adding;  ///< what is added is for this; null: for nobody any more

signals:
    void changed();
};

/// The file of a cloud as it is now, before it is read. Throws WorldError.
render::SitePoints::Source sourceOf(const PointsWork::Cloud& cloud);

/// Distances as points: those that differ in colour, the others grey.
std::shared_ptr<const render::SitePoints> distancePoints(const PointsWork::Distances& distances, const std::string& name);

}  // namespace rubble
