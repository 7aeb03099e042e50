#include "Support/SineBeam.h"

#include <antinode_focus/SpillOver.h>
#include <antinode_learning/ChooseSensors.h>
#include <antinode_learning/LearnModes.h>
#include <antinode_model/ModalModel.h>
#include <antinode_numerics/Statistics.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace antinode;
using test::sineBeam;

namespace
{
constexpr double rate = 24000;

/** A beam of five modes under a burst of noise. */
struct Play
{
    ModalModel model = sineBeam (5, 3);
    ModeSpread deviations = sameSpread (5, 0.005, 0.1, 0.05);
    Eigen::MatrixXd voltages = Eigen::MatrixXd::Zero (3, 6000);
    Eigen::MatrixX2d places { 81, 2 };

    Play()
    {
        RandomNumbers random (1);

        for (Eigen::Index i = 0; i < 3; ++i)
            voltages.row (i).segment (200, 1000) = 20 * random.normal (1000).transpose();

        for (Eigen::Index p = 0; p < 81; ++p)
            places.row (p) << -0.08 + 0.002 * static_cast<double> (p), 0;
    }

    PlayedInformation information() const
    {
        return playedInformation (model, deviations, PlayedVoltages (voltages, rate));
    }

    Eigen::MatrixXd audibilities (double noise) const
    {
        return shapesAtPlaces (model, places).cwiseAbs2() / (noise * noise);
    }
};
} // namespace

TEST_CASE ("One sensor for one mode belongs at its antinode", "[learning][sensors]")
{
    Play play;
    play.model = firstModes (play.model, 1);
    play.deviations = sameSpread (1, 0.005, 0.1, 0.05);
    const auto choice = chooseSensors (play.information(), play.audibilities (1e-4), 1);
    CHECK (play.places (choice.chosen.front(), 0) == Approx (0).margin (1e-12));
}

TEST_CASE ("Exchanged sensors tell what the best of all pairs tells", "[learning][sensors]")
{
    const Play play;
    const auto information = play.information();
    const Eigen::MatrixXd audibilities = play.audibilities (1e-4);
    const auto choice = chooseSensors (information, audibilities, 2);
    double best = 0;

    for (Eigen::Index a = 0; a < audibilities.rows(); ++a)
        for (Eigen::Index b = a + 1; b < audibilities.rows(); ++b)
            best = std::max (best,
                             informationBits (information, (audibilities.row (a) + audibilities.row (b)).transpose()));

    CHECK (choice.bits.back() == Approx (best).epsilon (1e-3));
    CHECK (choice.bits.front() < choice.bits.back());
}

TEST_CASE ("Chosen sensors learn frequencies as well as was said, and better than random ones", "[learning][sensors]")
{
    const Play play;
    constexpr double noise = 1e-5;
    const auto choice = chooseSensors (play.information(), play.audibilities (noise), 2);
    const auto left = [&] (const std::vector<Eigen::Index>& chosen)
    {
        std::vector<Sensor> sensors;

        for (const auto place : chosen)
            sensors.push_back ({ shapesAtPlaces (play.model, play.places).row (place) });

        const auto velocities = modeVelocities (play.model, { play.voltages, rate }, play.voltages.cols());
        PlayedRecording recording { rate, play.voltages, Eigen::MatrixXd (2, play.voltages.cols()),
                                    Eigen::VectorXd::Constant (2, noise), 0 };

        for (Eigen::Index m = 0; m < 2; ++m)
            recording.signals.row (m) =
                (velocities * sensors[static_cast<std::size_t> (m)].shapes.transpose()).transpose();

        const auto learnt = learnModes (play.model, sensors, play.deviations, { recording });
        return learnt.frequencyDeviations.array().log().sum() + learnt.dampingDeviations.array().log().sum();
    };
    const auto best = left (choice.chosen);
    RandomNumbers random (2);
    int worse = 0;

    for (int i = 0; i < 5; ++i)
        worse += left ({ static_cast<Eigen::Index> (80 * random.uniform()),
                         static_cast<Eigen::Index> (80 * random.uniform()) })
                 > best;

    CHECK (worse >= 4);
}
