#pragma once

#include <QScrollArea>
#include <optional>
#include <string>
#include <vector>

#include "core/evidence/maps/fragment_path.h"
#include "core/fe/material.h"

class QLabel;
class QToolButton;
class QVBoxLayout;

namespace rubble::widgets {

class PanelGroup;

/// Shows what is selected: one element, as active structure and as fragment, or the sums over many. Emits what the user wants to do
/// with it.
class Inspector : public QScrollArea {
    Q_OBJECT

public:
    /// What is known of the fragment of an element. Places in m with the origin of the case added.
    struct FragmentFacts {
        FragmentId id{};
        double birthTime = 0.0;  ///< s
        std::optional<Vec3> birthPlace;
        double birthSpeed = 0.0;         ///< m/s
        std::optional<Vec3> finalPlace;  ///< of a run; where it was last
        double finalTime = 0.0;          ///< s, of that place
        std::optional<ClusterId> cluster;
        std::size_t clusterSize = 0;
        std::optional<double> error;       ///< m, against the reference at finalTime
        std::optional<FragmentPath> path;  ///< unset: not known (yet)
        bool pathPending = false;          ///< it is being read
    };
    struct ElementFacts {
        std::int64_t number = 0;  ///< user's element number
        std::string component;
        std::string material;
        bool materialAssumed = false;  ///< guessed from the density of its component
        bool materialFits = true;      ///< or taken for want of one that has it
        std::string shape;
        double mass = 0.0;                    ///< kg
        double volume = 0.0;                  ///< m3
        std::optional<double> lastActive;     ///< s, last state at which it is active; unset: never active
        std::optional<double> firstInactive;  ///< s, first state that reports it inactive; unset: it does not die
        std::optional<double> exactDeath;     ///< s, where the file gives it
        std::string reportedBy;               ///< how the file says so
        std::optional<double> carriedSince;   ///< s, when the engine took over the loose island it was in; unset: it did not
        std::optional<FragmentFacts> fragment;
    };
    struct Sums {
        std::size_t elements = 0;
        std::size_t fragments = 0;                                    ///< of them, that die
        std::size_t dead = 0;                                         ///< of them, at the present time
        double mass = 0.0;                                            ///< kg
        std::vector<std::pair<std::string, std::size_t>> components;  ///< with the number of elements, most first
        double firstBirth = 0.0;                                      ///< s
        double lastBirth = 0.0;                                       ///< s
    };

    explicit Inspector(QWidget* parent = nullptr);

    void showNothing();
    void showElement(const ElementFacts& facts);
    void showSums(const Sums& sums);
    /// Whether the views are moving along with the fragment.
    void setFollowing(bool following);
    QString title() const;
    QSize sizeHint() const override;

signals:
    void birthRequested();
    void followRequested(bool follow);
    void isolateRequested();
    void hideRequested();
    void clusterRequested();
    void clearRequested();
    /// The user says what a component is made of.
    void materialChosen(const QString& component, rubble::Material material);
    /// An impact was chosen: go to its time, s.
    void timeRequested(double time);

private:
    QToolButton* addButton(QLayout* row, const QString& text, const QString& tip);
    void restart(const QString& title, const QString& subtitle);
    PanelGroup* addGroup(const QString& heading);
    void addMaterial(PanelGroup& group, const ElementFacts& facts);
    void addDeath(const ElementFacts& facts);
    void addJourney(const FragmentFacts& fragment);
    void addImpacts(const FragmentPath& path);

    QVBoxLayout* m_column;
    QVBoxLayout* m_groups;
    QLabel* m_title;
    QLabel* m_subtitle;
    QToolButton* m_birth;
    QToolButton* m_follow;
    QToolButton* m_cluster;
    QToolButton* m_isolate;
    QToolButton* m_hide;
    QToolButton* m_clear;
};

}  // namespace rubble::widgets
