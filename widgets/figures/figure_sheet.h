#pragma once

#include <QImage>
#include <QSize>
#include <QString>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "widgets/figures/marks.h"
#include "widgets/figures/overlay/overlay.h"
#include "widgets/render/basics/camera.h"
#include "widgets/render/basics/scene_data.h"
#include "widgets/render/basics/view.h"
#include "widgets/render/framing.h"
#include "widgets/render/scene.h"

class QPainter;

namespace rubble::figures {

/// One picture of a figure: what a pane shows, from where and when.
struct SheetPanel {
    render::PaneContent content = render::PaneContent::Fe;
    render::View view;
    QString stage;        ///< "original", "final stage"; takes the place of the content in the caption, empty: none
    bool framed = false;  ///< its camera shows what it shows: what lies outside all the same is counted in the caption
};

/// A figure for print: panels in rows of equal columns, each with its caption below.
struct Sheet {
    int columns = 1;
    std::vector<int> choices;  ///< numbers of columns to choose from; empty: `columns`
    std::vector<SheetPanel> panels;
    bool pairs = false;         ///< panels belong together by twos, of which the second stands below the first
    bool commonLegend = false;  ///< one at the foot, without counts, instead of one below each picture
    bool framed = false;        ///< cameras are to show what the pictures show, as large as it goes, from `look`
    render::Preset look = render::Preset::Side;
    double around = 1.0;  ///< so many times what is shown is seen in plan

    int rows() const { return (static_cast<int>(panels.size()) + columns - 1) / columns; }
};

/// The panes of a view as panels.
Sheet sheetOf(const render::View& view);

/// Settles columns, cameras and, where the height of the figure is 0 pixels, that height, so that what is shown fills the pictures.
/// @param framing  of all of them
void arrange(Sheet& sheet, const render::Framing& framing, QSize& pixels, double dpi, bool provenance, bool cautions);

/// Arrangements of published figures (DESIGN.md 2.6).
enum class FigurePreset : std::uint8_t {
    Pairs,         ///< FE above, fragments below, same camera, three instants
    End,           ///< both at the end
    Surroundings,  ///< debris within terrain and surroundings
    Stages         ///< original, early, intermediate and final stage
};
inline constexpr std::array<std::pair<std::string_view, FigurePreset>, 4> figurePresets{
    {{"fe_against_fragments", FigurePreset::Pairs},
     {"at_the_end", FigurePreset::End},
     {"in_its_surroundings", FigurePreset::Surroundings},
     {"stages", FigurePreset::Stages}}};
/// The same as earlier versions called them: by the published figure of that arrangement.
inline constexpr std::array<std::pair<std::string_view, FigurePreset>, 4> numberedPresets{
    {{"11", FigurePreset::Pairs}, {"12", FigurePreset::End}, {"13", FigurePreset::Surroundings}, {"14", FigurePreset::Stages}}};

/// Where the instants of a preset come from and how its model is seen.
struct PresetRequest {
    FigurePreset preset = FigurePreset::Pairs;
    std::vector<double> times;  ///< s, on the file's clock; empty: those of the published figure, as shares of the FE result
    std::optional<render::Preset> look;  ///< unset: that of the preset
    bool camerasOfView = false;          ///< those of `like` as they are
    std::optional<render::Style> style;  ///< unset: presentation, for readers who see only the figure
    double end = 0.0;                    ///< s, last instant that can be shown
};

/// Pixels of a figure of which no size was asked for; of an arrangement the height is 0, which arrange() settles.
QSize usualSize(std::optional<FigurePreset> preset);

/// How many instants a preset shows.
std::size_t presetInstants(FigurePreset preset);

/// Gives a view a style for a picture that is handed over: materials come with shaded edges and earth without the lines of a grid;
/// colours of analysis leave all else as it is.
void dress(render::View& view, render::Style style);

/// A preset as a sheet that arrange() has yet to settle. @param like  colours, hidden parts and so on
/// Throws UsageError for another number of times than it shows.
Sheet presetSheet(const PresetRequest& request, const render::View& like, const render::SceneData& data);

/// Where the pictures of a sheet lie and how high its lines of text are, in pixels of the figure.
struct SheetLayout {
    double text = 0.0;   ///< 9 pt
    double small = 0.0;  ///< 6 pt
    int gap = 0;         ///< between columns
    int key = 0;         ///< legends below the pictures of each row; 0: none
    int caption = 0;     ///< below these
    int legend = 0;      ///< the common one; 0: none
    int cautions = 0;    ///< above the foot; 0: none
    int provenance = 0;  ///< at the foot; 0: none
    QSize panel;

    QRect panelAt(int column, int row) const;
};
/// Where the legends of a sheet stand: nothing of the pictures is covered by one that fits into a line.
enum class SheetLegend : std::uint8_t {
    None,
    Foot,  ///< one for all
    Below  ///< one below each picture
};
SheetLayout layOutSheet(int columns, int rows, SheetLegend legend, bool provenance, QSize pixels, double dpi,
                        bool cautions = false);

/// Height of two lines of cautions, pixels. @param text  height of the text of the picture
int cautionHeight(double text);
/// What must be known beside a picture, on amber, whole: in smaller letters rather than cut.
void paintCautions(QPainter& painter, const QRectF& strip, const QString& cautions, double text, render::Theme theme);

/// What a panel showed when it was drawn.
struct ShownPanel {
    render::PaneContent content = render::PaneContent::Fe;
    render::PaneStatus status;
    QString caption;  ///< "a) Conventional FE result (t = 1.68 s, computed)"
};

/// A figure that was drawn: pictures of the scene, and everything that stands over and below them as it can be painted anywhere.
class SheetPicture {
public:
    struct Panel {
        QRect place;
        QImage picture;
        render::View view;
        ShownPanel shown;
        Overlay overlay;
        std::vector<LegendEntry> legend;  ///< below the picture
        std::vector<ColourBar> bars;
        double metresPerPixel = 0.0;  ///< of the scale bar below the picture; 0: none
        std::optional<Corner> axes = Corner::UpperRight;
    };

    SheetPicture(QSize pixels, SheetLayout layout) : m_pixels(pixels), m_layout(layout) {}
    void add(Panel panel) { m_panels.push_back(std::move(panel)); }
    void setFoot(std::vector<LegendEntry> legend, std::vector<ColourBar> bars, QString provenance, QString cautions = {});

    const std::vector<Panel>& panels() const { return m_panels; }
    QSize pixels() const { return m_pixels; }
    /// Paints the figure in its pixels; text and lines stay vectors where the device keeps them.
    void paint(QPainter& painter) const;
    QImage image() const;

private:
    void paintCaptions(QPainter& painter) const;
    void paintLegends(QPainter& painter) const;
    void paintProvenance(QPainter& painter) const;
    double commonScale() const;

    QSize m_pixels;
    SheetLayout m_layout;
    std::vector<Panel> m_panels;
    std::vector<LegendEntry> m_legend;
    std::vector<ColourBar> m_bars;
    QString m_provenance;
    QString m_cautions;
};

/// Where the legends of a sheet stand.
SheetLegend legendOf(const Sheet& sheet);
/// Scale bar and legend of a panel leave its picture for the lines below; a legend that does not fit stays in the sky above the
/// debris, a scale bar stays where no line is below.
void takeMarksBelow(SheetPicture::Panel& panel, const SheetLayout& layout);

/// What a pane shows, without a time: "Conventional FE result".
QString paneName(render::PaneContent content, bool looseBodies = false);

/// "a) Conventional FE result (t = 1.68 s, computed)": the class of what is shown always stands in the brackets.
/// @param stage    instead of the name of what is shown, empty: none
/// @param outside  elements and fragments that lie outside the picture
QString captionBelow(std::size_t index, render::PaneContent content, const render::PaneStatus& status, double timeOrigin,
                     const QString& stage = {}, std::size_t outside = 0);
/// That class alone: "computed", "simulated, interpolated", "illustrative, not simulated".
QString classWords(render::PaneContent content, const render::PaneStatus& status);

/// The class of what a panel showed: "FE", "FE, interpolated between two states", "simulated", ..., "illustrative" where nothing
/// was simulated.
std::string shownAs(render::PaneContent content, const render::PaneStatus& status);

}  // namespace rubble::figures
