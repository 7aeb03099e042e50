#include "MotionView.h"

#include <antinode_base/Prefixes.h>
#include <antinode_base/Watch.h>
#include <antinode_charts/PlateCharts.h>

#include <chrono>
#include <utility>

namespace antinode
{
namespace
{
constexpr auto interval = std::chrono::milliseconds (15); // between looks at the capture

/** A line: only the field is drawn, the painter's other curves are empty. */
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
    // The painter leaves the first place out: the instrument's spot, which is not here.
    auto map = plateFieldChart (model, frames.focusField, "velocity", { Target {} });
    map.contours = {};
    return map;
}

std::shared_ptr<const DesignPicture> makePicture (const std::shared_ptr<const ModalModel>& model, FieldFrames frames)
{
    auto made = std::make_shared<DesignPicture>();
    made->question.model = model;
    made->field = model->surface.kind == SurfaceKind::line ? std::make_shared<const Chart> (lineChart (*model, frames))
                                                           : std::make_shared<const Chart> (plateMap (*model, frames));
    made->frames = std::make_shared<const FieldFrames> (std::move (frames));
    return made;
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

void MotionView::stop()
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
        showRest (now->model);

    Eigen::MatrixXd window;

    // A path of the device before may still be in the snapshot for a moment.
    if (isWanted && now->motion != nullptr && now->motion->take (window) && window.rows() == now->model->coordinates())
        show (*now, window);
}

void MotionView::showRest (const std::shared_ptr<const ModalModel>& model)
{
    auto made = std::make_shared<MotionPicture>();
    made->model = model;
    made->field = makePicture (model, stillFrames (*model));
    made->spectrum = std::make_shared<const Chart> (amplitudeChart (Eigen::VectorXd::Zero (model->modes())));
    const std::lock_guard lock (mutex);
    newest = std::move (made);
    wantsNext = true;
}

void MotionView::show (const PlateSnapshot& snapshot, const Eigen::MatrixXd& window)
{
    auto made = std::make_shared<MotionPicture>();
    made->model = snapshot.model;
    made->field = makePicture (snapshot.model, makeFrames (*snapshot.model, window));
    const Eigen::VectorXd largest = window.topRows (snapshot.model->modes()).cwiseAbs().rowwise().maxCoeff();
    made->spectrum = std::make_shared<const Chart> (amplitudeChart (largest));
    made->step = snapshot.captureStep;
    const std::lock_guard lock (mutex);
    newest = std::move (made);
    wantsNext = false;
}
} // namespace antinode
