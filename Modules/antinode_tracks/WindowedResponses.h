#pragma once

#include "PointResponses.h"

#include <antinode_numerics/Fourier.h>

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <vector>

namespace antinode
{
/** G: from voltages that are 0 outside a window to displacement at the points over the whole of an event, by Fourier
    transforms, never as a matrix. Signals are columns. One thread at a time calls; each call uses all threads. */
class WindowedResponses
{
public:
    /** @param window      samples that voltages may differ from 0, from the first on
        @param compliance  lambda of the preconditioner, m^2/V^2, above 0
        [worker] */
    WindowedResponses (PointResponses, Eigen::Index window, double compliance);

    /** G u. @param voltages  window x actuators @return  length x points [worker] */
    Eigen::MatrixXd motion (const Eigen::MatrixXd& voltages);

    /** G' z. @param multipliers  length x points @return  window x actuators [worker] */
    Eigen::MatrixXd pulls (const Eigen::MatrixXd& multipliers);

    /** (H H^H + lambda)^-1 line by line: the inverse of G G' + lambda if the window were all of the event.
        @param right  length x points [worker] */
    Eigen::MatrixXd precondition (const Eigen::MatrixXd& right);

    /** Another lambda, above 0. [worker] */
    void setCompliance (double);

    Eigen::Index length() const { return responses.length; }
    Eigen::Index points() const { return responses.points; }
    Eigen::Index actuators() const { return responses.actuators; }
    Eigen::Index windowLength() const { return window; }
    double compliance() const { return lambda; }

private:
    Eigen::MatrixXcd spectra (const Eigen::MatrixXd& signals);
    /** Signals, each line multiplied by a factor from each signal to each result and summed. rows of length. */
    template <typename Term>
    Eigen::MatrixXd combined (const Eigen::MatrixXd& signals, Eigen::Index count, Eigen::Index rows, const Term& term);
    void forEach (Eigen::Index count, const std::function<void (Eigen::Index, FourierTables&)>& work);

    PointResponses responses;
    Eigen::Index window;
    double lambda;
    Eigen::MatrixXcd inverses; // (length / 2 + 1) x points^2: column p + points q
    std::vector<std::unique_ptr<FourierTables>> tables;
};
} // namespace antinode
