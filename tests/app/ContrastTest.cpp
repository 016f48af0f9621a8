// Whether what is written and drawn can be told from its ground: WCAG 2.1, level AA, in every theme.
#include "SceneMarks.h"
#include "SeamColors.h"
#include "StatusLine.h"
#include "Theme.h"
#include "ViewScene.h"

#include <QApplication>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

namespace bolster {
namespace {

constexpr double forText = 4.5; // 3 for large letters, which nothing here relies on
constexpr double forSigns = 3;

/// Relative luminance, as WCAG defines it.
double luminanceOf(const QColor& color)
{
    const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}

double contrastOf(const QColor& a, const QColor& b)
{
    const auto [low, high] = std::minmax({luminanceOf(a), luminanceOf(b)});
    return (high + 0.05) / (low + 0.05);
}

class ContrastTest : public testing::TestWithParam<Theme> {
protected:
    ~ContrastTest() override { applyTheme(*qApp, Theme::System); }

    static void expect(double least, const char* what, const QColor& color, const char* where, const QColor& ground)
    {
        EXPECT_GE(contrastOf(color, ground), least)
            << what << ' ' << color.name().toStdString() << " on " << where << ' ' << ground.name().toStdString();
    }

    QPalette palette = [] {
        applyTheme(*qApp, GetParam());
        return QApplication::palette();
    }();
    ViewColors colors = ViewColors::of(palette);
    ViewScene scene = [this] {
        ViewScene made;
        made.setColors(colors);
        return made;
    }();
};

TEST(Contrast, IsMeasuredAsDefined)
{
    EXPECT_NEAR(contrastOf(Qt::black, Qt::white), 21, 1e-9);
    EXPECT_NEAR(contrastOf(QColor(0x76, 0x76, 0x76), Qt::white), 4.54, 0.01);
    EXPECT_EQ(contrastOf(Qt::red, Qt::red), 1);
}

TEST_P(ContrastTest, WordsInWindowsCanBeRead)
{
    using Role = QPalette::ColorRole;
    const std::tuple<const char*, Role, Role> pairs[] = {
        {"words in a window", QPalette::WindowText, QPalette::Window},
        {"words in a field", QPalette::Text, QPalette::Base},
        {"words in every other row", QPalette::Text, QPalette::AlternateBase},
        {"words on a button", QPalette::ButtonText, QPalette::Button},
        {"a tip", QPalette::ToolTipText, QPalette::ToolTipBase},
        {"what is selected", QPalette::HighlightedText, QPalette::Highlight},
        {"a link in a window", QPalette::Link, QPalette::Window},
        {"a link in a field", QPalette::Link, QPalette::Base},
        {"what a field is for", QPalette::PlaceholderText, QPalette::Base},
        {"a hint in a window", QPalette::PlaceholderText, QPalette::Window}};
    for (const auto group : {QPalette::Active, QPalette::Inactive})
        for (const auto& [what, text, ground] : pairs)
            expect(forText, what, palette.color(group, text), "its ground", palette.color(group, ground));
    // Written in forms and lists in colours of their own.
    for (const Role ground : {QPalette::Window, QPalette::Base}) {
        expect(forText, "a note", colors.mutedLabel, "a form", palette.color(ground));
        expect(forText, "a warning", colors.warning, "a form", palette.color(ground));
        expect(forText, "an error", colors.error, "a form", palette.color(ground));
    }
}

TEST_P(ContrastTest, SignsInWindowsCanBeSeen)
{
    using Mood = StatusLine::Mood;
    for (const Mood mood : {Mood::Idle, Mood::Busy, Mood::Good, Mood::Worried, Mood::Failed})
        expect(forSigns, "the dot of the status line", StatusLine::colorOf(mood), "its ground",
               palette.color(QPalette::Window));
    for (const auto ground : {QPalette::Window, QPalette::Base, QPalette::Button})
        expect(forSigns, "what has the keyboard", palette.color(QPalette::Highlight), "its ground",
               palette.color(ground));
}

TEST_P(ContrastTest, ThePatternCanBeRead)
{
    for (const auto& [what, color] :
         {std::pair("labels", colors.label), std::pair("muted labels", colors.mutedLabel),
          std::pair("errors", colors.error), std::pair("warnings", colors.warning)})
        expect(forText, what, color, "the canvas", colors.canvas);
    for (const auto& [what, color] :
         {std::pair("outlines", colors.outline), std::pair("what is selected", colors.accent),
          std::pair("what lies under the pointer", colors.hover), std::pair("fixations", colors.fixation),
          std::pair("handles", colors.handle), std::pair("fancy seams", colors.fancySeam),
          std::pair("hints", colors.snap)})
        expect(forSigns, what, color, "the canvas", colors.canvas);
    Design design;
    Edit seams;
    for (int id = 1; id <= 8; ++id)
        seams.changes.push_back({ElementId{id}, nullptr, makeElement(Seam{{ElementId{100 + id}, 0, 1}, {}})});
    for (const auto& [id, color] : seamColors(design.with(seams), colors.dark))
        expect(forSigns, "a seam", color, "the canvas", colors.canvas);
}

/// Behind the cover there is a ground from one shade to another.
TEST_P(ContrastTest, MarksInThe3DViewCanBeSeen)
{
    const QColor grounds[] = {colorOf(scene.backgroundTop), colorOf(scene.backgroundBottom)};
    for (const QColor& ground : grounds) {
        expect(forText, "labels", colors.label, "the ground", ground);
        for (const auto& [what, color] :
             {std::pair("what is selected", colors.accent), std::pair("handles", colors.handle),
              std::pair("fancy seams", colors.fancySeam), std::pair("hints", colors.snap),
              std::pair("errors", colors.error), std::pair("warnings", colors.warning),
              std::pair("fixation curves", fixationCurveColor(colors))})
            expect(forSigns, what, color, "the ground", ground);
    }
    expect(forSigns, "what lies under the pointer", colors.hover, "the middle of the ground", scene.veil());
}

INSTANTIATE_TEST_SUITE_P(Themes, ContrastTest, testing::Values(Theme::Light, Theme::Dark, Theme::HighContrast),
                         [](const auto& theme) {
                             return theme.param == Theme::Light  ? "Light"
                                    : theme.param == Theme::Dark ? "Dark"
                                                                 : "HighContrast";
                         });

} // namespace
} // namespace bolster
