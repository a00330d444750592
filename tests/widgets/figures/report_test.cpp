#include <gtest/gtest.h>

#include <QPainter>

// Shared pointers of the standard library alone.
#define POINTERHOLDER_TRANSITION 4
#include <cmath>
#include <fstream>
#include <qpdf/QPDF.hh>

#include "tests/support/temporary_folder.h"
#include "widgets/figures/figure_file.h"
#include "widgets/figures/report/formula.h"
#include "widgets/figures/report/report_chart.h"
#include "widgets/figures/report/report_document.h"
#include "widgets/figures/report/report_sections.h"

namespace rubble::figures {
namespace {

class Report : public testing::Test {
protected:
    static void SetUpTestSuite() { ensureGuiApplication(); }
};

TEST_F(Report, FractionsStandAboveTheLineAndSubscriptsBelow) {
    const SetFormula plain = setFormula("x", 20.0);
    const SetFormula fraction = setFormula("\\frac{a}{b}", 20.0);
    EXPECT_GT(fraction.ascent, 1.3 * plain.ascent);
    EXPECT_GT(fraction.descent, plain.descent + 5.0);
    const SetFormula below = setFormula("x_{i}", 20.0);
    EXPECT_GT(below.descent, plain.descent);
    EXPECT_GT(below.width, plain.width);
    EXPECT_GT(setFormula("x^{2}", 20.0).ascent, plain.ascent);
    EXPECT_GT(setFormula("\\sqrt[3]{x}", 20.0).width, plain.width + 5.0);
    EXPECT_GT(setFormula("\\sum_{i}^{n} x", 20.0).ascent, setFormula("\\sum x", 20.0).ascent);
}

TEST_F(Report, HalfAFormulaIsSetAsFarAsItGoes) {
    for (const char* notation : {"", "\\frac{a}", "\\frac{a}{", "x_", "\\", "{{{", "}}}", "\\sqrt[3", "\\text{open", "\\nothing"}) {
        const SetFormula set = setFormula(QString::fromUtf8(notation), 20.0);
        EXPECT_GE(set.width, 0.0) << notation;
    }
    EXPECT_TRUE(formulaSvg("m < 3", 12.0, "m less than \"3\"").contains("m less than &quot;3&quot;"));
}

TEST_F(Report, NumbersShowNoMoreDigitsThanTheirRangeDeserves) {
    EXPECT_EQ(reportNumber(12345.678).toStdString(), "12,300");
    EXPECT_EQ(reportNumber(0.012345).toStdString(), "0.0123");
    EXPECT_EQ(reportNumber(-2.5, 2).toStdString(), "\u22122.5");
    EXPECT_EQ(reportNumber(std::nan("")).toStdString(), "\u2013");
    EXPECT_EQ(reportNumber(1.5e-9).toStdString(), "1.50 \u00d7 10<sup>-9</sup>");
    EXPECT_EQ(rangedNumber(123.456, {122.1, 124.9}).toStdString(), "123.5 (122.1 to 124.9)");
    EXPECT_EQ(rangedNumber(123.456, {100.0, 150.0}).toStdString(), "123 (100 to 150)");
    EXPECT_EQ(rangedNumber(123.456, {123.456, 123.456}).toStdString(), "123");
}

ReportDocument smallReport() {
    ReportDocument document;
    document.title = "Bridge & river";
    document.contents = "Contents";
    document.page = "page %1 of %2";
    document.figure = "Figure %1";
    document.table = "Table %1";
    document.language = "en";
    ReportTable table;
    table.caption = "Numbers";
    table.columns = QStringList{"name", "value"};
    for (int i = 0; i < 120; ++i) {
        table.rows.push_back({QString("row %1").arg(i), QString::number(i)});
    }
    ReportFigure chart;
    chart.caption = "A chart";
    chart.words = "A \"chart\" in words";
    chart.paint = [](QPainter& painter, const QRectF& area, double text) {
        ReportChart drawn;
        drawn.series = {{"line", Qt::red, true, false, {{0.0, 1.0, {}}, {1.0, 2.0, "end"}}}};
        drawn.paint(painter, area, text);
    };
    document.blocks = {ReportHeading{1, "First", false},
                       ReportText{"Some <b>text</b>."},
                       ReportHeading{2, "Part", false},
                       ReportEquation{"a = \\frac{b}{c}", "a is b over c", ""},
                       table,
                       chart,
                       ReportNotice{"Look."},
                       ReportList{{"one", "two"}},
                       ReportHeading{1, "Appendix", true}};
    return document;
}

TEST_F(Report, HeadingsAreNumbered) {
    const auto headings = numberedHeadings(smallReport());
    ASSERT_EQ(headings.size(), 3u);
    EXPECT_EQ(headings[0].second, "1  First");
    EXPECT_EQ(headings[1].second, "1.1  Part");
    EXPECT_EQ(headings[2].second, "A  Appendix");
}

TEST_F(Report, HtmlNeedsNothingElse) {
    const QString html = QString::fromUtf8(reportHtml(smallReport(), R"({"rubble_provenance":1,"x":"</script>"})"));
    EXPECT_TRUE(html.contains("Bridge &amp; river"));
    EXPECT_TRUE(html.contains("row 119"));
    EXPECT_EQ(html.count("<svg"), 2) << "the equation and the chart";
    EXPECT_TRUE(html.contains("<b>Table 1.</b> Numbers"));
    EXPECT_TRUE(html.contains("<b>Figure 1.</b> A chart"));
    EXPECT_TRUE(html.contains("<svg role=\"img\" aria-label=\"A &quot;chart&quot; in words\"")) << "for who cannot see it";
    EXPECT_TRUE(html.contains("<title>A &quot;chart&quot; in words</title>"));
    EXPECT_EQ(html.count("</script>"), 1);
    for (const char* outside : {"src=\"http", "href=\"http", "@import", "url("}) {
        EXPECT_FALSE(html.contains(outside)) << outside;
    }
    EXPECT_TRUE(html.contains("href=\"#s2\"") && html.contains("id=\"s2\""));
    EXPECT_TRUE(html.contains("<th scope=\"col\" class=\"w\">name</th><th scope=\"col\">value</th>")) << "columns have their heads";
}

std::size_t pagesIn(const std::string& path) {
    QPDF file;
    file.processFile(path.c_str());
    return file.getAllPages().size();
}

/// Pages of a report of so many lines, a heading and a table of so many rows.
std::size_t pagesOf(int lines, int rows) {
    ReportDocument document = smallReport();
    ReportTable table;
    table.columns = QStringList{"name", "value"};
    for (int i = 0; i < rows; ++i) {
        table.rows.push_back({"row", "1"});
    }
    document.blocks.clear();
    for (int i = 0; i < lines; ++i) {
        document.blocks.emplace_back(ReportText{"One line."});
    }
    document.blocks.insert(document.blocks.end(), {ReportHeading{1, "Heading", false}, table});
    const io::TemporaryFolder folder;
    Findings findings;
    writeReportPdf(folder / "report.pdf", document, "{}", findings);
    return pagesIn(folder / "report.pdf");
}

TEST_F(Report, AHeadingGoesWithItsTableAndAShortTableIsNotBroken) {
    // First page, contents, text. How many lines fit on the page with the heading and a table of one row, and of ten?
    const auto mostLines = [](int rows) {
        int lines = 1;
        while (pagesOf(lines + 1, rows) == 3) {
            ++lines;
        }
        return lines;
    };
    const int withOne = mostLines(1);
    const int withTen = mostLines(10);
    EXPECT_GT(withTen, 10);
    // Nine rows more take the place of lines: none of them goes to the next page alone.
    EXPECT_GT(withOne - withTen, 5);
    EXPECT_LT(withOne - withTen, 10);
    // A long table fills the page that it begins on.
    EXPECT_EQ(pagesOf(20, 60), 4U) << "from below the lines to the next page";
}

TEST_F(Report, PdfHasItsPagesAndItsProvenance) {
    const io::TemporaryFolder folder;
    const std::string path = folder / "report.pdf";
    Findings findings;
    writeReportPdf(path, smallReport(), R"({"rubble_provenance":1,"kind":"report"})", findings);
    EXPECT_TRUE(findings.empty());
    std::ifstream in(path, std::ios::binary);
    const std::string pdf(std::istreambuf_iterator<char>(in), {});
    EXPECT_TRUE(pdf.starts_with("%PDF"));
    EXPECT_NE(pdf.find(R"({"rubble_provenance":1,"kind":"report"})"), std::string::npos);
    EXPECT_GE(pagesIn(path), 5u) << "first page, contents, and a table of 120 rows over several pages";
}

}  // namespace
}  // namespace rubble::figures
