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

template <typename Term>
Eigen::MatrixXd WindowedResponses::combined (const Eigen::MatrixXd& signals, Eigen::Index count, Eigen::Index rows,
                                             const Term& term)
{
    const auto lines = spectra (signals);
    Eigen::MatrixXd result (rows, count);
    forEach (count,
             [&] (Eigen::Index to, FourierTables& table)
             {
                 Eigen::VectorXcd sum = Eigen::VectorXcd::Zero (lines.rows());

                 for (Eigen::Index from = 0; from < lines.cols(); ++from)
                     sum.array() += term (to, from) * lines.col (from).array();

                 result.col (to) = table.inverse (sum, length()).head (rows);
             });
    return result;
}

Eigen::MatrixXd WindowedResponses::motion (const Eigen::MatrixXd& voltages)
{
    return combined (voltages, points(), length(),
                     [this] (Eigen::Index p, Eigen::Index i)
                     { return responses.values.col (p + points() * i).array(); });
}

Eigen::MatrixXd WindowedResponses::pulls (const Eigen::MatrixXd& multipliers)
{
    return combined (multipliers, actuators(), window,
                     [this] (Eigen::Index i, Eigen::Index p)
                     { return responses.values.col (p + points() * i).array().conjugate(); });
}

Eigen::MatrixXd WindowedResponses::precondition (const Eigen::MatrixXd& right)
{
    return combined (right, points(), length(),
                     [this] (Eigen::Index p, Eigen::Index q) { return inverses.col (p + points() * q).array(); });
}
} // namespace antinode
