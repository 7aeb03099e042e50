#include <Engine/AllocationCount.h>
#include <Engine/PlayerFixtures.h>
#include <Support/RealtimeScope.h>
#include <Support/SyscallTrap.h>

#include <antinode_engine/VoltageLimiter.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <thread>

#include <sys/syscall.h>
#include <unistd.h>

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr int blockLength = 32;
constexpr double limit = 20; // V: less than what overlapping foci ask for
constexpr double triggersPerSecond = 256;

struct Findings
{
    std::int64_t samples = 0, sent = 0, allocations = 0, locks = 0, limited = 0;
    double largest = 0;
    bool isFinite = true;
    PlayerCounters counters;
};

/** Plays so many seconds of audio as fast as it goes, random triggers all along, and looks at every block. */
void play (FocusPlayer& player, double seconds, Findings& findings)
{
    VoltageLimiter limiter (Eigen::VectorXd::Constant (playerCeramics, limit));
    Eigen::MatrixXd planar (blockLength, playerCeramics), interleaved (playerCeramics, blockLength);
    std::vector<double*> channels;
    std::vector<FocusEvent> events;
    std::mt19937 random (11);
    const auto wanted = static_cast<std::int64_t> (seconds * playerRate);
    double next = 0;
    events.reserve (blockLength);

    for (int i = 0; i < playerCeramics; ++i)
        channels.push_back (planar.col (i).data());

    for (; findings.samples < wanted; findings.samples += blockLength)
    {
        events.clear();

        for (; next < static_cast<double> (findings.samples + blockLength); next += playerRate / triggersPerSecond)
            events.push_back ({ static_cast<int> (next - static_cast<double> (findings.samples)),
                                FocusEventKind::trigger, static_cast<int> (random() % FocusBank::places),
                                static_cast<double> (random() % 128) / 127 });

        findings.sent += static_cast<std::int64_t> (events.size());
        const auto memoryBefore = mallocCalls(), locksBefore = lockCalls();
        {
            const SyscallTrap trap;
            const RealtimeScope realtime;
            player.process (channels.data(), blockLength, events);
            interleaved = planar.transpose();
            limiter.process (interleaved);
        }
        findings.allocations += mallocCalls() - memoryBefore;
        findings.locks += lockCalls() - locksBefore;
        findings.isFinite = findings.isFinite && interleaved.allFinite();
        findings.largest = std::max (findings.largest, interleaved.cwiseAbs().maxCoeff());
    }

    for (const auto count : limiter.limitedSamples())
        findings.limited += count;

    findings.counters = player.counters();
}

/** Whether the guards see what they are there for: a system call, memory and a lock. */
bool guardsSee()
{
    const auto memoryBefore = mallocCalls(), locksBefore = lockCalls();
    std::mutex mutex;
    void* const volatile memory = std::malloc (1); // volatile: else the compiler leaves it out
    std::free (memory);
    mutex.lock();
    mutex.unlock();

    if (SyscallTrap::isAvailable())
    {
        const SyscallTrap trap;
        syscall (SYS_getppid);
    }

    const auto isSeen = (! mallocIsCounted() || (mallocCalls() > memoryBefore && lockCalls() > locksBefore))
                        && (! SyscallTrap::isAvailable() || SyscallTrap::firstCaught() == SYS_getppid);
    SyscallTrap::clear();
    return isSeen;
}

bool isSound (const Findings& findings)
{
    const auto& counters = findings.counters;
    return findings.isFinite && findings.largest <= limit && findings.allocations == 0 && findings.locks == 0
           && SyscallTrap::firstCaught() < 0 && counters.triggered == findings.sent && counters.empty == 0
           && counters.cut == 0;
}
} // namespace

/** Plays random foci for some seconds of audio, 600 where none are given, while banks change all the time. Exit code 1 where anything
    happened on the audio thread that may not, a focus was missed or doubled, or a voltage exceeded its limit. */
int main (int argumentCount, char** arguments)
{
    const auto seconds = argumentCount > 1 ? std::atof (arguments[1]) : 600.0;

    if (! guardsSee())
    {
        std::puts ("the guards of the audio thread do not work");
        return 1;
    }

    FocusPlayer player (playerCeramics, playerRate, {});
    player.handOver().give (variedBank (10));
    std::atomic<bool> isPlaying { true };
    std::int64_t banks = 1;
    std::thread worker (
        [&]
        {
            for (; isPlaying; ++banks)
            {
                player.handOver().give (variedBank (5 + static_cast<double> (banks % 10)));
                std::this_thread::sleep_for (std::chrono::microseconds (200));
            }
        });
    Findings findings;
    std::thread audio ([&] { play (player, seconds, findings); });
    audio.join();
    isPlaying = false;
    worker.join();

    const auto& counters = findings.counters;
    std::printf (
        "%.0f s of audio in blocks of %d, %lld foci asked for, %lld begun, %lld stolen, %lld cut, %lld banks\n",
        static_cast<double> (findings.samples) / playerRate, blockLength, static_cast<long long> (findings.sent),
        static_cast<long long> (counters.triggered), static_cast<long long> (counters.stolen),
        static_cast<long long> (counters.cut), static_cast<long long> (banks));
    std::printf (
        "on the audio thread: %lld allocations%s, %lld locks, first system call %ld%s; largest voltage %g of %g V, "
        "%lld samples limited\n",
        static_cast<long long> (findings.allocations), mallocIsCounted() ? "" : " (not counted)",
        static_cast<long long> (findings.locks), SyscallTrap::firstCaught(),
        SyscallTrap::isAvailable() ? "" : " (not caught by this kernel)", findings.largest, limit,
        static_cast<long long> (findings.limited));
    std::puts (isSound (findings) ? "sound" : "NOT SOUND");
    return isSound (findings) ? 0 : 1;
}
