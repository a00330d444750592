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
    /// @param some  there is a survey to say it of
    void setStated(const Stated& stated, bool some);

signals:
    /// When it was taken and what it shows were changed; the registration never is here.
    void edited(const rubble::widgets::SurveyPlace::Stated& stated);
    /// Pairs are to be clicked, or taken from a table.
    void pickRequested();
    void pairsRequested();
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
    QPushButton* m_unplace;
};

}  // namespace rubble::widgets
