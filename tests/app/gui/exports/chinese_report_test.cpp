#include <gtest/gtest.h>

#include <QRegularExpression>
#include <QSet>
#include <QTextDocumentFragment>
#include <filesystem>
#include <fstream>

#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/run/run_file.h"
#include "io/site/input_files.h"
#include "io/validation/kept_validation.h"
#include "tests/app/gui/spoken_texts.h"
#include "tests/scenes/validation_records.h"
#include "tests/support/photographed_case.h"

namespace rubble {

namespace {

/// Files, components and words of this case, keys (of effects, self-test, sets, the case file), letters of formulas, people who are
/// cited, and what the program's build says of itself.
const QSet<QString>& allowed() {
    static const QSet<QString> words = [] {
        QSet<QString> all;
        for (const QString& word :
             QStringLiteral("small other real gpkg site tif causes json Title deck girder pier Plate ContactNets tosses assumed "
                            "concrete closed form projectile bounce incline slide skid impact carry spin air water tie root "
                            "scenario scenarios bookmarks members varied format inputs active value terrain structure contact "
                            "of sin cos rho Nf NA fk rk mc SHA UTC Xu Lu Guan Ren threads paper")
                 .split(u' ')) {
            all.insert(word);
        }
        return all;
    }();
    return words;
}

/// A report with every chapter that a case can give it: photograph, survey, ensemble, repeats, self-test, validation, causes.
class ChineseReport : public cli::PhotoOfCase {
protected:
    void SetUp() override {
        cli::PhotoOfCase::SetUp();
        m_case.scenarios[0].scenario = io::openRun(m_out)->origin().scenario;
        m_case.title = "Title";
        m_case.ensemble = {{variationFrom("friction", "uniform:0.3:0.7"), variationFrom("friction_level", "uniform:0:1")}, 3, 7};
        ASSERT_EQ(cli::cli({"map", m_out, "--out", m_folder / "real.gpkg"}).exitCode, 0);
        m_case.inputs.push_back({"survey-1", InputRole::Survey, "real.gpkg", io::sha256OfFile(m_folder / "real.gpkg")});
        m_file = save();
        io::keepValidation(scenes::tossRecord(), m_folder / "cache");
    }
    /// What `compare` prints of two causes that are the same.
    std::string causes() {
        const std::string other = m_folder / "other.exo";
        std::filesystem::copy_file(m_path, other);
        const cli::Outcome compared = cli::cli({"compare", m_path, other, "--members", "2", "--set", "settle_time=0.5", "--against",
                                                "footprint=" + (m_folder / "real.gpkg"), "--cache", m_folder / "cache", "--json"});
        EXPECT_EQ(compared.exitCode, 0) << compared.err;
        std::ofstream(m_folder / "causes.json") << compared.out;
        return m_folder / "causes.json";
    }
    /// Paragraphs and cells of the page, without pictures.
    static QStringList parts(const std::string& html) {
        QString text = QString::fromStdString(html);
        static const QRegularExpression unseen(QStringLiteral("<style.*?</style>|data:[^\"')]*"),
                                               QRegularExpression::DotMatchesEverythingOption);
        static const QRegularExpression end(QStringLiteral("</(?:p|td|th|li|h\\d|figcaption|div|text|title)>"));
        text.remove(unseen);
        return text.mid(text.indexOf(QLatin1String("<body"))).split(end);
    }

    std::string m_file;
};

TEST_F(ChineseReport, HoldsNoEnglishButNamesAndKeys) {
    ASSERT_EQ(cli::cli({"ensemble", m_file, "--members", "3", "--cache", m_folder / "cache"}).exitCode, 0);
    const cli::Outcome made =
        cli::cli({"report", m_file, "--run", m_out, "--repeats", "1", "--causes", causes(), "--language", "zh_CN", "--question",
                  "?", "--by", "?", "--out", m_folder / "report", "--cache", m_folder / "cache"});
    ASSERT_EQ(made.exitCode, 0) << made.err;
    const std::string html = cli::textOf(m_folder / "report/report.html");
    QStringList names = namesIn(nullptr);
    names << QStringLiteral("Tosses of a cube") << QStringLiteral("Automation in Construction");
    int looked = 0;
    for (const QString& part : parts(html)) {
        const QString plain = QTextDocumentFragment::fromHtml(part).toPlainText();
        looked += plain.trimmed().isEmpty() ? 0 : 1;
        static const QRegularExpression key(QStringLiteral("<code>.*?</code>"));
        EXPECT_FALSE(QString(part).remove(key).contains(QLatin1String("friction_level"))) << "what is drawn has its name";
        for (const QString& word : strangeWords(plain, names)) {
            EXPECT_TRUE(allowed().contains(word)) << qPrintable(word) << " in: " << qPrintable(plain.simplified().left(300));
        }
    }
    EXPECT_GT(looked, 400);
}

}  // namespace

}  // namespace rubble
