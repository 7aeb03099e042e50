#include "IdentificationDiagram.h"

#include "IdentificationTables.h"

#include <antinode_diagram.h>
#include <antinode_identification/FitDiagram.h>
#include <juce_core/juce_core.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace antinode
{
namespace
{
/** What stands in the page for something else. */
void replaceMark (std::string& page, std::string_view mark, const std::string& content)
{
    const auto place = page.find (mark);

    if (place == std::string::npos)
        throw std::logic_error ("the page of the diagram has no " + std::string (mark));

    page.replace (place, mark.size(), content);
}

bool endsWith (std::string_view name, std::string_view ending)
{
    return name.size() >= ending.size() && name.substr (name.size() - ending.size()) == ending;
}

/** All files of a kind, one after the other. */
std::string filesOfKind (std::string_view ending)
{
    std::string all;

    for (const auto& file : diagram::files())
        if (endsWith (file.name, ending))
            all += file.text();

    return all;
}

/** JSON that cannot end the element it is in, whatever names say. */
std::string forScript (const nlohmann::json& data)
{
    std::string text;

    for (const auto character : data.dump (-1, ' ', false, nlohmann::json::error_handler_t::replace))
        if (character == '<')
            text += "\\u003c";
        else
            text += character;

    return text;
}
} // namespace

std::string identificationDiagram (const IdentificationResult& result, const std::string& reportName)
{
    auto data = diagramData (result);
    data["report"] = reportName;
    auto page = filesOfKind (".html");
    replaceMark (page, "@style@", filesOfKind (".css"));
    replaceMark (page, "@script@", filesOfKind (".js"));
    replaceMark (page, "@data@", forScript (data));
    return page;
}

namespace
{
using Json = nlohmann::json;

/** Most values of responses in a page: two bytes each, 5.3 MB as text. */
constexpr Eigen::Index largestPage = 2'000'000;

Json polesJson (const std::vector<StabilisationPoint>& poles)
{
    const auto count = static_cast<Eigen::Index> (poles.size());
    Eigen::VectorXd frequencies (count);
    Eigen::VectorXi orders (count), areStable (count);

    for (Eigen::Index n = 0; n < count; ++n)
    {
        const auto& pole = poles[static_cast<std::size_t> (n)];
        frequencies[n] = pole.frequency;
        orders[n] = pole.order;
        areStable[n] = pole.stable ? 1 : 0;
    }

    return { { "frequency", compactDoubles (frequencies) },
             { "order", compactBytes (orders) },
             { "stable", compactBytes (areStable) } };
}

double frequencyOf (const IdentifiedModes& modes, Eigen::Index k)
{
    return modes.angularFrequencies[k] / (2 * std::numbers::pi);
}

/** Where no poles were clustered, the modes are what can be picked. */
Json candidatesJson (const IdentifiedModes& modes)
{
    auto list = Json::array();

    for (const auto& candidate : modes.candidates)
        list.push_back ({ { "frequency", candidate.frequency },
                          { "damping", candidate.dampingRatio },
                          { "presence", candidate.presence },
                          { "mode", candidate.mode ? Json (*candidate.mode) : Json() } });

    for (Eigen::Index k = 0; modes.candidates.empty() && k < modes.modes(); ++k)
        list.push_back ({ { "frequency", frequencyOf (modes, k) },
                          { "damping", modes.dampingRatios[k] },
                          { "presence", 1 },
                          { "mode", k } });

    return list;
}

Json modeJson (const IdentifiedModes& modes, Eigen::Index k)
{
    const auto quality = static_cast<std::size_t> (k) < modes.quality.size()
                             ? modes.quality[static_cast<std::size_t> (k)]
                             : ModeQuality {};
    Json mode { { "frequency", frequencyOf (modes, k) },
                { "damping", modes.dampingRatios[k] },
                { "collinearity", quality.collinearity },
                { "warnings", quality.warnings } };

    if (modes.complexShapes.size() == 0)
    {
        mode["shape"] = compactFloats (modes.shapes.col (k));
        mode["participation"] = compactFloats (modes.participation.row (k).transpose());
        return mode;
    }

    mode["shape"] = compactFloats (modes.complexShapes.col (k).real());
    mode["shapeImaginary"] = compactFloats (modes.complexShapes.col (k).imag());
    mode["participation"] = compactFloats (modes.complexParticipation.row (k).real().transpose());
    mode["participationImaginary"] = compactFloats (modes.complexParticipation.row (k).imag().transpose());
    return mode;
}

Json residualsJson (const IdentifiedModes& modes)
{
    auto list = Json::array();

    for (const auto& term : modes.residuals)
        list.push_back ({ { "power", term.power }, { "coefficients", compactFloats (term.coefficients.reshaped()) } });

    return list;
}

double largestFinite (const Eigen::VectorXcd& values)
{
    const Eigen::ArrayXd sizes = values.cwiseAbs();
    return sizes.isFinite().select (sizes, 0).maxCoeff();
}

/** Of each reference and point, what is left of it. */
Json responsesJson (const FitDiagram& diagram)
{
    auto list = Json::array();

    for (std::size_t i = 0; i < diagram.measured.values.size(); ++i)
    {
        auto ofReference = Json::array();

        for (Eigen::Index p = 0; p < diagram.measured.points.rows(); ++p)
        {
            const Eigen::VectorXcd residual =
                diagram.measured.values[i].col (p) - diagram.synthesised.values[i].col (p);
            const auto largest = std::max (largestFinite (residual), 1e-300);
            ofReference.push_back ({ { "largest", largest }, { "residual", compactComplex (residual, largest) } });
        }

        list.push_back (std::move (ofReference));
    }

    return list;
}

Json indicatorJson (const Eigen::MatrixXd& indicator)
{
    auto list = Json::array();

    for (const auto& curve : indicator.colwise())
        list.push_back (compactFloats (curve));

    return list;
}
} // namespace

nlohmann::json diagramData (const IdentificationResult& result)
{
    const auto& modes = result.modes;
    const auto diagram = fitDiagram (result.measured, modes, largestPage);
    Json data { { "title", result.model.name + ": diagram of the modes" },
                { "subtitle", sizeInWords (result) },
                { "band", { modes.minimumFrequency, modes.maximumFrequency } },
                { "unit", result.measured.drive == DriveQuantity::force ? "(m/s)/N" : "(m/s)/V" },
                { "delay", modes.delay },
                { "frequencies", compactDoubles (diagram.measured.frequencies) },
                { "usedLines", diagram.usedLines },
                { "points",
                  { { "names", result.pointNames },
                    { "x", compactDoubles (result.measured.points.col (0)) },
                    { "y", compactDoubles (result.measured.points.col (1)) } } },
                { "references", Json::array() },
                { "poles", polesJson (modes.stabilisation) },
                { "candidates", candidatesJson (modes) },
                { "modes", Json::array() },
                { "residuals", residualsJson (modes) },
                { "lowPasses", compactFloats (modes.lowPasses.reshaped()) },
                { "indicator", indicatorJson (diagram.indicator) },
                { "measuredSize", compactFloats (diagram.measuredSize) },
                { "errorSize", compactFloats (diagram.errorSize) },
                { "responses", responsesJson (diagram) } };

    for (const auto& reference : result.measured.references)
        data["references"].push_back (reference.name);

    for (Eigen::Index k = 0; k < modes.modes(); ++k)
        data["modes"].push_back (modeJson (modes, k));

    return data;
}

namespace
{
static_assert (JUCE_LITTLE_ENDIAN, "pages hold little-endian numbers");

template <typename Value>
std::string encoded (const std::vector<Value>& values)
{
    return juce::Base64::toBase64 (values.data(), values.size() * sizeof (Value)).toStdString();
}

std::uint8_t levelOf (std::complex<double> value, double largest)
{
    constexpr double highest = 254, stepsPerDecade = 40;

    if (! std::isfinite (value.real()) || ! std::isfinite (value.imag()))
        return 255;

    const auto size = std::abs (value);
    const auto level = size > 0 ? highest + stepsPerDecade * std::log10 (size / largest) : 0;
    return static_cast<std::uint8_t> (std::clamp (std::round (level), 0.0, highest));
}

std::uint8_t angleOf (std::complex<double> value)
{
    constexpr double parts = 256;
    const auto angle = std::arg (value);
    const auto turns = std::isfinite (angle) ? angle / (2 * std::numbers::pi) : 0;
    return static_cast<std::uint8_t> (static_cast<int> (std::round (turns * parts)) & 255);
}
} // namespace

std::string compactDoubles (const Eigen::VectorXd& values)
{
    return encoded (std::vector<double> (values.begin(), values.end()));
}

std::string compactFloats (const Eigen::VectorXd& values)
{
    std::vector<float> floats (static_cast<std::size_t> (values.size()));
    std::transform (values.begin(), values.end(), floats.begin(),
                    [] (double value) { return static_cast<float> (value); });
    return encoded (floats);
}

std::string compactBytes (const Eigen::VectorXi& values)
{
    std::vector<std::uint8_t> bytes (static_cast<std::size_t> (values.size()));
    std::transform (values.begin(), values.end(), bytes.begin(),
                    [] (int value) { return static_cast<std::uint8_t> (std::clamp (value, 0, 255)); });
    return encoded (bytes);
}

std::string compactComplex (const Eigen::VectorXcd& values, double largest)
{
    std::vector<std::uint8_t> bytes;

    for (const auto value : values)
    {
        bytes.push_back (levelOf (value, largest));
        bytes.push_back (angleOf (value));
    }

    return encoded (bytes);
}
} // namespace antinode
