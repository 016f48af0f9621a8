// What the user sets about the program: kept, found, taken along, and seen at once.
#include "WindowTest.h"

#include "ApplyPreferences.h"
#include "ElementEdits.h"
#include "Inspector.h"
#include "KeyPresets.h"
#include "NumberBox.h"
#include "PreferencesWindow.h"
#include "Shortcuts.h"
#include "StatusLine.h"
#include "WholeFile.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QSettings>

namespace bolster {
namespace {

/// Another value that the setting may have.
QVariant otherValue(const Preferences& now, const PreferenceRow& row)
{
    if (const auto* form = std::get_if<OneOf>(&row.form)) {
        for (const PreferenceChoice& choice : form->choices())
            if (choice.id != valueOf(now, row))
                return choice.id;
    } else if (const auto* whole = std::get_if<WholeNumber>(&row.form)) {
        return whole->most;
    } else if (std::holds_alternative<LengthNumber>(row.form)) {
        return 12.5;
    } else if (std::holds_alternative<OnOff>(row.form)) {
        return !valueOf(now, row).toBool();
    }
    return QStringLiteral("/somewhere");
}

Preferences allOthers()
{
    Preferences other;
    for (const PreferenceRow& row : preferenceTable())
        if (const auto with = withValue(other, row, otherValue(other, row)))
            other = *with;
        else if (QLatin1String(row.key) != QLatin1String("language")) // tests are built without others
            ADD_FAILURE() << row.key;
    return other;
}

class PreferencesTest : public WindowTest {
protected:
    void TearDown() override
    {
        Preferences usual;
        window.preferences().set(usual);
        WindowTest::TearDown();
    }

    PreferencesWindow& preferences()
    {
        window.command("edit.preferences")->trigger();
        auto* found = window.findChild<PreferencesWindow*>();
        EXPECT_TRUE(found && QTest::qWaitForWindowExposed(found));
        return *found;
    }

    template <class Editor>
    static Editor& editor(PreferencesWindow& in, const char* key)
    {
        return *in.findChild<Editor*>(QString::fromLatin1(key));
    }

    /// As by the user: what has the keyboard hears of it.
    static void choose(PreferencesWindow& in, const char* key, const QString& id)
    {
        auto& box = editor<QComboBox>(in, key);
        const int at = box.findData(id);
        ASSERT_GE(at, 0) << key;
        box.setCurrentIndex(at);
        emit box.activated(at);
    }

    static QStringList shownSettings(PreferencesWindow& in)
    {
        QStringList keys;
        for (const PreferenceRow& row : preferenceTable())
            if (in.findChild<QWidget*>(QString::fromLatin1(row.key))->isVisible())
                keys << QString::fromLatin1(row.key);
        return keys;
    }

    NumberBox* firstLength()
    {
        for (NumberBox* box : window.inspector().findChildren<NumberBox*>())
            if (box->isVisible() && (box->suffix() == lengthSuffix()))
                return box;
        return nullptr;
    }
};

TEST_F(PreferencesTest, EverySettingIsKeptAndOnlyWhatDiffers)
{
    const QString before = QSettings().allKeys().join(u' ');
    const Preferences other = allOthers();
    {
        PreferenceStore store;
        EXPECT_EQ(store.now(), Preferences());
        store.set(other);
    }
    EXPECT_EQ(storedPreferences(), other);
    PreferenceStore store;
    store.set({});
    EXPECT_EQ(storedPreferences(), Preferences());
    EXPECT_EQ(QSettings().allKeys().join(u' '), before);
}

TEST_F(PreferencesTest, WhatOlderVersionsHaveKeptHolds)
{
    QSettings().setValue("window/theme", 2);
    EXPECT_EQ(themeOf(storedPreferences()), Theme::Dark);
    QSettings().setValue("window/theme", 77);
    EXPECT_EQ(themeOf(storedPreferences()), Theme::System) << "what nobody understands is as at first";
}

TEST_F(PreferencesTest, AreTakenToAnotherMachine)
{
    const QTemporaryDir folder;
    const QString file = folder.filePath("mine.json");
    PreferencesWindow& shown = preferences();
    Preferences other = allOthers();
    other.fontPercent = 110;
    other.fabricFolder = folder.path(); // one that is there
    window.preferences().set(other);
    shown.exportTo(file);
    window.preferences().set({});
    shown.importFrom(file);
    EXPECT_EQ(window.preferences().now(), other);
    shown.close();
}

TEST_F(PreferencesTest, BadFilesSayWhyAndChangeNothing)
{
    const QTemporaryDir folder;
    const QString file = folder.filePath("bad.json");
    PreferencesWindow& shown = preferences();
    const std::pair<const char*, const char*> files[] = {
        {"", "character"},
        {"{\"format\": \"bolster-pref", "character"},
        {"[1, 2]", "no file of preferences"},
        {R"({"format": "bolster-preferences"})", "no file of preferences"},
        {R"({"format": "bolster-preferences", "settings": {"units/length": "cm", "window/font-percent": 900}})",
         "window/font-percent"},
        {R"({"format": "bolster-preferences", "settings": {"units/length": "ell"}})", "units/length"},
        {R"({"format": "bolster-preferences", "settings": {"units/length": "cm", "units/length": "in"}})",
         "\"units/length\" stands there twice"},
        {R"({"format": "bolster-preferences", "settings": {"units/length": "cm"}, "settings": {}})",
         "\"settings\" stands there twice"},
    };
    for (const auto& [text, said] : files) {
        ASSERT_TRUE(replaceWholeFile(file, text).empty());
        shown.importFrom(file);
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        ASSERT_TRUE(box) << text;
        EXPECT_TRUE(box->informativeText().contains(QLatin1String(said))) << box->informativeText().toStdString();
        EXPECT_EQ(window.preferences().now(), Preferences()) << text;
        box->close();
        QCoreApplication::processEvents();
    }
    shown.importFrom(folder.filePath("none.json"));
    ASSERT_TRUE(QApplication::activeModalWidget());
    QApplication::activeModalWidget()->close();
    shown.close();
}

TEST_F(PreferencesTest, NewerFilesAreTakenAsFarAsTheyAreKnown)
{
    const QTemporaryDir folder;
    const QString file = folder.filePath("newer.json");
    ASSERT_TRUE(replaceWholeFile(file, R"({"format": "bolster-preferences",
        "settings": {"units/length": "cm", "moon/phase": 3}})")
                    .empty());
    PreferencesWindow& shown = preferences();
    shown.importFrom(file);
    EXPECT_EQ(window.preferences().now().length, "cm");
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    ASSERT_TRUE(box);
    EXPECT_TRUE(box->informativeText().contains("moon/phase"));
    box->close();
    shown.close();
}

TEST_F(PreferencesTest, AFolderThatIsNoneHereStaysWhatItWas)
{
    const QTemporaryDir folder;
    const QString file = folder.filePath("mine.json");
    Preferences now;
    now.fabricFolder = folder.path();
    window.preferences().set(now);
    for (const QString& other : {file, folder.filePath("gone")}) {
        Preferences elsewhere;
        elsewhere.length = "cm";
        elsewhere.fabricFolder = other;
        ASSERT_TRUE(replaceWholeFile(file, preferencesText(elsewhere)).empty());
        PreferencesWindow& shown = preferences();
        shown.importFrom(file);
        EXPECT_EQ(window.preferences().now().fabricFolder, folder.path());
        EXPECT_EQ(window.preferences().now().length, "cm") << "all others are taken";
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        ASSERT_TRUE(box);
        EXPECT_TRUE(box->informativeText().contains(other)) << box->informativeText().toStdString();
        box->close();
        shown.close();
        QCoreApplication::processEvents();
    }
}

TEST_F(PreferencesTest, UnitsChangeAtOnceInThePropertiesAndAreTyped)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    window.selection().clear(); // the design's own properties
    QCoreApplication::processEvents();
    NumberBox* length = firstLength();
    ASSERT_TRUE(length);
    const double before = length->value();
    ASSERT_TRUE(length->text().endsWith(" mm"));
    PreferencesWindow& shown = preferences();
    choose(shown, "units/length", QStringLiteral("in"));
    QCoreApplication::processEvents();
    length = firstLength();
    ASSERT_TRUE(length);
    EXPECT_TRUE(length->text().endsWith(u'\u2033')) << length->text().toStdString();
    EXPECT_DOUBLE_EQ(length->value(), before);
    shown.close();
    takeKeyboard();
    length->setFocus();
    length->selectAll();
    QTest::keyClicks(length, "3/4"); // 1/2 is what 12 mm are shown as, and changes nothing
    QTest::keyClick(length, Qt::Key_Return);
    EXPECT_NEAR(window.document().design().settings().edgeLength, 19.05, 1e-3);
    EXPECT_EQ(storedPreferences().length, "in");
    window.document().undo();
    EXPECT_DOUBLE_EQ(window.document().design().settings().edgeLength, before);
}

TEST_F(PreferencesTest, TheStatusLineKeepsUpWithTheUnit)
{
    emit window.patternView().pointerMoved(Vec2(254, 127));
    const auto shown = [&](const QString& text) {
        const auto labels = window.statusLine().findChildren<QLabel*>();
        return std::ranges::any_of(labels, [&](const QLabel* label) { return label->text().contains(text); });
    };
    EXPECT_TRUE(shown("254.0"));
    Preferences inches;
    inches.length = "in";
    window.preferences().set(inches);
    EXPECT_TRUE(shown("10.00")) << "though the pointer stands still";
    EXPECT_FALSE(shown("254.0"));
}

TEST_F(PreferencesTest, SettingsAreFoundByTheirWords)
{
    PreferencesWindow& shown = preferences();
    EXPECT_EQ(shownSettings(shown), (QStringList{"units/length", "units/inch-fraction", "units/decimal"}));
    shown.search("reduced motion");
    EXPECT_EQ(shownSettings(shown), QStringList{"view/reduced-motion"});
    shown.search("blender");
    EXPECT_EQ(shownSettings(shown), (QStringList{"mouse/preset", "keys/preset"})) << "by what may be chosen, too";
    shown.search("zzz");
    EXPECT_TRUE(shownSettings(shown).isEmpty());
    shown.search({});
    EXPECT_EQ(shownSettings(shown).size(), 3);
    shown.showPage(PreferencePage::Mouse);
    EXPECT_EQ(shownSettings(shown), (QStringList{"mouse/preset", "mouse/invert-zoom"}));
    for (const PreferenceRow& row : preferenceTable()) // each by its own label
        EXPECT_TRUE(row.found(row.labelText())) << row.key;
    shown.close();
}

TEST_F(PreferencesTest, AThemeAndLargerLettersComeAtOnce)
{
    PreferencesWindow& shown = preferences();
    const double size = QApplication::font().pointSizeF();
    choose(shown, "window/theme", QString::number(static_cast<int>(Theme::HighContrast)));
    EXPECT_EQ(window.palette().color(QPalette::Window), QColor(Qt::black));
    EXPECT_EQ(window.palette().color(QPalette::WindowText), QColor(Qt::white));
    EXPECT_TRUE(window.command("view.theme-contrast")->isChecked()) << "the menu knows";
    window.command("view.theme-light")->trigger();
    EXPECT_GT(window.palette().color(QPalette::Window).lightness(), 128);
    EXPECT_EQ(editor<QComboBox>(shown, "window/theme").currentData(), "1") << "and the other way round";
    auto& percent = editor<NumberBox>(shown, "window/font-percent");
    percent.setValue(150);
    EXPECT_NEAR(QApplication::font().pointSizeF(), 1.5 * size, 0.1);
    EXPECT_NEAR(window.inspector().font().pointSizeF(), 1.5 * size, 0.1);
    shown.showPage(PreferencePage::Looks);
    QTest::mouseClick(shown.findChild<QPushButton*>("defaults"), Qt::LeftButton);
    EXPECT_NEAR(QApplication::font().pointSizeF(), size, 0.1);
    EXPECT_EQ(window.preferences().now(), Preferences());
    shown.close();
}

TEST_F(PreferencesTest, WhatHoldsAtTheNextStartOnlyOffersToStartAgain)
{
    ASSERT_TRUE(open(sample("trapezoid")));
    const QString path = window.session().path();
    QStringList again;
    QObject::connect(&window, &MainWindow::restartWanted, [&](const QString& with) { again << with; });
    PreferencesWindow& shown = preferences();
    shown.showPage(PreferencePage::Looks);
    auto& restart = editor<QPushButton>(shown, "restart");
    choose(shown, "window/theme", QString::number(static_cast<int>(Theme::Dark)));
    EXPECT_FALSE(restart.isVisible()) << "that holds already";
    choose(shown, "language", "de");
    EXPECT_TRUE(restart.isVisible());
    choose(shown, "language", {});
    EXPECT_FALSE(restart.isVisible());
    choose(shown, "language", "de");

    window.document().commit(edits::addElement(window.document().design(), makeElement(Fabric())));
    answer(QMessageBox::Cancel);
    QTest::mouseClick(&restart, Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return answered == 1; }, 20000));
    EXPECT_TRUE(window.isVisible()) << "asked as when it is closed";
    answer(QMessageBox::Discard);
    QTest::mouseClick(&restart, Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !again.isEmpty(); }, 20000));
    EXPECT_FALSE(window.isVisible());
    EXPECT_EQ(again, QStringList{path});
    EXPECT_EQ(storedPreferences().language, "de");
}

TEST_F(PreferencesTest, WhoStaysAndClosesLaterDoesNotStartAgain)
{
    ASSERT_TRUE(open(sample("trapezoid")));
    bool again = false;
    QObject::connect(&window, &MainWindow::restartWanted, [&] { again = true; });
    window.document().commit(edits::addElement(window.document().design(), makeElement(Fabric())));
    answer(QMessageBox::Cancel);
    window.restart();
    ASSERT_TRUE(QTest::qWaitFor([&] { return answered == 1; }, 20000));
    answer(QMessageBox::Discard);
    window.close();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window.isVisible(); }, 20000));
    EXPECT_FALSE(again);
}

TEST_F(PreferencesTest, TogglesOfTheMenusAreTheSameSettings)
{
    QAction* rulers = window.command("draw.rulers");
    ASSERT_TRUE(rulers->isChecked());
    PreferencesWindow& shown = preferences();
    shown.showPage(PreferencePage::Pattern);
    QTest::mouseClick(&editor<QCheckBox>(shown, "drawing/rulers"), Qt::LeftButton, {}, {8, 8});
    EXPECT_FALSE(rulers->isChecked());
    rulers->trigger();
    EXPECT_TRUE(editor<QCheckBox>(shown, "drawing/rulers").isChecked());
    EXPECT_EQ(window.preferences().now(), Preferences());
    shown.close();
}

TEST_F(PreferencesTest, DefaultsComeBackOnOnePageOnly)
{
    PreferencesWindow& shown = preferences();
    choose(shown, "units/length", QStringLiteral("cm"));
    choose(shown, "mouse/preset", QStringLiteral("cad"));
    shown.showPage(PreferencePage::Mouse);
    QTest::mouseClick(shown.findChild<QPushButton*>("defaults"), Qt::LeftButton);
    EXPECT_EQ(window.preferences().now().mouse, "bolster");
    EXPECT_EQ(window.preferences().now().length, "cm");
    shown.close();
}

TEST_F(PreferencesTest, MousePresetsTurnTheCamera)
{
    PreferencesWindow& shown = preferences();
    choose(shown, "mouse/preset", QStringLiteral("clo"));
    EXPECT_TRUE(shown.findChild<QLabel*>("mouse-table")->text().contains("right button"));
    shown.close();
    takeKeyboard();
    CoverView& view = window.coverView();
    const auto drag = [&](Qt::MouseButton button) {
        const Camera before = view.navigation().camera();
        const QPoint from = view.rect().center(), to = from + QPoint(60, 0);
        QTest::mousePress(&view, button, {}, from);
        move(view, to, button);
        QTest::mouseRelease(&view, button, {}, to);
        return view.navigation().camera().azimuth != before.azimuth;
    };
    EXPECT_TRUE(drag(Qt::RightButton));
    EXPECT_FALSE(drag(Qt::MiddleButton)) << "it pans";
    Preferences wanted = window.preferences().now();
    wanted.mouse = QStringLiteral("blender");
    window.preferences().set(wanted);
    EXPECT_TRUE(drag(Qt::MiddleButton));
}

TEST_F(PreferencesTest, NoPresetOfKeysHasClashes)
{
    const QList<QAction*> actions = window.commands().all();
    for (const KeyPreset& preset : keyPresets()) {
        Preferences wanted;
        wanted.keys = QString::fromLatin1(preset.id);
        window.preferences().set(wanted);
        for (const auto& [id, keys] : preset.keys) {
            ASSERT_TRUE(actions.contains(window.command(id))) << id;
            EXPECT_EQ(window.command(id)->shortcut(), keys) << preset.id << ' ' << id;
            EXPECT_FALSE(Shortcuts::reserved(keys)) << preset.id << ' ' << id;
        }
        QHash<QKeySequence, QAction*> holders;
        for (QAction* action : actions)
            for (const QKeySequence& keys : action->shortcuts()) {
                QAction*& holder = holders[keys];
                EXPECT_FALSE(holder) << preset.id << ": " << keys.toString().toStdString() << " of "
                                     << action->objectName().toStdString() << " and "
                                     << (holder ? holder->objectName().toStdString() : "");
                holder = action;
            }
    }
}

TEST_F(PreferencesTest, OwnKeysStayBelowAPreset)
{
    QSettings().setValue("shortcuts/view.isolate", "H"); // which the preset gives to another
    MainWindow again;
    Preferences wanted;
    wanted.keys = QStringLiteral("blender");
    again.preferences().set(wanted);
    EXPECT_EQ(again.command("view.isolate")->shortcut(), QKeySequence("H"));
    EXPECT_TRUE(again.command("view.hide")->shortcuts().isEmpty());
    EXPECT_EQ(again.command("view.from-top")->shortcut(), QKeySequence("7"));
    again.preferences().set({});
    EXPECT_EQ(again.command("view.from-top")->shortcut(), QKeySequence("5"));
    QSettings().remove("shortcuts");
}

TEST_F(PreferencesTest, NewDesignsBeginAsWished)
{
    Preferences wanted;
    wanted.fabric = QStringLiteral("Velvet, green");
    wanted.allowance = 12;
    window.preferences().set(wanted);
    window.session().startNew();
    const Design& design = window.document().design();
    int fabrics = 0;
    design.each<Fabric>([&](ElementId, const Fabric& fabric) {
        ++fabrics;
        EXPECT_EQ(fabric.name, "Velvet, green");
    });
    EXPECT_EQ(fabrics, 1);
    ASSERT_TRUE(design.settings().cutting.allowance);
    EXPECT_DOUBLE_EQ(design.settings().cutting.allowance->width, 12);
    EXPECT_FALSE(window.document().hasUnsavedWork());
    window.preferences().set({});
    window.session().startNew();
    EXPECT_FALSE(window.document().design().settings().cutting.allowance);
}

TEST_F(PreferencesTest, WorkInTheBinIsNeverKeptShorterThanItWas)
{
    Preferences wanted;
    wanted.daysInBin = 90;
    window.preferences().set(wanted);
    EXPECT_EQ(WorkJournal::daysInBin(), 90);
    WorkJournal::setDaysInBin(3);
    EXPECT_EQ(WorkJournal::daysInBin(), 30);
    const auto& table = preferenceTable();
    const auto row = std::ranges::find_if(
        table, [](const PreferenceRow& r) { return QLatin1String(r.key) == QLatin1String("work/days-in-bin"); });
    ASSERT_NE(row, table.end());
    EXPECT_FALSE(withValue({}, *row, 29));
    EXPECT_TRUE(withValue({}, *row, 30));
}

} // namespace
} // namespace bolster
