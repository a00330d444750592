#include <QCheckBox>
#include <QImage>

#include "app/gui/exports/picture_export.h"
#include "app/gui/stage/view_area.h"
#include "tests/app/gui/workbench.h"
#include "widgets/evidence/figure_dialog.h"
#include "widgets/views/view_widget.h"

namespace rubble {

namespace {

class FigureSelection : public FreshWorkbench {
protected:
    QImage figure(const render::View& view, bool selection) {
        widgets::FigureChoice choice;
        choice.pixels = {600, 400};
        choice.dpi = 75;
        choice.selection = selection;
        const QString path = folder.filePath(QStringLiteral("figure-%1.png").arg(++made));
        window->rooms().pictures->exportFigureTo(path, choice, view, window->rooms().scene->data());
        EXPECT_TRUE(QTest::qWaitFor([&] { return QFile::exists(path) && !session->computation().busy(); }, patience));
        return QImage(path);
    }

    QTemporaryDir folder;
    int made = 0;
};

TEST_F(FigureSelection, IsShownOnlyWhereItIsAskedFor) {
    openArch();
    render::View view = window->area().views().view();
    const QImage plain = figure(view, false);
    ASSERT_FALSE(plain.isNull());
    for (std::uint32_t e = 0; e < 4000; ++e) {
        view.selection.push_back(idAt<ElementIndex>(e));
    }
    EXPECT_EQ(figure(view, false), plain) << "as if nothing were selected";
    EXPECT_NE(figure(view, true), plain);
}

TEST_F(FigureSelection, IsAskedForInTheDialog) {
    widgets::FigureDialog dialog({});
    dialog.show();
    EXPECT_FALSE(dialog.choice().selection);
    auto* box = dialog.findChild<QCheckBox*>(QStringLiteral("figureSelection"));
    QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
    EXPECT_TRUE(dialog.choice().selection);
}

}  // namespace

}  // namespace rubble
