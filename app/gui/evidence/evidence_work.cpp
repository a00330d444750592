#include "app/gui/evidence/evidence_work.h"

#include <algorithm>

#include "app/gui/session/computation.h"
#include "core/base/error.h"
#include "io/run/run_cautions.h"
#include "io/site/photograph_file.h"

namespace rubble {

namespace {

constexpr int picturePixels = 3000;  // longest side of what is shown: 27 MB whatever the photograph
constexpr int outlinePixels = 1200;

LoadedPhoto loadPhoto(const QString& path, const Execution& execution) {
    LoadedPhoto photo;
    photo.path = path;
    try {
        const io::PhotographFile file = io::readPhotograph(path.toStdString());
        photo.sha256 = file.sha256;
        photo.findings = file.findings;
        const io::PhotoPicture picture = io::readPicture(path.toStdString(), picturePixels, execution);
        photo.findings.append(picture.findings);
        photo.picture = QImage(picture.rgb.data(), picture.width, picture.height, 3 * picture.width, QImage::Format_RGB888)
                            .convertToFormat(QImage::Format_RGB32);
    } catch (const Cancelled&) {
        throw;
    } catch (...) {
        photo.failure = failureOf(std::current_exception());
    }
    return photo;
}

}  // namespace

EvidenceRun::EvidenceRun(const Inputs& inputs, const RunRecord* record) {
    if (inputs.fe != nullptr && record != nullptr && record->reader != nullptr && record->reader->frameCount() > 0) {
        fe = inputs.fe;
        trajectory = record->reader;
        fragments = record->results.fragments;
        result = record->outcome;
        terrain = inputs.terrain;
        scenario = record->scenario;
    }
}

EvidenceWork::EvidenceWork(QObject* parent) : QObject(parent) {}

QString EvidenceWork::whyNoDebris(const RunRecord* record) {
    if (record == nullptr || record->reader == nullptr || record->running) {
        return tr("Simulate first, or show one of the runs: there is no debris yet.");
    }
    return {};
}

std::vector<Caution> EvidenceWork::cautionsOf(const Photograph& photograph, const std::optional<CameraMatch>& match,
                                              const RunRecord* record) {
    const bool shown = record != nullptr && record->reader != nullptr && !record->running;
    const std::optional<RunStanding> standing = shown ? std::optional(io::standingOf(*record->reader)) : std::nullopt;
    return photographCautions(photograph, match ? &*match : nullptr, standing ? &*standing : nullptr);
}

void EvidenceWork::find(const QStringList& paths) {
    auto outcome = std::make_shared<FoundPhotos>();
    m_files.startNext({Worker::Kind::Write,
                       [paths, outcome](const Execution& execution) {
                           for (const QString& path : paths) {
                               execution.check();
                               try {
                                   const io::PhotographFile file = io::readPhotograph(path.toStdString());
                                   outcome->photos.push_back({path, file.facts, file.sha256});
                               } catch (...) {
                                   outcome->failures.push_back(*failureOf(std::current_exception()));
                               }
                           }
                       },
                       [this, outcome](const std::exception_ptr& thrown) {
                           if (thrown == nullptr) {
                               emit found(*outcome);
                           }
                       }});
}

void EvidenceWork::load(const QString& path) {
    auto outcome = std::make_shared<LoadedPhoto>();
    m_files.start({Worker::Kind::Open, [path, outcome](const Execution& execution) { *outcome = loadPhoto(path, execution); },
                   [this, outcome](const std::exception_ptr& thrown) {
                       if (thrown == nullptr) {
                           emit loaded(*outcome);
                       }
                   }});
}

void EvidenceWork::outline(const EvidenceRun& run, const CameraModel& camera, QSize photograph, double time, bool withFallen) {
    auto outlines = std::make_shared<std::vector<std::vector<Eigen::Vector2d>>>();
    m_study.startNext({Worker::Kind::Update,
                       [=](const Execution& execution) {
                           const MappedRun mapped = run.mapped();
                           const MapSpan span = mapSpan(mapped);
                           const SiteShape site =
                               siteOfRun(mapped, std::clamp(time, span.first, span.last), fallenFrom, camera.place, execution);
                           const SitePicture seen = pictureOf(site, camera, photograph.width(), photograph.height(), outlinePixels);
                           *outlines = outlinesOf(seen, debrisIn(seen, withFallen));
                       },
                       // Without debris there are none.
                       [this, outlines](const std::exception_ptr&) { emit outlined(*outlines); }});
}

void EvidenceWork::compare(const EvidenceRun& run, const Photograph& photograph, const CameraMatch& match,
                           const ComparisonSettings& settings) {
    m_comparing = true;
    auto made = std::make_shared<std::shared_ptr<const PhotoComparison>>();
    m_study.start({Worker::Kind::Study,
                   [=](const Execution& execution) {
                       *made = std::make_shared<const PhotoComparison>(
                           compareRunWithPhoto(run.mapped(), photograph, match, settings, execution));
                   },
                   [this, made](const std::exception_ptr& thrown) {
                       m_comparing = false;
                       const auto failure = failureOf(thrown);
                       emit compared(thrown == nullptr ? *made : nullptr, failure ? &*failure : nullptr);
                   }});
}

void EvidenceWork::cancelComparison() {
    m_study.cancel(Worker::Kind::Study);
    // What had not started yet never ends by itself.
    if (m_comparing && !m_study.busy(Worker::Kind::Study)) {
        m_comparing = false;
        emit compared(nullptr, nullptr);
    }
}

void EvidenceWork::cancel() {
    cancelComparison();
    m_study.cancel();
    m_files.cancel();
}

}  // namespace rubble
