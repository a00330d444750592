#include "widgets/figures/view_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "core/base/error.h"

namespace rubble::figures {
namespace {

render::View randomView(std::mt19937& engine) {
    std::normal_distribution<double> n(0.0, 100.0);
    const auto pick = [&](int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine); };
    render::View view;
    view.layout = static_cast<render::Layout>(pick(6));
    for (render::Camera& camera : view.cameras) {
        camera.position = Vec3(n(engine), n(engine), n(engine));
        camera.focalPoint = Vec3(n(engine), n(engine), n(engine));
        camera.up = Vec3(n(engine), n(engine), n(engine));
        camera.viewAngle = 1.0 + std::abs(std::fmod(n(engine), 170.0));
        camera.parallel = pick(2) == 1;
        camera.parallelScale = 1e-3 + std::abs(n(engine));
    }
    view.camerasLinked = pick(2) == 1;
    view.time = n(engine);
    view.timeOrigin = n(engine);
    view.colourBy = static_cast<render::ColourBy>(pick(7));
    view.theme = static_cast<render::Theme>(pick(3));
    view.colourMap = static_cast<render::ColourMap>(pick(4));
    view.style = static_cast<render::Style>(pick(2));
    view.ground = pick(2) == 1;
    view.groundGrid = pick(2) == 1;
    view.shading = pick(2) == 1;
    view.shadows = pick(2) == 1;
    view.cloud = pick(2) == 1 ? "survey-1" : "";
    view.pointColour = static_cast<render::PointColour>(pick(4));
    view.axes = pick(2) == 1;
    view.captions = pick(2) == 1;
    view.legends = pick(2) == 1;
    view.scaleBar = pick(2) == 1;
    if (pick(2) == 1) {
        view.basicGrid = {1e-3 + std::abs(n(engine)), 1e-3 + std::abs(n(engine)), 1e-3 + std::abs(n(engine))};
    }
    view.errorSteps.clear();
    for (int i = pick(4); i >= 0; --i) {
        view.errorSteps.push_back(1e-3 + std::abs(n(engine)) + (view.errorSteps.empty() ? 0.0 : view.errorSteps.back()));
    }
    for (int i = pick(4); i > 0; --i) {
        view.selection.push_back(idAt<ElementIndex>(static_cast<std::size_t>(pick(1000000))));
    }
    const auto point = [&] { return Vec3(n(engine), n(engine), n(engine)); };
    for (int i = pick(3); i > 0; --i) {
        view.hidden.push_back(idAt<ElementIndex>(static_cast<std::size_t>(pick(1000000))));
        view.hiddenComponents.push_back("deck, \"" + std::to_string(i) + "\"");
        view.componentColours["pier " + std::to_string(pick(9))] = {static_cast<std::uint8_t>(pick(256)), 7, 0};
        view.measurements.push_back({point(), point(), pick(2) == 1});
        view.path.push_back(point());
    }
    if (pick(2) == 1) {
        view.clip = render::ClipPlane{point(), point().normalized()};
    }
    for (render::FilterRange* range : {&view.filter.speed, &view.filter.mass, &view.filter.size, &view.filter.birth}) {
        range->low = pick(2) == 1 ? std::optional(n(engine)) : std::nullopt;
        range->high = pick(2) == 1 ? std::optional(n(engine)) : std::nullopt;
    }
    view.filter.component = pick(2) == 1 ? "deck \"1\"" : "";
    return view;
}

TEST(ViewJson, ReadsBackEveryBit) {
    std::mt19937 engine(5);
    for (int i = 0; i < 200; ++i) {
        const render::View view = randomView(engine);
        EXPECT_EQ(viewFromJson(toJson(view), "view"), view);
        EXPECT_EQ(toJson(viewFromJson(toJson(view), "view")), toJson(view));
    }
}

TEST(ViewJson, MissingKeysKeepTheirDefaults) {
    EXPECT_EQ(viewFromJson("{}", "view"), render::View{});
    render::View view;
    view.time = 5.76;
    EXPECT_EQ(viewFromJson(R"({"time": 5.76})", "view"), view);
}

TEST(ViewJson, RefusesWhatItCannotReadAndSaysWhere) {
    const auto complaint = [](const std::string& json) -> std::string {
        try {
            viewFromJson(json, "case.rubble");
        } catch (const ParseError& error) {
            EXPECT_FALSE(error.remedy().empty());
            return error.what();
        }
        return "accepted";
    };
    for (const auto& [json, place] : {std::pair<std::string, std::string>{"", "JSON"},
                                      {"{\"time\": 1", "JSON"},
                                      {"[1, 2]", "JSON"},
                                      {R"({"rubble_view": 99})", "version"},
                                      {R"({"time": "late"})", "time"},
                                      {R"({"layout": "round"})", "layout"},
                                      {R"({"colour_by": 3})", "colour_by"},
                                      {R"({"ground": 1})", "ground"},
                                      {R"({"cameras": [{}]})", "cameras"},
                                      {R"({"colour_map": "rainbow"})", "colour_map"},
                                      {R"({"clip": {"normal": [0, 0, 0]}})", "clip.normal"},
                                      {R"({"clip": 3})", "clip"},
                                      {R"({"hidden": [1.5]})", "hidden"},
                                      {R"({"filter": 3})", "filter"},
                                      {R"({"filter": {"mass": [1]}})", "filter.mass"},
                                      {R"({"filter": {"speed": ["fast", 2]}})", "filter.speed"},
                                      {R"({"filter": {"component": 3}})", "filter.component"},
                                      {R"({"hidden_components": [3]})", "hidden_components"},
                                      {R"({"component_colours": {"deck": "blue"}})", "component_colours.deck"},
                                      {R"({"measurements": [{}, {"from": [1]}]})", "measurements[1].from"},
                                      {R"({"path": [[1, 2]]})", "path.point"},
                                      {R"({"cameras": [{}, {"view_angle": 0}]})", "cameras[1].view_angle"},
                                      {R"({"cameras": [{"position": [1, 2]}, {}]})", "cameras[0].position"},
                                      {R"({"cameras": [{"position": [0, 0, 0]}, {}]})", "cameras[0]"},
                                      {R"({"cameras": [{"parallel_scale": -1}, {}]})", "cameras[0].parallel_scale"},
                                      {R"({"selection": [1.5]})", "selection"},
                                      {R"({"basic_grid": [1, 2]})", "basic_grid"},
                                      {R"({"basic_grid": [1, 2, 0]})", "basic_grid"},
                                      {R"({"error_steps": []})", "error_steps"},
                                      {R"({"error_steps": [0.2, 0.1]})", "error_steps"},
                                      {R"({"selection": 4})", "selection"}}) {
        const std::string text = complaint(json);
        EXPECT_NE(text.find("case.rubble"), std::string::npos) << json << ": " << text;
        EXPECT_NE(text.find(place), std::string::npos) << json << ": " << text;
    }
}

}  // namespace
}  // namespace rubble::figures
