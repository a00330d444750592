#include "app/gui/evidence/points_work.h"

#include <QFileInfo>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/unknown.h"
#include "io/site/clouds/octree/octree_choice.h"
#include "io/site/clouds/octree/octree_file.h"
#include "widgets/figures/point_colours.h"
#include "widgets/render/site/point_sight.h"

namespace rubble {

namespace {

using Scale = render::SitePoints::Scale;

/// What stands behind a colour that is asked for, as far as the cloud has it.
Scale scaleOf(render::PointColour colour, const io::OctreeHead& head) {
    if (colour == render::PointColour::Class && head.columns.classes) {
        return Scale::Class;
    }
    if (colour == render::PointColour::Own && head.columns.colour) {
        return Scale::Own;
    }
    return colour == render::PointColour::Own && head.columns.intensity ? Scale::Intensity : Scale::Height;
}

/// Heights between which nearly all points lie, m.
std::pair<double, double> heightsOf(const io::CloudBlock& block) {
    std::vector<double> heights;
    for (const Vec3& place : block.places) {
        heights.push_back(place.z());
    }
    std::sort(heights.begin(), heights.end());
    if (heights.empty()) {
        return {0.0, 1.0};
    }
    const std::size_t beyond = heights.size() / 50;
    return {heights[beyond], heights[heights.size() - 1 - beyond]};
}

double shareOf(double value, double low, double high) {
    return high > low ? (value - low) / (high - low) : 0.0;
}

void putPoint(render::SitePoints::Patch& patch, const Vec3& place, const render::Rgb& colour) {
    for (int axis = 0; axis < 3; ++axis) {
        patch.places.push_back(static_cast<float>(place[axis]));
    }
    patch.rgb.insert(patch.rgb.end(), {colour.r, colour.g, colour.b});
}

std::shared_ptr<const render::SitePoints::Patch> patchOf(const io::CloudBlock& block, Scale scale, PointsWork::Opened& opened) {
    const io::OctreeHead& head = opened.octree->octree().head();
    auto patch = std::make_shared<render::SitePoints::Patch>();
    patch->places.reserve(3 * block.size());
    patch->rgb.reserve(3 * block.size());
    for (std::size_t i = 0; i < block.size(); ++i) {
        render::Rgb colour;
        if (scale == Scale::Own) {
            const auto& own = block.colours[i];
            colour = {static_cast<std::uint8_t>(own[0]), static_cast<std::uint8_t>(own[1]), static_cast<std::uint8_t>(own[2])};
        } else if (scale == Scale::Class) {
            colour = figures::classColour(block.classes[i]);
            opened.classes[block.classes[i]] = colour;
        } else if (scale == Scale::Intensity) {
            colour = figures::scaleColour(scale, shareOf(block.intensity[i], head.intensityLeast, head.intensityMost));
        } else {
            colour = figures::scaleColour(scale, shareOf(block.places[i].z(), opened.heights.first, opened.heights.second));
        }
        putPoint(*patch, block.places[i], colour);
    }
    return patch;
}

/// What a look at a cloud needs of it; what is there already is not read again.
std::shared_ptr<const render::SitePoints> pointsFor(PointsWork::Opened& opened, const PointsWork::Look& look,
                                                    const std::string& name, bool& whole, const Execution& execution) {
    const io::CloudOctree& octree = opened.octree->octree();
    if (look.colour != opened.colour) {
        opened.colour = look.colour;
        opened.read.clear();
        opened.classes.clear();
    }
    const std::vector<Aabb>& boxes = opened.octree->boxes();
    const bool far = !look.panes.empty() && opened.farSites.nearer(look.panes.front().second.focalPoint);
    if (far != opened.far) {
        opened.far = far;
        opened.read.clear();
        opened.classes.clear();
        opened.heights = heightsOf(opened.octree->read(opened.root()));
    }
    const io::OctreeChoice choice = io::chooseNodes(
        octree.nodes(),
        [&](std::size_t n) {
            // Both parts would push the camera's range so wide that nothing near could be told apart.
            double most = 0.0;
            if (octree.nodes()[n].far != far) {
                return most;
            }
            for (const auto& [pane, camera] : look.panes) {
                most = std::max(most, render::pixelsOf(camera, pane.aspect(), pane.height, boxes[n], octree.nodes()[n].spacing));
            }
            return most;
        },
        pointsBudget);
    whole = choice.whole;
    auto points = std::make_shared<render::SitePoints>();
    points->name = name;
    points->source = opened.source;
    points->source.whole = choice.whole;
    points->source.far = far ? octree.head().points - octree.head().farPoints : octree.head().farPoints;
    points->all = octree.head().points;
    points->scale = scaleOf(look.colour, octree.head());
    points->low = points->scale == Scale::Intensity ? static_cast<double>(octree.head().intensityLeast) : opened.heights.first;
    points->high = points->scale == Scale::Intensity ? static_cast<double>(octree.head().intensityMost) : opened.heights.second;
    std::map<std::size_t, std::shared_ptr<const render::SitePoints::Patch>> used;
    for (const std::size_t n : choice.nodes) {
        execution.check();
        std::shared_ptr<const render::SitePoints::Patch>& patch = opened.read[n];
        if (patch == nullptr) {
            patch = patchOf(opened.octree->read(n), points->scale, opened);
        }
        used[n] = patch;
        points->patches.push_back(patch);
        const double spacing = octree.nodes()[n].spacing;
        points->source.finest = points->source.finest > 0.0 ? std::min(points->source.finest, spacing) : spacing;
        points->shown += patch->rgb.size() / 3;
    }
    points->classes.assign(opened.classes.begin(), opened.classes.end());
    opened.read = std::move(used);
    return points;
}

}  // namespace

render::SitePoints::Source sourceOf(const PointsWork::Cloud& cloud) {
    const io::CloudStamp stamp = io::stampOf(cloud.path);
    return {cloud.path, stamp.bytes, stamp.time, cloud.placed};
}

std::shared_ptr<const render::SitePoints> distancePoints(const PointsWork::Distances& distances, const std::string& name) {
    const io::CloudComparison& made = distances.made.compared;
    auto points = std::make_shared<render::SitePoints>();
    points->name = name;
    points->source = distances.source;
    points->scale = Scale::Distance;
    points->all = made.cores.size();
    points->time = distances.time;
    points->registered = made.settings.registrationError.has_value();
    for (const CoreDistance& core : made.distances) {
        if (core.significant()) {
            points->low = std::min(points->low, core.distance);
            points->high = std::max(points->high, core.distance);
            ++points->significant;
        }
    }
    const double most = std::max(points->high, -points->low);
    points->detection = middleDetection(made.distances);
    auto patch = std::make_shared<render::SitePoints::Patch>();
    for (std::size_t k = 0; k < made.distances.size(); ++k) {
        const CoreDistance& core = made.distances[k];
        if (core.state != CoreState::Measured) {
            continue;
        }
        const bool judged = std::isfinite(core.detection);
        points->unknown += judged ? 0 : 1;
        const render::Rgb even = judged ? figures::withinDetection : figures::detectionUnknown;
        putPoint(*patch, distances.cores[k], core.significant() ? figures::distanceColour(core.distance / most) : even);
    }
    points->shown = patch->rgb.size() / 3;
    points->patches.push_back(std::move(patch));
    return points;
}

std::size_t PointsWork::Opened::root() const {
    const std::vector<io::OctreeNode>& nodes = octree->octree().nodes();
    const auto found = std::find_if(nodes.begin(), nodes.end(), [&](const io::OctreeNode& node) { return node.far == far; });
    return static_cast<std::size_t>(found - nodes.begin());
}

bool PointsWork::Measured::operator==(const Measured& other) const {
    const auto parts = [](const Measured& m) {
        return std::tie(m.cloud, m.survey, m.run, m.cell, m.settings.normalRadius, m.settings.projectionRadius, m.settings.depth,
                        m.settings.registrationError);
    };
    return parts(*this) == parts(other);
}

PointsWork::PointsWork(QObject* parent) : QObject(parent) {
    connect(&worker, &Worker::progressed, this, [this](Worker::Kind kind, const Progress& progress) {
        if (kind == Worker::Kind::Open) {
            fraction = progress.fraction;
            emit changed();
        }
    });
    connect(&pictures, &Worker::progressed, this, [this](Worker::Kind, const Progress& progress) {
        picturesFraction = progress.fraction;
        emit changed();
    });
    connect(&pictures, &Worker::changed, this, &PointsWork::changed);
}

void PointsWork::close() {
    worker.cancel();
    cloud.reset();
    opened = nullptr;
    failure.reset();
    points = nullptr;
}

void PointsWork::open(const Cloud& wanted) {
    close();
    cloud = wanted;
    fraction = 0.0;
    auto made = std::make_shared<Opened>();
    worker.start({Worker::Kind::Open,
                  [made, wanted](const Execution& execution) {
                      made->source = sourceOf(wanted);
                      made->octree = std::make_unique<io::PlacedOctree>(wanted.path, wanted.read, wanted.frame, wanted.site,
                                                                        wanted.placed, execution);
                      made->farSites = io::FarSites(*made->octree, execution);
                      made->heights = heightsOf(made->octree->read(0));
                  },
                  [this, made, wanted](const std::exception_ptr& thrown) {
                      if (!cloud || !(*cloud == wanted)) {
                          return;
                      }
                      failure = failureOf(thrown);
                      if (thrown == nullptr) {
                          opened = made;
                      }
                      emit changed();
                  }});
    emit changed();
}

void PointsWork::look(const Look& from) {
    const std::string name = QFileInfo(QString::fromStdString(cloud->path)).fileName().toStdString();
    auto made = std::make_shared<std::pair<std::shared_ptr<const render::SitePoints>, bool>>();
    worker.startNext({Worker::Kind::Study,
                      [made, from, name, seen = opened](const Execution& execution) {
                          made->first = pointsFor(*seen, from, name, made->second, execution);
                      },
                      [this, made, seen = opened](const std::exception_ptr& thrown) {
                          if (seen != opened) {
                              return;
                          }
                          failure = failureOf(thrown);
                          if (thrown == nullptr) {
                              points = made->first;
                              whole = made->second;
                          }
                          emit changed();
                      }});
}

}  // namespace rubble
