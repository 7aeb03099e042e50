#include "OneSidedContact.h"

#include "ContactStep.h"
#include "LoadedModel.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_numerics/KaiserSinc.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
constexpr double stepPhase = 0.05;     // rad of the highest mode in a step
constexpr int maximumMeetings = 3;     // within a step: fingers that rattle faster are taken as touching
constexpr int searches = 40;           // for a meeting within a step
constexpr double timeTolerance = 1e-6; // of a step
constexpr Eigen::Index watched = 1024; // samples between looks at the watch

/** A surface and its fingers in time. */
class TouchedSurface
{
public:
    TouchedSurface (const ContactBodies& bodiesToMove, double stepToTake)
        : bodies (bodiesToMove), whole (contactStep (bodies, stepToTake)), state (restingState (bodies)),
          histories (bodies.fingers.size())
    {
    }

    /** Moves on by a step under even modal forces. */
    void advance (const Eigen::VectorXd& forces)
    {
        auto next = moved (bodies, whole, state, forces);
        auto left = whole.duration;

        for (int meetings = 0; meetings < maximumMeetings; ++meetings)
        {
            const auto met = penetrating (next);

            if (met < 0)
                break;

            const auto free = timeToMeeting (forces, met, left);
            accept (moved (bodies, contactStep (bodies, free), state, forces), free);
            strike (met);
            left -= free;
            next = moved (bodies, contactStep (bodies, left), state, forces);
        }

        accept (std::move (next), left);
    }

    Eigen::VectorXd velocities() const { return modalVelocities (bodies, state); }
    const std::vector<ContactHistory>& contacts() const { return histories; }

private:
    void accept (ContactState next, double duration)
    {
        for (std::size_t f = 0; f < histories.size(); ++f)
            if (! next.isTouching[f])
            {
                histories[f].lifts += state.isTouching[f] ? 1 : 0;
                histories[f].liftedTime += duration;
            }

        state = std::move (next);
    }

    /** A finger that meets the surface may knock others off. */
    void strike (int finger)
    {
        const auto before = state.isTouching;
        meet (bodies, state, finger);

        for (std::size_t f = 0; f < histories.size(); ++f)
            histories[f].lifts += before[f] && ! state.isTouching[f] ? 1 : 0;
    }

    /** A lifted finger below the surface, or -1. */
    int penetrating (const ContactState& next) const
    {
        const auto places = surfacePlaces (bodies, next);

        for (std::size_t f = 0; f < histories.size(); ++f)
            if (const auto i = static_cast<Eigen::Index> (f); ! next.isTouching[f] && places[i] > next.fingers (0, i))
                return static_cast<int> (f);

        return -1;
    }

    /** How far a lifted finger would be below the surface after a time, m. */
    double depthAfter (double time, const Eigen::VectorXd& forces, int finger) const
    {
        const auto then = moved (bodies, contactStep (bodies, time), state, forces);
        return surfacePlaces (bodies, then)[finger] - then.fingers (0, finger);
    }

    /** By the Illinois rule: false position that halves the value of an end that stays. Just below the surface. */
    double timeToMeeting (const Eigen::VectorXd& forces, int finger, double latest) const
    {
        double least = 0, most = latest, above = depthAfter (0, forces, finger),
               below = depthAfter (latest, forces, finger);

        for (int i = 0; i < searches && above < 0 && most - least > timeTolerance * whole.duration; ++i)
        {
            const auto time = least + (most - least) * above / (above - below);
            const auto depth = depthAfter (time, forces, finger);

            if (depth > 0)
            {
                most = time;
                below = depth;
                above /= 2;
            }
            else
            {
                least = time;
                above = depth;
                below /= 2;
            }
        }

        return most;
    }

    const ContactBodies& bodies;
    ContactStep whole;
    ContactState state;
    std::vector<ContactHistory> histories;
};

/** The samples that act at instants evenly within an interval: rows from the oldest sample, a column an instant. */
Eigen::MatrixXd interpolation (Playback playback, Eigen::Index steps)
{
    if (playback.reconstruction == Reconstruction::zeroOrderHold)
        return Eigen::MatrixXd::Ones (1, steps);

    return Eigen::MatrixXd::NullaryExpr (
        2 * kaiserSincHalfWidth, steps,
        [steps] (Eigen::Index tap, Eigen::Index step)
        {
            const auto x = (static_cast<double> (step) + 0.5) / static_cast<double> (steps);
            return kaiserSinc (x + (kaiserSincHalfWidth - 1) - static_cast<double> (tap));
        });
}

/** Samples first .. first + count - 1 with what lies beside the given ones. */
Eigen::MatrixXd window (const Eigen::MatrixXd& voltages, Eigen::Index first, Eigen::Index count)
{
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero (voltages.rows(), count);

    for (Eigen::Index n = std::max<Eigen::Index> (0, -first); n < count; ++n)
        result.col (n) = voltages.col (std::min (first + n, voltages.cols() - 1));

    return result;
}
} // namespace

bool canLiftOff (const std::vector<Finger>& fingers)
{
    return std::any_of (fingers.begin(), fingers.end(),
                        [] (const auto& finger) { return finger.pressingForce.has_value(); });
}

ContactMotion motionUnderFingers (const ModalModel& model, const std::vector<Finger>& fingers, Playback playback,
                                  const Eigen::MatrixXd& voltages)
{
    requireRealModes (model, "fingers that can lift off");
    requireKnownScale (model, "fingers");
    validate (fingers, model.surface);
    const auto bodies = contactBodies (model, fingers);
    const auto interval = 1 / playback.sampleRate;
    const auto steps =
        static_cast<Eigen::Index> (std::ceil (model.angularFrequencies.maxCoeff() * interval / stepPhase));
    const auto kernel = interpolation (playback, steps);
    const auto before = kernel.rows() / 2 - (kernel.rows() > 1 ? 1 : 0); // samples that act before their own time
    TouchedSurface surface (bodies, interval / static_cast<double> (steps));
    ContactMotion motion;
    motion.modalVelocities.resize (model.modes(), voltages.cols());

    for (Eigen::Index n = -before; n < voltages.cols(); ++n)
    {
        if (n % watched == 0)
            checkWatch();

        if (n >= 0)
            motion.modalVelocities.col (n) = surface.velocities();

        const Eigen::MatrixXd forces = model.participation * (window (voltages, n - before, kernel.rows()) * kernel);

        for (Eigen::Index step = 0; step < steps; ++step)
            surface.advance (forces.col (step));
    }

    motion.histories = surface.contacts();
    return motion;
}
} // namespace antinode
