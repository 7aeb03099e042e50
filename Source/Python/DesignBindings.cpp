#include "ArrayViews.h"
#include "Bindings.h"
#include "Pictures.h"
#include "Values.h"
#include "Work.h"

#include <CommandLine/FocusOnDevice.h>
#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_documents/DesignFile.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/Prediction.h>
#include <antinode_library/Library.h>
#include <antinode_library/SkinThresholds.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <pybind11/stl.h>

namespace antinode
{
namespace
{
namespace py = pybind11;

using Design = std::shared_ptr<DesignValue>;

/** The steps of `antinode design`, in its order. */
DesignValue makeDesign (const FocusValue& focus, const DeviceValue& device, const DesignSettings& settings)
{
    const auto wanted = focusWith (focus, settings);
    const auto playback = playbackOf (settings);
    const auto known = solveDevice (device.description, {}, settings.usesCache);
    checkKindOfPlaces (known, wanted);
    const auto wide = wideOf (device.description, known, playback, settings.usesCache);
    return { designOn (device.description, wide, wanted, playback, settings.usesCache), playback, settings.repetitions,
             settings.thresholdFile };
}

Design design (const FocusValue& focus, const DeviceValue& device, const DesignSettings& settings, py::object progress)
{
    Work work (std::move (progress));
    return work.run ([&] { return std::make_shared<DesignValue> (makeDesign (focus, device, settings)); });
}

void saveDesign (const DesignValue& design, const std::string& path)
{
    OutputFolder folder (path);
    folder.write ("design.json", designText (design));
    folder.commit();
}

/** design.json without the power, which takes a render. */
std::string designNumbers (const DesignValue& design)
{
    const auto& wide = design.made.wide;
    return designToJson (design.made.design, designedModel (wide)).dump();
}

py::list oscillations (const DesignValue& design)
{
    using namespace py::literals;
    py::list all;

    for (const auto& each : design.made.design.program.oscillations)
        all.append (py::dict ("mode"_a = each.mode, "start_s"_a = each.start, "end_s"_a = each.end,
                              "growth_per_s"_a = each.growth, "angular_frequency_rad_s"_a = each.angularFrequency,
                              "in_phase"_a = each.inPhase, "quadrature"_a = each.quadrature));

    return all;
}

py::object samples (const py::object& self)
{
    const auto& held = self.cast<const DesignValue&>().made.design.program.samples;
    return held ? py::object (viewOf (held->values, self)) : py::none();
}

/** The field at the (first) focus by the closed form: N_p, m/s. */
Eigen::VectorXd predictedField (const WideDesign& made)
{
    const auto& model = made.wide.model;
    const auto states = predictStates (model, made.design.program, made.design.moments.front().time);
    return model.shapes * modalVelocities (model, states);
}

py::bytes designPicture (const DesignValue& value, const PictureStyle& style)
{
    const auto& made = value.made;
    return Work (py::none())
        .run ([&] { return fieldPicture (made.wide.model, made.design, predictedField (made), style); });
}

void bindArrays (py::class_<DesignValue, Design>& bound)
{
    bound.def_property_readonly (
        "allocation_V",
        viewProperty<DesignValue> ([] (const DesignValue& value) { return &value.made.design.program.allocation; }));
    bound.def_property_readonly (
        "voltage_limits_V",
        viewProperty<DesignValue> ([] (const DesignValue& value) { return &value.made.design.program.voltageLimits; }));
    bound.def_property_readonly (
        "wanted_field_m_s",
        viewProperty<DesignValue> ([] (const DesignValue& value) { return &value.made.design.target.field; }));
    bound.def_property_readonly (
        "represented_field_m_s",
        viewProperty<DesignValue> ([] (const DesignValue& value) { return &value.made.design.truncatedField; }));
    bound.def_property_readonly (
        "points_m",
        viewProperty<DesignValue> ([] (const DesignValue& value) { return &value.made.wide.model.surface.points; }));
    bound.def ("predicted_field_m_s", [] (const DesignValue& self)
               { return arrayOf (Work (py::none()).run ([&] { return predictedField (self.made); })); });
    bound.def_property_readonly ("samples_V", &samples);
    bound.def_property_readonly ("oscillations", &oscillations);
}
} // namespace

Playback playbackOf (const DesignSettings& settings)
{
    checkSampleRate (settings.sampleRate);

    if (settings.reconstruction == "band_limited")
        return { Reconstruction::bandLimited, settings.sampleRate };

    if (settings.reconstruction == "zero_order_hold")
        return { Reconstruction::zeroOrderHold, settings.sampleRate };

    throw InputError ("--reconstruction",
                      "is " + inQuotes (settings.reconstruction) + "; allowed: band_limited, zero_order_hold");
}

FocusDescription focusWith (const FocusValue& focus, const DesignSettings& settings)
{
    auto wanted = focus.description;

    if (wanted.felt && ! settings.thresholdFile.empty())
        wanted.felt->threshold = findSkinThreshold (settings.thresholdFile);

    return wanted;
}

std::string designText (const DesignValue& design)
{
    const auto power = designedPower (design.made, design.playback, design.repetitions);
    return designDocument (design.made, power).dump (2) + "\n";
}

void bindDesign (py::module_& module)
{
    py::class_<DesignSettings> (module, "DesignSettings")
        .def (py::init<double, std::string, double, std::string, bool>(), py::arg ("sample_rate_Hz"),
              py::arg ("reconstruction"), py::arg ("repeat_Hz"), py::arg ("threshold"), py::arg ("cache"));

    py::class_<DesignValue, Design> value (module, "Design");
    value.def_static ("make", &design);
    value.def_property_readonly ("device", [] (const DesignValue& self) { return self.made.wide.model.name; });
    value.def_property_readonly ("focus", [] (const DesignValue& self) { return self.made.design.description.name; });
    value.def_property_readonly ("is_plate", [] (const DesignValue& self)
                                 { return self.made.wide.model.surface.kind == SurfaceKind::plate; });
    value.def_property_readonly ("peak_voltage_V",
                                 [] (const DesignValue& self) { return peakVoltage (self.made.design); });
    value.def ("numbers", &designNumbers);
    value.def ("text",
               [] (const DesignValue& self) { return Work (py::none()).run ([&] { return designText (self); }); });
    value.def ("save", [] (const DesignValue& self, const std::string& folder)
               { workAway ([&] { saveDesign (self, folder); }); });
    value.def ("png", &designPicture);
    bindArrays (value);
}
} // namespace antinode
