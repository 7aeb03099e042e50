#include "WindowedResponses.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/Decompositions.h>
#include <antinode_numerics/ParallelFor.h>

#include <utility>

namespace antinode
{
namespace
{
Eigen::MatrixXcd preconditioner (const PointResponses& responses, double compliance)
{
    const auto points = responses.points;
    Eigen::MatrixXcd inverses (responses.values.rows(), points * points);

    const auto atLine = [&] (std::size_t index)
    {
        checkWatch();
        const auto line = static_cast<Eigen::Index> (index);
        const auto response = responses.atLine (line);
        Eigen::MatrixXcd gram = response * response.adjoint();
        gram.diagonal().array() += compliance;
        const Eigen::MatrixXcd inverse = solveSemidefinite (gram, Eigen::MatrixXcd::Identity (points, points));
        inverses.row (line) = Eigen::Map<const Eigen::RowVectorXcd> (inverse.data(), inverse.size());
    };
    parallelFor (static_cast<std::size_t> (inverses.rows()), atLine);
    return inverses;
}
} // namespace

WindowedResponses::WindowedResponses (PointResponses responsesToUse, Eigen::Index windowToUse, double compliance)
    : responses (std::move (responsesToUse)), window (windowToUse), lambda (compliance),
      inverses (preconditioner (responses, compliance))
{
    for (std::size_t i = 0; i < processorThreads(); ++i)
        tables.push_back (std::make_unique<FourierTables>());
}

void WindowedResponses::setCompliance (double compliance)
{
    lambda = compliance;
    inverses = preconditioner (responses, compliance);
}

/** Every table is used by one thread: signal i by that of i modulo their number. */
void WindowedResponses::forEach (Eigen::Index count, const std::function<void (Eigen::Index, FourierTables&)>& work)
{
    parallelFor (tables.size(),
                 [&] (std::size_t stripe)
                 {
                     for (auto i = static_cast<Eigen::Index> (stripe); i < count;
                          i += static_cast<Eigen::Index> (tables.size()))
                     {
                         checkWatch();
                         work (i, *tables[stripe]);
                     }
                 });
}

Eigen::MatrixXcd WindowedResponses::spectra (const Eigen::MatrixXd& signalsToTransform)
{
    Eigen::MatrixXcd result (length() / 2 + 1, signalsToTransform.cols());
    forEach (result.cols(), [&] (Eigen::Index i, FourierTables& table)
             { result.col (i) = table.forward (signalsToTransform.col (i), length()); });
    return result;
}

Eigen::MatrixXd WindowedResponses::motion (const Eigen::MatrixXd& voltages)
{
    const auto driven = spectra (voltages);
    Eigen::MatrixXd result (length(), points());
    forEach (points(),
             [&] (Eigen::Index p, FourierTables& table)
             {
                 Eigen::VectorXcd sum = Eigen::VectorXcd::Zero (driven.rows());

                 for (Eigen::Index i = 0; i < actuators(); ++i)
                     sum.array() += responses.values.col (p + points() * i).array() * driven.col (i).array();

                 result.col (p) = table.inverse (sum, length());
             });
    return result;
}

Eigen::MatrixXd WindowedResponses::pulls (const Eigen::MatrixXd& multipliers)
{
    const auto pulling = spectra (multipliers);
    Eigen::MatrixXd result (window, actuators());
    forEach (actuators(),
             [&] (Eigen::Index i, FourierTables& table)
             {
                 Eigen::VectorXcd sum = Eigen::VectorXcd::Zero (pulling.rows());

                 for (Eigen::Index p = 0; p < points(); ++p)
                     sum.array() +=
                         responses.values.col (p + points() * i).array().conjugate() * pulling.col (p).array();

                 result.col (i) = table.inverse (sum, length()).head (window);
             });
    return result;
}

Eigen::MatrixXd WindowedResponses::precondition (const Eigen::MatrixXd& right)
{
    const auto lines = spectra (right);
    Eigen::MatrixXd result (length(), points());
    forEach (points(),
             [&] (Eigen::Index p, FourierTables& table)
             {
                 Eigen::VectorXcd sum = Eigen::VectorXcd::Zero (lines.rows());

                 for (Eigen::Index q = 0; q < points(); ++q)
                     sum.array() += inverses.col (p + points() * q).array() * lines.col (q).array();

                 result.col (p) = table.inverse (sum, length());
             });
    return result;
}
} // namespace antinode
