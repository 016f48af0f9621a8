// The Scan menu, and the same wishes from the properties of a scan.
#pragma once

#include "ElementId.h"

#include <QCoreApplication>
#include <QObject>

#include <functional>
#include <vector>

namespace bolster {

class Commands;
class CoverAtRest;
class Document;
class ImportFlow;
class Inspector;
struct ScanJob;
class ScanLink;
struct ScanMark;
enum class ScanWish;
class Selection;
class StatusLine;
class CoverView;

class ScanCommands : public QObject {
    Q_DECLARE_TR_FUNCTIONS(ScanCommands)

public:
    ScanCommands(Commands& commands, Document& document, Selection& selection, ScanLink& scans, ImportFlow& imports,
                 CoverView& coverView, Inspector& inspector, StatusLine& status, CoverAtRest& cover,
                 QWidget& window);

private:
    void add();
    std::function<void()> wishes(ScanWish wish);
    void onTheScan(const std::function<void(ElementId)>& work);
    void work(ElementId scan, ScanWish wish);
    ScanJob watched(const QString& begun, const std::function<QString(int)>& step);
    void fitPlacement(ElementId scan);
    void askForPlaces(ElementId scan, const std::vector<ScanMark>& marks);
    void align(ElementId scan, const std::vector<ScanMark>& marks);

    Commands& m_commands;
    CoverAtRest& m_cover;
    Document& m_document;
    Selection& m_selection;
    ScanLink& m_scans;
    ImportFlow& m_imports;
    CoverView& m_coverView;
    StatusLine& m_status;
    QWidget& m_window;
};

} // namespace bolster
