#include "ArrayViews.h"
#include "Bindings.h"
#include "Pictures.h"
#include "Values.h"
#include "Work.h"

#include <CommandLine/RenderFiles.h>
#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_charts/FocusCharts.h>
#include <antinode_library/SkinThresholds.h>
#include <antinode_render/Summary.h>

#include <nlohmann/json.hpp>

#include <pybind11/stl.h>

#include <algorithm>
#include <optional>
#include <string_view>

namespace antinode
{
namespace
{
namespace py = pybind11;

using Rendered = std::shared_ptr<RenderValue>;

/** What of `antinode render` is not of the design. */
struct RenderSettingsValue
{
    std::vector<std::pair<double, double>> probes; ///< x, y, mm
    std::optional<double> duration;                ///< ms
    int blockSize = 512;
};

RenderOptions renderOptions (const DesignValue& design, const RenderSettingsValue& settings)
{
    RenderOptions options;
    options.playback = design.playback;
    options.blockSize = settings.blockSize;
    options.repetitions = design.repetitions;
    options.threshold = findSkinThreshold (design.thresholdFile);

    if (settings.duration)
        options.duration = *settings.duration / milli;

    for (const auto& [x, y] : settings.probes)
        options.probes.emplace_back (x / milli, y / milli);

    return options;
}

Rendered render (const DesignValue& design, const RenderSettingsValue& settings, py::object progress)
{
    Work work (std::move (progress));
    const auto show = work.progress();
    return work.run (
        [&]
        {
            const auto tell = [&] (double share)
            {
                if (show)
                    show ("Rendering", share);
            };
            auto focus = renderFocus (design.made.wide, design.made.design, renderOptions (design, settings), tell);
            auto outcome = evaluateOutcome (focus);
            return std::make_shared<RenderValue> (RenderValue { std::move (focus), std::move (outcome) });
        });
}

void checkWord (const std::string& option, const std::string& word, const std::vector<std::string_view>& allowed)
{
    if (std::find (allowed.begin(), allowed.end(), word) == allowed.end())
        throw InputError (option, "is " + inQuotes (word) + "; allowed: " + listed (allowed));
}

void save (const RenderValue& value, const std::string& folder, const std::string& format, bool hasReport,
           const std::vector<std::string>& figures)
{
    checkWord ("--format", format, { "wav", "csv", "mat", "tfw" });

    for (const auto& figure : figures)
        checkWord ("--figures", figure, { "svg", "pdf" });

    workAway ([&] { writeRendered (folder, value.focus, value.outcome, { format, hasReport, figures }); });
}

/** N_probes x 2, mm */
Eigen::MatrixX2d probesInMillimetres (const RenderedFocus& focus)
{
    Eigen::MatrixX2d places (static_cast<Eigen::Index> (focus.probes.size()), 2);

    for (std::size_t i = 0; i < focus.probes.size(); ++i)
        places.row (static_cast<Eigen::Index> (i)) << focus.probes[i].first * milli, focus.probes[i].second * milli;

    return places;
}

py::bytes fieldPng (const RenderValue& value, const PictureStyle& style)
{
    const auto& focus = value.focus;
    return Work (py::none()).run ([&] { return fieldPicture (focus.model, focus.design, focus.reachedField, style); });
}

py::bytes voltagesPng (const RenderValue& value, const PictureStyle& style)
{
    constexpr int heightPerCeramic = 44, heightOfAxes = 110; // pixels
    const auto& focus = value.focus;
    const auto height = heightOfAxes + heightPerCeramic * static_cast<int> (focus.render.voltages.rows());
    return Work (py::none())
        .run ([&] { return picture (voltagesChart (focus.model, focus.design.program, focus.render), style, height); });
}

void bindArrays (py::class_<RenderValue, Rendered>& bound)
{
    bound.def_property_readonly ("voltages_V", viewProperty<RenderValue> ([] (const RenderValue& value)
                                                                          { return &value.focus.render.voltages; }));
    bound.def_property_readonly (
        "output_voltages_V",
        viewProperty<RenderValue> ([] (const RenderValue& value) { return &outputVoltages (value.focus); }));
    bound.def_property_readonly (
        "probe_velocities_m_s",
        viewProperty<RenderValue> ([] (const RenderValue& value) { return &value.focus.render.probeVelocities; }));
    bound.def_property_readonly (
        "modal_velocities",
        viewProperty<RenderValue> ([] (const RenderValue& value) { return &value.focus.render.modalVelocities; }));
    bound.def_property_readonly (
        "reached_field_m_s",
        viewProperty<RenderValue> ([] (const RenderValue& value) { return &value.focus.reachedField; }));
    bound.def_property_readonly (
        "wanted_field_m_s",
        viewProperty<RenderValue> ([] (const RenderValue& value) { return &value.focus.design.target.field; }));
    bound.def_property_readonly (
        "represented_field_m_s",
        viewProperty<RenderValue> ([] (const RenderValue& value) { return &value.focus.design.truncatedField; }));
    bound.def_property_readonly ("points_m", viewProperty<RenderValue> ([] (const RenderValue& value)
                                                                        { return &value.focus.model.surface.points; }));
    bound.def_property_readonly ("probes_mm",
                                 [] (const RenderValue& self) { return arrayOf (probesInMillimetres (self.focus)); });
}
} // namespace

void bindRender (py::module_& module)
{
    py::class_<RenderSettingsValue> (module, "RenderSettings")
        .def (py::init<std::vector<std::pair<double, double>>, std::optional<double>, int>(), py::arg ("probes_mm"),
              py::arg ("duration_ms"), py::arg ("block_size"));

    py::class_<RenderValue, Rendered> value (module, "Rendered");
    value.def_static ("make", &render);
    value.def_property_readonly ("sample_rate_Hz",
                                 [] (const RenderValue& self) { return self.focus.render.sampleRate; });
    value.def_property_readonly ("focus_sample",
                                 [] (const RenderValue& self) { return self.focus.render.focusSample; });
    value.def_property_readonly ("is_plate", [] (const RenderValue& self)
                                 { return self.focus.model.surface.kind == SurfaceKind::plate; });
    value.def_property_readonly ("summary", [] (const RenderValue& self)
                                 { return summaryToJson (self.focus, self.outcome).dump(); });
    value.def ("save", &save);
    value.def ("field_png", &fieldPng);
    value.def ("voltages_png", &voltagesPng);
    bindArrays (value);
}
} // namespace antinode
