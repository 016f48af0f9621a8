// The picture decoder cannot open files or sockets, whatever a picture makes of it.
#include "../model/TestFiles.h"

#include "ImageImport.h"

#include <OpenImageIO/imageio.h>

#include <QDir>
#include <QProcess>

namespace bolster {
namespace {

std::string printedBy(const QString& program, const QStringList& arguments)
{
    QProcess process;
    process.start(program, arguments);
    EXPECT_TRUE(process.waitForFinished(60'000));
    EXPECT_EQ(process.exitCode(), 0) << process.readAllStandardError().toStdString();
    return process.readAllStandardOutput().toStdString();
}

class SandboxTest : public TestFiles {
protected:
    /// More pixels than fit into a pipe.
    QString picture() const
    {
        const std::string file = path("a.png").toStdString();
        const auto output = OIIO::ImageOutput::create("png");
        EXPECT_TRUE(output && output->open(file, OIIO::ImageSpec(600, 600, 3, OIIO::TypeDesc::UINT8)));
        const std::vector<std::uint8_t> values(600 * 600 * 3, 128);
        EXPECT_TRUE(output->write_image(OIIO::TypeDesc::UINT8, values.data()) && output->close());
        return path("a.png");
    }
};

TEST_F(SandboxTest, NothingButComputingIsPossible)
{
    EXPECT_EQ(printedBy(SANDBOX_PROBE, {}), "");
    const std::string outside = printedBy(SANDBOX_PROBE, {"free"});
    for (const char* what : {"read a file", "see a file", "write to another open file", "open a local socket",
                             "start a process", "have memory that runs"})
        EXPECT_NE(outside.find(what), std::string::npos) << what;
}

TEST_F(SandboxTest, TheDecoderIsInItWhileItDecodes)
{
    QProcess decoder; // which waits for somebody who takes the pixels
    decoder.setStandardInputFile(picture());
    decoder.start(ImageDecoder::usualProgram(), {}, QIODevice::ReadOnly);
    decoder.setReadChannel(QProcess::StandardOutput);
    ASSERT_TRUE(decoder.waitForReadyRead(60'000)); // it has sent the head, so it has seen the picture
    const QString proc = QString("/proc/%1/").arg(decoder.processId());
    QFile status(proc + "status");
    ASSERT_TRUE(status.open(QIODevice::ReadOnly));
    const QByteArray text = status.readAll();
    EXPECT_TRUE(text.contains("Seccomp:\t2")) << text.toStdString();
    EXPECT_TRUE(text.contains("NoNewPrivs:\t1"));
    decoder.kill();
    decoder.waitForFinished();
}

TEST_F(SandboxTest, TheDecoderHasNoEnvironment)
{
    qputenv("BOLSTER_SECRET", "1");
    const QString program =
        write("decoder", "#!/bin/sh\n[ -z \"$BOLSTER_SECRET$HOME$DISPLAY\" ] && printf "
                         "'MILB\\0\\0\\0\\0\\001\\0\\0\\0\\001\\0\\0\\0\\001\\0\\0\\0pixl'; sleep 1000\n");
    QFile::setPermissions(program, QFile::ReadOwner | QFile::ExeOwner);
    ImageDecoder decoder{program};
    decoder.time = std::chrono::milliseconds(20'000);
    const ImageOutcome outcome = importImage(picture(), {}, decoder);
    EXPECT_TRUE(outcome.pixels) << outcome.problem.english();
    qunsetenv("BOLSTER_SECRET");
}

} // namespace
} // namespace bolster
