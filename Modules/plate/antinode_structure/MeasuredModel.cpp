#include "MeasuredModel.h"

#include <antinode_base/InputError.h>

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace antinode
{
namespace
{
void requireModes (const MeasuredDevice& measured, const ModalModel& drawn)
{
    const auto parts = drawn.coordinates() / drawn.modes();
    const auto where = "device '" + drawn.name + "'";

    for (const auto& mode : measured.modes)
    {
        if (mode.drawn >= drawn.modes())
            throw InputError (where, "has measured mode " + std::to_string (mode.drawn + 1)
                                         + " of its drawing, which gives " + std::to_string (drawn.modes())
                                         + "; allowed: as many modes in the base as when they were measured");

        if (mode.participation.rows() != parts || mode.participation.cols() != drawn.actuators())
            throw InputError (where, "has measured modes of " + std::to_string (mode.participation.cols())
                                         + " ceramics, its drawing " + std::to_string (drawn.actuators())
                                         + (parts > 1 ? ", or lacks the imaginary parts of complex modes" : "")
                                         + "; allowed: the base as it was when they were measured");
    }
}

/** Real parts, and of complex modes imaginary parts below. */
Eigen::MatrixXd participationOf (const ModalModel& model, Eigen::Index mode)
{
    Eigen::MatrixXd rows (model.coordinates() / model.modes(), model.actuators());

    for (Eigen::Index part = 0; part < rows.rows(); ++part)
        rows.row (part) = model.participation.row (mode + part * model.modes());

    return rows;
}

/** Of all shapes that its own is made of. */
std::vector<MeasuredMode::Share> wholeShares (const MeasuredMode& mode)
{
    return mode.shares.empty() ? std::vector<MeasuredMode::Share> { { mode.drawn, 1 } } : mode.shares;
}

bool isTurnedOver (const MeasuredMode& mode, const ModalModel& drawn)
{
    return mode.reference
           && drawn.participation (mode.drawn, mode.reference->ceramic) * mode.reference->participation < 0;
}

/** The shares of a mode for the signs that a solution gave to the drawing's modes. */
std::vector<MeasuredMode::Share> sharesNow (const MeasuredMode& mode, const MeasuredDevice& measured,
                                            const ModalModel& drawn)
{
    const auto signOf = [&] (const MeasuredMode& one) { return isTurnedOver (one, drawn) ? -1.0 : 1.0; };
    auto shares = mode.shares;

    for (auto& each : shares)
    {
        const auto found = std::find_if (measured.modes.begin(), measured.modes.end(),
                                         [&] (const MeasuredMode& one) { return one.drawn == each.drawn; });

        if (found == measured.modes.end())
            throw InputError ("device '" + drawn.name + "'",
                              "has a share of mode " + std::to_string (each.drawn + 1)
                                  + " of its base, which it does not list; allowed: shares of modes that it lists");

        each.share *= signOf (mode) * signOf (*found);
    }

    return shares;
}

/** One shape of a model as a mixture of the drawing's. */
void mix (ModalModel& model, Eigen::Index k, const std::vector<MeasuredMode::Share>& shares, const ModalModel& drawn)
{
    model.shapes.col (k).setZero();

    if (model.slopes.size() > 0)
        model.slopes.col (k).setZero();

    for (const auto& each : shares)
    {
        model.shapes.col (k) += each.share * drawn.shapes.col (each.drawn);

        if (model.slopes.size() > 0)
            model.slopes.col (k) += each.share * drawn.slopes.col (each.drawn);
    }
}

MeasuredMode::Reference referenceOf (const ModalModel& drawn, Eigen::Index mode)
{
    Eigen::Index ceramic = 0;
    drawn.participation.row (mode).cwiseAbs().maxCoeff (&ceramic);
    return { ceramic, drawn.participation (mode, ceramic) };
}

/** The reference of a mode for the sign that a solution gave it. */
std::optional<MeasuredMode::Reference> referenceOf (const MeasuredMode& mode, const Eigen::MatrixXd& participation)
{
    auto reference = mode.reference;

    if (reference && participation != mode.participation)
        reference->participation *= -1;

    return reference;
}

/** The mode of another model that has the same shape to the bit: the same number in most, a near one in others. */
std::optional<Eigen::Index> sameShape (const ModalModel& model, Eigen::Index mode, const ModalModel& other)
{
    const auto isSame = [&] (Eigen::Index k)
    {
        const auto shape = model.shapes.col (mode), candidate = other.shapes.col (k);
        return std::equal (shape.begin(), shape.end(), candidate.begin(), candidate.end());
    };

    for (Eigen::Index distance = 0; distance < other.modes(); ++distance)
        for (const auto k : { mode - distance, mode + distance })
            if (k >= 0 && k < other.modes() && isSame (k))
                return k;

    return {};
}

/** The share of each mode of another model in a shape, of those near a number; none where it is no mixture of them. */
std::optional<std::vector<MeasuredMode::Share>> sharesOf (const Eigen::VectorXd& shape, Eigen::Index mode,
                                                          const ModalModel& other)
{
    constexpr Eigen::Index farthest = 2;
    constexpr double rounding = 1e-9, none = 1e-12;
    const auto first = std::max<Eigen::Index> (0, mode - farthest);
    const auto count = std::min (other.modes() - 1, mode + farthest) - first + 1;

    if (count < 1 || other.hasComplexModes())
        return {};

    const auto near = other.shapes.middleCols (first, count);
    const Eigen::VectorXd shares = near.householderQr().solve (shape);

    if (! ((near * shares - shape).norm() < rounding * shape.norm()))
        return {};

    std::vector<MeasuredMode::Share> all;

    for (Eigen::Index i = 0; i < count; ++i)
        if (std::abs (shares[i]) > none)
            all.push_back ({ first + i, shares[i] });

    return all;
}

/** Shares of measured modes as shares of the drawing's. */
std::vector<MeasuredMode::Share> ofDrawing (const std::vector<MeasuredMode::Share>& shares,
                                            const MeasuredDevice* measuredBefore)
{
    if (measuredBefore == nullptr)
        return shares;

    std::map<Eigen::Index, double> sums;

    for (const auto& each : shares)
    {
        const auto& mode = measuredBefore->modes[static_cast<std::size_t> (each.drawn)];

        for (const auto& part : wholeShares (mode))
            sums[part.drawn] += each.share * part.share;
    }

    std::vector<MeasuredMode::Share> all;
    all.reserve (sums.size());

    for (const auto& [drawn, share] : sums)
        all.push_back ({ drawn, share });

    return all;
}

/** The modes as modes of the drawing; none where one has another shape. */
std::optional<std::vector<MeasuredMode>> modesOfDrawing (const MeasuredDevice* measuredBefore, const ModalModel& before,
                                                         const ModalModel& now)
{
    if (now.shapes.rows() != before.shapes.rows() || now.surface.points != before.surface.points
        || now.actuators() != before.actuators())
        return {};

    std::vector<MeasuredMode> modes;

    for (Eigen::Index k = 0; k < now.modes(); ++k)
    {
        auto same = sameShape (now, k, before);
        std::vector<MeasuredMode::Share> shares;

        if (! same)
        {
            const auto mixture = sharesOf (now.shapes.col (k), k, before);

            if (! mixture)
                return {};

            same = k;
            shares = ofDrawing (*mixture, measuredBefore);
        }

        const auto* const earlier =
            measuredBefore != nullptr ? &measuredBefore->modes[static_cast<std::size_t> (*same)] : nullptr;
        MeasuredMode mode { earlier != nullptr ? earlier->drawn : *same,
                            now.angularFrequencies[k],
                            now.dampingRatios[k],
                            participationOf (now, k),
                            {} };

        if (earlier != nullptr)
            mode.reference = referenceOf (*earlier, participationOf (before, *same));
        else if (now.actuators() > 0)
            mode.reference = referenceOf (before, *same);

        if (! shares.empty())
            mode.shares = std::move (shares);
        else if (earlier != nullptr)
            mode.shares = earlier->shares;

        modes.push_back (std::move (mode));
    }

    return modes;
}

std::vector<MeasuredCeramic> ceramicChanges (const MeasuredDevice* measuredBefore, const ModalModel& before,
                                             const ModalModel& now)
{
    auto ceramics = measuredBefore != nullptr ? measuredBefore->ceramics : std::vector<MeasuredCeramic> {};
    ceramics.resize (now.ceramics.size());

    for (std::size_t i = 0; i < ceramics.size(); ++i)
    {
        const auto &then = before.ceramics[i], &is = now.ceramics[i];

        if (is.voltageLimit != then.voltageLimit)
            ceramics[i].voltageLimit = is.voltageLimit;

        if (is.slewLimit != then.slewLimit)
            ceramics[i].slewLimit = is.slewLimit;

        ceramics[i].lag = is.lag;
    }

    return ceramics;
}

/** How much larger each ceramic's participations are than drawn. N_b */
Eigen::RowVectorXd gainsOf (const Eigen::MatrixXd& measured, const Eigen::MatrixXd& drawn)
{
    const Eigen::RowVectorXd energies = drawn.colwise().squaredNorm();
    return (energies.array() > 0)
        .select (measured.cwiseProduct (drawn).colwise().sum().array() / energies.array(), 1.0)
        .matrix();
}

/** Behind a device's modes the last shapes of its drawing. */
void appendShare (ModalModel& model, const ModalModel& drawn, const std::vector<Eigen::Index>& order,
                  Eigen::Index share)
{
    const auto modes = model.modes(), all = modes + share;
    const Eigen::RowVectorXd gains = gainsOf (model.participation, drawn.participation (order, Eigen::all));
    const auto append = [&] (Eigen::VectorXd& values, const Eigen::VectorXd& more)
    {
        values.conservativeResize (all);
        values.tail (share) = more.tail (share);
    };
    const auto highest = model.angularFrequencies[modes - 1];
    append (model.angularFrequencies, drawn.angularFrequencies.cwiseMax (highest));
    append (model.dampingRatios, drawn.dampingRatios);
    model.participation.conservativeResize (all, Eigen::NoChange);
    model.participation.bottomRows (share) = drawn.participation.bottomRows (share) * gains.asDiagonal();
    model.shapes.conservativeResize (Eigen::NoChange, all);
    model.shapes.rightCols (share) = drawn.shapes.rightCols (share);
}
} // namespace

void sortByFrequency (std::vector<MeasuredMode>& modes)
{
    std::stable_sort (modes.begin(), modes.end(),
                      [] (const MeasuredMode& one, const MeasuredMode& other)
                      { return one.angularFrequency < other.angularFrequency; });
}

ModalModel measuredModel (const MeasuredDevice& measured, const ModalModel& drawn, Eigen::Index share)
{
    requireModes (measured, drawn);
    auto model = drawn;
    model.origin = measured.origin;
    const auto count = static_cast<Eigen::Index> (measured.modes.size());
    const auto parts = drawn.coordinates() / drawn.modes();
    std::vector<Eigen::Index> order, coordinates;

    for (const auto& mode : measured.modes)
        order.push_back (mode.drawn);

    for (Eigen::Index part = 0; part < parts; ++part)
        for (const auto k : order)
            coordinates.push_back (k + part * drawn.modes());

    model.shapes = drawn.shapes (Eigen::all, coordinates);
    model.angularFrequencies.resize (count);
    model.dampingRatios.resize (count);
    model.participation.resize (parts * count, drawn.actuators());

    if (drawn.slopes.size() > 0)
        model.slopes = drawn.slopes (Eigen::all, coordinates);

    for (Eigen::Index k = 0; k < count; ++k)
        if (const auto& mode = measured.modes[static_cast<std::size_t> (k)]; ! mode.shares.empty())
            mix (model, k, sharesNow (mode, measured, drawn), drawn);

    model.frequencyErrors.resize (0); // Those of the solver are no longer of these frequencies.

    for (Eigen::Index k = 0; k < count; ++k)
    {
        const auto& mode = measured.modes[static_cast<std::size_t> (k)];
        model.angularFrequencies[k] = mode.angularFrequency;
        model.dampingRatios[k] = mode.dampingRatio;

        for (Eigen::Index part = 0; part < parts; ++part)
            model.participation.row (k + part * count) =
                (isTurnedOver (mode, drawn) ? -1.0 : 1.0) * mode.participation.row (part);
    }

    for (std::size_t i = 0; i < measured.ceramics.size(); ++i)
    {
        auto& ceramic = model.ceramics[i];
        ceramic.voltageLimit = measured.ceramics[i].voltageLimit.value_or (ceramic.voltageLimit);
        ceramic.slewLimit = measured.ceramics[i].slewLimit.value_or (ceramic.slewLimit);
        ceramic.lag = measured.ceramics[i].lag;
    }

    if (share > 0 && parts == 1)
        appendShare (model, drawn, order, share);

    validate (model);
    return model;
}

std::optional<MeasuredDevice> measuredChanges (const DeviceDescription& device, const ModalModel& before,
                                               const ModalModel& now)
{
    const auto* const measuredBefore = std::get_if<MeasuredDevice> (&device.body);

    if (measuredBefore == nullptr && ! isComputed (device))
        return {};

    auto modes = modesOfDrawing (measuredBefore, before, now);

    if (! modes)
        return {};

    sortByFrequency (*modes);
    return MeasuredDevice { measuredBefore != nullptr ? measuredBefore->drawing
                                                      : std::make_shared<const DeviceDescription> (device),
                            std::move (*modes), ceramicChanges (measuredBefore, before, now), now.origin };
}
} // namespace antinode
