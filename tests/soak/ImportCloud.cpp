// bolster_import_cloud COUNT [FOLDER [ENDING...]]: writes scans of so many points as PLY, XYZ, PCD and compressed
// PCD (ply, xyz, pcd, packed.pcd), imports them, and prints the peak of memory over what there was before, the
// time, and how long it takes to stop.
#include "CloudImport.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <random>
#include <string>
#include <thread>

namespace bolster {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Of this process: "VmHWM", "VmRSS", in MB.
double memory(const std::string& what)
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(what))
            return std::atof(line.c_str() + what.size() + 1) * 1024 / 1e6;
    return 0;
}

/// From now on the peak is counted anew.
void forgetPeak()
{
    std::ofstream("/proc/self/clear_refs") << "5";
}

/// A room of 6 x 4 x 2.5 m with a wavy floor, seen in rows as scanners do.
Vec3 pointOf(std::uint64_t i, std::uint64_t count, std::mt19937& random)
{
    std::normal_distribution<double> noise(0, 0.4);
    const double t = 40 * static_cast<double>(i) / static_cast<double>(count);
    const double row = std::fmod(t, 1.0);
    const double column = static_cast<double>(random()) / 4294967296.0;
    const double z = t < 20 ? 30 * std::sin(9 * row) * std::sin(7 * column) : 2500 * row;
    return {6000 * column + noise(random), t < 20 ? 4000 * row : 4000 + noise(random), z + noise(random)};
}

/// Column by column, in runs of bytes as they are: the form of compressed ones, though it saves nothing.
void writePackedPcd(const std::string& path, std::uint64_t count)
{
    constexpr std::size_t longestRun = 32;
    std::ofstream file(path, std::ios::binary);
    const auto size = static_cast<std::uint32_t>(12 * count);
    const std::uint32_t packed = size + (size + longestRun - 1) / longestRun;
    file << "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " << count
         << "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " << count << "\nDATA binary_compressed\n";
    file.write(reinterpret_cast<const char*>(&packed), sizeof packed);
    file.write(reinterpret_cast<const char*>(&size), sizeof size);
    std::string run;
    const auto flush = [&] {
        file.put(static_cast<char>(run.size() - 1)).write(run.data(), static_cast<std::streamsize>(run.size()));
        run.clear();
    };
    for (int axis = 0; axis < 3; ++axis) {
        std::mt19937 random(1); // the same points again
        for (std::uint64_t i = 0; i < count; ++i) {
            const auto number = static_cast<float>(pointOf(i, count, random)[axis]);
            run.append(reinterpret_cast<const char*>(&number), sizeof number);
            if (run.size() == longestRun)
                flush();
        }
    }
    if (!run.empty())
        flush();
}

void writeScan(const std::string& path, std::uint64_t count)
{
    if (path.ends_with("packed.pcd")) {
        writePackedPcd(path, count);
        return;
    }
    std::ofstream file(path, std::ios::binary);
    std::mt19937 random(1);
    const std::string number = std::to_string(count);
    const bool text = path.ends_with("xyz");
    if (path.ends_with("ply"))
        file << "ply\nformat binary_little_endian 1.0\nelement vertex " << number
             << "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
    if (path.ends_with("pcd"))
        file << "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " << number
             << "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " << number << "\nDATA binary\n";
    for (std::uint64_t i = 0; i < count; ++i) {
        const Vec3 point = pointOf(i, count, random);
        const Eigen::Vector3f floats = point.cast<float>();
        char line[100];
        if (text)
            file.write(line, std::snprintf(line, sizeof line, "%.3f %.3f %.3f\n", point.x(), point.y(), point.z()));
        else
            file.write(reinterpret_cast<const char*>(floats.data()), sizeof floats);
    }
}

struct Stop {
    double seconds = 0;
    double processor = 0; ///< s: says more on a busy machine
};

double processorTime()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// The longest of some tries: from the request to stop until it is done.
Stop slowestStop(const QString& file, double seconds)
{
    Stop slowest;
    for (const double share : {0.02, 0.3, 0.45, 0.5, 0.55, 0.6, 0.8, 0.97}) {
        std::stop_source stop;
        Clock::time_point asked;
        double before = 0;
        std::jthread later([&] {
            std::this_thread::sleep_for(std::chrono::duration<double>(share * seconds));
            asked = Clock::now();
            before = processorTime();
            stop.request_stop();
        });
        const bool stopped = !importCloud(file, {stop.get_token(), {}}).cloud;
        const Clock::time_point ended = Clock::now();
        const double after = processorTime();
        later.join();
        if (!stopped)
            continue;
        slowest.seconds = std::max(slowest.seconds, std::chrono::duration<double>(ended - asked).count());
        slowest.processor = std::max(slowest.processor, after - before);
    }
    return slowest;
}

int run(std::uint64_t count, const QString& folder, const QStringList& endings)
{
    for (const QString& ending : endings) {
        const QString file = folder + "/bolster-scan." + ending;
        writeScan(file.toStdString(), count);
        forgetPeak();
        const double before = memory("VmRSS:");
        const auto start = Clock::now();
        const ImportedCloud imported = importCloud(file);
        const double seconds = secondsSince(start);
        const double peak = memory("VmHWM:") - before;
        if (!imported.cloud) {
            std::fprintf(stderr, "%s\n", imported.problem.english().c_str());
            return 1;
        }
        const Stop stop = slowestStop(file, seconds);
        std::printf(
            "%-10s  %11llu points, %5.0f MB  ->  %8zu points, one every %.2f  peak %4.0f MB over base  %6.1f s  "
            "stops within %3.0f ms (%.0f ms of processor time)\n",
            qPrintable(ending), static_cast<unsigned long long>(count),
            static_cast<double>(QFileInfo(file).size()) / 1e6, imported.cloud->points.size(),
            imported.cloud->spacing, peak, seconds, 1000 * stop.seconds, 1000 * stop.processor);
        std::fflush(stdout);
        QFile::remove(file);
    }
    return 0;
}

} // namespace
} // namespace bolster

int main(int argc, char* argv[])
{
    const QCoreApplication application(argc, argv);
    const QStringList words = QCoreApplication::arguments();
    const QStringList endings = words.mid(3);
    return bolster::run(words.size() > 1 ? words[1].toULongLong() : 10'000'000, words.value(2, QDir::tempPath()),
                        endings.isEmpty() ? QStringList{"ply", "xyz", "pcd", "packed.pcd"} : endings);
}
