#pragma once

#include <QObject>

namespace rubble {

class Actions;
class Document;
class Playback;
namespace widgets {
class BookmarkEditor;
class Timeline;
class Transport;
}  // namespace widgets

/// Bookmarks of the case on the timeline, and the ways of playing that have a key: backwards, round a range, on states only,
/// counted from zero.
class TimelineDisplay : public QObject {
    Q_OBJECT

public:
    TimelineDisplay(Document& document, Playback& playback, widgets::Timeline& timeline, widgets::Transport& transport,
                    Actions& actions, QObject* parent = nullptr);
    ~TimelineDisplay() override;

    /// Marks the instant that is shown, or opens the bookmark that is there.
    void mark();
    void setNote(std::size_t bookmark, const QString& note);
    void remove(std::size_t bookmark);
    /// To the next bookmark, or the one before.
    void jump(bool forward);
    widgets::BookmarkEditor& editor() { return *m_editor; }

private:
    void connectActions(Actions& actions);
    void refresh();
    void edit(std::size_t bookmark);

    Document& m_document;
    Playback& m_playback;
    widgets::Timeline& m_timeline;
    widgets::BookmarkEditor* m_editor;
    std::size_t m_edited = 0;
};

}  // namespace rubble
