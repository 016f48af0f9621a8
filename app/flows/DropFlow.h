// Files that are dropped on the window, of whatever kind: each goes the way of its own import, one after the other.
#pragma once

#include <QObject>
#include <QStringList>
#include <QTimer>

#include <functional>

namespace bolster {

class FabricCommands;
struct FileFlows;

class DropFlow : public QObject {
    Q_OBJECT

public:
    DropFlow(FileFlows& files, FabricCommands& fabrics, QWidget* window);

    /// The first design is opened here, others in windows of their own; then what is to come to it is imported.
    void drop(const QStringList& files);
    /// By the ending of the file.
    static bool takes(const QString& file);
    /// Where further designs are opened; false: it could not be.
    void setOtherWindows(std::function<bool(const QString&)> open) { m_elsewhere = std::move(open); }
    bool busy() const { return m_going || !m_waiting.isEmpty(); }

private:
    void goOn();
    void take(const QString& file);
    void takeDesign(const QString& file);
    void import(const QString& file);
    bool occupied() const;
    QString whyNot(const QString& file) const;

    FileFlows& m_files;
    FabricCommands& m_fabrics;
    QWidget* m_window;
    std::function<bool(const QString&)> m_elsewhere;
    QStringList m_waiting;
    bool m_opened = false; ///< one of those that were dropped together
    bool m_going = false;
    QTimer m_look; ///< whether the one before is done
};

} // namespace bolster
