// What came of laying a form flat, in words.
#pragma once

#include "FormPatternJob.h"

#include <QCoreApplication>
#include <QStringList>

namespace bolster {

struct FormPatternReport {
    Q_DECLARE_TR_FUNCTIONS(FormPatternReport)

public:
    const FormMade& made;
    const FormCover* cover = nullptr; ///< null: not known
    bool isSolved = false;            ///< its cover will be known soon
    bool divides = false;             ///< what would not lie flat was to be divided
    double limit = 0;                 ///< of strain that the fabric bears; 1
    double edgeLength = 0;            ///< of the cover, mm
    bool isFrame = false;             ///< the form is of one
    bool keepsOutside = false;        ///< which keeps the cover outside

    /// A line for each thing there is to say; of a form of which nothing became, why.
    QString text() const;

private:
    /// How pieces are strained that lie on the form, not sewn and not held.
    struct OnForm {
        const FlatPiece* worst = nullptr;
        std::string name; ///< of the worst one
        int pieces = 0;   ///< that are not left out
        int over = 0;     ///< the limit
    };

    OnForm onForm() const;
    QString problemText() const;
    static QStringList saidOnce(const std::vector<Message>& notes);
    void sayPieces(int pieces, QStringList& lines) const;
    void sayCover(int over, QStringList& lines) const;
    void sayBeside(QStringList& lines) const;
    void sayLeftOut(QStringList& lines) const;
    static void sayStrain(const OnForm& found, QStringList& lines);
    void sayWhatHelps(const OnForm& found, QStringList& lines) const;
};

} // namespace bolster
