#include "OneSidedContact.h"

#include "LoadedModel.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_base/Watch.h>
#include <antinode_numerics/Decompositions.h>
#include <antinode_numerics/KaiserSinc.h>
#include <unsupported/Eigen/MatrixFunctions>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace antinode
{
namespace
{
using Complex = std::complex<double>;

constexpr double leastContactMass = 1e-6; // kg: lighter ones rattle faster than steps follow

/** The surface's velocities at the fingers, m/s. */
Eigen::VectorXd surfaceVelocities (const ContactBodies& bodies, const Eigen::VectorXcd& modes)
{
    return (bodies.velocityRows * modes).real();
}

std::vector<int> touchingFingers (const ContactState& state)
{
    std::vector<int> touching;

    for (std::size_t f = 0; f < state.isTouching.size(); ++f)
        if (state.isTouching[f])
            touching.push_back (static_cast<int> (f));

    return touching;
}

/** Of the equations of these fingers alone. */
Eigen::VectorXd solved (const Eigen::MatrixXd& answer, const Eigen::VectorXd& right, const std::vector<int>& touching)
{
    return solveSemidefinite (Eigen::MatrixXd (answer (touching, touching)), Eigen::MatrixXd (right (touching)));
}

/** Forces between fingers and surface beside the static ones, N: those that touch move together at the end of the step,
    the others feel none of the whole. Who would have to pull lifts off. */
Eigen::VectorXd contactForces (const ContactBodies& bodies, const ContactStep& step, ContactState& state,
                               const Eigen::VectorXd& freeSurface, const Eigen::VectorXd& freeFingers)
{
    const auto count = static_cast<Eigen::Index> (bodies.fingers.size());
    Eigen::MatrixXd answer = step.velocityPerForce;

    for (Eigen::Index f = 0; f < count; ++f)
        answer (f, f) += step.fingerGain[static_cast<std::size_t> (f)][1];

    for (;;)
    {
        const auto touching = touchingFingers (state);
        Eigen::VectorXd forces = Eigen::VectorXd::Zero (count);

        for (Eigen::Index f = 0; f < count; ++f)
            if (! state.isTouching[static_cast<std::size_t> (f)])
                forces[f] = -bodies.pressing[f];

        const Eigen::VectorXd apart = freeSurface - freeFingers - answer * forces;

        if (! touching.empty())
            forces (touching) = solved (answer, apart, touching);

        auto hasLifted = false;

        for (const auto f : touching)
            if (forces[f] < -bodies.pressing[f])
            {
                state.isTouching[static_cast<std::size_t> (f)] = false;
                hasLifted = true;
            }

        if (! hasLifted)
            return forces;
    }
}

Eigen::Matrix3d fingerMatrix (const Finger& finger)
{
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    matrix (0, 1) = 1;
    matrix (1, 0) = -finger.stiffness / finger.mass;
    matrix (1, 1) = -finger.damping / finger.mass;
    matrix (1, 2) = 1 / finger.mass;
    return matrix;
}
} // namespace

ContactBodies contactBodies (const ModalModel& model, const std::vector<Finger>& fingers)
{
    const auto count = static_cast<Eigen::Index> (fingers.size());
    ContactBodies bodies;
    const Eigen::ArrayXd decay = decayRates (model).array();
    bodies.turn = dampedFrequencies (model).array();
    bodies.poles = -decay.cast<Complex>() + Complex (0, 1) * bodies.turn.cast<Complex>();
    bodies.decayPerTurn = decay / bodies.turn;
    bodies.contacts.resize (count, model.modes());
    bodies.fingers = fingers;
    bodies.pressing.resize (count);

    for (Eigen::Index f = 0; f < count; ++f)
    {
        const auto& finger = fingers[static_cast<std::size_t> (f)];

        if (! (finger.mass >= leastContactMass))
            throw InputError ("finger " + std::to_string (f + 1),
                              "has a mass of " + inWords (finger.mass * milli)
                                  + " g; allowed where a finger can lift off: 0.001 g or more");

        bodies.contacts.row (f) = contactShapes (model, finger);
        bodies.pressing[f] = finger.pressingForce.value_or (std::numeric_limits<double>::infinity());
    }

    const Eigen::RowVectorXcd toVelocity = (1.0 + Complex (0, 1) * bodies.decayPerTurn.cast<Complex>()).transpose();
    const Eigen::RowVectorXcd toPlace = (Complex (0, -1) / bodies.turn.cast<Complex>()).transpose();
    bodies.velocityRows = bodies.contacts.cast<Complex>() * toVelocity.asDiagonal();
    bodies.placeRows = bodies.contacts.cast<Complex>() * toPlace.asDiagonal();
    return bodies;
}

ContactState restingState (const ContactBodies& bodies)
{
    return { Eigen::VectorXcd::Zero (bodies.poles.size()),
             Eigen::Matrix2Xd::Zero (2, static_cast<Eigen::Index> (bodies.fingers.size())),
             std::vector<bool> (bodies.fingers.size(), true) };
}

ContactStep contactStep (const ContactBodies& bodies, double duration)
{
    ContactStep step;
    step.duration = duration;
    step.transition = (bodies.poles * duration).exp();
    // expm1 of a complex number: a short step must not lose its digits.
    const Eigen::ArrayXcd half = bodies.poles * (0.5 * duration);
    step.gain = 2.0 * half.exp() * half.sinh() / bodies.poles;
    step.velocityPerForce =
        (bodies.velocityRows * step.gain.matrix().asDiagonal() * bodies.contacts.transpose().cast<Complex>()).real();

    for (const auto& finger : bodies.fingers)
    {
        const Eigen::Matrix3d whole = (fingerMatrix (finger) * duration).exp();
        step.fingerTransition.emplace_back (whole.topLeftCorner<2, 2>());
        step.fingerGain.emplace_back (whole.topRightCorner<2, 1>());
    }

    return step;
}

ContactState moved (const ContactBodies& bodies, const ContactStep& step, const ContactState& before,
                    const Eigen::VectorXd& forces)
{
    auto state = before;
    state.modes = (step.transition * before.modes.array() + step.gain * forces.array().cast<Complex>()).matrix();

    for (std::size_t f = 0; f < bodies.fingers.size(); ++f)
        state.fingers.col (static_cast<Eigen::Index> (f)) =
            step.fingerTransition[f] * before.fingers.col (static_cast<Eigen::Index> (f));

    const auto contact =
        contactForces (bodies, step, state, surfaceVelocities (bodies, state.modes), state.fingers.row (1));
    const Eigen::VectorXd onModes = bodies.contacts.transpose() * contact;
    state.modes -= (step.gain * onModes.array().cast<Complex>()).matrix();
    const auto places = surfacePlaces (bodies, state), velocities = surfaceVelocities (bodies, state.modes);

    for (Eigen::Index f = 0; f < contact.size(); ++f)
        if (state.isTouching[static_cast<std::size_t> (f)])
            state.fingers.col (f) << places[f], velocities[f];
        else
            state.fingers.col (f) += step.fingerGain[static_cast<std::size_t> (f)] * contact[f];

    return state;
}

void meet (const ContactBodies& bodies, ContactState& state, int finger)
{
    state.isTouching[static_cast<std::size_t> (finger)] = true;
    Eigen::MatrixXd answer = bodies.contacts * bodies.contacts.transpose();

    for (Eigen::Index f = 0; f < answer.rows(); ++f)
        answer (f, f) += 1 / bodies.fingers[static_cast<std::size_t> (f)].mass;

    state.fingers (0, finger) = surfacePlaces (bodies, state)[finger];
    const Eigen::VectorXd apart = surfaceVelocities (bodies, state.modes) - state.fingers.row (1).transpose();
    Eigen::VectorXd impulses = Eigen::VectorXd::Zero (apart.size());

    for (auto hasLifted = true; hasLifted;)
    {
        const auto touching = touchingFingers (state);
        impulses.setZero();
        impulses (touching) = solved (answer, apart, touching);
        hasLifted = false;

        for (const auto f : touching)
            if (f != finger && impulses[f] < 0 && std::isfinite (bodies.pressing[f]))
            {
                state.isTouching[static_cast<std::size_t> (f)] = false;
                hasLifted = true;
            }
    }

    state.modes -= (bodies.contacts.transpose() * impulses).cast<Complex>();

    for (std::size_t f = 0; f < bodies.fingers.size(); ++f)
        state.fingers (1, static_cast<Eigen::Index> (f)) +=
            impulses[static_cast<Eigen::Index> (f)] / bodies.fingers[f].mass;
}

Eigen::VectorXd surfacePlaces (const ContactBodies& bodies, const ContactState& state)
{
    return (bodies.placeRows * state.modes).real();
}

Eigen::VectorXd modalVelocities (const ContactBodies& bodies, const ContactState& state)
{
    return (state.modes.real().array() - bodies.decayPerTurn * state.modes.imag().array()).matrix();
}

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
