// Timers and standard paths need an application; files of the tests must not mix with the user's.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QTemporaryDir>

#include <memory>

namespace {

class CoreApplication : public ::testing::Environment {
    void SetUp() override
    {
        static int argc = 1;
        static char name[] = "bolster-model-tests";
        static char* argv[] = {name, nullptr};
        qputenv("XDG_DATA_HOME", m_home.path().toUtf8());
        m_application = std::make_unique<QCoreApplication>(argc, argv);
    }
    void TearDown() override { m_application.reset(); }

    QTemporaryDir m_home; // each test runs in a process of its own, several at a time
    std::unique_ptr<QCoreApplication> m_application;
};

[[maybe_unused]] const auto* const registered = ::testing::AddGlobalTestEnvironment(new CoreApplication);

} // namespace
