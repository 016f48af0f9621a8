// The preferences that hold now, and where they are kept.
#pragma once

#include "Preferences.h"

#include "Message.h"

#include <QObject>

namespace bolster {

/// As the settings have them; what is not, or not valid there, is as at first.
Preferences storedPreferences();

class PreferenceStore : public QObject {
    Q_OBJECT

public:
    explicit PreferenceStore(QObject* parent = nullptr);

    const Preferences& now() const { return m_now; }
    /// Those that the program was started with.
    const Preferences& atStart() const { return m_atStart; }
    /// Kept at once, if the disk lets it; in the settings there is only what differs from the program's own.
    void set(const Preferences& preferences);

signals:
    void changed(const bolster::Preferences& before);
    /// They hold while the program runs, but are not on the disk. Said once, until they were kept again.
    void notKept(const bolster::Message& why);

private:
    void keep(const Preferences& before);

    Preferences m_now;
    Preferences m_atStart;
    bool m_notKept = false;
};

/// All settings as text for a file.
std::string preferencesText(const Preferences& preferences);

/// What a file says. Those that it does not have stay as they are in `now`.
struct ReadPreferences {
    Preferences preferences;
    Message problem;      ///< why it is none of ours; nothing is taken then
    QStringList unknown;  ///< keys that another version of the program must have written
    QStringList noFolder; ///< what should be a folder and is none on this machine; that setting stays as it was
};
ReadPreferences readPreferences(const std::string& text, const Preferences& now);

} // namespace bolster
