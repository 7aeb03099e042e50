#include "CsvResponses.h"

#include "CsvHeading.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_numerics/Fourier.h>
#include <antinode_text/CsvTable.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <set>

namespace antinode
{
namespace
{
constexpr double halfTurn = 180;

/** The two columns of a response. */
struct ColumnPair
{
    CsvHeading first, second;
    Eigen::Index firstColumn = 0, secondColumn = 0; ///< The second is 0 as long as it is not found.
    Eigen::Index abscissaColumn = 0;                ///< Of its frequencies.
};

bool isFirst (CsvColumnKind kind)
{
    return kind == CsvColumnKind::real || kind == CsvColumnKind::magnitude || kind == CsvColumnKind::decibel;
}

bool belongTogether (CsvColumnKind first, CsvColumnKind second)
{
    return (first == CsvColumnKind::real) == (second == CsvColumnKind::imaginary);
}

/** The meaning of the two columns of a response in a form. */
void applyForm (CsvForm form, ColumnPair& pair)
{
    const auto isReal = form == CsvForm::byHeadings || form == CsvForm::realImaginary;
    const auto isDecibel = form == CsvForm::decibelDegrees || form == CsvForm::decibelRadians;
    pair.first.kind = isReal ? CsvColumnKind::real : isDecibel ? CsvColumnKind::decibel : CsvColumnKind::magnitude;
    pair.second.kind = isReal ? CsvColumnKind::imaginary : CsvColumnKind::phase;
    pair.second.isDegrees = form == CsvForm::magnitudeDegrees || form == CsvForm::decibelDegrees;
    pair.second.isRadians = form == CsvForm::magnitudeRadians || form == CsvForm::decibelRadians;
}

/** Consecutive pairs of columns, if headings do not describe them. */
std::vector<ColumnPair> pairsByOrder (const std::vector<CsvHeading>& headings, CsvForm form, const std::string& source)
{
    std::vector<ColumnPair> pairs;
    Eigen::Index abscissa = 0;
    std::vector<std::size_t> columns; // Without frequencies.

    for (std::size_t c = 1; c < headings.size(); ++c)
        if (headings[c].kind != CsvColumnKind::frequency)
            columns.push_back (c);

    if (columns.size() % 2 != 0 || columns.empty())
        throw InputError (source,
                          "has " + std::to_string (headings.size())
                              + " columns; allowed: one of frequencies and two per response, or columns with headings");

    for (std::size_t i = 0; i < columns.size(); i += 2)
    {
        const auto first = columns[i], second = columns[i + 1];
        abscissa =
            headings[first - 1].kind == CsvColumnKind::frequency ? static_cast<Eigen::Index> (first - 1) : abscissa;
        ColumnPair pair { headings[first], headings[second], static_cast<Eigen::Index> (first),
                          static_cast<Eigen::Index> (second), abscissa };
        applyForm (form, pair);
        pairs.push_back (pair);
    }

    return pairs;
}

/** The pair that a second column completes: that with its names, or the last one where it has none. */
std::vector<ColumnPair>::iterator partnerOf (const CsvHeading& heading, std::vector<ColumnPair>& pairs)
{
    const auto isOpen = [&] (const auto& pair)
    { return pair.secondColumn == 0 && belongTogether (pair.first.kind, heading.kind); };
    const auto named = std::find_if (pairs.begin(), pairs.end(),
                                     [&] (const auto& pair) {
                                         return isOpen (pair) && pair.first.point == heading.point
                                                && pair.first.reference == heading.reference;
                                     });

    if (named != pairs.end() || pairs.empty() || ! heading.point.empty() || ! heading.reference.empty())
        return named;

    return isOpen (pairs.back()) ? std::prev (pairs.end()) : pairs.end();
}

std::vector<ColumnPair> pairsByHeadings (const std::vector<CsvHeading>& headings, const std::string& source)
{
    std::vector<ColumnPair> pairs;
    Eigen::Index abscissa = 0;

    for (std::size_t c = 1; c < headings.size(); ++c)
    {
        const auto& heading = headings[c];
        const auto column = static_cast<Eigen::Index> (c);
        const auto fail = [&] (const std::string& wrong)
        { throw InputError (source, "column " + std::to_string (c + 1) + " " + wrong); };

        if (heading.kind == CsvColumnKind::coherence)
            continue;

        if (heading.kind == CsvColumnKind::frequency)
        {
            abscissa = column;
            continue;
        }

        if (heading.kind == CsvColumnKind::unknown)
            fail ("has an unknown content; allowed: real, imag, magnitude, dB, phase or coherence in its "
                  "heading");

        if (isFirst (heading.kind))
        {
            pairs.push_back ({ heading, {}, column, 0, abscissa });
            continue;
        }

        const auto partner = partnerOf (heading, pairs);

        if (partner == pairs.end())
            fail ("has no preceding column with the other part of its response");

        partner->second = heading;
        partner->secondColumn = column;
    }

    for (const auto& pair : pairs)
        if (pair.secondColumn == 0)
            throw InputError (source, "column " + std::to_string (pair.firstColumn + 1)
                                          + " has no column with the other part of its response");

    return pairs;
}

Eigen::VectorXcd readValues (const ColumnPair& pair, const CsvTable& table, MeasurementFile& file,
                             const std::string& source)
{
    constexpr double decibelsADecade = 20;
    const Eigen::ArrayXd first = table.numbers.col (pair.firstColumn), second = table.numbers.col (pair.secondColumn);
    const auto unit = std::complex<double> (0, 1);

    if (pair.first.kind == CsvColumnKind::real)
        return first + unit * second;

    auto isDegrees = pair.second.isDegrees;

    if (! isDegrees && ! pair.second.isRadians)
    {
        isDegrees = second.isFinite().select (second, 0).abs().maxCoeff() > 2 * std::numbers::pi;
        file.remarks.push_back (source + ": the unit of the phases is missing and assumed to be "
                                + (isDegrees ? "degrees." : "radians."));
    }

    const Eigen::ArrayXd magnitude =
        pair.first.kind == CsvColumnKind::decibel ? Eigen::ArrayXd (Eigen::pow (10.0, first / decibelsADecade)) : first;
    const Eigen::ArrayXd phase = isDegrees ? Eigen::ArrayXd (second * std::numbers::pi / halfTurn) : second;
    return magnitude * (unit * phase.cast<std::complex<double>>()).exp();
}

/** Hz or s per number of the first column. */
double abscissaFactor (const std::vector<std::string>& words)
{
    const auto has = [&] (std::string_view word)
    { return std::find (words.begin(), words.end(), word) != words.end(); };
    return has ("khz") ? 1e3 : has ("rad") || has ("omega") ? 1 / (2 * std::numbers::pi) : has ("ms") ? 1e-3 : 1;
}

bool isTime (const std::vector<std::string>& words)
{
    constexpr std::array<std::string_view, 7> times { "time", "t", "times", "zeit", "temps", "timestamp", "elapsed" };
    return ! words.empty() && std::find (times.begin(), times.end(), words.front()) != times.end();
}

/** A column of frequencies that does not stand first, behind numbers of the lines, comes there. */
void beginWithFrequencies (CsvTable& table, std::vector<CsvHeading>& headings)
{
    const auto isFrequency = [] (const auto& heading) { return heading.kind == CsvColumnKind::frequency; };
    const auto isResponse = [] (const auto& heading) { return heading.kind > CsvColumnKind::frequency; };
    const auto first = std::find_if (headings.begin(), headings.end(), isFrequency);

    if (first == headings.end() || std::any_of (headings.begin(), first, isResponse))
        return;

    const auto before = first - headings.begin();
    headings.erase (headings.begin(), first);
    table.headings.erase (table.headings.begin(), table.headings.begin() + before);
    table.numbers = table.numbers.rightCols (table.numbers.cols() - before).eval();
}

/** Columns that repeat the first one are its frequencies again, whatever their headings say. */
void markRepeatedFrequencies (const CsvTable& table, std::vector<CsvHeading>& headings)
{
    constexpr Eigen::Index fewest = 3; // Rows, of which a few could agree by chance.

    for (Eigen::Index c = 1; c < table.numbers.cols(); ++c)
        if (table.numbers.rows() > fewest && table.numbers.col (c) == table.numbers.col (0))
            headings[static_cast<std::size_t> (c)].kind = CsvColumnKind::frequency;
}

std::vector<CsvHeading> readHeadings (const CsvTable& table)
{
    std::vector<CsvHeading> headings (static_cast<std::size_t> (table.numbers.cols()));

    if (! table.headings.empty())
        std::transform (table.headings.begin(), table.headings.end(), headings.begin(),
                        [] (const auto& text) { return csvHeading (text); });

    return headings;
}

std::optional<ResponseUnit> findUnit (const CsvTable& table)
{
    for (const auto& comment : table.comments)
        if (const auto unit = unitInText (comment))
            return unit;

    return std::nullopt;
}

/** Names the labels that stand for units and are not known, of headings, and of comments where nothing else says one.
 */
void addUnknownUnits (const std::vector<CsvHeading>& headings, const CsvTable& table, MeasurementFile& file,
                      const std::string& source)
{
    std::set<std::string> labels;
    auto isStated = false;

    for (const auto& heading : headings)
    {
        isStated = isStated || heading.unit;

        if (! heading.unknownUnit.empty())
            labels.insert (heading.unknownUnit);
    }

    for (const auto& comment : table.comments)
        if (const auto label = unknownUnitInText (comment); ! isStated && ! label.empty())
            labels.insert (label);

    for (const auto& label : labels)
        file.remarks.push_back (unknownUnitRemark (source, label));
}

/** Motion and force over time are no impulse responses. */
void refuseForces (const CsvTable& table, const std::string& source)
{
    for (const auto& heading : table.headings)
        for (const auto& word : splitWords (heading))
            if (word == "force" || word == "hammer")
                throw InputError (source, "has a force over time " + inQuotes (heading)
                                              + "; allowed: frequency responses, or impulse responses, which 'frf' "
                                                "computes from recordings of force and motion");
}

/** Lines so dense are times without a heading: nothing that vibrates slowly or for minutes is meant. */
void refuseTimes (const Eigen::VectorXd& frequencies, const std::string& source)
{
    constexpr double low = 20, fine = 0.1, finest = 2.5e-3; // Hz
    const auto count = frequencies.size();

    if (count < 2)
        return;

    const auto highest = frequencies[count - 1], step = (highest - frequencies[0]) / static_cast<double> (count - 1);

    if (step > 0 && ((highest < low && step < fine) || step < finest))
        throw InputError (source,
                          "has frequencies up to " + numberText (highest) + " Hz every " + numberText (step)
                              + " Hz, which look like times; allowed: lines at least 0.0025 Hz apart, and 0.1 Hz "
                                "where none is above 20 Hz; the heading of a column of times is 'time'");
}

/** The power of ten of which all times are multiples: that of their last digit; nothing where it is very small. */
std::optional<double> lastDigit (const Eigen::VectorXd& times)
{
    constexpr double tolerance = 1e-6;
    constexpr int mostDigits = 9;

    for (int digits = 0; digits <= mostDigits; ++digits)
    {
        const auto unit = std::pow (10.0, -digits);
        const Eigen::ArrayXd scaled = times.array() / unit;

        if (((scaled - scaled.round()).abs() < tolerance).all())
            return unit;
    }

    return std::nullopt;
}

/** The interval of the straight line through times that are rounded to their last digit; nothing where one is further
   from it than the rounding says, or the line is not known to a thousandth. */
std::optional<double> roundedInterval (const Eigen::VectorXd& times)
{
    constexpr double mostDeviation = 0.75, accuracy = 1e-3; // of the last digit
    const auto unit = times.allFinite() ? lastDigit (times) : std::nullopt;

    if (! unit)
        return std::nullopt;

    const auto count = static_cast<double> (times.size());
    const Eigen::ArrayXd index =
        Eigen::ArrayXd::LinSpaced (times.size(), 0, count - 1) - (count - 1) / 2; // Around its mean.
    const auto interval = (index * times.array()).sum() / index.square().sum();
    const auto deviation = (times.array() - times.mean() - interval * index).abs().maxCoeff();
    const auto isKnown = *unit < accuracy * interval * count * std::sqrt (count);
    return isKnown && deviation <= mostDeviation * *unit ? std::optional (interval) : std::nullopt;
}

void addImpulseResponses (const CsvTable& table, const std::vector<CsvHeading>& headings, const Eigen::VectorXd& times,
                          MeasurementFile& file, MeasuredResponse common)
{
    const auto interval = samplingInterval (times, common.source);
    const auto unit = common.unit;

    for (Eigen::Index c = 1; c < table.numbers.cols(); ++c)
    {
        const auto& heading = headings[static_cast<std::size_t> (c)];
        const auto spectrum = impulseSpectrum (table.numbers.col (c), interval);
        common.point = heading.point;
        common.reference = heading.reference;
        common.unit = heading.unit.value_or (unit);
        common.frequencies = sharedFrequencies (spectrum.frequencies, file.responses);
        common.values = spectrum.values;
        common.recordLength = spectrum.recordLength;
        file.responses.push_back (common);
    }

    file.remarks.push_back (common.source
                            + ": the first column is a time, so the others are read as impulse responses.");
}
} // namespace

double samplingInterval (const Eigen::VectorXd& times, const std::string& source)
{
    constexpr double tolerance = 1e-3;
    const auto count = times.size();
    const auto interval = count > 1 ? (times[count - 1] - times[0]) / static_cast<double> (count - 1) : 0;
    auto isEven = interval > 0;

    for (Eigen::Index n = 1; isEven && n < count; ++n)
        isEven =
            std::abs (times[n] - times[n - 1] - interval) < tolerance * interval + 1e-6 * times.cwiseAbs().maxCoeff();

    if (count < 2 || isEven)
    {
        if (! (interval > 0))
            throw InputError (source, "has fewer than two samples");

        return interval;
    }

    const auto rounded = roundedInterval (times);

    if (! rounded)
        throw InputError (source, "has unevenly spaced times; allowed: samples at a constant rate");

    return *rounded;
}

MeasurementFile measurementFromCsv (std::string_view text, const std::string& source, CsvForm form)
{
    auto table = readCsvTable (text, source);
    auto headings = readHeadings (table);
    beginWithFrequencies (table, headings);
    markRepeatedFrequencies (table, headings);
    const auto words = table.headings.empty() ? std::vector<std::string> {} : splitWords (table.headings.front());
    const auto factor = abscissaFactor (words);
    const Eigen::VectorXd abscissae = table.numbers.col (0) * factor;
    const auto unit = findUnit (table);
    MeasurementFile file;
    MeasuredResponse response;
    response.source = source;
    response.unit = unit.value_or (ResponseUnit {});
    addUnknownUnits (headings, table, file, source);

    if (isTime (words))
    {
        refuseForces (table, source);
        addImpulseResponses (table, headings, abscissae, file, response);
        return file;
    }

    const auto isKnown = [] (const auto& heading) { return heading.kind > CsvColumnKind::frequency; };
    const auto areTold = form == CsvForm::byHeadings && std::any_of (headings.begin() + 1, headings.end(), isKnown);

    if (! areTold)
        refuseTimes (abscissae, source);

    for (const auto& pair : areTold ? pairsByHeadings (headings, source) : pairsByOrder (headings, form, source))
    {
        response.point = pair.first.point;
        response.reference = pair.first.reference;
        response.unit = pair.first.unit.value_or (unit.value_or (ResponseUnit {}));
        response.values = readValues (pair, table, file, source);
        response.frequencies = sharedFrequencies (factor * table.numbers.col (pair.abscissaColumn), file.responses);
        file.responses.push_back (response);
    }

    return file;
}

namespace
{
bool isQuick (Eigen::Index count)
{
    for (const Eigen::Index factor : { 2, 3, 5 })
        while (count % factor == 0)
            count /= factor;

    return count == 1;
}
} // namespace

ImpulseSpectrum impulseSpectrum (const Eigen::VectorXd& samples, double interval)
{
    auto count = samples.size();

    while (! isQuick (count)) // A large prime factor would take a time that grows as its square.
        --count;

    // A constant counts at 0 Hz alone: elsewhere not even its rounding is left.
    Eigen::VectorXcd lines = forwardFourier (Eigen::VectorXd (samples.head (count).array() - samples[0]));
    lines[0] += static_cast<double> (count) * samples[0];
    const auto recordLength = static_cast<double> (count) * interval;
    return { Eigen::VectorXd::LinSpaced (lines.size(), 0, static_cast<double> (lines.size() - 1)) / recordLength,
             lines * interval, recordLength };
}
} // namespace antinode
