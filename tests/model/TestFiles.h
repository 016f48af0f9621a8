// Files that tests write and read.
#pragma once

#include <QFile>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <string>
#include <string_view>

namespace bolster {

/// A number as the bytes of a binary file.
template <class Number>
void append(std::string& bytes, Number value, bool bigEndian = false)
{
    auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(value);
    if (bigEndian)
        std::reverse(raw.begin(), raw.end());
    bytes.append(raw.data(), raw.size());
}

class TestFiles : public ::testing::Test {
protected:
    QString path(const QString& name) const { return m_folder.filePath(name); }

    QString write(const QString& name, std::string_view bytes) const
    {
        QFile file(path(name));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        EXPECT_EQ(file.write(bytes.data(), static_cast<qint64>(bytes.size())), static_cast<qint64>(bytes.size()));
        return file.fileName();
    }

    std::string read(const QString& name) const
    {
        QFile file(path(name));
        EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name.toStdString();
        return file.readAll().toStdString();
    }

    QTemporaryDir m_folder;
};

} // namespace bolster
