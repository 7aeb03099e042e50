#include "FeltElsewhere.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

namespace antinode
{
namespace
{
constexpr double lowestLine = 20, highestLine = 1500; // Hz: beyond, skin feels next to nothing
constexpr double ringingHeard = 0.5;                  // s after the voltages end
constexpr double weakestRow = 1e-4;                   // of the strongest one's energy
constexpr Eigen::Index linesAtOnce = 128;

Eigen::VectorXd evenLines (double duration)
{
    const auto step = 1 / (duration + ringingHeard);
    const auto first = std::ceil (lowestLine / step);
    const auto count = static_cast<Eigen::Index> (std::floor (highestLine / step) - first) + 1;
    return Eigen::VectorXd::LinSpaced (count, first * step, (first + static_cast<double> (count - 1)) * step);
}

/** One row a place: its mode shapes, so that the sum of squares is a mean. */
Eigen::MatrixXd shapesOfPlaces (const ModalModel& model, const std::vector<std::pair<double, double>>& places)
{
    Eigen::MatrixXd shapes (places.size(), model.modes());

    for (std::size_t i = 0; i < places.size(); ++i)
        shapes.row (static_cast<Eigen::Index> (i)) = shapesAt (model, places[i].first, places[i].second);

    return shapes / std::sqrt (static_cast<double> (places.size()));
}

/** The square roots of the areas of points elsewhere, so that their sum of squares is 1; 0 near a target. */
Eigen::VectorXd rootsElsewhere (const ModalModel& model, const std::vector<Target>& targets)
{
    const auto& surface = model.surface;
    Eigen::VectorXd areas = surface.areas;

    for (Eigen::Index n = 0; n < areas.size(); ++n)
        for (const auto& target : targets)
        {
            const auto y = surface.points.cols() > 1 ? surface.points (n, 1) - target.y : 0.0;

            if (std::hypot (surface.points (n, 0) - target.x, y) <= feltNeighbourhood)
                areas[n] = 0;
        }

    if (! (areas.sum() > 0))
        throw InputError ("focus: felt", "is to be less everywhere, but the surface ends within 30 mm of the targets; "
                                         "allowed: a list of places");

    return (areas / areas.sum()).cwiseSqrt();
}

/** The mode shapes elsewhere as few rows with the same sum of squares for any motion, but for what is hardly felt.
    @param gains  of each mode, the largest on any line */
Eigen::MatrixXd shapesElsewhere (const ModalModel& model, const std::vector<Target>& targets,
                                 const Eigen::VectorXd& gains)
{
    const Eigen::MatrixXd shapes = rootsElsewhere (model, targets).asDiagonal() * model.shapes * gains.asDiagonal();
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero (gains.size(), gains.size());
    addTransposedLeft (gram, 1, shapes, shapes);
    const auto parts = symmetricEigen (std::move (gram));
    const auto kept = (parts.values.array() > weakestRow * parts.values.maxCoeff()).count();
    return parts.values.tail (kept).cwiseSqrt().asDiagonal() * parts.vectors.rightCols (kept).transpose()
           * gains.cwiseInverse().asDiagonal();
}

Eigen::MatrixXd shapesOf (const ModalModel& model, const FocusDescription& focus, const Eigen::VectorXd& gains)
{
    const auto& felt = focus.felt.value();

    if (felt.at == FeltAt::everywhere)
        return shapesElsewhere (model, focus.targets, gains);

    auto places = felt.places;

    if (felt.at == FeltAt::fingers)
        for (const auto& finger : focus.fingers)
            places.emplace_back (finger.x, finger.y);

    if (places.empty())
        throw InputError ("focus: felt", "is to be less at the fingers, but there are none; allowed: fingers, "
                                         "'everywhere' or a list of places");

    return shapesOfPlaces (model, places);
}

/** Displacement per modal force in thresholds, of all modes and lines: N_m x N_f. */
Eigen::MatrixXcd modalGains (const ModalModel& model, const Eigen::VectorXd& lines, const SkinThreshold& threshold)
{
    const auto root = std::sqrt (2 * (lines.size() > 1 ? lines[1] - lines[0] : 1)); // both signs of frequency
    Eigen::MatrixXcd gains (model.modes(), lines.size());

    for (Eigen::Index f = 0; f < lines.size(); ++f)
    {
        const auto w = 2 * std::numbers::pi * lines[f];
        const auto scale = root / thresholdAt (threshold, lines[f]);

        for (Eigen::Index k = 0; k < model.modes(); ++k)
        {
            const auto natural = model.angularFrequencies[k];
            gains (k, f) = scale / std::complex (natural * natural - w * w, 2 * model.dampingRatios[k] * natural * w);
        }
    }

    return gains;
}
} // namespace

FeltLines feltLines (const ModalModel& model, const FocusDescription& focus, double duration)
{
    requireRealModes (model, "focuses with less felt elsewhere");
    FeltLines lines { evenLines (duration), {}, {} };
    const auto gains = modalGains (model, lines.frequencies, focus.threshold);
    const auto shapes = shapesOf (model, focus, gains.cwiseAbs().rowwise().maxCoeff());
    const Eigen::MatrixXd real = gains.real(), imaginary = gains.imag();

    for (Eigen::Index p = 0; p < shapes.rows(); ++p)
    {
        checkWatch();
        const Eigen::MatrixXd seen = shapes.row (p).transpose().asDiagonal() * model.participation;

        for (const auto& [from, to] : { std::pair { &real, &lines.real }, { &imaginary, &lines.imaginary } })
        {
            Eigen::MatrixXd row = Eigen::MatrixXd::Zero (model.actuators(), lines.frequencies.size());
            addTransposedLeft (row, 1, seen, *from);
            to->push_back (std::move (row));
        }
    }

    return lines;
}

Eigen::MatrixXd spectraOn (const FeltLines& lines, const Eigen::MatrixXd& samples, double sampleRate)
{
    const auto count = lines.frequencies.size();
    Eigen::MatrixXd spectra = Eigen::MatrixXd::Zero (samples.rows(), 2 * count);

    for (Eigen::Index first = 0; first < count; first += linesAtOnce)
    {
        checkWatch();
        const auto some = std::min (linesAtOnce, count - first);
        Eigen::MatrixXd cosines (samples.cols(), some), sines (samples.cols(), some);

        for (Eigen::Index f = 0; f < some; ++f)
        {
            const auto turn = std::polar (1.0, -2 * std::numbers::pi * lines.frequencies[first + f] / sampleRate);
            std::complex<double> phasor = 1 / sampleRate;

            for (Eigen::Index n = 0; n < samples.cols(); ++n, phasor *= turn)
            {
                cosines (n, f) = phasor.real();
                sines (n, f) = phasor.imag();
            }
        }

        addProduct (spectra.middleCols (first, some), 1, samples, cosines);
        addProduct (spectra.middleCols (count + first, some), 1, samples, sines);
    }

    return spectra;
}

FeltElsewhere::FeltElsewhere (FeltLines linesToUse, const QuietBasis& basis, const Eigen::MatrixXd& participation,
                              double sampleRate)
    : lines (std::move (linesToUse)), splines (spectraOn (lines, basis.splineWaves(), sampleRate))
{
    const auto spectra = spectraOn (lines, basis.rowWaveforms(), sampleRate);
    const auto count = lines.frequencies.size();
    const Eigen::MatrixXd real = spectra.leftCols (count), imaginary = spectra.rightCols (count);

    for (std::size_t p = 0; p < lines.real.size(); ++p)
    {
        const Eigen::MatrixXd a = participation * lines.real[p], b = participation * lines.imaginary[p];
        Eigen::MatrixXd seen (spectra.rows(), 2 * count);
        seen.leftCols (count) = a.cwiseProduct (real) - b.cwiseProduct (imaginary);
        seen.rightCols (count) = a.cwiseProduct (imaginary) + b.cwiseProduct (real);
        rows.push_back (seen.transpose());
    }
}

Eigen::MatrixXd FeltElsewhere::ofSamples (const Eigen::MatrixXd& samples, double sampleRate) const
{
    return ofSpectra (spectraOn (lines, samples, sampleRate));
}

Eigen::MatrixXd FeltElsewhere::ofCorrection (const QuietCorrection& change) const
{
    Eigen::MatrixXd spectra = Eigen::MatrixXd::Zero (change.splines.rows(), splines.cols());
    addProduct (spectra, 1, change.splines, splines);
    auto felt = ofSpectra (spectra);

    for (std::size_t p = 0; p < rows.size(); ++p)
        felt.col (static_cast<Eigen::Index> (p)) -= rows[p] * change.rows;

    return felt;
}

QuietCorrection FeltElsewhere::slope (const Eigen::MatrixXd& felt) const
{
    const auto count = lines.frequencies.size();
    Eigen::MatrixXd spectra = Eigen::MatrixXd::Zero (lines.real.front().rows(), 2 * count);
    Eigen::VectorXd pulls = Eigen::VectorXd::Zero (rows.front().cols());

    for (std::size_t p = 0; p < rows.size(); ++p)
    {
        const auto column = felt.col (static_cast<Eigen::Index> (p));
        const auto real = column.head (count).asDiagonal(), imaginary = column.tail (count).asDiagonal();
        spectra.leftCols (count) += lines.real[p] * real + lines.imaginary[p] * imaginary;
        spectra.rightCols (count) += lines.real[p] * imaginary - lines.imaginary[p] * real;
        pulls -= rows[p].transpose() * column;
    }

    QuietCorrection result { Eigen::MatrixXd::Zero (spectra.rows(), splines.rows()), std::move (pulls) };
    addTransposedRight (result.splines, 1, spectra, splines);
    return result;
}

Eigen::MatrixXd FeltElsewhere::ofSpectra (const Eigen::MatrixXd& spectra) const
{
    const auto count = lines.frequencies.size();
    const auto real = spectra.leftCols (count), imaginary = spectra.rightCols (count);
    Eigen::MatrixXd felt (2 * count, static_cast<Eigen::Index> (lines.real.size()));

    for (std::size_t p = 0; p < lines.real.size(); ++p)
    {
        const auto &a = lines.real[p], &b = lines.imaginary[p];
        auto column = felt.col (static_cast<Eigen::Index> (p));
        column.head (count) = (a.cwiseProduct (real) - b.cwiseProduct (imaginary)).colwise().sum().transpose();
        column.tail (count) = (a.cwiseProduct (imaginary) + b.cwiseProduct (real)).colwise().sum().transpose();
    }

    return felt;
}
} // namespace antinode
