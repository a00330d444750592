#include "tests/support/photographed_case.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <vector>

#include "io/base/files.h"
#include "io/case/case_file.h"
#include "tests/core/evidence/camera_scene.h"

namespace rubble::cli {

void writeGreyTiff(const std::string& path, std::uint16_t width, std::uint16_t height) {
    std::vector<std::uint8_t> bytes{'I', 'I', 42, 0, 8, 0, 0, 0, 8, 0};
    const auto put = [&](std::uint32_t value, int count) {
        for (int k = 0; k < count; ++k) {
            bytes.push_back(static_cast<std::uint8_t>(value >> (8 * k)));
        }
    };
    const std::uint32_t pixels = std::uint32_t{width} * height;
    const std::uint32_t begin = 8 + 2 + 8 * 12 + 4;
    const std::array<std::array<std::uint32_t, 2>, 8> tags{
        {{256, width}, {257, height}, {258, 8}, {259, 1}, {262, 1}, {273, begin}, {278, height}, {279, pixels}}};
    for (const auto& [tag, value] : tags) {
        put(tag, 2);
        put(4, 2);
        put(1, 4);
        put(value, 4);
    }
    put(0, 4);
    bytes.resize(begin + pixels, 128);
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

void addPhotograph(Case& theCase, const std::string& path) {
    writeGreyTiff(path, 800, 600);
    theCase.inputs.push_back(
        {"photograph-1", InputRole::Photograph, std::filesystem::path(path).filename().string(), io::sha256OfFile(path)});
    CameraScene scene(3, 4, 0.0);
    scene.camera.focal = 900.0;
    scene.camera.principal = {400.0, 300.0};
    scene.camera.place = {-4.0, -12.0, 4.0};
    scene.look({3.0, 0.5, 1.0}, 0.01);
    Photograph photograph;
    photograph.input = "photograph-1";
    photograph.facts.width = photograph.camera.width = 800;
    photograph.facts.height = photograph.camera.height = 600;
    photograph.camera.focal = 900.0;
    const std::array clicks{0.4, -0.7, 0.3, 0.8, -0.5, -0.2, 0.6, -0.6};
    for (int k = 0; k < 8; ++k) {
        const Vec3 point(6.0 * (k & 1), 2.0 * ((k >> 1) & 1), 3.0 * (k >> 2));
        const std::size_t i = static_cast<std::size_t>(k);
        photograph.pairs.push_back({"corner", *scene.camera.project(point) + Eigen::Vector2d(clicks[i], clicks[7 - i]), point});
    }
    photograph.masks = {{MaskClass::Debris, {{250.0, 250.0}, {650.0, 250.0}, {650.0, 450.0}, {250.0, 450.0}}}};
    theCase.photographs = {photograph};
}

void PhotoOfCase::SetUp() {
    run({}, "2");
    m_case = io::caseForFe(m_path, m_folder / "small.rubble");
    addPhotograph(m_case, m_folder / "site.tif");
}

std::string PhotoOfCase::save() {
    const std::string path = m_folder / "small.rubble";
    io::saveCase(path, m_case);
    return path;
}

}  // namespace rubble::cli
