#include "EveryDialog.h"

#include "Commands.h"
#include "ElidedLabel.h"

#include <QAbstractSpinBox>
#include <QAccessible>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QFileDialog>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollBar>
#include <QTest>

#include <algorithm>

namespace bolster::test {

namespace {

QDialog* openDialogOf(const QWidget& window)
{
    const QList<QWidget*> all = QApplication::topLevelWidgets();
    const auto found = std::ranges::find_if(
        all, [&](QWidget* one) { return one != &window && one->isVisible() && qobject_cast<QDialog*>(one); });
    return found == all.end() ? nullptr : static_cast<QDialog*>(*found);
}

void closeAll(const QWidget& window)
{
    for (int tries = 0; tries < 10; ++tries) {
        QDialog* dialog = openDialogOf(window);
        if (!dialog)
            return;
        dialog->reject();
        (void)QTest::qWaitFor([&] { return openDialogOf(window) != dialog; }, 1000);
    }
}

QString described(const QWidget& widget, const QString& text, int has, int needs)
{
    return QStringLiteral("\"%1\" (%2, %3 of %4 pixels)")
        .arg(text, QString::fromLatin1(widget.metaObject()->className()))
        .arg(has)
        .arg(needs);
}

/// Within a scroll area a text may be out of sight, but not cut.
void addLabel(const QLabel& label, QStringList& found)
{
    if (label.text().isEmpty() || qobject_cast<const ElidedLabel*>(&label))
        return;
    if (label.wordWrap()) {
        const int needs = label.heightForWidth(label.width());
        if (needs > label.height() + 2)
            found << described(label, label.text().left(60), label.height(), needs);
    } else if (label.sizeHint().width() > label.width() + 1) {
        found << described(label, label.text().left(60), label.width(), label.sizeHint().width());
    }
}

void addButton(const QAbstractButton& button, QStringList& found)
{
    const bool shows = qobject_cast<const QPushButton*>(&button) || qobject_cast<const QCheckBox*>(&button) ||
                       qobject_cast<const QRadioButton*>(&button);
    if (!shows || button.text().isEmpty())
        return;
    const int needs = std::min(button.sizeHint().width(), button.minimumSizeHint().width());
    if (needs > button.width() + 1)
        found << described(button, button.text(), button.width(), needs);
}

} // namespace

int lookAtDialogs(MainWindow& window, const std::function<void(QWidget&, const QString& id)>& look)
{
    int count = 0;
    for (QAction* action : window.commands().all()) {
        if (!action->text().contains(u'\u2026') || !action->isEnabled())
            continue;
        action->trigger();
        QDialog* dialog = nullptr;
        (void)QTest::qWaitFor([&] { return (dialog = openDialogOf(window)) != nullptr; }, 1500);
        if (dialog && !qobject_cast<QFileDialog*>(dialog)) {
            QTest::qWait(50); // laid out
            look(*dialog, action->objectName());
            ++count;
        }
        closeAll(window);
    }
    return count;
}

QStringList clippedTexts(const QWidget& window)
{
    QStringList found;
    for (const auto* widget : window.findChildren<QWidget*>()) {
        if (!widget->isVisible())
            continue;
        if (const auto* label = qobject_cast<const QLabel*>(widget))
            addLabel(*label, found);
        else if (const auto* button = qobject_cast<const QAbstractButton*>(widget))
            addButton(*button, found);
        else if (const auto* box = qobject_cast<const QGroupBox*>(widget);
                 box && box->fontMetrics().horizontalAdvance(box->title()) > box->width())
            found << described(*box, box->title(), box->width(),
                               box->fontMetrics().horizontalAdvance(box->title()));
    }
    return found;
}

QStringList namelessControls(const QWidget& window)
{
    QStringList found;
    for (auto* widget : window.findChildren<QWidget*>()) {
        const bool partOfOther =
            widget->parentWidget() && (qobject_cast<QAbstractSpinBox*>(widget->parentWidget()) ||
                                       qobject_cast<QComboBox*>(widget->parentWidget()));
        if (!widget->isVisible() || partOfOther || !(widget->focusPolicy() & Qt::TabFocus))
            continue;
        QAccessibleInterface* said = QAccessible::queryAccessibleInterface(widget);
        if (!said || said->role() == QAccessible::NoRole || said->text(QAccessible::Name).trimmed().isEmpty())
            found << QStringLiteral("%1 \"%2\" in %3")
                         .arg(QString::fromLatin1(widget->metaObject()->className()), widget->objectName(),
                              QString::fromLatin1(widget->parentWidget()->metaObject()->className()));
    }
    return found;
}

} // namespace bolster::test
