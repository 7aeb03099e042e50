#include "SvgPage.h"

#include "SvgNumbers.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace antinode
{
namespace
{
/** The length of an attribute such as 210mm, m; nothing without a unit of length. A pixel is none: programs take 72, 90
   or 96 of them for an inch. */
std::optional<double> svgLength (std::string_view text)
{
    constexpr std::array<std::pair<std::string_view, double>, 7> units { { { "mm", 1e-3 },
                                                                           { "cm", 1e-2 },
                                                                           { "m", 1 },
                                                                           { "in", 0.0254 },
                                                                           { "pt", 0.0254 / 72 },
                                                                           { "pc", 0.0254 / 6 },
                                                                           { "Q", 0.25e-3 } } };
    SvgNumbers numbers (text);
    const auto value = numbers.number();

    if (! value || ! (*value > 0))
        return std::nullopt;

    auto unit = numbers.left();
    unit = unit.substr (0, unit.find_last_not_of (" \t\r\n\f") + 1);
    const auto found = std::find_if (units.begin(), units.end(), [&] (const auto& each) { return each.first == unit; });
    return found == units.end() ? std::nullopt : std::optional (*value * found->second);
}

/** x, y, width and height of the page, in units of the drawing. */
std::array<double, 4> pageBox (const XmlNode& root, double unit, const std::string& source)
{
    const auto text = root.attribute ("viewBox");

    if (const auto values = svgNumberList (text); values && values->size() == 4 && (*values)[2] > 0 && (*values)[3] > 0)
        return { (*values)[0], (*values)[1], (*values)[2], (*values)[3] };

    if (! text.empty())
        throw InputError (source, "viewBox is " + inQuotes (text)
                                      + "; allowed: four numbers, the last two of which are larger than 0");

    SvgNumbers height (root.attribute ("height"));

    if (unit > 0)
        return { 0, 0, 1, height.number().value_or (0) };

    throw InputError (source, "has no viewBox, so the size of its units is unknown; allowed: a document in mm, or "
                              "a unit beside the file's name");
}

/** From the page in units of the drawing to m, y still downwards: as preserveAspectRatio says, in the middle. */
Eigen::Affine2d scaledPage (const std::array<double, 4>& box, const Eigen::Vector2d& size, bool isStretched)
{
    Eigen::Vector2d scale (size.x() / box[2], size.y() / box[3]);

    if (! isStretched)
        scale.setConstant (scale.minCoeff());

    const Eigen::Vector2d margin = (size - scale.cwiseProduct (Eigen::Vector2d (box[2], box[3]))) / 2;
    return Eigen::Translation2d (margin) * Eigen::Scaling (scale) * Eigen::Translation2d (-box[0], -box[1]);
}
} // namespace

Eigen::Affine2d svgPage (const XmlNode& root, double unit, const std::string& source)
{
    const auto box = pageBox (root, unit, source);
    const auto isStretched = root.attribute ("preserveAspectRatio").substr (0, 4) == "none";
    Eigen::Vector2d size = unit * Eigen::Vector2d (box[2], box[3]);

    if (! (unit > 0))
    {
        const auto width = svgLength (root.attribute ("width")), height = svgLength (root.attribute ("height"));

        if (! width || ! height)
            throw InputError (source, "width is " + inQuotes (root.attribute ("width")) + " and height "
                                          + inQuotes (root.attribute ("height"))
                                          + ", so the size of its units is unknown; allowed: mm, cm, m, in, pt, "
                                            "pc or Q, or a unit beside the file's name");

        size = { *width, *height };
    }

    const auto upwards = Eigen::Translation2d (0, size.y()) * Eigen::Scaling (Eigen::Vector2d (1, -1));
    return upwards
           * (unit > 0 ? Eigen::Affine2d (Eigen::Scaling (unit) * Eigen::Translation2d (-box[0], -box[1]))
                       : scaledPage (box, size, isStretched));
}
} // namespace antinode
