#include "app/gui/evidence/validation_work.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/validation/scene_sets.h"
#include "io/base/machine.h"
#include "io/validation/kept_validation.h"
#include "io/validation/set_folder.h"

namespace rubble {

namespace {

/// A set that comes with the program, and how it is simulated.
struct ShippedSet {
    std::string id;
    std::function<SetResult(ValidationSet& read, const Execution& execution)> simulate;
};

std::vector<ShippedSet> shippedOnes(const std::vector<std::string>& only) {
    std::vector<ShippedSet> sets;
    for (const io::SetPlace& place : io::setsIn(io::shippedSets())) {
        sets.push_back({place.id, [place](ValidationSet& read, const Execution& execution) {
                            read = io::readSet(place, execution);
                            return validate(read, {}, execution);
                        }});
    }
    for (const SceneSet& scene : sceneSets()) {
        sets.push_back(
            {scene.about.id, [&scene](ValidationSet&, const Execution& execution) { return validateScene(scene, {}, execution); }});
    }
    if (!only.empty()) {
        std::erase_if(sets, [&](const ShippedSet& set) { return std::find(only.begin(), only.end(), set.id) == only.end(); });
    }
    return sets;
}

}  // namespace

ValidationWork::ValidationWork(QObject* parent) : QObject(parent) {}

void ValidationWork::load() {
    struct Kept {
        std::vector<ValidationRecord> records;
        Findings findings;
    };
    auto kept = std::make_shared<Kept>();
    m_worker.startNext({Worker::Kind::Open,
                        [kept](const Execution&) { kept->records = io::keptValidations(io::cacheFolder(), kept->findings); },
                        [this, kept](const std::exception_ptr& thrown) {
                            // Without a folder for what can be made again nothing is kept.
                            if (thrown == nullptr) {
                                m_records = std::move(kept->records);
                                m_findings = std::move(kept->findings);
                                emit changed();
                            }
                        }});
}

void ValidationWork::start(const std::vector<std::string>& only) {
    if (m_running) {
        return;
    }
    m_running = true;
    m_left.restart();
    m_worker.start({Worker::Kind::Study,
                    [this, only](const Execution& execution) {
                        const std::vector<ShippedSet> sets = shippedOnes(only);
                        for (std::size_t i = 0; i < sets.size(); ++i) {
                            QMetaObject::invokeMethod(this, [this, i, count = sets.size(),
                                                             id = QString::fromStdString(sets[i].id)] { tellSet(id, i, count); });
                            ValidationSet read;
                            io::keepValidation(recordOf(sets[i].simulate(read, execution)), io::cacheFolder());
                        }
                    },
                    [this](const std::exception_ptr& thrown) {
                        m_running = false;
                        load();
                        const auto failure = failureOf(thrown);
                        emit ended(failure ? &*failure : nullptr);
                    }});
}

void ValidationWork::tellSet(const QString& set, std::size_t done, std::size_t count) {
    if (!m_running) {
        return;
    }
    const double fraction = static_cast<double>(done) / static_cast<double>(count);
    emit progressed(set, fraction, m_left.after({{"validation.sets", "", {}}, fraction}));
}

void ValidationWork::cancel() {
    m_worker.cancel();
    // What had not started yet never ends by itself.
    if (m_running && !m_worker.busy(Worker::Kind::Study)) {
        m_running = false;
        emit ended(nullptr);
    }
}

}  // namespace rubble
