#include "io/exports/provenance.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "io/base/embedded_text.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/fe/fe_reader.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

using nlohmann::json;

RunOrigin origin(const std::string& fe, const std::string& sha) {
    RunOrigin from;
    from.fePath = fe;
    from.feSha256 = sha;
    from.scenarioName = "as computed";
    from.build = "build";
    from.scenario.simulation.friction = 0.5;
    return from;
}

std::string chunk(const std::string& type, const std::string& data) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) {
        bytes += static_cast<char>(data.size() >> shift & 0xff);
    }
    return bytes + type + data + "crc!";
}

std::string packed(const std::string& text) {
    uLongf size = compressBound(static_cast<uLong>(text.size()));
    std::string bytes(size, '\0');
    compress(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(text.data()),
             static_cast<uLong>(text.size()));
    bytes.resize(size);
    return bytes;
}

void write(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

TEST(Provenance, CarriesInputsScenarioBuildTimesAndClasses) {
    const ExportRecord record{
        "figure", {{"a) \xC3\x84 ]]> b", 1.5, std::nullopt, "simulated"}}, R"({"dpi":200})", R"({"time":1.5})", ""};
    const std::string text = exportProvenance(record, origin("/x/a.exo", std::string(64, 'a')), nullptr);
    EXPECT_TRUE(text.starts_with(provenanceStart));
    for (const char c : text) {
        EXPECT_TRUE(c >= 32 && c < 127) << "plain ASCII goes into any file";
    }
    EXPECT_EQ(text.find("]]>"), std::string::npos);
    const json about = json::parse(text);
    EXPECT_EQ(about["kind"], "figure");
    EXPECT_EQ(about["inputs"][0]["sha256"], std::string(64, 'a'));
    EXPECT_EQ(about["build"], "build");
    EXPECT_EQ(about["settings"]["friction"], 0.5);
    EXPECT_EQ(about["shown"][0]["class"], "simulated");
    EXPECT_EQ(about["shown"][0]["time_s"], 1.5);
    EXPECT_EQ(about["shown"][0]["name"], "a) \xC3\x84 ]]> b");
    EXPECT_EQ(about["settings_of_export"]["dpi"], 200);
}

TEST(Provenance, NamesACloudByDigestPlaceAndWhatIsDrawnOfIt) {
    const TemporaryFolder folder;
    const std::string path = folder / "scan.xyz";
    write(path, "1 2 3\n");
    const CloudStamp then = stampOf(path);
    ShownCloud cloud;
    cloud.file = shownCloudFile(path, then, Execution());
    cloud.placed = Registration{};
    cloud.placed->shift = Vec3(0.0, 0.0, 2.5);
    cloud.shown = 17;
    cloud.all = 40;
    cloud.far = 3;
    cloud.finest = 0.25;
    cloud.whole = false;
    cloud.colours = "height";
    ExportRecord record{"figure", {}, "", "", ""};
    record.clouds.push_back(cloud);
    const json about = json::parse(exportProvenance(record, origin("/x/a.exo", "5a"), nullptr));
    const json& told = about["clouds"][0];
    EXPECT_EQ(told["sha256"], sha256OfFile(path));
    EXPECT_EQ(told["path"], path);
    EXPECT_EQ(told["registration"]["shift_m"][2], 2.5);
    EXPECT_EQ(told["points_shown"], 17);
    EXPECT_EQ(told["points"], 40);
    EXPECT_EQ(told["far_points_not_drawn"], 3);
    EXPECT_EQ(told["levels_left_out"], true);
    EXPECT_EQ(told["finest_cells_m"], 0.25);
    EXPECT_EQ(about["inputs"].back(), (json{{"role", "cloud"}, {"path", path}, {"sha256", sha256OfFile(path)}}));
    EXPECT_TRUE(json::parse(exportProvenance({"figure", {}, "", "", ""}, origin("/x", "5a"), nullptr))["clouds"].empty());
    // Of a file that is another one by now no digest is that of the points.
    write(path, "1 2 3\n4 5 6\n");
    EXPECT_THROW(shownCloudFile(path, then, Execution()), WorldError);
}

TEST(Provenance, IsReadFromEveryKindOfFile) {
    const TemporaryFolder folder;
    const std::string text =
        exportProvenance({"figure", {}, "", R"({"a":{"b":"}\""}})", "/c/case.rubble"}, origin("/x/a.exo", "5a"), nullptr);
    const std::string png = "\x89PNG\r\n\x1a\n" + chunk("IHDR", "0123456789abc");
    const std::string key = std::string(provenanceKeyword) + '\0';
    write(folder / "text.png", png + chunk("tEXt", key + text) + chunk("IEND", ""));
    write(folder / "packed.png",
          png + chunk("tEXt", std::string("Software") + '\0' + "x") + chunk("zTXt", key + '\0' + packed(text)) + chunk("IEND", ""));
    write(folder / "international.png", png + chunk("iTXt", key + '\1' + '\0' + '\0' + '\0' + packed(text)) + chunk("IEND", ""));
    write(folder / "a.svg", "<svg><metadata><![CDATA[" + text + "]]></metadata></svg>");
    write(folder / "a.mp4", std::string(3 << 20, 'x') + text + std::string(1 << 20, '\0'));
    write(folder / "b.mp4", std::string((1 << 20) - 7, 'x') + text + "}}}");
    for (const char* name : {"text.png", "packed.png", "international.png", "a.svg", "a.mp4", "b.mp4"}) {
        const auto read = readProvenance(folder / name);
        ASSERT_TRUE(read) << name;
        EXPECT_EQ(read->text, text) << name;
        EXPECT_EQ(read->feSha256, "5a");
        EXPECT_EQ(read->casePath, "/c/case.rubble");
        EXPECT_EQ(json::parse(read->view)["a"]["b"], "}\"");
        EXPECT_TRUE(read->fingerprint.empty()) << "nothing was simulated";
    }
}

TEST(Provenance, FilesWithoutOneOrWithADamagedOneAreTold) {
    const TemporaryFolder folder;
    write(folder / "plain.png", "\x89PNG\r\n\x1a\n" + chunk("IHDR", "0123456789abc") + chunk("IEND", ""));
    write(folder / "cut.png", "\x89PNG\r\n\x1a\n" + chunk("tEXt", "Rubble-Prov").substr(0, 12));
    write(folder / "open.svg", std::string(provenanceStart) + "1,\"kind\":\"fig");
    write(folder / "empty", "");
    for (const char* name : {"plain.png", "cut.png", "open.svg", "empty"}) {
        EXPECT_FALSE(readProvenance(folder / name)) << name;
    }
    write(folder / "none.svg", std::string(provenanceStart) + "1,\"kind\":\"figure\"}");
    EXPECT_THROW(readProvenance(folder / "none.svg"), ParseError);
    EXPECT_THROW(readProvenance(folder / "missing.png"), WorldError);
}

TEST(Provenance, FindsTheCaseThatStandsOnTheSameFeResult) {
    const TemporaryFolder folder;
    const std::string fe = sourcePath("resources/samples/rc-arch.exo");
    const std::string sha = sha256OfFe(fe);
    std::filesystem::create_directories(folder / "figures");
    Case right = caseForFe(fe, folder / "right.rubble");
    right.inputs[0].sha256 = sha;
    right.scenarios[0].name = "as computed";
    Case wrong = right;
    wrong.inputs[0].sha256 = std::string(64, '0');
    saveCase(folder / "a-wrong.rubble", wrong);
    saveCase(folder / "right.rubble", right);
    ReadProvenance from;
    from.feSha256 = sha;
    from.fePath = fe;
    from.scenarioName = "as computed";
    from.casePath = "/gone/away.rubble";
    const Execution execution;
    const ExportSource beside = findSource(from, folder / "figures/f.png", {}, execution);
    EXPECT_TRUE(beside.isCase);
    EXPECT_EQ(beside.path, folder / "right.rubble");
    EXPECT_EQ(beside.scenarioId, "scenario-1");
    // Of two cases on the same FE result that with the scenario, wherever it lies; the nearer one of two with it.
    Case other = right;
    other.scenarios[0].name = "another";
    saveCase(folder / "figures/other.rubble", other);
    EXPECT_EQ(findSource(from, folder / "figures/f.png", {}, execution).path, folder / "right.rubble");
    saveCase(folder / "figures/z-near.rubble", right);
    EXPECT_EQ(findSource(from, folder / "figures/f.png", {}, execution).path, folder / "figures/z-near.rubble");
    // What lies above the folder of the temporary ones is not ours to know.
    const TemporaryFolder elsewhere;
    std::filesystem::create_directories(elsewhere / "figures");
    const std::vector<std::string> known{folder / "a-wrong.rubble", folder / "right.rubble"};
    from.fePath = "/gone/rc-arch.exo";
    EXPECT_EQ(findSource(from, elsewhere / "figures/f.png", known, execution).path, folder / "right.rubble");
    EXPECT_THROW(findSource(from, elsewhere / "figures/f.png", {}, execution), WorldError);
    std::filesystem::copy_file(fe, elsewhere / "figures/rc-arch.exo");
    const ExportSource bare = findSource(from, elsewhere / "figures/f.png", {}, execution);
    EXPECT_FALSE(bare.isCase);
    EXPECT_EQ(bare.path, elsewhere / "figures/rc-arch.exo");
}

}  // namespace
}  // namespace rubble::io
