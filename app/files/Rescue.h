// Damaged files and damaged work: what can be read of them goes into a new project.
#pragma once

#include "FileTalk.h"
#include "WorkJournal.h"

namespace bolster {

class SaveFlow;
struct Salvaged;

class Rescue : public QObject {
    Q_OBJECT

public:
    Rescue(FileTalk& talk, SaveFlow& saving);

    /// Says why, and offers to recover what can be read of a damaged project.
    void failToOpen(const QString& path, const Message& problem);
    void salvageWork(const WorkJournal::Left& damaged, const QString& why);
    void offerWorkSalvage(const WorkJournal::Left& damaged);

signals:
    /// This was recovered, and shall be opened.
    void openWanted(const QString& path);

private:
    void offerSalvage(const QString& path, const Message& problem, bool damaged);
    void salvage(const QString& path);
    void sayWhatIsLeft(const QString& path, const std::vector<Message>& notes);
    void sayWhatBecameOf(const QString& work, const QString& why, const QString& recovered,
                         const Salvaged& salvaged);

    FileTalk& m_talk;
    SaveFlow& m_saving;
};

} // namespace bolster
