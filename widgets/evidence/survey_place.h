#pragma once

#include <QWidget>
#include <optional>
#include <string>

#include "core/scenario/registration.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace rubble::widgets {

class NumberField;

/// When a survey was taken, which debris it shows, and how it lies in the case.
class SurveyPlace : public QWidget {
    Q_OBJECT

public:
    explicit SurveyPlace(QWidget* parent = nullptr);

    struct Stated {
        std::string taken;  ///< as clockTime() gives it; empty: not known
        bool before = false;
        std::optional<double> instant;  ///< s; unset: at rest
        std::optional<Registration> registration;
        friend bool operator==(const Stated&, const Stated&) = default;
    };
    /// @param some  there is a survey to say it of; @param cloud  it has points that can be fitted
    void setStated(const Stated& stated, bool some, bool cloud = false);
    /// How well the control points of a table are known where it does not say it, m, standard deviation; unset: not known.
    std::optional<double> control() const;
    /// Puts the keyboard where the time is written.
    void askTime();

signals:
    /// When it was taken and what it shows were changed; the registration never is here.
    void edited(const rubble::widgets::SurveyPlace::Stated& stated);
    /// Pairs are to be clicked, or taken from a table.
    void pickRequested();
    void pairsRequested();
    /// It is to be fitted to what did not move.
    void fitRequested();
    void unplaceRequested();

private:
    void send();
    void takeTime();

    Stated m_stated;
    bool m_showing = false;
    QLineEdit* m_taken;
    QCheckBox* m_before;
    NumberField* m_instant;
    QLabel* m_said;
    QLabel* m_placed;
    QPushButton* m_pick;
    QPushButton* m_pairs;
    NumberField* m_control;
    QPushButton* m_fit;
    QPushButton* m_unplace;
};

}  // namespace rubble::widgets
