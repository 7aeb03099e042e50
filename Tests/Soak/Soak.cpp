#include <antinode_focus/FocusPlaces.h>
#include <antinode_graph/InstrumentGraph.h>
#include <antinode_graph/OutputNodes.h>
#include <antinode_session/DesignWorker.h>

#include <Support/AudioThreadGuards.h>

#include <Support/SineBeam.h>
#include <Support/WaitForBank.h>

#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <thread>

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr double rate = 48000;
constexpr int ceramics = 8, probes = 2;
constexpr int longestBlock = 64;     // 1 to 64, in the mean 32
constexpr double voltageLimit = 0.5; // V: more than a focus asks for, less than what many at once do
constexpr double triggersPerSecond = 256, releasesPerSecond = 128, stopsPerSecond = 0.5;

struct Findings
{
    std::int64_t samples = 0, sent = 0, releases = 0, stops = 0, requests = 0;
    std::int64_t allocations = 0, locks = 0, limited = 0, failed = 0;
    double largestVoltage = 0, largestVelocity = 0; // V, m/s
    bool isFinite = true;
    PlayerCounters counters;
};

/** Notes as from a player with many hands: triggers, releases and stops, each at random samples. */
class RandomEvents
{
public:
    RandomEvents() { events.reserve (3UL * longestBlock); }

    const std::vector<FocusEvent>& next (int count, Findings& findings)
    {
        events.clear();

        for (int n = 0; n < count; ++n)
        {
            if (happens (triggersPerSecond))
                add (n, FocusEventKind::trigger, findings.sent);

            if (happens (releasesPerSecond))
                add (n, FocusEventKind::release, findings.releases);

            if (happens (stopsPerSecond))
                add (n, FocusEventKind::stopAll, findings.stops);
        }

        return events;
    }

    int blockLength() { return 1 + static_cast<int> (random() % longestBlock); }

private:
    bool happens (double perSecond) { return static_cast<double> (random()) < perSecond / rate * 4294967296.0; }

    void add (int offset, FocusEventKind kind, std::int64_t& count)
    {
        events.push_back ({ offset, kind, static_cast<int> (random() % (FocusBank::livePlace + 1)),
                            static_cast<double> (random() % 128) / 127 });
        ++count;
    }

    std::mt19937 random { 11 };
    std::vector<FocusEvent> events;
};

/** Plays so many seconds of audio as fast as it goes, random events all along, and looks at every block. */
void play (NodeGraph& graph, double seconds, Findings& findings)
{
    using Block = Eigen::Matrix<double, longestBlock, ceramics + probes>;
    Block block = Block::Zero();
    std::array<double*, ceramics + probes> channels;
    RandomEvents random;
    const auto wanted = findings.samples + static_cast<std::int64_t> (seconds * rate);

    for (std::size_t i = 0; i < channels.size(); ++i)
        channels[i] = block.col (static_cast<Eigen::Index> (i)).data();

    while (findings.samples < wanted)
    {
        const auto count = random.blockLength();
        const auto& events = random.next (count, findings);
        const auto memoryBefore = mallocCalls(), locksBefore = lockCalls();
        {
            const SyscallTrap trap;
            const RealtimeScope realtime;
            graph.process (channels.data(), count, events);
        }
        findings.allocations += mallocCalls() - memoryBefore;
        findings.locks += lockCalls() - locksBefore;
        findings.samples += count;
        findings.isFinite = findings.isFinite && block.allFinite();
        const auto voltage = block.leftCols<ceramics>().cwiseAbs().maxCoeff();
        const auto velocity = block.rightCols<probes>().cwiseAbs().maxCoeff();
        findings.largestVoltage = std::max (findings.largestVoltage, voltage);
        findings.largestVelocity = std::max (findings.largestVelocity, velocity);
    }
}

std::shared_ptr<const ModalModel> limitedBeam()
{
    auto model = sineBeam (10, ceramics);

    for (auto& ceramic : model.ceramics)
        ceramic.voltageLimit = voltageLimit;

    return std::make_shared<const ModalModel> (model);
}

/** A bank of all places with foci of some width, of which every other has a brake, and every third plays samples. */
DesignRequest makeRequest (const std::shared_ptr<const ModalModel>& model, unsigned choice)
{
    DesignRequest request;
    request.model = model;
    request.focus.targets = { Target {} };
    request.focus.targets[0].width = 0.02 + 1e-4 * (choice % 100);
    request.focus.targets[0].peakVelocity = 0.01;
    request.focus.focusTime = 0.02;
    request.focus.modes.count = 5;
    request.places = bankPlaces (model->surface, FocusBank::places, 0.02);
    request.first = { static_cast<int> (choice % FocusBank::places) };
    request.playback = { Reconstruction::bandLimited, rate };

    if (choice % 2 == 0)
        request.focus.transients.brake = 5;

    if (choice % 3 == 0)
        request.focus.allocation.method = AllocationMethod::leastVoltage;

    return request;
}

/** The whole graph for some seconds of audio, while a worker designs banks that are asked for at random. */
void soak (const PlayerSettings& settings, double seconds, Findings& findings)
{
    const auto model = limitedBeam();
    Eigen::MatrixXd probeShapes (probes, model->modes());
    probeShapes << shapesAt (*model, -0.03, 0), shapesAt (*model, 0.05, 0);
    InstrumentNodes nodes;
    nodes.settings = settings;
    nodes.probeShapes = probeShapes;
    auto standard = instrumentGraph (model, std::move (nodes));
    standard.graph.prepare ({ rate, longestBlock });
    auto& player = standard.voiceNode().voices();
    DesignWorker worker (player.handOver());
    worker.request (makeRequest (model, 0));
    test::waitForBank (worker, FocusBank::places);
    std::atomic<bool> isPlaying { true };
    std::thread audio (
        [&]
        {
            play (standard.graph, seconds, findings);
            isPlaying = false;
        });

    for (std::mt19937 random (3); isPlaying; ++findings.requests)
    {
        worker.request (makeRequest (model, static_cast<unsigned> (random())));
        std::this_thread::sleep_for (std::chrono::milliseconds (random() % 60));
        findings.failed += worker.progress().failed;
    }

    audio.join();
    const auto& limiter = static_cast<const LimiterNode&> (standard.graph.node (standard.limiter)).limiter();

    for (const auto count : limiter.limitedSamples())
        findings.limited += count;

    findings.counters.triggered += player.counters().triggered;
    findings.counters.empty += player.counters().empty;
    findings.counters.stolen += player.counters().stolen;
    findings.counters.cut += player.counters().cut;
}

bool isSound (const Findings& findings)
{
    const auto& counters = findings.counters;
    return findings.isFinite && findings.largestVoltage <= voltageLimit && findings.largestVelocity > 0
           && findings.allocations == 0 && findings.locks == 0 && SyscallTrap::firstCaught() < 0
           && counters.triggered == findings.sent && counters.empty == 0 && counters.cut == 0 && findings.failed == 0;
}

void print (const Findings& findings)
{
    const auto number = [] (std::int64_t count) { return static_cast<long long> (count); };
    const auto& counters = findings.counters;
    std::printf (
        "%.0f s of audio in blocks of 1 to %d; %lld foci asked for, %lld begun, %lld stolen, %lld cut; %lld note-offs, "
        "%lld stops, %lld banks asked for\n",
        static_cast<double> (findings.samples) / rate, longestBlock, number (findings.sent),
        number (counters.triggered), number (counters.stolen), number (counters.cut), number (findings.releases),
        number (findings.stops), number (findings.requests));
    std::printf (
        "on the audio thread: %lld allocations%s, %lld locks, first system call %ld%s; largest voltage %g of %g V, "
        "%lld samples limited; largest velocity %g m/s\n",
        number (findings.allocations), mallocIsCounted() ? "" : " (not counted)", number (findings.locks),
        SyscallTrap::firstCaught(), SyscallTrap::isAvailable() ? "" : " (not caught by this kernel)",
        findings.largestVoltage, voltageLimit, number (findings.limited), findings.largestVelocity);
}
} // namespace

/** Plays the whole graph for some seconds of audio, 600 where none are given, a third with each behaviour of note-offs,
   while banks are designed and change all the time. Exit code 1 where anything happened on the audio thread that may
   not, a focus was missed or doubled, or a voltage exceeded its limit. */
int main (int argumentCount, char** arguments)
{
    const auto seconds = argumentCount > 1 ? std::atof (arguments[1]) : 600.0;

    if (! guardsSee())
    {
        std::puts ("the guards of the audio thread do not work");
        return 1;
    }

    Findings findings;
    soak ({ NoteOffBehaviour::ignore, RetriggerBehaviour::overlap }, seconds / 3, findings);
    soak ({ NoteOffBehaviour::fade, RetriggerBehaviour::restart }, seconds / 3, findings);
    soak ({ NoteOffBehaviour::brake, RetriggerBehaviour::overlap, true }, seconds / 3, findings);
    print (findings);
    std::puts (isSound (findings) ? "sound" : "NOT SOUND");
    return isSound (findings) ? 0 : 1;
}
