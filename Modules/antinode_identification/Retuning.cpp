#include "Retuning.h"

#include "Assignment.h"
#include "Comparison.h"
#include "FrequencyDrift.h"

#include <antinode_base/InputError.h>
#include <antinode_model/ShapesAtPlaces.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr double minimumRetunedAssurance = 0.7;

/** The signature of each mode at all points and references, one mode per column: products of shape and participation.
 */
Eigen::MatrixXd signatures (const Eigen::MatrixXd& shapes, const Eigen::MatrixXd& participation)
{
    Eigen::MatrixXd result (shapes.rows() * participation.cols(), shapes.cols());

    for (Eigen::Index k = 0; k < shapes.cols(); ++k)
        result.col (k) = (shapes.col (k) * participation.row (k)).reshaped();

    return result;
}

/** Which known mode each identified one is, -1 where none, when all frequencies have drifted by about one factor. */
std::vector<Eigen::Index> findPartners (const IdentifiedModes& found, const ModalModel& model,
                                        const Eigen::MatrixXd& assurance, double drift, double differencePenalty)
{
    Eigen::MatrixXd scores = assurance;

    for (Eigen::Index k = 0; k < scores.rows(); ++k)
        for (Eigen::Index l = 0; l < scores.cols(); ++l)
            scores (k, l) -=
                differencePenalty
                * std::abs (std::log (found.angularFrequencies[k] / (drift * model.angularFrequencies[l])));

    auto partners = assign (scores);

    for (Eigen::Index k = 0; k < scores.rows(); ++k)
        if (auto& l = partners[static_cast<std::size_t> (k)]; l >= 0 && assurance (k, l) < minimumRetunedAssurance)
            l = -1;

    return partners;
}

double medianDrift (const IdentifiedModes& found, const ModalModel& model, const std::vector<Eigen::Index>& partners)
{
    std::vector<double> drifts;

    for (std::size_t k = 0; k < partners.size(); ++k)
        if (partners[k] >= 0)
            drifts.push_back (found.angularFrequencies[static_cast<Eigen::Index> (k)]
                              / model.angularFrequencies[partners[k]]);

    if (drifts.empty())
        throw InputError ("frequency responses", "contain no mode of device '" + model.name + "'");

    const auto middle = drifts.begin() + static_cast<std::ptrdiff_t> (drifts.size() / 2);
    std::nth_element (drifts.begin(), middle, drifts.end());
    return *middle;
}

/** By what each reference's known share of the signatures is to be multiplied, least squares over the modes, each in
    its own measure. */
Eigen::VectorXd participationScales (const Eigen::MatrixXd& found, const Eigen::MatrixXd& known,
                                     const std::vector<Eigen::Index>& partners, Eigen::Index references)
{
    const auto points = known.rows() / references;
    Eigen::VectorXd between = Eigen::VectorXd::Zero (references), squares = between;

    for (std::size_t k = 0; k < partners.size(); ++k)
    {
        if (partners[k] < 0)
            continue;

        const auto weight = 1 / known.col (partners[k]).squaredNorm();

        for (Eigen::Index i = 0; i < references; ++i)
        {
            const auto ofKnown = known.col (partners[k]).segment (i * points, points);
            between[i] += weight * ofKnown.dot (found.col (static_cast<Eigen::Index> (k)).segment (i * points, points));
            squares[i] += weight * ofKnown.squaredNorm();
        }
    }

    return (squares.array() > 1e-12).select (between.cwiseQuotient (squares.cwiseMax (1e-300)), 1);
}

void check (const ModalModel& model, const FrequencyResponses& responses)
{
    if (responses.drive != DriveQuantity::voltage)
        throw InputError ("frequency responses",
                          "are per force; allowed: responses to voltages of the device's ceramics");

    if (static_cast<Eigen::Index> (responses.references.size()) != model.actuators())
        throw InputError ("frequency responses", "have " + std::to_string (responses.references.size())
                                                     + " references; allowed: the " + std::to_string (model.actuators())
                                                     + " ceramics of device '" + model.name + "'");
}
} // namespace

RetunedModel retune (const ModalModel& model, const FrequencyResponses& responses, const IdentificationOptions& options)
{
    requireRealModes (model, "updates of modes by new measurements");
    check (model, responses);
    const auto shapes = shapesAtPlaces (model, responses.points);
    auto found = identify (responses, options);
    found.shapes = found.shapes.array().isFinite().select (found.shapes, 0);
    const auto ofFound = signatures (found.shapes, found.participation);
    const auto ofKnown = signatures (shapes, model.participation);
    const auto assurance = modalAssurance (ofFound, ofKnown, {});
    // First any drift, then only what differs from the common one.
    const auto drift = medianDrift (found, model, findPartners (found, model, assurance, 1, 2));
    const auto partners = findPartners (found, model, assurance, drift, 10);
    ModeUpdate update { Eigen::VectorXd::Zero (model.modes()), Eigen::VectorXd::Zero (model.modes()),
                        std::vector<bool> (static_cast<std::size_t> (model.modes())) };

    for (std::size_t k = 0; k < partners.size(); ++k)
        if (const auto l = partners[k]; l >= 0)
        {
            update.isKnown[static_cast<std::size_t> (l)] = true;
            update.angularFrequencies[l] = found.angularFrequencies[static_cast<Eigen::Index> (k)];
            update.dampingRatios[l] = found.dampingRatios[static_cast<Eigen::Index> (k)];
        }

    auto changed = updated (model, update);
    RetunedModel result;
    result.found = update.isKnown;
    result.frequencyChanges = (changed.angularFrequencies.array() / model.angularFrequencies.array() - 1).matrix();
    result.dampingChanges = (changed.dampingRatios.array() / model.dampingRatios.array() - 1).matrix();
    result.participationScales = participationScales (ofFound, ofKnown, partners, model.actuators());
    changed.participation *= result.participationScales.asDiagonal();
    result.model = ascending (std::move (changed));
    result.delay = found.delay;
    result.reconstructionError = found.reconstructionError;
    return result;
}
} // namespace antinode
