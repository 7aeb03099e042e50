#include <antinode_focus/FocusPlaces.h>
#include <antinode_graph/InstrumentGraph.h>
#include <antinode_graph/OutputNodes.h>
#include <antinode_session/DesignWorker.h>

#include <Support/SineBeam.h>
#include <Support/WaitForBank.h>

#include <catch2/catch.hpp>

#include <atomic>
#include <random>

using namespace antinode;

// Everything that several threads touch, all at once: to be run under ThreadSanitizer (preset tsan), and shortly in any
// build.

namespace
{
constexpr double rate = 48000;
constexpr int ceramics = 6, places = 16, blockLength = 32;

struct Stress
{
    std::shared_ptr<const ModalModel> model = std::make_shared<const ModalModel> (test::sineBeam (10, ceramics));
    InstrumentGraph standard;
    std::atomic<bool> isRunning { true };
    std::int64_t sent = 0; ///< Of the audio thread, as all below.
    bool isFinite = true;
    double largest = 0;

    Stress()
    {
        PlayerSettings settings;
        settings.noteOff = NoteOffBehaviour::brake;
        InstrumentNodes nodes;
        nodes.settings = settings;
        nodes.probeShapes = shapesAt (*model, 0.01, 0);
        standard = instrumentGraph (model, std::move (nodes));
        standard.graph.prepare ({ rate, blockLength });
    }

    FocusVoices& player() { return standard.voiceNode().voices(); }

    DesignRequest request (double width) const
    {
        DesignRequest request;
        request.model = model;
        request.focus.targets = { Target {} };
        request.focus.targets[0].width = width;
        request.focus.targets[0].peakVelocity = 0.02;
        request.focus.focusTime = 0.02;
        request.focus.modes.count = 5;
        request.focus.transients.brake = 5;
        request.places = bankPlaces (model->surface, places, 0.02);
        request.playback = { Reconstruction::bandLimited, rate };
        return request;
    }

    void play()
    {
        std::mt19937 random (5);
        Eigen::MatrixXd block (blockLength, ceramics + 1);
        std::vector<double*> channels;

        for (int i = 0; i <= ceramics; ++i)
            channels.push_back (block.col (i).data());

        for (int n = 0; isRunning; ++n)
        {
            const auto isTrigger = n % 4 == 0;
            const FocusEvent event { n % blockLength, isTrigger ? FocusEventKind::trigger : FocusEventKind::release,
                                     static_cast<int> (random() % places), 0.5 };
            standard.graph.process (channels.data(), blockLength, std::span (&event, 1));
            sent += isTrigger ? 1 : 0;
            isFinite = isFinite && block.allFinite();
            largest = std::max (largest, block.leftCols (ceramics).cwiseAbs().maxCoeff());
            std::this_thread::sleep_for (std::chrono::microseconds (50));
        }
    }

    /** What an editor does while it is open. */
    void watch (const DesignWorker& worker)
    {
        auto& limiter = static_cast<LimiterNode&> (standard.graph.node (standard.limiter));

        for (bool isArmed = true; isRunning; isArmed = ! isArmed)
        {
            const auto progress = worker.progress();
            isProgressSound = isProgressSound && progress.designed <= progress.wanted && progress.error.empty();
            limiter.setArmed (isArmed);
            std::this_thread::sleep_for (std::chrono::microseconds (70));
        }
    }

    bool isProgressSound = true; ///< Of the thread that watches.
};
} // namespace

TEST_CASE ("Requests, designs, progress and the whole graph at once, and an end in the midst of it", "[stress]")
{
    Stress stress;
    std::thread audio ([&] { stress.play(); });
    {
        DesignWorker worker (stress.player().handOver());
        std::thread editor ([&] { stress.watch (worker); });

        for (int i = 0; i < 60; ++i)
        {
            worker.request (stress.request (0.02 + 0.0003 * i));
            std::this_thread::sleep_for (std::chrono::milliseconds (i % 7));

            if (i % 20 == 10)
                test::waitForBank (worker, places);
        }

        worker.request (stress.request (0.025));
        std::this_thread::sleep_for (std::chrono::milliseconds (5));
        stress.isRunning = false;
        editor.join();
    } // The worker ends while it designs.
    audio.join();
    const auto& counters = stress.player().counters();
    CHECK (counters.triggered > 0);
    CHECK (counters.triggered + counters.empty == stress.sent);
    CHECK (stress.isFinite);
    CHECK (stress.isProgressSound);
    CHECK (stress.largest <= 150);
}

TEST_CASE ("A bank is taken, replaced or freed, whoever is quicker", "[stress]")
{
    constexpr int given = 2000;
    BankHandOver handOver;
    std::atomic<bool> isGiving { true };
    int taken = 0;
    std::thread audio (
        [&]
        {
            const FocusBank* playing = nullptr;

            while (isGiving)
                if (const auto* const bank = handOver.canGiveBack() ? handOver.take() : nullptr)
                {
                    if (playing != nullptr)
                        handOver.giveBack (playing);

                    playing = bank;
                    ++taken;
                }

            if (playing != nullptr)
                handOver.giveBack (playing);
        });

    for (int i = 0; i < given; ++i)
        handOver.give (std::make_unique<const FocusBank>());

    isGiving = false;
    audio.join();
    CHECK (taken <= given);
}
