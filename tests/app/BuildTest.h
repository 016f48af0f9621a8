// A window in which a whole design is built by pointer and keys and compared with the one that was meant.
#pragma once

#include "DesignJson.h"
#include "DesignLikeness.h"
#include "Designer.h"
#include "TestPaths.h"
#include "WindowTest.h"

#include <QFile>

namespace bolster {

class BuildTest : public WindowTest {
protected:
    void SetUp() override
    {
        WindowTest::SetUp();
        m_empty = design();
    }

    const Design& design() { return window.document().design(); }

    /// It is as in tests/data/designs, it settles without a problem, and every step can be undone and redone.
    /// With BOLSTER_WRITE_BUILT in the environment the file is written anew.
    void expectBuilt(const QString& name)
    {
        const Design built = design();
        const QString path = QString::fromStdString(test::dataFolder() + "/designs/") + name;
        if (qEnvironmentVariableIsSet("BOLSTER_WRITE_BUILT"))
            write(path, built);
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
        const ReadDesign expected = readDesign(file.readAll().toStdString());
        ASSERT_TRUE(expected.readable);
        const QStringList different = differences(built, expected.design, 1.5);
        EXPECT_TRUE(different.isEmpty()) << different.join(u'\n').toStdString();
        ASSERT_TRUE(waitUntilSolved());
        for (const Problem& problem : window.solver().status().problems)
            ADD_FAILURE() << problem.english();
        EXPECT_TRUE(window.session().problems().empty());
        expectUndone(built);
    }

    Designer designer{window};

private:
    static void write(const QString& path, const Design& design)
    {
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(QByteArray::fromStdString(writeDesign(design)));
    }

    void expectUndone(const Design& built)
    {
        const int steps = window.document().history().count() - 1;
        for (int i = 0; i < steps; ++i)
            designer.key(Qt::Key_Z, Qt::ControlModifier);
        EXPECT_EQ(writeDesign(design()), writeDesign(m_empty));
        EXPECT_FALSE(window.command("edit.undo")->isEnabled());
        for (int i = 0; i < steps; ++i)
            designer.key(Qt::Key_Y, Qt::ControlModifier);
        EXPECT_EQ(writeDesign(design()), writeDesign(built));
    }

    Design m_empty;
};

} // namespace bolster
