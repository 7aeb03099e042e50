#include "ContactStep.h"

#include "LoadedModel.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_numerics/Decompositions.h>

#include <unsupported/Eigen/MatrixFunctions>

#include <cmath>
#include <limits>
#include <string>

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
} // namespace antinode
