// What the File menu does: the dialogs around opening, saving, importing and exporting.
#pragma once

#include "Ask.h"
#include "DesignSession.h"
#include "FileContent.h"
#include "FixationsOff.h"
#include "Scene.h"
#include "SurfaceMesh.h"

#include <QImage>
#include <QMessageBox>
#include <QPointer>
#include <QProgressDialog>

#include <functional>
#include <stop_token>

class QMenu;
class QWidget;

namespace bolster {

class Banner;
enum class CoverFormat;
struct CoverFile;
struct Drawing;
struct FoundPattern;
struct PatternChoice;
struct PatternOrder;
struct Salvaged;

class FileFlow : public QObject {
    Q_OBJECT

public:
    using Then = std::function<void()>;

    FileFlow(DesignSession& session, QWidget* window, Banner* banner);

    void startNew(const Then& begun = {});
    /// Asks for a file when `path` is empty. `opened` is called when it is there.
    void open(const QString& path = {}, const Then& opened = {});
    /// As a new design without a name.
    void openTemplate(const QString& path);
    /// Goes on with unsaved work.
    void openLeft(const WorkJournal::Left& left);
    /// Of unsaved work, as the user knows it.
    static QString nameOf(const WorkJournal::Left& left);
    /// Looks for unsaved work in the background: leftFound.
    void findLeft();
    void save();
    void saveAs();
    void saveCopy(const SaveOptions& options);
    /// To the version that was saved last; the way back is in the history.
    void revert();
    /// There is such a version: the design is in a file of the user's.
    bool hasSaved() const;
    /// Goes on when nothing unsaved is lost by it: saved, discarded on purpose, or nothing was unsaved.
    void keepWork(const Then& then);

    /// Ask for file, unit and axis.
    void importFrame(const QString& path = {});
    void importScan(const QString& path = {});
    /// Shows the pieces of a pattern file, and adds those that are wanted.
    void importPattern(const QString& path = {});
    /// The same for an element that is there.
    void replaceFile(ElementId id);
    void exportSurface(const SurfaceMeshPtr& surface);
    /// Ask where, and by that in which format.
    void exportCover(const SurfaceMeshPtr& surface, const FabricBaker& bake);
    void exportFoam(const SurfaceMeshPtr& surface);
    void exportPicture(const QImage& picture);
    /// Asks how, then where. `takePicture`: of the cover, for the sewing sheet; null when there is none.
    void exportPattern(std::function<QImage()> takePicture);
    /// Named like the design and beside it.
    QString proposedPicture() const { return proposed(QStringLiteral("png")); }

    void fillRecent(QMenu& menu);
    void fillSamples(QMenu& menu);
    void fillUnsaved(QMenu& menu);
    /// Goes on where a crash has ended the last run, if it has.
    void recover();
    /// A design, a frame, a scan or a pattern, by its ending.
    static bool takes(const QString& file);
    void drop(const QString& file);

signals:
    /// Something has happened that is worth a line in the status bar.
    void done(const QString& what);
    /// A file for others was written.
    void exported();
    /// A frame or a scan is in the design now.
    void imported(bolster::FileKind kind);
    /// A pattern is: of these patches.
    void patternImported(const std::vector<bolster::ElementId>& patches);
    /// Something in the pattern shall be seen: in outline coordinates, mm.
    void placeWanted(bolster::ElementId element, bolster::ElementId patch, const bolster::Vec2& place);
    /// Work that is not in any file, the newest first, that of this window left out.
    void leftFound(const QList<bolster::WorkJournal::Left>& all);
    /// The user wants to see what is wrong.
    void problemsWanted();
    /// The user wants to see what has been done.
    void historyWanted();

private:
    /// What comes to the design, and what it takes the place of.
    struct PlacedFile {
        QString path;
        FileContent content;
        Element element;
        std::optional<ElementId> replaced;
        PlacedMesh old;
    };

    void restore(const WorkJournal::Left& left, int others = 0);
    void announceRestored(int others);
    void setAside(const WorkJournal::Left& left, const Message& problem);
    void goOnWithout(const WorkJournal::Left& damaged, const Message& problem);
    void salvageWork(const WorkJournal::Left& damaged, const QString& why);
    void sayWhatBecameOf(const QString& work, const QString& why, const QString& recovered,
                         const Salvaged& salvaged);
    void offerWorkSalvage(const WorkJournal::Left& damaged);
    void warnOfCrashes(const Message& why);
    void askAboutWork(const Then& then);
    void keepForLater(const Then& then);
    void saveForGood(bool asProject, const Then& then);
    void chooseSaveTarget(const Answer& chosen);
    void openNow(const QString& path, const Then& opened = {});
    void failToOpen(const QString& path, const Message& problem);
    void offerSalvage(const QString& path, const Message& problem, bool damaged);
    void salvage(const QString& path);
    void sayWhatIsLeft(const QString& path, const std::vector<Message>& notes);
    QPointer<QProgressDialog> showProgress(const QString& text, std::stop_source stop);
    QPointer<QProgressDialog> showReading(const QString& text, const std::stop_source& stop);
    void openAs(const QString& path, DesignSession::Opening opening, const Then& opened);
    void saveTo(const QString& path, const Then& then);
    void saveCopyTo(const QString& path, const SaveOptions& options);
    void offerAnotherTry(const QString& path, const Message& problem, const Then& again, const Then& elsewhere);
    void saveBesideOthers(const QString& path, const Then& then);
    void saveBesideStranger(const QString& path, const Message& stranger, const Then& then);
    void saveElsewhere(const Then& then);
    void askOrSaveElsewhere(QMessageBox* box, const QString& text, const Then& act, const Then& elsewhere);
    void keepAside(const QString& path, const Then& then);
    void takeTheirs(const QString& path, const Then& then);
    QString name() const;
    QString exportFolder() const;
    QString proposed(const QString& ending, const QString& addition = {}) const;
    void chooseTarget(const QString& title, const QString& proposal, const QString& filter,
                      const QStringList& endings, const Answer& chosen);
    void remember(const QString& path);
    void announceProblems();
    template <class T>
    void import(const T& element, const QString& title, const QString& filter, const QString& path);
    void importNow(const QString& path, const Element& element, std::optional<ElementId> replaced);
    static QString readingText(const QString& path);
    void choosePieces(const QString& path, const Drawing& drawing);
    void addPattern(const QString& path, const std::shared_ptr<const FoundPattern>& pattern,
                    const PatternChoice& choice);
    template <class Result, class Read, class Done>
    void readInBackground(const QString& path, Read read, Done done);
    template <class Result, class Read, class Done>
    void withProgress(const QString& text, Read read, Done done);
    void place(const QString& path, const ImportedFile& file, const Element& element,
               std::optional<ElementId> replaced);
    /// As an OBJ file without the unwanted parts, with about so many triangles; nothing: with all.
    void writeAnew(const PlacedFile& file, const std::vector<std::string>& unwanted,
                   std::optional<std::size_t> triangles);
    void addPlaced(const PlacedFile& file);
    void exportPatternTo(const QString& path, const PatternOrder& order, const QImage& cover);
    void exportSurfaceTo(const SurfaceMeshPtr& surface, const QString& path);
    void exportCoverTo(const SurfaceMeshPtr& surface, const FabricBaker& bake, CoverFormat format,
                       const QString& path);
    void finishCoverExport(const CoverFile& file, const QString& path);
    void failImport(const QString& path, const Message& why);
    void fail(const QString& title, const Message& why);
    QMessageBox* newBox(QMessageBox::Icon icon, const QString& text, QMessageBox::StandardButtons buttons);
    QString startFolder() const;

    DesignSession& m_session;
    QWidget* m_window;
    Banner* m_banner;
    QPointer<QMessageBox> m_question;    ///< what becomes of unsaved work
    QPointer<QProgressDialog> m_reading; ///< of the design that is being opened
    int m_restored = 0;                  ///< number of what the banner says about it
    struct Exported {
        QString of; ///< the design's file
        QString folder;
    };
    Exported m_exported;   ///< the last time
    Message m_unprotected; ///< why what is done is not protected; empty when it is
};

} // namespace bolster
