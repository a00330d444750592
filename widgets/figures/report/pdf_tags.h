#pragma once

#include <QString>

#include <cstddef>
#include <string>
#include <vector>

class QPainter;

namespace rubble::figures {

/// What stands on the pages of a PDF and in which order it is read: its structure tree (ISO 32000-1, 14.7). It is noted while pages
/// are painted. Qt writes no tags, so marks are painted for taggedPdf() to find: small squares of one place outside of the page,
/// whose colour is their number.
class PdfTags {
public:
    /// A structure element. Its marks lie on one page.
    struct Element {
        std::string type;                   ///< standard type: "P", "H2", "TH" (ISO 32000-1, 14.8.4)
        QString alternative;                ///< for readers who cannot see it
        QString actual;                     ///< text that a drawing stands for
        std::size_t parent = 0;             ///< index; of the first one itself
        std::vector<std::size_t> children;  ///< indices in reading order; an element has children or marks
        std::vector<std::size_t> marks;     ///< numbers, ascending from 1 in order of painting
    };

    PdfTags();

    /// Opens an element below the one that is open.
    void open(const char* type, const QString& alternative = {}, const QString& actual = {});
    void close();
    /// What is painted from here to end() belongs to the element that is open. The painter is in the coordinates of the page, and
    /// pages do not change meanwhile.
    void begin(QPainter& painter);
    void end(QPainter& painter);

    /// A heading that the outline of the file leads to. @param level  from 1; @param page  from 0
    void addBookmark(int level, const QString& title, std::size_t page) { m_bookmarks.push_back({level, title, page}); }
    struct Bookmark {
        int level = 1;
        QString title;
        std::size_t page = 0;
    };
    const std::vector<Bookmark>& bookmarks() const { return m_bookmarks; }

    /// The first one is the document.
    const std::vector<Element>& elements() const { return m_elements; }
    std::size_t marks() const { return m_marks; }

    static constexpr double markPlace = -16.0;  ///< dots, of both coordinates
    static constexpr double markSize = 8.0;     ///< dots

private:
    void paint(QPainter& painter);

    std::vector<Element> m_elements;
    std::vector<Bookmark> m_bookmarks;  ///< in reading order
    std::size_t m_open = 0;
    std::size_t m_marks = 0;
    unsigned int m_painted = 0;  ///< squares
};

/// An element that is open as long as this lives.
class PdfTag {
public:
    PdfTag(PdfTags& tags, const char* type, const QString& alternative = {}, const QString& actual = {}) : m_tags(tags) {
        m_tags.open(type, alternative, actual);
    }
    ~PdfTag() { m_tags.close(); }
    PdfTag(const PdfTag&) = delete;
    PdfTag& operator=(const PdfTag&) = delete;

private:
    PdfTags& m_tags;
};

/// What is painted while this lives belongs to the element that is open.
class PdfMark {
public:
    PdfMark(PdfTags& tags, QPainter& painter) : m_tags(tags), m_painter(painter) { m_tags.begin(m_painter); }
    ~PdfMark() { m_tags.end(m_painter); }
    PdfMark(const PdfMark&) = delete;
    PdfMark& operator=(const PdfMark&) = delete;

private:
    PdfTags& m_tags;
    QPainter& m_painter;
};

}  // namespace rubble::figures
