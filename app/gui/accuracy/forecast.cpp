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

Forecast::Forecast(std::string machine, QObject* parent) : QObject(parent), m_machine(std::move(machine)) {}

void Forecast::forgetPoints() {
    // The worker may still use the older ones.
    m_earlier = std::make_shared<Earlier>();
}

bool Forecast::Loose::of(const Inputs& inputs, const Scenario& scenario) const {
    return fe.lock() == inputs.fe && terrain.lock() == inputs.terrain && fragments == scenario.fragments &&
           groundHeight == scenario.simulation.groundHeight && switches == scenario.effects.switches;
}

Forecast::Answer Forecast::answer(const Question& question, const std::string& machine, const Calibration* calibration,
                                  Earlier& earlier, Loose& loose, const Execution& execution) {
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
    Answer answer{question.scenario, question.bodies, {}, std::nullopt, false};
    if (open.carries) {
        if (!loose.of(question.inputs, settled)) {
            loose = {question.inputs.fe,       question.inputs.terrain,
                     settled.fragments,        settled.simulation.groundHeight,
                     settled.effects.switches, looseBeside(question.inputs, settled, execution)};
        }
        answer.beside = loose.most;
    }
    for (const Predicted what : shownFigures) {
        Prediction prediction = predict(what, open, earlier.points, calibration);
        if (what == Predicted::WallSeconds && !prediction.known) {
            prediction = crudeWallSeconds(*question.fragments, question.bodies, question.inputs.fe->times().back(), settled,
                                          machineSpeed(execution), answer.beside.has_value());
            for (double* seconds : {&prediction.value, &prediction.low, &prediction.high}) {
                *seconds *= question.learnt;
            }
        }
        answer.figures.push_back({what, std::move(prediction), std::nullopt});
    }
    return answer;
}

void Forecast::learn(double predicted, double measured) {
    constexpr double most = 10.0;  // beyond, something else was in the way
    if (predicted > 0.0 && measured > 0.0) {
        m_learnt = std::clamp(m_learnt * measured / predicted, 1.0 / most, most);
    }
}

void Forecast::ask(Question question) {
    question.learnt = m_learnt;
    const int number = ++m_asked;
    auto made = std::make_shared<std::optional<Answer>>();
    m_worker.startNext(
        {Worker::Kind::Study,
         [question, machine = m_machine, calibration = m_calibration, earlier = m_earlier, loose = m_loose,
          made](const Execution& execution) { *made = answer(question, machine, calibration.get(), *earlier, *loose, execution); },
         [this, number, made](const std::exception_ptr&) {
             if (made->has_value()) {
                 (*made)->newest = number == m_asked;
                 emit said(**made);
             }
         }});
}

}  // namespace rubble
