#include "PlayerFixtures.h"
#include "Support/AllocationCount.h"

#include <antinode_engine/PlateModel.h>
#include <antinode_focus/Brake.h>
#include <antinode_focus/Prediction.h>

#include <Support/SineBeam.h>

#include <Eigen/LU>
#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr double rate = 192000;
constexpr Playback playback { Reconstruction::bandLimited, rate };
constexpr int place = 60;

std::int64_t toSamples (double seconds)
{
    return std::llround (seconds * rate);
}

/** Eight modes of a beam that decay with 40 / s, each moved by a ceramic of its own for 20 ms, then brought to rest
   within 20 ms, or not. */
struct Braked
{
    ModalModel model = sineBeam (playerCeramics, playerCeramics);
    VoltageProgram program;
    std::shared_ptr<const PlayableFocus> focus;

    explicit Braked (bool isBraked = true)
    {
        model.dampingRatios = 40 * model.angularFrequencies.cwiseInverse();
        model.participation.setIdentity();
        program.focusTime = 0.02;
        program.voltageLimits = Eigen::VectorXd::Constant (playerCeramics, 100);
        program.allocation = Eigen::MatrixXd::Identity (playerCeramics, playerCeramics);

        for (int k = 0; k < playerCeramics; ++k)
            program.oscillations.push_back ({ k, 0, 0.02, 100, dampedFrequencies (model)[k], 0.1, 0.02 * k });

        if (isBraked)
            appendBrakes (0.0207);

        focus = std::make_shared<const PlayableFocus> (program, playback);
    }

    void appendBrakes (double time)
    {
        const BrakeWindow window { time, time + 0.02, 200 };
        const auto states = predictStates (model, program, window.end);
        const auto poles = modalPoles (model);

        for (int k = 0; k < playerCeramics; ++k)
        {
            auto drives = brakeDrives (k, decayRates (model)[k], dampedFrequencies (model)[k], window);
            Eigen::Matrix2d responses;
            responses.col (0) = responseTo (drives[0], poles[k], window.end);
            responses.col (1) = responseTo (drives[1], poles[k], window.end);
            const Eigen::Vector2d amounts =
                responses.inverse() * Eigen::Vector2d (-states[k].real(), -states[k].imag());
            const auto share = counterShare (poles[k], drives, { amounts[0], -amounts[1] });

            for (int d = 0; d < 2; ++d)
                for (auto oscillation : drives[static_cast<std::size_t> (d)])
                {
                    oscillation.counterShare = share;
                    program.oscillations.push_back (oscillation);
                    program.allocation.conservativeResize (Eigen::NoChange, program.allocation.cols() + 1);
                    program.allocation.rightCols<1>() = amounts[d] * Eigen::VectorXd::Unit (playerCeramics, k);
                }
        }
    }

    static Eigen::Vector2d responseTo (const std::vector<Oscillation>& drive, std::complex<double> pole, double time)
    {
        std::complex<double> state = 0;

        for (const auto& oscillation : drive)
            state += modalResponse (pole, oscillation, time);

        return { state.real(), state.imag() };
    }

    Eigen::MatrixXd played (const std::vector<TimedEvent>& events, Eigen::Index length, PlayerSettings settings,
                            const std::vector<int>& blocks = { 256 }) const
    {
        FocusPlayer player (playerCeramics, rate, settings);
        giveTo (player);
        return test::played (player, events, length, blocks);
    }

    void giveTo (FocusPlayer& player) const
    {
        auto bank = std::make_unique<FocusBank>();
        bank->foci[place] = bank->foci[place + 1] = focus;
        player.handOver().give (std::move (bank));
    }

    std::int64_t brakeStart() const { return focus->brake->startSample(); }

    /** How large the motion is at a sample, kinetic and elastic: the root of the sum of v_k^2 + (b_k q_k)^2. */
    double motionAt (const Eigen::MatrixXd& voltages, std::int64_t sample) const
    {
        PlateModel plate (model, playback, Eigen::MatrixXd (0, model.modes()));
        Eigen::MatrixXd velocities (model.modes(), sample + plate.latencySamples() + 1);
        plate.processModes (voltages.leftCols (velocities.cols()), velocities);
        const Eigen::VectorXd turned = dampedFrequencies (model).cwiseProduct (plate.modalDisplacements());
        return std::hypot (plate.modalVelocities().norm(), turned.norm());
    }
};

PlayerSettings holding()
{
    PlayerSettings settings;
    settings.noteOff = NoteOffBehaviour::brake;
    return settings;
}
} // namespace

TEST_CASE ("A brake that a note-off begins late stops the plate as well as the designed one", "[engine][player]")
{
    const Braked braked;
    const auto length = toSamples (0.15), rest = toSamples (0.025);
    const auto start = braked.brakeStart();
    const auto designed = braked.played ({ triggerAt (0, place) }, length, {});
    const auto leftByDesigned = braked.motionAt (designed, start + rest) / braked.motionAt (designed, start);
    CHECK (leftByDesigned < 3e-4);

    for (const auto delay : { 1, 28, 160, 1333, 4000, 10000 })
    {
        const auto late = braked.played ({ triggerAt (0, place), releaseAt (start + delay, place) }, length, holding());
        const auto left = braked.motionAt (late, start + delay + rest) / braked.motionAt (late, start + delay);
        CAPTURE (delay);
        CHECK (left < 1.5 * leftByDesigned);
    }
}

TEST_CASE ("The plate rings freely after the focus while the note is held", "[engine][player]")
{
    const Braked braked, free (false);
    const auto length = toSamples (0.1);
    const auto held = braked.played ({ triggerAt (0, place) }, length, holding());
    CHECK ((held - free.played ({ triggerAt (0, place) }, length, {})).cwiseAbs().maxCoeff()
           < 1e-12 * held.cwiseAbs().maxCoeff());
    CHECK (held.rightCols (length - braked.focus->endSample).cwiseAbs().maxCoeff() == 0);
}

TEST_CASE ("A note-off before the brake's own time is the plain play", "[engine][player]")
{
    const Braked braked;
    const auto length = toSamples (0.1);
    const auto plain = braked.played ({ triggerAt (5, place, 0.7) }, length, {});

    for (const auto release : std::initializer_list<std::int64_t> { 6, 900, braked.brakeStart() + 5 })
        CHECK (braked.played ({ triggerAt (5, place, 0.7), releaseAt (release, place) }, length, holding()) == plain);

    // What is played is what the program says, in one synthesiser.
    Eigen::MatrixXd whole (playerCeramics, length);
    VoltageSynthesiser (braked.program, playback).process (-5, whole);
    CHECK ((0.7 * whole - plain).cwiseAbs().maxCoeff() < 1e-12 * plain.cwiseAbs().maxCoeff());
}

TEST_CASE ("A late brake is the same to the bit in blocks of any size", "[engine][player]")
{
    const Braked braked;
    std::vector<TimedEvent> events;

    for (int i = 0; i < 60; ++i)
        events.push_back (i % 3 == 2 ? releaseAt (211 * i, place + i % 2) : triggerAt (211 * i, place + i % 2, 0.3));

    const auto whole = braked.played (events, 24000, holding(), { 24000 });
    CHECK (braked.played (events, 24000, holding(), { 1 }) == whole);
    CHECK (braked.played (events, 24000, holding(), { 7, 512, 1, 33 }) == whole);
    CHECK (whole.allFinite());
}

TEST_CASE ("A voice waits for its note-off until its modes have decayed, then ends silently", "[engine][player]")
{
    const Braked braked;
    FocusPlayer player (playerCeramics, rate, holding());
    braked.giveTo (player);
    const auto slowest = decayRates (braked.model).minCoeff();
    const auto end = braked.brakeStart() + toSamples (std::log (1000) / slowest);
    played (player, { triggerAt (0, place) }, end - 10, { 512 });
    CHECK (player.activeVoices() == 1);
    const auto rest = played (player, { releaseAt (20, place) }, 2000, { 64 });
    CHECK (player.activeVoices() == 0);
    CHECK (rest.cwiseAbs().maxCoeff() == 0);
}

TEST_CASE ("Stopping, retriggering and stealing end a voice that waits, without its brake", "[engine][player]")
{
    const Braked braked;
    const auto waiting = braked.focus->endSample + 500;
    auto settings = holding();
    settings.retrigger = RetriggerBehaviour::restart;
    FocusPlayer player (playerCeramics, rate, settings);
    braked.giveTo (player);
    played (player, { triggerAt (0, place) }, waiting, { 64 });
    REQUIRE (player.activeVoices() == 1);

    SECTION ("stop")
    {
        const TimedEvent stop { 0, { 0, FocusEventKind::stopAll, 0, 0 } };
        CHECK (played (player, { stop, releaseAt (1, place) }, 3000, { 64 }).cwiseAbs().maxCoeff() == 0);
        CHECK (player.activeVoices() == 0);
    }

    SECTION ("retrigger")
    {
        const auto again = played (player, { triggerAt (0, place) }, waiting, { 64 });
        CHECK (player.activeVoices() == 1);
        CHECK (again == braked.played ({ triggerAt (0, place) }, waiting, settings));
    }

    SECTION ("stealing")
    {
        PlayerSettings overlapping = holding();
        FocusPlayer crowded (playerCeramics, rate, overlapping);
        braked.giveTo (crowded);
        const std::vector<TimedEvent> many (FocusPlayer::soundingVoices + 8, triggerAt (0, place, 0.1));
        played (crowded, many, waiting, { 64 });
        CHECK (crowded.counters().stolen == 8);
        CHECK (crowded.activeVoices() == FocusPlayer::soundingVoices);
        const auto released = played (crowded, { releaseAt (0, place) }, toSamples (0.5), { 64 });
        CHECK (released.allFinite());
        CHECK (released.cwiseAbs().maxCoeff() > 0);
        CHECK (crowded.activeVoices() == 0);
    }
}

TEST_CASE ("A focus without a brake ignores the note-off", "[engine][player]")
{
    const Braked free (false);
    const std::vector<TimedEvent> events { triggerAt (3, place), releaseAt (500, place) };
    CHECK (free.played (events, 3000, holding()) == free.played (events, 3000, {}));
}

TEST_CASE ("Modes that are still when their brake begins are left alone, with no denormal number", "[engine][player]")
{
    VoltageProgram brakes;
    brakes.oscillations = { { 0, 0, 1, -20, 3000, 1, 1, 2 }, { 1, 0, 1, -8000, 90000, 1, 1, 700 } };
    brakes.allocation = Eigen::MatrixXd::Ones (1, 2);
    brakes.voltageLimits = Eigen::VectorXd::Ones (1);
    std::array<std::complex<double>, 2> factors;
    PlayableBrake (brakes, playback).factorsAfter (toSamples (1), factors);
    CHECK (std::abs (factors[0]) == Approx (std::exp (-2)).epsilon (0.02));
    CHECK (factors[1] == 0.0);
}

TEST_CASE ("Beginning 512 brakes late allocates nothing", "[engine][player]")
{
    auto program = shortProgram (500, 0.002, 1);

    for (int k = 0; k < static_cast<int> (PlayableBrake::maximumOscillations); ++k)
        program.oscillations.push_back ({ k, 0.003, 0.01, -400, 600.0 * (k + 1), 0.1, 0.2, 20 });

    program.allocation = Eigen::MatrixXd::Constant (playerCeramics, 1 + PlayableBrake::maximumOscillations, 0.001);
    auto bank = std::make_unique<FocusBank>();
    bank->foci[place] = std::make_shared<const PlayableFocus> (program, playback);
    REQUIRE (bank->foci[place]->brake.has_value());
    FocusPlayer player (playerCeramics, rate, holding());
    player.handOver().give (std::move (bank));
    Eigen::MatrixXd voltages (64, playerCeramics);
    std::vector<double*> channels;

    for (int i = 0; i < playerCeramics; ++i)
        channels.push_back (voltages.col (i).data());

    const auto before = mallocCalls();

    for (int block = 0; block < 20; ++block)
    {
        const FocusEvent event { 5, block == 0 ? FocusEventKind::trigger : FocusEventKind::release, place, 1 };
        player.process (channels.data(), 64, std::span (&event, block == 0 || block == 10 ? 1U : 0U));

        if (block == 11)
            CHECK (voltages.cwiseAbs().maxCoeff() > 0);
    }

    CHECK (mallocCalls() == before);
}
