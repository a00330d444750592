#pragma once

#include <QObject>
#include <array>
#include <map>
#include <memory>
#include <optional>

#include "app/gui/session/worker.h"
#include "core/analysis/accuracy/loose_beside.h"
#include "core/analysis/accuracy/prediction.h"
#include "core/pipeline/pipeline.h"
#include "widgets/basics/prediction_box.h"

namespace rubble {

/// Says what a setting will cost and how accurate it will be, from earlier points in the user's cache and the calibration of this
/// machine. Works on a thread of its own; of questions that wait only the newest is answered.
class Forecast : public QObject {
    Q_OBJECT

public:
    struct Question {
        Inputs inputs;
        Scenario scenario;
        std::shared_ptr<const FragmentSet> fragments;
        std::int64_t bodies = 0;
        std::shared_ptr<const Components> components;  ///< null: not known yet
        std::shared_ptr<const Clustering> clustering;  ///< likewise
    };
    /// What runs told, since the program began.
    struct Learnt {
        double crude = 1.0;                  ///< what the last run took over what was foretold crudely
        std::map<Digest, double> crudeOf{};  ///< the same, of the last run of each scene
        std::map<Digest, double> seconds{};  ///< wall time of each setting that was run
    };
    /// The answer with what it was asked for.
    struct Answer {
        Scenario scenario;
        std::int64_t bodies = 0;
        Digest scene;    ///< what collapses
        Digest setting;  ///< stage key of its simulation
        std::vector<widgets::PredictedFigure> figures;
        std::optional<LooseAtOnce> beside;  ///< what the engine moves beside the fragments
        bool newest = false;                ///< nothing was asked since
    };

    /// @param machine  in words
    /// @param learnt  is added to by learn(); outlives this
    Forecast(std::string machine, Learnt& learnt, QObject* parent = nullptr);

    void setCalibration(std::shared_ptr<const Calibration> calibration) { m_calibration = std::move(calibration); }
    /// Earlier points are read anew: there may be more now.
    void forgetPoints();
    /// Answers with said().
    void ask(Question question);
    /// A run took so long: the same setting is foretold by it, and where it was predicted crudely, others are as well.
    /// @param measured  s
    void learn(const Answer& before, double measured);

signals:
    void said(const rubble::Forecast::Answer& answer);

private:
    /// Earlier points of the scene that was asked for last; used by the worker alone.
    struct Earlier {
        Digest scene;
        bool read = false;
        std::vector<KnownPoint> points;
    };
    /// What comes loose in the scene that was asked for last, and what that depends on; used by the worker alone.
    struct Loose {
        std::weak_ptr<const FeResult> fe;
        std::weak_ptr<const TerrainGrid> terrain;
        FragmentSettings fragments;
        double groundHeight = 0.0;  ///< m
        std::array<EffectSwitch, effectCount> switches{};
        std::optional<LooseAtOnce> most;

        bool of(const Inputs& inputs, const Scenario& scenario) const;
    };
    static Answer answer(const Question& question, const Learnt& learnt, const std::string& machine, const Calibration* calibration,
                         Earlier& earlier, Loose& loose, const Execution& execution);

    std::string m_machine;
    int m_asked = 0;
    Learnt& m_learnt;
    std::shared_ptr<const Calibration> m_calibration;
    std::shared_ptr<Earlier> m_earlier = std::make_shared<Earlier>();
    std::shared_ptr<Loose> m_loose = std::make_shared<Loose>();
    // Last, so that it has ended before anything it uses goes.
    Worker m_worker;
};

}  // namespace rubble
