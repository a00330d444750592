#include "widgets/figures/report/tagged_pdf.h"

// Shared pointers of the standard library alone.
#define POINTERHOLDER_TRANSITION 4
#include <qpdf/Pl_Buffer.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <qpdf/QPDFPageObjectHelper.hh>
#include <qpdf/QPDFWriter.hh>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string_view>

namespace rubble::figures {
namespace {

using Handle = QPDFObjectHandle;

/// Where a mark went.
struct PlacedMark {
    std::size_t page = 0;
    int id = 0;  ///< MCID, from 0 on each page
};

/// Goes over the operations of a page. Squares of PdfTags become the begin and end of marked content.
class Marker : public Handle::TokenFilter {
public:
    Marker(const std::vector<const PdfTags::Element*>& owners, std::vector<PlacedMark>& placed, std::size_t page)
        : m_owners(owners), m_placed(placed), m_page(page) {}

    void handleToken(const QPDFTokenizer::Token& token) override {
        m_text += token.getRawValue();
        const QPDFTokenizer::token_type_e type = token.getType();
        if (type == QPDFTokenizer::tt_integer || type == QPDFTokenizer::tt_real) {
            m_numbers.push_back(std::strtod(token.getValue().c_str(), nullptr));
        } else if (type == QPDFTokenizer::tt_word) {
            operation(token.getValue());
        }
    }
    void handleEOF() override {
        m_stretch += m_text;
        m_text.clear();
        if (m_marked || m_square) {
            throw std::runtime_error("a mark does not end on its page");
        }
        writeArtifact();
    }

private:
    void operation(const std::string& name) {
        static const std::set<std::string, std::less<>> painting{"f", "F",  "f*", "B",  "B*", "b", "b*", "S",
                                                                 "s", "sh", "Do", "Tj", "TJ", "'", "\"", "EI"};
        const bool square =
            name == "re" && m_numbers == std::vector{PdfTags::markPlace, PdfTags::markPlace, PdfTags::markSize, PdfTags::markSize};
        if (m_square && name != "f") {
            throw std::runtime_error("a mark is not painted as it was before");
        }
        if (square || m_square) {
            m_text.clear();
            if (m_square) {
                event();
            }
            m_square = square;
        } else {
            if (name == "scn") {
                m_colour = m_numbers;
            }
            m_paints = m_paints || painting.count(name) > 0;
            m_stretch += m_text;
            m_text.clear();
        }
        m_numbers.clear();
    }
    /// A square begins a mark or ends it.
    void event() {
        const std::size_t number = 2 * m_placed.size() + (m_marked ? 0 : 1);
        if (m_colour.size() != 3 || numberOf(m_colour) != number || (!m_marked && m_placed.size() >= m_owners.size())) {
            throw std::runtime_error("marks are not in their order");
        }
        m_marked = !m_marked;
        if (!m_marked) {
            write(m_stretch + "\nEMC\n");
            m_stretch.clear();
            m_paints = false;
            return;
        }
        writeArtifact();
        write("/" + m_owners[m_placed.size()]->type + " <</MCID " + std::to_string(m_next) + ">> BDC\n");
        m_placed.push_back({m_page, m_next++});
    }
    static std::size_t numberOf(const std::vector<double>& colour) {
        std::size_t number = 0;
        for (const double part : colour) {
            number = 256 * number + static_cast<std::size_t>(std::lround(255.0 * std::clamp(part, 0.0, 1.0)));
        }
        return number;
    }
    void writeArtifact() {
        write(m_paints ? "/Artifact BMC\n" + m_stretch + "\nEMC\n" : m_stretch);
        m_stretch.clear();
        m_paints = false;
    }

    const std::vector<const PdfTags::Element*>& m_owners;  ///< of each mark
    std::vector<PlacedMark>& m_placed;
    std::size_t m_page;
    int m_next = 0;
    std::string m_text;     ///< of the operation that is read
    std::string m_stretch;  ///< what was read since the last square
    std::vector<double> m_numbers;
    std::vector<double> m_colour;
    bool m_paints = false;
    bool m_marked = false;
    bool m_square = false;
};

/// What Qt says that glyphs stand for, and what is read and searched for: the glyph that spaces and tabs share is a space, and
/// ligatures are their letters.
void mendCharacters(QPDF& file) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 6> mended{{{"<0009>", "<0020>"},
                                                                                   {"<FB00>", "<00660066>"},
                                                                                   {"<FB01>", "<00660069>"},
                                                                                   {"<FB02>", "<0066006C>"},
                                                                                   {"<FB03>", "<006600660069>"},
                                                                                   {"<FB04>", "<00660066006C>"}}};
    for (Handle& object : file.getAllObjects()) {
        if (!object.isDictionaryOfType("/Font") || !object.getKey("/ToUnicode").isStream()) {
            continue;
        }
        Handle stream = object.getKey("/ToUnicode");
        const std::shared_ptr<Buffer> held = stream.getStreamData();
        std::string map(reinterpret_cast<const char*>(held->getBuffer()), held->getSize());
        // Inside of brackets stand characters, before them glyphs.
        bool characters = false;
        for (std::size_t at = 0; at < map.size(); ++at) {
            characters = map[at] == '[' || (characters && map[at] != ']');
            for (const auto& [qt, read] : mended) {
                if (characters && map.compare(at, qt.size(), qt) == 0) {
                    map.replace(at, qt.size(), read);
                }
            }
        }
        stream.replaceStreamData(map, Handle::newNull(), Handle::newNull());
    }
}

Handle pdfName(const std::string& name) {
    return Handle::newName("/" + name);
}

/// The elements as objects of the file, and what leads from the marks of each page back to them.
class Tree {
public:
    Tree(QPDF& file, const PdfTags& tags, const std::vector<PlacedMark>& placed, std::vector<Handle> pages)
        : m_file(file), m_tags(tags), m_placed(placed), m_pages(std::move(pages)), m_parents(m_pages.size(), Handle::newArray()) {
        for (Handle& each : m_parents) {
            each = file.makeIndirectObject(Handle::newArray());
        }
    }

    Handle root() {
        Handle root = m_file.makeIndirectObject(Handle::newDictionary());
        root.replaceKey("/Type", pdfName("StructTreeRoot"));
        root.replaceKey("/K", elementOf(0, root));
        Handle numbers = Handle::newArray();
        for (std::size_t p = 0; p < m_pages.size(); ++p) {
            m_pages[p].replaceKey("/StructParents", Handle::newInteger(static_cast<long long>(p)));
            numbers.appendItem(Handle::newInteger(static_cast<long long>(p)));
            numbers.appendItem(m_parents[p]);
        }
        Handle tree = m_file.makeIndirectObject(Handle::newDictionary());
        tree.replaceKey("/Nums", numbers);
        root.replaceKey("/ParentTree", tree);
        root.replaceKey("/ParentTreeNextKey", Handle::newInteger(static_cast<long long>(m_pages.size())));
        return root;
    }

private:
    Handle elementOf(std::size_t index, const Handle& parent) {
        const PdfTags::Element& element = m_tags.elements()[index];
        Handle made = m_file.makeIndirectObject(Handle::newDictionary());
        made.replaceKey("/Type", pdfName("StructElem"));
        made.replaceKey("/S", pdfName(element.type));
        made.replaceKey("/P", parent);
        if (!element.alternative.isEmpty()) {
            made.replaceKey("/Alt", Handle::newUnicodeString(element.alternative.toStdString()));
        }
        if (!element.actual.isEmpty()) {
            made.replaceKey("/ActualText", Handle::newUnicodeString(element.actual.toStdString()));
        }
        if (element.type == "TH") {
            Handle attributes = Handle::newDictionary();
            attributes.replaceKey("/O", pdfName("Table"));
            attributes.replaceKey("/Scope", pdfName("Column"));
            made.replaceKey("/A", attributes);
        }
        Handle kids = Handle::newArray();
        for (const std::size_t mark : element.marks) {
            const auto& [page, id] = m_placed[mark - 1];
            made.replaceKey("/Pg", m_pages[page]);
            kids.appendItem(Handle::newInteger(id));
            // Marks are numbered in the order in which they are met here.
            m_parents[page].appendItem(made);
        }
        for (const std::size_t child : element.children) {
            kids.appendItem(elementOf(child, made));
        }
        made.replaceKey("/K", kids);
        return made;
    }

    QPDF& m_file;
    const PdfTags& m_tags;
    const std::vector<PlacedMark>& m_placed;
    std::vector<Handle> m_pages;
    std::vector<Handle> m_parents;  ///< [page][MCID] element
};

/// Whose each mark is.
std::vector<const PdfTags::Element*> ownersOf(const PdfTags& tags) {
    std::vector<const PdfTags::Element*> owners(tags.marks(), nullptr);
    for (const PdfTags::Element& each : tags.elements()) {
        for (const std::size_t mark : each.marks) {
            owners[mark - 1] = &each;
        }
    }
    return owners;
}

std::vector<PlacedMark> markPages(QPDF& file, const PdfTags& tags, std::vector<Handle>& pages) {
    const std::vector<const PdfTags::Element*> owners = ownersOf(tags);
    std::vector<PlacedMark> placed;
    for (QPDFPageObjectHelper& page : QPDFPageDocumentHelper(file).getAllPages()) {
        Marker marker(owners, placed, pages.size());
        Pl_Buffer content("content");
        page.filterContents(&marker, &content);
        page.getObjectHandle().replaceKey("/Contents", file.newStream(content.getBufferSharedPointer()));
        pages.push_back(page.getObjectHandle());
    }
    if (placed.size() != tags.marks()) {
        throw std::runtime_error("marks are missing");
    }
    return placed;
}

/// The bookmarks as the outline that readers show beside the pages (ISO 32000-1, 12.3.3); nothing without any.
void addOutline(QPDF& file, const std::vector<PdfTags::Bookmark>& bookmarks, const std::vector<Handle>& pages) {
    if (bookmarks.empty()) {
        return;
    }
    Handle root = file.makeIndirectObject(Handle::newDictionary());
    root.replaceKey("/Type", pdfName("Outlines"));
    root.replaceKey("/Count", Handle::newInteger(static_cast<long long>(bookmarks.size())));
    // From the root down to the last item, with levels.
    std::vector<std::pair<int, Handle>> way{{0, root}};
    for (const PdfTags::Bookmark& each : bookmarks) {
        Handle item = file.makeIndirectObject(Handle::newDictionary());
        item.replaceKey("/Title", Handle::newUnicodeString(each.title.toStdString()));
        Handle place = Handle::newArray();
        place.appendItem(pages.at(each.page));
        place.appendItem(pdfName("Fit"));
        item.replaceKey("/Dest", place);
        while (way.back().first >= each.level) {
            way.pop_back();
        }
        Handle parent = way.back().second;
        item.replaceKey("/Parent", parent);
        if (parent.hasKey("/Last")) {
            Handle before = parent.getKey("/Last");
            before.replaceKey("/Next", item);
            item.replaceKey("/Prev", before);
        } else {
            parent.replaceKey("/First", item);
        }
        parent.replaceKey("/Last", item);
        for (std::size_t i = 1; i < way.size(); ++i) {
            Handle above = way[i].second;
            const long long below = above.hasKey("/Count") ? above.getKey("/Count").getIntValue() : 0;
            above.replaceKey("/Count", Handle::newInteger(below + 1));
        }
        way.emplace_back(each.level, item);
    }
    file.getRoot().replaceKey("/Outlines", root);
}

}  // namespace

QByteArray withStructure(const QByteArray& pdf, const PdfTags& tags, const QString& language) {
    QPDF file;
    file.setSuppressWarnings(true);
    file.setAttemptRecovery(false);
    file.processMemoryFile("report", pdf.constData(), static_cast<std::size_t>(pdf.size()));
    std::vector<Handle> pages;
    const std::vector<PlacedMark> placed = markPages(file, tags, pages);
    mendCharacters(file);
    Handle catalog = file.getRoot();
    catalog.replaceKey("/StructTreeRoot", Tree(file, tags, placed, pages).root());
    addOutline(file, tags.bookmarks(), pages);
    Handle marked = Handle::newDictionary();
    marked.replaceKey("/Marked", Handle::newBool(true));
    catalog.replaceKey("/MarkInfo", marked);
    catalog.replaceKey("/Lang", Handle::newUnicodeString(language.toStdString()));
    Handle viewer = Handle::newDictionary();
    viewer.replaceKey("/DisplayDocTitle", Handle::newBool(true));
    catalog.replaceKey("/ViewerPreferences", viewer);
    QPDFWriter writer(file);
    writer.setOutputMemory();
    writer.setMinimumPDFVersion("1.7");
    writer.setObjectStreamMode(qpdf_o_generate);
    writer.write();
    const std::shared_ptr<Buffer> made = writer.getBufferSharedPointer();
    return {reinterpret_cast<const char*>(made->getBuffer()), static_cast<qsizetype>(made->getSize())};
}

QByteArray taggedPdf(const QByteArray& pdf, const PdfTags& tags, const QString& language, Findings& findings) {
    try {
        return withStructure(pdf, tags, language);
    } catch (const std::exception& error) {
        findings.add({"report.untagged", "The report as PDF has no tags for screen readers: {0}", {error.what()}},
                     {"report.untagged.remedy", "Hand over report.html beside it, which has them.", {}});
        return pdf;
    }
}

}  // namespace rubble::figures
