// What comes into the design from files of others: frames, scans, patterns.
#pragma once

#include "FileContent.h"
#include "FileTalk.h"
#include "FixationsOff.h"

#include <optional>

namespace bolster {

struct Drawing;
struct FoundPattern;
struct PatternChoice;

class ImportFlow : public QObject {
    Q_OBJECT

public:
    ImportFlow(DesignSession& session, FileTalk& talk);

    /// Ask for file, unit and axis.
    void importFrame(const QString& path = {});
    void importScan(const QString& path = {});
    /// Shows the pieces of a pattern file, and adds those that are wanted.
    void importPattern(const QString& path = {});
    /// The same for an element that is there.
    void replaceFile(ElementId id);

signals:
    /// A frame or a scan is in the design now.
    void imported(bolster::FileKind kind);
    /// A pattern is: of these patches.
    void patternImported(const std::vector<bolster::ElementId>& patches);

private:
    /// What comes to the design, and what it takes the place of.
    struct PlacedFile {
        QString path;
        FileContent content;
        Element element;
        std::optional<ElementId> replaced;
        PlacedMesh old;
    };

    template <class T>
    void import(const T& element, const QString& title, const QString& filter, const QString& path);
    void importNow(const QString& path, const Element& element, std::optional<ElementId> replaced);
    void choosePieces(const QString& path, const Drawing& drawing);
    void addPattern(const QString& path, const std::shared_ptr<const FoundPattern>& pattern,
                    const PatternChoice& choice);
    void place(const QString& path, const ImportedFile& file, const Element& element,
               std::optional<ElementId> replaced);
    /// As an OBJ file without the unwanted parts, with about so many triangles; nothing: with all.
    void writeAnew(const PlacedFile& file, const std::vector<std::string>& unwanted,
                   std::optional<std::size_t> triangles);
    void addPlaced(const PlacedFile& file);
    void failImport(const QString& path, const Message& why);

    DesignSession& m_session;
    FileTalk& m_talk;
};

} // namespace bolster
