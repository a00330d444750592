#pragma once

#include <QObject>
#include <memory>
#include <type_traits>
#include <typeindex>
#include <utility>
#include <vector>

#include "app/gui/session/computation.h"
#include "app/gui/session/document.h"
#include "widgets/case/preferences_dialog.h"

namespace rubble {

/// What is worked on, apart from the window that shows it: the case, what is computed for it, the preferences, and of each feature
/// the part that goes on while a window is made anew.
class Session : public QObject {
    Q_OBJECT

public:
    /// Reads the preferences of this user.
    explicit Session(QObject* parent = nullptr);
    /// Ends all work; what a feature keeps goes before the case that it is about.
    ~Session() override;

    Document& document() { return m_document; }
    Computation& computation() { return m_computation; }
    const widgets::Preferences& preferences() const { return m_preferences; }
    /// Keeps preferences for this user and puts them in force.
    void setPreferences(const widgets::Preferences& preferences);
    /// Preferences that could not be read and are as delivered; they are named once.
    QStringList takeComplaints() { return std::exchange(m_complaints, {}); }
    /// The part of a feature that outlives windows. Made when it is first asked for, from the session where it takes one.
    template <typename Part>
    Part& part();

    /// Says in the status line what came of something.
    void tell(const QString& what) { emit told(what); }
    /// Says what went wrong, where the window says such things.
    void report(const Failure& failure) { emit failed(failure); }

    /// Says what came of a file that was to be written: saved, given up, or what went wrong. @param thrown  by what wrote it; null:
    /// nothing
    void tellWritten(const QString& path, const std::exception_ptr& thrown = nullptr);
    /// Writes a file at once and says what came of it. Returns whether it is there.
    bool writeNow(const QString& path, const std::function<void()>& write);

signals:
    void told(const QString& what);
    void failed(const rubble::Failure& failure);
    /// Other preferences are in force. @param before  those that were
    void preferencesChanged(const rubble::widgets::Preferences& before);

private:
    void usePreferences();

    Document m_document;
    Computation m_computation;
    widgets::Preferences m_preferences;
    QStringList m_complaints;
    std::vector<std::pair<std::type_index, std::shared_ptr<void>>> m_parts;
};

template <typename Part>
Part& Session::part() {
    const std::type_index type(typeid(Part));
    for (const auto& [known, part] : m_parts) {
        if (known == type) {
            return *static_cast<Part*>(part.get());
        }
    }
    std::shared_ptr<Part> made;
    if constexpr (std::is_constructible_v<Part, Session&>) {
        made = std::make_shared<Part>(*this);
    } else {
        made = std::make_shared<Part>();
    }
    m_parts.emplace_back(type, made);
    return *made;
}

}  // namespace rubble
