// Pages of a document, one below the other, as wide as there is room.
#pragma once

#include <QImage>
#include <QScrollArea>

#include <vector>

namespace bolster {

class PagesView : public QScrollArea {
    Q_OBJECT

public:
    explicit PagesView(QWidget* parent = nullptr);

    /// None: `instead` stands there.
    void showPages(std::vector<QImage> pages, const QString& instead);
    int count() const;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    class Sheets;

    Sheets* m_sheets;
};

} // namespace bolster
