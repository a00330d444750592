#include "widgets/figures/report/tagged_pdf.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QPainter>

// Shared pointers of the standard library alone.
#define POINTERHOLDER_TRANSITION 4
#include <algorithm>
#include <map>
#include <qpdf/Pl_Buffer.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <qpdf/QPDFPageObjectHelper.hh>
#include <set>

#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"
#include "widgets/figures/figure_file.h"
#include "widgets/figures/report/report_document.h"

namespace rubble::figures {
namespace {

using testing::ElementsAre;

/// A report with one block of each kind. Its first table goes over pages and has an empty cell.
ReportDocument oneOfEach(const QString& language) {
    ReportDocument document;
    const bool chinese = language.startsWith("zh");
    document.title = chinese ? QStringLiteral("桥梁 & 河") : QStringLiteral("Bridge & river");
    document.subtitle = "Where it fell";
    document.facts = {{"Run", "<code>1a2b</code>"}, {"Program", "0.2"}};
    document.header = "header of each page";
    document.contents = chinese ? QStringLiteral("目录") : QStringLiteral("Contents");
    document.page = "page %1 of %2";
    document.figure = "Figure %1";
    document.table = "Table %1";
    document.language = language;
    ReportTable table;
    table.caption = "Numbers";
    table.columns = QStringList{"name", "value"};
    for (int i = 0; i < 120; ++i) {
        table.rows.push_back({QString("row %1").arg(i), i == 7 ? QString() : QString::number(i)});
    }
    table.source = "From run 1a2b";
    ReportFigure drawn;
    drawn.caption = "Mass in t/m<sup>2</sup>";
    drawn.words = drawn.caption;
    drawn.paint = [](QPainter& painter, const QRectF& area, double) { painter.drawText(area.center(), "inside"); };
    ReportFigure picture;
    picture.words = chinese ? QStringLiteral("桥在左") : QStringLiteral("The bridge is left");
    picture.picture = QImage(40, 20, QImage::Format_RGB32);
    picture.picture.fill(Qt::red);
    document.blocks = {ReportHeading{1, "First", false},
                       ReportText{"Some <b>text</b>."},
                       ReportText{QStringLiteral("Words find no end over lines. ").repeated(20).trimmed()},
                       ReportHeading{2, "Part", false},
                       ReportEquation{"a = \\frac{b}{c}", "a is b over c", "where a is"},
                       table,
                       drawn,
                       ReportNotice{"Look."},
                       ReportList{{"one", "two"}},
                       picture,
                       ReportHeading{1, "Appendix", true},
                       table};
    return document;
}

/// What a reader of tags finds in a file.
class TagsOf {
public:
    explicit TagsOf(const std::string& path) {
        m_file.processFile(path.c_str());
        for (QPDFPageObjectHelper& page : QPDFPageDocumentHelper(m_file).getAllPages()) {
            m_pages.push_back(page.getObjectHandle());
            readMarks(page);
        }
        walk(catalog().getKey("/StructTreeRoot").getKey("/K"), "");
    }

    QPDFObjectHandle catalog() { return m_file.getRoot(); }
    QPDF& file() { return m_file; }
    /// Elements of a type in reading order.
    std::vector<QPDFObjectHandle> all(const std::string& type) const {
        std::vector<QPDFObjectHandle> found;
        std::ranges::copy_if(m_elements, std::back_inserter(found),
                             [&](QPDFObjectHandle e) { return e.getKey("/S").getName() == type; });
        return found;
    }
    std::vector<std::string> texts(const std::string& type, const std::string& key) const {
        std::vector<std::string> found;
        for (QPDFObjectHandle& each : all(type)) {
            found.push_back(each.hasKey(key) ? each.getKey(key).getUTF8Value() : "");
        }
        return found;
    }
    /// Every type with its way from the root, once each: "Document/Table/THead/TR/TH".
    const std::set<std::string>& ways() const { return m_ways; }
    /// [page] MCIDs in order of painting, and those that the tree names.
    const std::map<std::size_t, std::vector<int>>& painted() const { return m_painted; }
    const std::map<std::size_t, std::multiset<int>>& named() const { return m_named; }
    /// [page] MCIDs in the order in which the tree is read.
    const std::map<std::size_t, std::vector<int>>& read() const { return m_read; }
    /// Types of what stands in the document itself, in the order in which it is read.
    std::vector<std::string> parts() {
        std::vector<std::string> types;
        for (QPDFObjectHandle& kid : all("/Document").front().getKey("/K").getArrayAsVector()) {
            types.push_back(kid.getKey("/S").getName().substr(1));
        }
        return types;
    }
    int unmarked() const { return m_unmarked; }
    int wrongParents() const { return m_wrongParents; }

private:
    /// Counts painting outside of marked content.
    class Reader : public QPDFObjectHandle::ParserCallbacks {
    public:
        void handleObject(QPDFObjectHandle object) override {
            if (!object.isOperator()) {
                operands.push_back(object);
                return;
            }
            const std::string name = object.getOperatorValue();
            // Qt says inside of marks what text its glyphs stand for.
            if (name == "BDC" && operands.back().hasKey("/MCID")) {
                EXPECT_EQ(depth, 0);
                ids.push_back(operands.back().getKey("/MCID").getIntValueAsInt());
            }
            depth += name == "BDC" || name == "BMC" ? 1 : name == "EMC" ? -1 : 0;
            const bool paints = name == "f" || name == "S" || name == "B" || name == "Tj" || name == "Do";
            unmarked += depth == 0 && paints ? 1 : 0;
            operands.clear();
        }
        void handleEOF() override {}
        std::vector<QPDFObjectHandle> operands;
        std::vector<int> ids;
        int depth = 0;
        int unmarked = 0;
    };
    void readMarks(QPDFPageObjectHelper& page) {
        Reader reader;
        page.parseContents(&reader);
        EXPECT_EQ(reader.depth, 0);
        m_unmarked += reader.unmarked;
        m_painted[m_pages.size() - 1] = reader.ids;
    }
    void walk(QPDFObjectHandle element, const std::string& way) {
        const std::string here = way + (way.empty() ? "" : "/") + element.getKey("/S").getName().substr(1);
        m_ways.insert(here);
        m_elements.push_back(element);
        for (QPDFObjectHandle& kid : element.getKey("/K").getArrayAsVector()) {
            if (!kid.isInteger()) {
                m_wrongParents += kid.getKey("/P").getObjGen() == element.getObjGen() ? 0 : 1;
                walk(kid, here);
                continue;
            }
            const auto page = std::ranges::find_if(
                m_pages, [&](const QPDFObjectHandle& each) { return each.getObjGen() == element.getKey("/Pg").getObjGen(); });
            ASSERT_NE(page, m_pages.end());
            const int id = kid.getIntValueAsInt();
            m_named[static_cast<std::size_t>(page - m_pages.begin())].insert(id);
            m_read[static_cast<std::size_t>(page - m_pages.begin())].push_back(id);
            // The way back from the page leads here.
            const int parents = page->getKey("/StructParents").getIntValueAsInt();
            QPDFObjectHandle numbers = catalog().getKey("/StructTreeRoot").getKey("/ParentTree").getKey("/Nums");
            QPDFObjectHandle back = numbers.getArrayItem(2 * parents + 1).getArrayItem(id);
            m_wrongParents += back.getObjGen() == element.getObjGen() ? 0 : 1;
        }
    }

    QPDF m_file;
    std::vector<QPDFObjectHandle> m_pages;
    std::vector<QPDFObjectHandle> m_elements;
    std::set<std::string> m_ways;
    std::map<std::size_t, std::vector<int>> m_painted;
    std::map<std::size_t, std::multiset<int>> m_named;
    std::map<std::size_t, std::vector<int>> m_read;
    int m_unmarked = 0;
    int m_wrongParents = 0;
};

class TaggedPdf : public testing::Test {
protected:
    static void SetUpTestSuite() { ensureGuiApplication(); }
    std::string written(const QString& language) {
        Findings findings;
        writeReportPdf(m_path, oneOfEach(language), "{}", findings);
        EXPECT_TRUE(findings.empty());
        return m_path;
    }
    io::TemporaryFolder m_folder;
    std::string m_path = m_folder / "report.pdf";
};

TEST_F(TaggedPdf, EveryMarkIsOnceInTheTreeAndAllElseIsAnArtifact) {
    TagsOf tags(written("en"));
    EXPECT_GE(tags.painted().size(), 8U) << "pages";
    std::size_t marks = 0;
    for (const auto& [page, ids] : tags.painted()) {
        for (std::size_t i = 0; i < ids.size(); ++i) {
            EXPECT_EQ(ids[i], static_cast<int>(i)) << "page " << page;
        }
        ASSERT_TRUE(ids.empty() || tags.named().contains(page)) << page;
        if (!ids.empty()) {
            EXPECT_EQ(tags.named().at(page), std::multiset<int>(ids.begin(), ids.end())) << "page " << page;
        }
        marks += ids.size();
    }
    EXPECT_GT(marks, 480U) << "cells of both tables";
    EXPECT_EQ(tags.unmarked(), 0);
    EXPECT_EQ(tags.wrongParents(), 0);
    // Where lines meet, words are not run together; spaces are spaces, and ligatures letters.
    EXPECT_THAT(tags.texts("/P", "/ActualText"),
                testing::Contains(testing::HasSubstr("lines. Words find no end over lines. Words")));
    for (QPDFObjectHandle& object : tags.file().getAllObjects()) {
        if (object.isDictionaryOfType("/Font") && object.getKey("/ToUnicode").isStream()) {
            const auto map = object.getKey("/ToUnicode").getStreamData();
            const std::string text(reinterpret_cast<const char*>(map->getBuffer()), map->getSize());
            EXPECT_EQ(text.find(" <0009>", text.find('[')), std::string::npos) << "no tab";
            EXPECT_EQ(text.find("<FB01>"), std::string::npos) << "no ligature";
        }
    }
}

TEST_F(TaggedPdf, HeadingsTablesListsAndFiguresAreNamedInBothLanguages) {
    std::set<std::string> english;
    for (const QString language : {"en", "zh-CN"}) {
        SCOPED_TRACE(language.toStdString());
        TagsOf tags(written(language));
        EXPECT_EQ(tags.catalog().getKey("/Lang").getUTF8Value(), language.toStdString());
        EXPECT_TRUE(tags.catalog().getKey("/MarkInfo").getKey("/Marked").getBoolValue());
        EXPECT_TRUE(tags.catalog().getKey("/ViewerPreferences").getKey("/DisplayDocTitle").getBoolValue());
        EXPECT_EQ(tags.file().getTrailer().getKey("/Info").getKey("/Title").getUTF8Value(),
                  oneOfEach(language).title.toStdString());
        EXPECT_EQ(tags.all("/H1").size(), 1U);
        EXPECT_EQ(tags.all("/H2").size(), 3U) << "contents, first, appendix";
        EXPECT_EQ(tags.all("/H3").size(), 1U);
        EXPECT_EQ(tags.all("/TOCI").size(), 3U);
        EXPECT_EQ(tags.all("/Table").size(), 2U);
        EXPECT_EQ(tags.all("/TH").size(), 4U) << "heads on further pages are not read again";
        for (QPDFObjectHandle& each : tags.all("/TH")) {
            EXPECT_EQ(each.getKey("/A").getKey("/Scope").getName(), "/Column");
        }
        EXPECT_EQ(tags.all("/TR").size(), 242U);
        EXPECT_EQ(tags.all("/TD").size(), 480U) << "empty ones too";
        EXPECT_THAT(tags.texts("/Figure", "/Alt"), ElementsAre("Mass in t/m2", language == "en" ? "The bridge is left" : "桥在左"));
        EXPECT_THAT(tags.texts("/Formula", "/Alt"), ElementsAre("a is b over c"));
        for (const char* way : {"Document/H2", "Document/L/LI/Lbl", "Document/L/LI/LBody", "Document/TOC/TOCI/Reference",
                                "Document/Table/Caption", "Document/Table/THead/TR/TH", "Document/Table/TBody/TR/TD",
                                "Document/Div/Figure", "Document/Div/Caption", "Document/P/Formula"}) {
            EXPECT_TRUE(tags.ways().contains(way)) << way;
        }
        EXPECT_EQ(english.empty() ? tags.ways() : english, tags.ways());
        english = tags.ways();
    }
}

// Readers of tags go by the tree, all others by the order of painting: both are that of the document, in each language.
TEST_F(TaggedPdf, IsReadInTheOrderOfTheDocument) {
    for (const QString language : {"en", "zh-CN"}) {
        SCOPED_TRACE(language.toStdString());
        TagsOf tags(written(language));
        const std::vector<std::string> parts = tags.parts();
        const auto first = std::ranges::find(parts, std::string("TOC"));
        ASSERT_NE(first, parts.end()) << "after the cover";
        EXPECT_THAT(std::vector<std::string>(first + 1, parts.end()),
                    ElementsAre("H2", "P", "P", "H3", "P", "Table", "P", "Div", "P", "L", "Div", "H2", "Table", "P"));
        for (const auto& [page, ids] : tags.read()) {
            EXPECT_TRUE(std::ranges::is_sorted(ids)) << "page " << page;
        }
    }
}

/// Titles of an outline with their depth, and the page that each leads to.
struct OutlineRow {
    int depth = 0;
    std::string title;
    std::size_t page = 0;
};

void readOutline(QPDFObjectHandle parent, int depth, const std::vector<QPDFObjectHandle>& pages, std::vector<OutlineRow>& rows) {
    QPDFObjectHandle before;
    for (QPDFObjectHandle item = parent.getKey("/First"); item.isDictionary(); item = item.getKey("/Next")) {
        EXPECT_EQ(item.getKey("/Parent").getObjGen(), parent.getObjGen());
        EXPECT_TRUE(!before.isInitialized() || item.getKey("/Prev").getObjGen() == before.getObjGen());
        const auto page = std::ranges::find_if(pages, [&](const QPDFObjectHandle& each) {
            return each.getObjGen() == item.getKey("/Dest").getArrayItem(0).getObjGen();
        });
        rows.push_back({depth, item.getKey("/Title").getUTF8Value(), static_cast<std::size_t>(page - pages.begin())});
        const std::size_t own = rows.size();
        readOutline(item, depth + 1, pages, rows);
        if (rows.size() > own) {
            EXPECT_EQ(item.getKey("/Count").getIntValue(), static_cast<long long>(rows.size() - own));
        }
        before = item;
    }
    if (before.isInitialized()) {
        EXPECT_EQ(parent.getKey("/Last").getObjGen(), before.getObjGen());
    }
}

TEST_F(TaggedPdf, AnOutlineLeadsToEveryHeadingAndTheTitleIsInTheMetadata) {
    for (const QString language : {"en", "zh-CN"}) {
        SCOPED_TRACE(language.toStdString());
        TagsOf tags(written(language));
        std::vector<QPDFObjectHandle> pages;
        for (QPDFPageObjectHelper& page : QPDFPageDocumentHelper(tags.file()).getAllPages()) {
            pages.push_back(page.getObjectHandle());
        }
        QPDFObjectHandle outlines = tags.catalog().getKey("/Outlines");
        ASSERT_TRUE(outlines.isDictionary());
        std::vector<OutlineRow> rows;
        readOutline(outlines, 1, pages, rows);
        ASSERT_EQ(rows.size(), 3U);
        EXPECT_EQ(outlines.getKey("/Count").getIntValue(), 3);
        EXPECT_EQ(rows[0].title, "1 First");
        EXPECT_EQ(rows[1].title, "1.1 Part");
        EXPECT_EQ(rows[2].title, "A Appendix");
        EXPECT_EQ(rows[0].depth, 1);
        EXPECT_EQ(rows[1].depth, 2);
        EXPECT_EQ(rows[2].depth, 1);
        EXPECT_EQ(rows[0].page, 2U) << "after cover and contents";
        EXPECT_LE(rows[0].page, rows[1].page);
        EXPECT_LT(rows[1].page, rows[2].page);
        ASSERT_LT(rows[2].page, pages.size());
        const auto held = tags.catalog().getKey("/Metadata").getStreamData();
        const std::string metadata(reinterpret_cast<const char*>(held->getBuffer()), held->getSize());
        const std::string title = oneOfEach(language).title.toHtmlEscaped().toStdString();
        EXPECT_THAT(metadata, testing::HasSubstr("<rdf:li xml:lang='x-default'>" + title + "</rdf:li>"));
    }
}

TEST_F(TaggedPdf, WhatCannotBeTaggedIsWrittenAsItIsAndTold) {
    PdfTags tags;
    tags.open("P");
    for (const QByteArray& pdf : {QByteArray("no PDF"), QByteArray::fromStdString(io::wholeFile(written("en")))}) {
        Findings findings;
        // What is tagged already holds no squares: the mark that is asked for is missing.
        QImage page(10, 10, QImage::Format_RGB32);
        QPainter painter(&page);
        tags.begin(painter);
        tags.end(painter);
        EXPECT_EQ(taggedPdf(pdf, tags, "en", findings), pdf);
        ASSERT_EQ(findings.count("report.untagged"), 1);
        EXPECT_FALSE(englishText(findings.list()[0].what).empty());
    }
}

}  // namespace
}  // namespace rubble::figures
