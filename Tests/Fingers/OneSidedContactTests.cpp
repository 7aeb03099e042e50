#include "Support/HeldPlate.h"
#include "Support/SineBeam.h"

#include <antinode_base/InputError.h>
#include <antinode_engine/PlateModel.h>
#include <antinode_fingers/OneSidedContact.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
constexpr double rate = 48000;

Eigen::MatrixXd strongVoltages (const ModalModel& model, int samples)
{
    return Eigen::MatrixXd::NullaryExpr (
        model.actuators(), samples,
        [samples] (Eigen::Index i, Eigen::Index n)
        {
            const auto time = static_cast<double> (n);
            return n < samples * 3 / 4
                       ? 60 * std::sin (0.0004 * (time + 30) * time * (1 + 0.3 * static_cast<double> (i)))
                       : 0.0;
        });
}

/** A beam with one finger as M, C and K, touching and lifted, each by the exponential of its whole first-order matrix;
    instants of lifting and meeting are found on a fine grid and by bisection. No modes of the loaded beam are used. */
class LocatedEvents
{
public:
    LocatedEvents (const ModalModel& modelToUse, const Finger& fingerToUse)
        : model (modelToUse), finger (fingerToUse), count (model.modes()),
          under (contactShapes (model, finger).transpose()), state (Eigen::VectorXd::Zero (2 * count + 3))
    {
        state[2 * count + 2] = 1;
    }

    int lifts = 0;
    double liftedTime = 0; // s

    Eigen::VectorXd velocities() const { return state.segment (count, count); }

    void hold (const Eigen::VectorXd& force)
    {
        constexpr int grid = 100;
        const Eigen::MatrixXd matrices[] { matrix (true, force), matrix (false, force) };
        const auto interval = 1 / rate / grid;
        const Eigen::MatrixXd steps[] { test::exponential (matrices[0] * interval),
                                        test::exponential (matrices[1] * interval) };

        for (int i = 0; i < grid; ++i)
        {
            auto left = interval;
            auto after = Eigen::VectorXd (steps[isTouching ? 0 : 1] * state);

            while (hasEnded (after, matrices[0]))
            {
                double least = 0, most = left;
                const auto& now = matrices[isTouching ? 0 : 1];

                for (int j = 0; j < 40; ++j)
                {
                    const auto middle = 0.5 * (least + most);
                    const Eigen::VectorXd then = test::exponential (now * middle) * state;
                    (hasEnded (then, matrices[0]) ? most : least) = middle;
                }

                state = (test::exponential (now * most) * state).eval();
                liftedTime += isTouching ? 0 : most;
                left -= most;
                change();
                after = test::exponential (matrices[isTouching ? 0 : 1] * left) * state;
            }

            state = after;
            liftedTime += isTouching ? 0 : left;
        }
    }

private:
    /** Of (q, q', z, z', 1). */
    Eigen::MatrixXd matrix (bool touches, const Eigen::VectorXd& force) const
    {
        Eigen::MatrixXd mass = Eigen::MatrixXd::Identity (count, count);
        Eigen::MatrixXd damping = (2 * model.dampingRatios.cwiseProduct (model.angularFrequencies)).asDiagonal();
        Eigen::MatrixXd stiffness = model.angularFrequencies.cwiseAbs2().asDiagonal();
        Eigen::VectorXd right = force;

        if (touches)
        {
            mass += finger.mass * under * under.transpose();
            damping += finger.damping * under * under.transpose();
            stiffness += finger.stiffness * under * under.transpose();
        }
        else
            right += *finger.pressingForce * under;

        Eigen::MatrixXd result = Eigen::MatrixXd::Zero (2 * count + 3, 2 * count + 3);
        const auto inverse = mass.inverse().eval();
        result.block (0, count, count, count).setIdentity();
        result.block (count, 0, count, count) = -inverse * stiffness;
        result.block (count, count, count, count) = -inverse * damping;
        result.block (count, 2 * count + 2, count, 1) = inverse * right;
        const auto z = 2 * count;
        result (z, z + 1) = 1;

        if (touches)
            result.row (z + 1) = under.transpose() * result.middleRows (count, count);
        else
        {
            result (z + 1, z) = -finger.stiffness / finger.mass;
            result (z + 1, z + 1) = -finger.damping / finger.mass;
            result (z + 1, z + 2) = -*finger.pressingForce / finger.mass;
        }

        return result;
    }

    bool hasEnded (const Eigen::VectorXd& then, const Eigen::MatrixXd& touching) const
    {
        const auto z = 2 * count;

        if (! isTouching)
            return under.dot (then.head (count)) > then[z] + 1e-13; // beyond rounding

        return *finger.pressingForce + finger.mass * touching.row (z + 1).dot (then) + finger.damping * then[z + 1]
                   + finger.stiffness * then[z]
               < 0;
    }

    void change()
    {
        if (! isTouching)
        {
            const auto apart = under.dot (state.segment (count, count)) - state[2 * count + 1];
            const auto impulse = apart / (under.squaredNorm() + 1 / finger.mass);
            state.segment (count, count) -= impulse * under;
            state[2 * count + 1] += impulse / finger.mass;
        }
        else
            ++lifts;

        isTouching = ! isTouching;
    }

    ModalModel model;
    Finger finger;
    Eigen::Index count;
    Eigen::VectorXd under, state;
    bool isTouching = true;
};
} // namespace

TEST_CASE ("A finger that cannot pull moves as M, C and K with located events say", "[fingers]")
{
    const auto beam = test::sineBeam (5, 2);
    auto finger = builtInFinger ("medium", 0.013, 0);
    finger.pressingForce = 0.02;
    const auto voltages = strongVoltages (beam, 300);
    const auto motion = motionUnderFingers (beam, { finger }, { Reconstruction::zeroOrderHold, rate }, voltages);
    LocatedEvents located (beam, finger);
    double worst = 0, largest = 0;

    for (Eigen::Index n = 0; n < voltages.cols(); ++n)
    {
        const auto wanted = located.velocities();
        worst = std::max (worst, (motion.modalVelocities.col (n) - wanted).cwiseAbs().maxCoeff());
        largest = std::max (largest, wanted.cwiseAbs().maxCoeff());
        located.hold (beam.participation * voltages.col (n));
    }

    INFO ("lifts " << located.lifts << ", " << motion.histories.front().lifts << ", error " << worst / largest);
    CHECK (worst < 1e-4 * largest);
    CHECK (located.lifts > 3);
    CHECK (std::abs (motion.histories.front().lifts - located.lifts) <= 1); // one may last less than a step
    CHECK (motion.histories.front().liftedTime == Approx (located.liftedTime).epsilon (1e-3));
}

TEST_CASE ("Fingers that press hard enough never lift, and move as loaded modes do", "[fingers]")
{
    const auto beam = test::sineBeam (8, 2);
    std::vector<Finger> fingers { builtInFinger ("medium", 0.013, 0), builtInFinger ("firm", -0.04, 0) };
    fingers[0].pressingForce = 1000;
    const auto voltages = strongVoltages (beam, 300);

    for (const auto kind : { Reconstruction::zeroOrderHold, Reconstruction::bandLimited })
    {
        const Playback playback { kind, 192000 };
        const auto motion = motionUnderFingers (beam, fingers, playback, voltages);
        const auto loaded = loadedModel (beam, fingers);
        PlateModel plate (loaded, playback, loaded.shapes);
        Eigen::MatrixXd extended = Eigen::MatrixXd::Zero (voltages.rows(), voltages.cols() + plate.latencySamples());
        extended.leftCols (voltages.cols()) = voltages;
        Eigen::MatrixXd wanted (loaded.points(), extended.cols());
        plate.process (extended, wanted);
        const auto shown = wanted.middleCols (plate.latencySamples(), 250).eval();
        const Eigen::MatrixXd reached = beam.shapes * motion.modalVelocities.leftCols (250);
        CHECK ((reached - shown).cwiseAbs().maxCoeff() < 1e-4 * shown.cwiseAbs().maxCoeff());
        CHECK (motion.histories[0].lifts + motion.histories[1].lifts == 0);
    }
}

TEST_CASE ("Fingers without mass cannot lift off", "[fingers]")
{
    const auto beam = test::sineBeam (5, 2);
    auto finger = builtInFinger ("medium", 0.013, 0);
    finger.pressingForce = 0.02;
    finger.mass = 0;
    CHECK_THROWS_WITH (
        motionUnderFingers (beam, { finger }, { Reconstruction::zeroOrderHold, rate }, strongVoltages (beam, 4)),
        Catch::Contains ("finger 1") && Catch::Contains ("0.001 g or more"));
}
