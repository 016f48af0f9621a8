// Pictures for the cards of the start page, read beside the windows.
#pragma once

#include <QImage>
#include <QObject>
#include <QStringList>

namespace bolster {

/// Those that nobody has asked for lately are forgotten with the object.
class StartPictures : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// Of designs and projects, one after the other: that in a project, or NAME.png beside it.
    void read(const QStringList& designs);
    /// A picture in one of these forms; null when there is none that makes sense. May be asked on any thread.
    static QImage pictureOf(const QString& design);

signals:
    /// `there`: the file is. The picture may be null.
    void found(const QString& design, bool there, const QImage& picture);

private:
    struct Found {
        bool there = false;
        QImage picture;
    };

    void readNext(QStringList designs, int asked);

    int m_asked = 0; ///< only the newest list counts
};

} // namespace bolster
