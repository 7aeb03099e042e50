#include "MotionView.h"

#include <antinode_base/Prefixes.h>
#include <antinode_base/Watch.h>
#include <antinode_reports/PlateCharts.h>

#include <chrono>
#include <utility>

namespace antinode
{
namespace
{
constexpr auto interval = std::chrono::milliseconds (15); // between looks at the capture

/** A line: only the field is drawn, the other curves are empty. */
LineChart lineChart (const ModalModel& model, const FieldFrames& frames)
{
    LineChart chart;
    chart.xLabel = "place (mm)";
    chart.yLabel = "velocity (mm/s)";
    chart.series.resize (3);
    auto& field = chart.series[1];
    field.x = model.surface.points.col (0) * milli;
    field.y = frames.focusField * milli;
    field.colour = 0;

    for (const auto& ceramic : model.ceramics)
        chart.spans.push_back ({ ceramic.xMinimum * milli, ceramic.xMaximum * milli, ceramic.name });

    return chart;
}

HeatMap plateMap (const ModalModel& model, const FieldFrames& frames)
{
    auto map = plateFieldChart (model, frames.focusField, "velocity", {});
    map.contours = {};
    return map;
}

BarChart amplitudeChart (const Eigen::VectorXd& largest)
{
    BarChart chart;
    chart.xLabel = "mode";
    chart.yLabel = "largest modal velocity (mm/s \xE2\x88\x9Akg)";
    chart.series = { { "", largest * milli, 0 } };

    for (Eigen::Index k = 0; k < largest.size(); ++k)
        chart.categories.push_back (std::to_string (k + 1));

    return chart;
}
} // namespace

Chart motionChart (const ModalModel& model, const FieldFrames& frames)
{
    return model.surface.kind == SurfaceKind::line ? Chart (lineChart (model, frames))
                                                   : Chart (plateMap (model, frames));
}

void MotionView::leave()
{
    const std::lock_guard lock (mutex);
    isStopping = true;
    changed.notify_all();
}

void MotionView::watch (std::shared_ptr<const PlateSnapshot> snapshot)
{
    const std::lock_guard lock (mutex);
    watched = std::move (snapshot);
}

void MotionView::askForNext()
{
    const std::lock_guard lock (mutex);
    wantsNext = true;
}

std::shared_ptr<const MotionPicture> MotionView::picture() const
{
    const std::lock_guard lock (mutex);
    return newest;
}

void MotionView::run()
{
    const WatchScope scope (
        [this]
        {
            const std::lock_guard lock (mutex);
            return ! isStopping;
        });

    try
    {
        while (! isStoppedWithin (interval))
            step();
    }
    catch (const Cancelled&)
    {
        // It is stopping.
    }
}

bool MotionView::isStoppedWithin (std::chrono::milliseconds time)
{
    std::unique_lock lock (mutex);
    return changed.wait_for (lock, time, [this] { return isStopping; });
}

void MotionView::step()
{
    std::shared_ptr<const PlateSnapshot> now;
    std::shared_ptr<const MotionPicture> before;
    auto isWanted = false;
    {
        const std::lock_guard lock (mutex);
        now = watched;
        before = newest;
        isWanted = wantsNext;
    }

    if (now == nullptr || now->model == nullptr)
        return;

    if (before == nullptr || before->model != now->model)
        show (now->model, stillFrames (*now->model), Eigen::VectorXd::Zero (now->model->modes()), 0);

    Eigen::MatrixXd window;

    // A path of the device before may still be in the snapshot for a moment.
    if (isWanted && now->motion != nullptr && now->motion->take (window) && window.rows() == now->model->coordinates())
        show (now->model, makeFrames (*now->model, window),
              window.topRows (now->model->modes()).cwiseAbs().rowwise().maxCoeff(), now->captureStep);
}

/** @param step  0: the surface is at rest, and the next window is waited for */
void MotionView::show (std::shared_ptr<const ModalModel> model, FieldFrames frames, const Eigen::VectorXd& largest,
                       double step)
{
    auto made = std::make_shared<MotionPicture>();
    made->field = std::make_shared<const Chart> (motionChart (*model, frames));
    made->model = std::move (model);
    made->frames = std::make_shared<const FieldFrames> (std::move (frames));
    made->spectrum = std::make_shared<const Chart> (amplitudeChart (largest));
    made->step = step;
    const std::lock_guard lock (mutex);
    newest = std::move (made);
    wantsNext = step == 0;
}
} // namespace antinode
