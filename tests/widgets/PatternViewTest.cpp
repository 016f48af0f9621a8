#include "DesignFile.h"
#include "Document.h"
#include "PatternView.h"
#include "Picture.h"
#include "ProblemSet.h"
#include "Selection.h"

#include <QTest>

#include <gtest/gtest.h>

namespace bolster {
namespace {

class PatternViewTest : public testing::Test
{
protected:
    PatternViewTest()
    {
        view.resize(900, 700);
        view.show();
    }

    void open(const QString& sample)
    {
        const OpenedDesign opened =
            openDesign(QStringLiteral(BOLSTER_SAMPLES "/%1/%1.json").arg(sample));
        ASSERT_TRUE(opened.readable);
        document.reset(opened.design);
        view.fitAll();
    }

    Document document;
    Selection selection;
    ProblemSet problems;
    PatternView view{document, selection, problems};
};

TEST_F(PatternViewTest, ShowsTheArmchair)
{
    open(QStringLiteral("armchair"));
    keepPicture(view, QStringLiteral("armchair"));
    selection.set({ElementId{6}});
    view.fitSelection();
    keepPicture(view, QStringLiteral("armchair-seat"));
    selection.set({ElementId{48}});
    view.fitSelection();
    keepPicture(view, QStringLiteral("armchair-seam"));
}

} // namespace
} // namespace bolster
