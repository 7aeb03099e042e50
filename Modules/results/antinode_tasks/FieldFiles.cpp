#include "FieldFiles.h"

#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_reports/FieldSampling.h>

namespace antinode
{
namespace
{
constexpr auto columns = "x_mm,y_mm,wanted_mm_s,represented_mm_s,reached_mm_s\n";
constexpr int sectionPoints = 401;

/** What is wanted, represented and reached at one focus, N_p x 3, m/s. */
Eigen::MatrixXd fieldsAt (const RenderedFocus& focus, std::size_t moment)
{
    const auto& wanted = focus.design.moments[moment];
    Eigen::MatrixXd all (wanted.truncatedField.size(), 3);
    all << wanted.target.field, wanted.truncatedField, focus.moments[moment].field;
    return all;
}

void addRows (std::string& text, const std::string& first, const Eigen::MatrixX2d& places,
              const Eigen::MatrixXd& values)
{
    for (Eigen::Index i = 0; i < places.rows(); ++i)
        text += first
                + formatted ("%.9g,%.9g,%.9g,%.9g,%.9g\n", places (i, 0) * milli, places (i, 1) * milli,
                             values (i, 0) * milli, values (i, 1) * milli, values (i, 2) * milli);
}

/** Places on the surface along x (direction 0) or y (1) through a target. */
Eigen::MatrixX2d section (const Surface& surface, const Target& target, int direction)
{
    Eigen::MatrixX2d places (sectionPoints, 2);
    places.col (0).setConstant (target.x);
    places.col (1).setConstant (target.y);
    places.col (direction) = direction == 0
                                 ? Eigen::VectorXd::LinSpaced (sectionPoints, surface.xMinimum, surface.xMaximum)
                                 : Eigen::VectorXd::LinSpaced (sectionPoints, surface.yMinimum, surface.yMaximum);
    std::vector<Eigen::Index> on;

    for (Eigen::Index i = 0; i < places.rows(); ++i)
        if (liesOn (surface, places (i, 0), places (i, 1)))
            on.push_back (i);

    return places (on, Eigen::all);
}
} // namespace

void writeFields (OutputFolder& folder, const RenderedFocus& focus)
{
    const auto& surface = focus.model.surface;
    const auto on = pointsOn (surface);
    auto field = std::string ("focus,") + columns, sections = std::string ("focus,along,") + columns;

    for (std::size_t i = 0; i < focus.moments.size(); ++i)
    {
        const auto number = std::to_string (i + 1) + ",";
        const auto values = fieldsAt (focus, i);
        addRows (field, number, surface.points (on, Eigen::all), values (on, Eigen::all));

        if (surface.kind == SurfaceKind::plate)
            for (const auto direction : { 0, 1 })
            {
                const auto places = section (surface, focus.design.moments[i].targets.front(), direction);
                addRows (sections, number + (direction == 0 ? "x," : "y,"), places, fieldsAt (surface, values, places));
            }
    }

    folder.write ("field.csv", field);

    if (surface.kind == SurfaceKind::plate)
        folder.write ("section.csv", sections);
}
} // namespace antinode
