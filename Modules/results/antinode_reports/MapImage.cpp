#include "MapImage.h"

#include <antinode_base/Watch.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
Eigen::MatrixXd averagedRows (const Eigen::MatrixXd& values, int rows)
{
    Eigen::MatrixXd averaged (rows, values.cols());
    for (int k = 0; k < rows; ++k)
    {
        const auto first = k * values.rows() / rows;
        const auto last = (k + 1) * values.rows() / rows;
        averaged.row (k) = values.middleRows (first, last - first).colwise().mean();
    }
    return averaged;
}

Eigen::MatrixXd interpolatedRows (const Eigen::MatrixXd& values, int rows)
{
    Eigen::MatrixXd interpolated (rows, values.cols());
    const auto last = values.rows() - 1;
    for (int k = 0; k < rows; ++k)
    {
        const auto place = (k + 0.5) * static_cast<double> (values.rows()) / rows - 0.5;
        const auto inside = std::clamp (place, 0.0, static_cast<double> (last));
        const auto lower = static_cast<Eigen::Index> (inside);
        const auto share = inside - static_cast<double> (lower);
        interpolated.row (k) = (1 - share) * values.row (lower) + share * values.row (std::min (lower + 1, last));
    }
    return interpolated;
}

Eigen::MatrixXd withRows (const Eigen::MatrixXd& values, int rows)
{
    return values.rows() > rows ? averagedRows (values, rows) : interpolatedRows (values, rows);
}
} // namespace

Eigen::MatrixXd resampled (const Eigen::MatrixXd& values, int rows, int columns)
{
    const Eigen::MatrixXd turned = withRows (values, rows).transpose();
    return withRows (turned, columns).transpose();
}

Eigen::MatrixXd repeated (const Eigen::MatrixXd& values, int rows, int columns)
{
    return Eigen::MatrixXd::NullaryExpr (
        rows, columns,
        [&] (Eigen::Index row, Eigen::Index column)
        { return values (row * values.rows() / rows, column * values.cols() / columns); });
}

juce::Image colourImage (const Eigen::MatrixXd& pixels, AxisRange range, const ColourMap& map)
{
    const auto width = static_cast<int> (pixels.cols());
    const auto height = static_cast<int> (pixels.rows());
    juce::Image image (juce::Image::ARGB, width, height, true, juce::SoftwareImageType());
    const juce::Image::BitmapData data (image, juce::Image::BitmapData::writeOnly);
    const auto factor = 1 / (range.maximum - range.minimum);
    for (int x = 0; x < width; ++x)
    {
        checkWatch();
        for (int y = 0; y < height; ++y)
        {
            const auto value = pixels (height - 1 - y, x);
            if (std::isfinite (value))
                data.setPixelColour (x, y, map.at ((value - range.minimum) * factor));
        }
    }
    return image;
}
} // namespace antinode
