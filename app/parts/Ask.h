// Dialogs that are opened and say later what was answered: nothing in the program waits inside them.
#pragma once

#include "Translated.h"

#include <QMessageBox>
#include <QStringList>

#include <functional>

class QProgressBar;
class QProgressDialog;

namespace bolster {

/// Gets what was chosen or typed. Who closes a dialog has given no answer, and nothing is called.
using Answer = std::function<void(const QString&)>;

/// In front of all windows; deleted when it is closed. What message boxes say becomes sentences.
void openDialog(QDialog* dialog);
/// The same for a question; null when it was closed without an answer. The button lives as long as the call.
void openQuestion(QMessageBox* box, const std::function<void(const QAbstractButton*)>& answered);
/// Nothing to choose. Given an object's name, that of a place or of a message, F1 leads to its page.
QMessageBox* tell(QWidget* window, QMessageBox::Icon icon, const QString& text, const QString& more);

/// Of the file that is open; without one the folder where the user has opened or saved last.
QString usualFolder(const QString& openFile);
/// A file was opened or saved there.
void rememberFolder(const QString& file);

void askForFile(QWidget* window, const QString& title, const QString& folder, const QString& filter,
                const Answer& chosen);
/// A file to write. One of the endings is added, that of the chosen filter or the first, if none was typed; a file
/// that exists is replaced only when the user says so. `endings` may be empty: then the name is as it was typed.
void askWhereToWrite(QWidget* window, const QString& title, const QString& proposal, const QString& filter,
                     const QStringList& endings, const Answer& chosen);
/// Something other than spaces.
void askForText(QWidget* window, const QString& title, const QString& label, const QString& text,
                const Answer& typed);
void askForOneOf(QWidget* window, const QString& title, const QString& label, const QStringList& choices,
                 const Answer& chosen);

/// Comes up when something takes longer than a moment, goes when it is deleted. Its bar is to be set, not the
/// window itself: that would work through events in the middle of it. With no steps it only moves.
struct ProgressWindow {
    QProgressDialog* dialog;
    QProgressBar* bar;
};
ProgressWindow openProgress(QWidget* window, const QString& text, int steps = 0);
/// It has nothing more to say; null is all right.
void closeProgress(QProgressDialog* dialog);

} // namespace bolster
