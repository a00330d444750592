#include "app/gui/evidence/cluster_ensemble.h"

#include <algorithm>
#include <memory>

#include "io/base/machine.h"
#include "io/run/settled_files.h"

namespace rubble {

namespace {

constexpr const char* studyName = "ensemble";

/// An ensemble with what it is made from, once that is read.
struct Making {
    ClusterEnsemble ensemble;
    io::EnsembleSource source;
    std::string machine = io::machineText();

    EnsembleOptions options(SettledStore& store) const {
        EnsembleOptions options = optionsOf(ensemble.order, machine, store);
        options.choice = WorldChoice::none();
        return options;
    }

    std::optional<std::string> begin(const Execution& execution) {
        io::SettledFiles files(io::cacheFolder());
        const std::string store = files.worlds().folder();
        const std::string& subject = ensemble.read.subject;
        const auto ofThis = [&](const io::JobRecord& record) { return record.subject == subject; };
        // Reading a case takes long: not for nothing.
        if (!ensemble.submits && !io::newestJob(store, studyName, ofThis)) {
            return {};
        }
        const StudyOrder& order = ensemble.order;
        source = io::openEnsemble(caseRequest(ensemble.of, order), order.settings, execution);
        io::DistributedStudy study;
        study.name = studyName;
        study.subject = subject;
        study.store = store;
        study.islands = true;
        study.tasks = ensembleTasks(source.scenes, order.settings, options(files), execution);
        study.kept = [&files](const WorldOrigin& origin) { return files.keeps(origin); };
        study.sbatchOptions = ensemble.sbatchOptions;
        const std::string id = io::jobId(study.jobTasks());
        if (!ensemble.submits) {
            const auto record = io::newestJob(store, studyName, [&](const io::JobRecord& each) { return each.id == id; });
            return !record ? std::nullopt : std::optional(io::allMade(store, *record) ? std::string() : id);
        }
        if (io::missingTasks(study, execution).empty()) {
            return std::string();
        }
        study.setCommand(commandLineProgram(), keepJobCase(store, id, ensemble.read));
        std::size_t submitted = 0;
        return io::submitStudy(study, submitted);
    }

    void collect(const io::JobProgress& progress, const Execution& execution) const {
        // Its progress would stand in the way of that of the cluster.
        const Execution silent([&execution](const Progress&) { execution.check(); });
        io::SettledFiles files(io::cacheFolder());
        EnsembleReport report =
            ensembleStudy(source.scenes, ensemble.order.settings, options(files), silent.withThreads(execution.threads()));
        execution.check();
        report.findings.append(source.findings);
        report.findings.append(findingsOf(progress));
        ensemble.take({std::make_shared<const EnsembleReport>(std::move(report)), source.basis()});
    }
};

}  // namespace

ClusterWork::Study clusterStudy(ClusterEnsemble ensemble) {
    const auto making = std::make_shared<Making>();
    making->ensemble = std::move(ensemble);
    return {[making](const Execution& execution) { return making->begin(execution); },
            [making](const io::JobProgress& progress, const Execution& execution) { making->collect(progress, execution); }};
}

}  // namespace rubble
