#include "app/gui/accuracy/forecast.h"

#include <algorithm>

#include "core/analysis/accuracy/machine_speed.h"
#include "core/analysis/accuracy/study_tasks.h"
#include "core/base/error.h"
#include "io/base/machine.h"
#include "io/run/study_files.h"

namespace rubble {

namespace {

/// What the panels show, the robust measures of accuracy among them.
constexpr std::array<Predicted, 4> shownFigures{Predicted::WallSeconds, Predicted::Fps, Predicted::MassMap,
                                                Predicted::FootprintIou};

std::vector<KnownPoint> keptPoints(const Digest& scene) {
    try {
        Findings ignored;
        return io::StudyFiles(io::cacheFolder()).points(scene, ignored);
    } catch (const WorldError&) {
        // No folder for what can be made again: there are no points.
        return {};
    }
}

/// As the run will take it. Before there are clusters it is taken as it is asked for, which is the dearer one.
Scenario settledBefore(const Forecast::Question& question) {
    if (question.components == nullptr || question.clustering == nullptr) {
        return question.scenario;
    }
    Results results;
    results.components = question.components;
    results.fragments = question.fragments;
    results.clustering = question.clustering;
    return settledBy(question.inputs, question.scenario, results);
}

}  // namespace

Forecast::Forecast(std::string machine, Learnt& learnt, QObject* parent)
    : QObject(parent), m_machine(std::move(machine)), m_learnt(learnt) {}

void Forecast::forgetPoints() {
    // The worker may still use the older ones.
    m_earlier = std::make_shared<Earlier>();
}

bool Forecast::Loose::of(const Inputs& inputs, const Scenario& scenario) const {
    return fe.lock() == inputs.fe && terrain.lock() == inputs.terrain && fragments == scenario.fragments &&
           groundHeight == scenario.simulation.groundHeight && switches == scenario.effects.switches;
}

Forecast::Answer Forecast::answer(const Question& question, const Learnt& learnt, const std::string& machine,
                                  const Calibration* calibration, Earlier& earlier, Loose& loose, const Execution& execution) {
    const int threads = execution.threads();
    const WorldOrigin reference = originOf(question.inputs, referenceScenario(question.scenario), 0, 0.0, machine);
    const Digest scene = sceneDigest(reference, DebrisInstant::AtRest);
    if (!earlier.read || earlier.scene != scene) {
        earlier.points = keptPoints(scene);
        earlier.scene = scene;
        earlier.read = true;
    }
    KnownPoint open = openPoint(scene, machine, threads, question.scenario, static_cast<std::int64_t>(question.fragments->size()),
                                question.bodies);
    const Scenario settled = settledBefore(question);
    open.carries = settled.effects.loose != LooseStructurePolicy::Fe;
    open.span = collapseSpan(*question.fragments, question.inputs.fe->times().back());
    Answer answer{
        question.scenario, question.bodies, scene, stageKey(question.inputs, settled, Stage::Simulation), {}, std::nullopt, false};
    if (open.carries) {
        if (!loose.of(question.inputs, settled)) {
            loose = {question.inputs.fe,       question.inputs.terrain,
                     settled.fragments,        settled.simulation.groundHeight,
                     settled.effects.switches, looseBeside(question.inputs, settled, execution)};
        }
        answer.beside = loose.most;
    }
    for (const Predicted what : shownFigures) {
        const auto again = learnt.seconds.find(answer.setting);
        Prediction prediction = what == Predicted::WallSeconds && again != learnt.seconds.end()
                                    ? wallSecondsAgain(again->second)
                                    : predict(what, open, earlier.points, calibration);
        if (what == Predicted::WallSeconds && !prediction.known) {
            const auto ofScene = learnt.crudeOf.find(scene);
            const double ratio = ofScene != learnt.crudeOf.end() ? ofScene->second : learnt.crude;
            prediction = crudeWallSeconds(*question.fragments, question.bodies, question.inputs.fe->times().back(), settled,
                                          machineSpeed(execution), answer.beside.has_value());
            for (double* seconds : {&prediction.value, &prediction.low, &prediction.high}) {
                *seconds *= ratio;
            }
        }
        answer.figures.push_back({what, std::move(prediction), std::nullopt});
    }
    return answer;
}

void Forecast::learn(const Answer& before, double measured) {
    constexpr double most = 10.0;  // beyond, something else was in the way
    const auto wall = std::find_if(before.figures.begin(), before.figures.end(),
                                   [](const widgets::PredictedFigure& each) { return each.what == Predicted::WallSeconds; });
    if (!(measured > 0.0) || wall == before.figures.end()) {
        return;
    }
    m_learnt.seconds[before.setting] = measured;
    if (wall->prediction.fromSpeed && wall->prediction.value > 0.0) {
        const auto ofScene = m_learnt.crudeOf.find(before.scene);
        const double ratio = ofScene != m_learnt.crudeOf.end() ? ofScene->second : m_learnt.crude;
        m_learnt.crude = std::clamp(ratio * measured / wall->prediction.value, 1.0 / most, most);
        m_learnt.crudeOf[before.scene] = m_learnt.crude;
    }
}

void Forecast::ask(Question question) {
    const int number = ++m_asked;
    auto made = std::make_shared<std::optional<Answer>>();
    m_worker.startNext({Worker::Kind::Study,
                        [question, learnt = m_learnt, machine = m_machine, calibration = m_calibration, earlier = m_earlier,
                         loose = m_loose, made](const Execution& execution) {
                            *made = answer(question, learnt, machine, calibration.get(), *earlier, *loose, execution);
                        },
                        [this, number, made](const std::exception_ptr&) {
                            if (made->has_value()) {
                                (*made)->newest = number == m_asked;
                                emit said(**made);
                            }
                        }});
}

}  // namespace rubble
