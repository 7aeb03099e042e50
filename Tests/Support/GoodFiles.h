#pragma once

#include <string_view>
#include <vector>

namespace antinode
{
/** A file that must be read, and whether every key of it is needed. */
struct GoodFile
{
    std::string_view name;
    std::string_view text;
    bool isFocus = false;
    bool isMinimal = false; ///< It holds nothing but what must be given.
};

/** Files of every kind: with all keys, and with none but those that must be given. */
inline const std::vector<GoodFile>& goodFiles()
{
    static const std::vector<GoodFile> files {
        { "plate", R"({ "schema": "antinode.device/1", "name": "pane", "description": "two\nlines", "kind": "plate",
            "length_x_mm": 200, "length_y_mm": 120, "thickness_mm": 1,
            "material": { "E1_GPa": 40, "E2_GPa": 10, "G12_GPa": 4, "nu12": 0.3, "density_kg_m3": 1900 },
            "edges": { "left": "clamped", "right": "simply_supported", "bottom": "free", "top": "free" },
            "quality_factor": [190, 60],
            "ceramics": [
              { "name": "C1", "x_mm": 10, "y_mm": 15, "size_x_mm": 25, "size_y_mm": 20, "thickness_mm": 0.5, "material": "NCE51",
                "mounting": "both_sides", "wiring": "parallel", "polarity": -1, "capacitance_nF": 21.5, "loss_factor": 0.015,
                "glue": { "thickness_mm": 0.05, "youngs_modulus_GPa": 2 } },
              { "x_mm": 35, "y_mm": 15, "size_x_mm": 25, "size_y_mm": 25, "thickness_mm": 0.2,
                "material": { "youngs_modulus_GPa": 62.5, "poisson_ratio": 0.31, "density_kg_m3": 7800, "d31_m_per_V": -195e-12,
                              "permittivity_relative": 1850 },
                "mounting": "one_side", "wiring": "series" } ],
            "limits": { "voltage_V": 150, "full_scale_V": 200 },
            "modes": { "maximum_frequency_Hz": 30000, "count": 50 } })" },
        { "beam", R"({ "schema": "antinode.device/1", "name": "strip", "kind": "beam", "length_mm": 100, "width_mm": 12,
            "thickness_mm": 2, "material": { "youngs_modulus_GPa": 70, "poisson_ratio": 0.33, "density_kg_m3": 2700 },
            "ends": { "left": "guided", "right": "free" }, "damping_ratio": [0.005, 0.01],
            "ceramics": [ { "x_mm": -20, "length_mm": 9, "width_mm": 5, "thickness_mm": 0.5, "material": "NCE51",
                            "mounting": "both_sides", "wiring": "parallel", "polarity": 1 } ],
            "limits": { "voltage_V": 150 }, "modes": { "count": 12 } })" },
        { "modal", R"({ "schema": "antinode.device/1", "name": "measured", "kind": "modal",
            "modes": [
              { "frequency_Hz": 900, "quality_factor": 40, "participation_per_V": [0.1, -0.2], "shape": [1, 0, -1],
                "slope": [0, -2, 0], "frequency_error_relative": 1e-6, "frequency_standard_deviation_Hz": 0.01,
                "damping_ratio_standard_deviation": 1e-5 },
              { "frequency_Hz": 420, "damping_ratio": 0.003, "participation_per_V": [0.3, 0.4], "shape": [1, 2, 3],
                "slope": [1, 1, 1], "frequency_error_relative": 2e-6 } ],
            "points_mm": [[-50, 0], [0, 0], [40, 0]], "weights_kg": [0.001, 0.002, 0.001], "areas_m2": [1, 2, 1],
            "ceramics": [ { "name": "left", "x_mm": -30, "y_mm": 0, "size_x_mm": 9, "size_y_mm": 5, "voltage_limit_V": 100,
                            "capacitance_nF": 2.9, "loss_factor": 0.03 },
                          { "x_mm": 20, "y_mm": 0, "size_x_mm": 9, "size_y_mm": 5 } ],
            "limits": { "voltage_V": 120, "full_scale_V": 150 }, "delay_s": 1e-5, "covers_whole_body": false,
            "rigid_body_modes": 2 })" },
        { "measured",
          R"({ "schema": "antinode.device/1", "name": "tuned", "description": "as measured",
            "limits": { "voltage_V": 120, "full_scale_V": 150, "slew_V_per_us": 20, "requires_arming": true },
            "base": { "kind": "beam", "length_mm": 100, "width_mm": 12, "thickness_mm": 2, "material": "aluminium",
                      "ends": { "left": "free", "right": "free" }, "damping_ratio": 0.005,
                      "ceramics": [ { "name": "left", "x_mm": -20, "length_mm": 9, "width_mm": 5, "thickness_mm": 0.5,
                                      "material": "NCE51" } ], "modes": { "count": 4 } },
            "modes": [ { "base_mode": 2, "frequency_Hz": 2900, "quality_factor": 90, "participation_per_V": [0.02],
                         "base_sign": { "ceramic": 1, "participation_per_V": 0.03 } },
                       { "base_mode": 1, "frequency_Hz": 1100, "damping_ratio": 0.004, "participation_per_V": [-0.01] } ],
            "ceramics": [ { "name": "left", "voltage_limit_V": 110, "slew_limit_V_per_us": 18,
                            "lag": { "delay_us": 3, "time_constant_us": 5, "angle_deg": 2 } } ] })" },
        { "focus", R"({ "schema": "antinode.focus/1", "name": "two places",
            "targets": [
              { "shape": "sinc", "profile": "separable", "x_mm": -24, "y_mm": 3, "width_mm": 25, "width_y_mm": 15,
                "peak_velocity_mm_s": 40, "phase": -1 },
              { "shape": "gaussian", "x_mm": 24, "width_mm": 18, "peak_velocity_mm_s": 20 } ],
            "focus_time_ms": 25, "modes": { "count": 6, "choose": "frequency" },
            "transients": { "drive": "paper", "growth": [10, 4], "cycles": [3, 5], "maximum_duration_ms": 20, "brake": 20, "brake_duration_ms": 30 },
            "allocation": { "method": "paper", "voltage_limit_V": 50, "guard_modes": 10, "guard_weight": 30, "window_ms": 5 },
            "edge_window": { "tukey": 0.1 }, "probes_mm": [[0, 0], [24, 1]] })",
          true },
        { "robust focus", R"({ "schema": "antinode.focus/1",
            "targets": [ { "shape": "bump", "x_mm": 0, "width_mm": 25, "peak_velocity_mm_s": 40 } ], "focus_time_ms": 25,
            "allocation": { "robust": { "frequency_percent": 0.3, "damping_percent": 20, "participation_percent": 10,
                                        "drift_percent": 0.2, "weight": 500 } } })",
          true },
        { "minimal plate", R"({ "schema": "antinode.device/1", "name": "pane", "kind": "plate", "length_x_mm": 200,
            "length_y_mm": 120, "thickness_mm": 1, "material": "glass",
            "edges": { "left": "free", "right": "free", "bottom": "free", "top": "free" }, "damping_ratio": 0.005,
            "ceramics": [ { "x_mm": 0, "y_mm": 0, "size_x_mm": 25, "size_y_mm": 25, "thickness_mm": 0.5,
              "material": { "youngs_modulus_GPa": 62.5, "poisson_ratio": 0.31, "density_kg_m3": 7800, "d31_m_per_V": -195e-12 } } ],
            "limits": { "voltage_V": 150 } })",
          false, true },
        { "minimal staple",
          R"({ "schema": "antinode.device/1", "name": "staple", "kind": "staple", "top_length_mm": 150,
            "leg_length_mm": 17, "width_mm": 10, "thickness_mm": 2, "material": "aluminium", "quality_factor": 60,
            "ceramics": [ { "x_mm": 62, "length_mm": 9, "width_mm": 5, "thickness_mm": 0.5, "material": "NCE51" } ],
            "limits": { "voltage_V": 150 } })",
          false, true },
        { "minimal modal", R"({ "schema": "antinode.device/1", "name": "measured", "kind": "modal",
            "modes": [ { "frequency_Hz": 420, "damping_ratio": 0.003, "participation_per_V": [0.3], "shape": [1, 2] } ],
            "points_mm": [[0, 0], [40, 10]], "weights_kg": [0.001, 0.002], "limits": { "voltage_V": 120 } })",
          false, true },
        { "minimal focus", R"({ "schema": "antinode.focus/1",
            "targets": [ { "shape": "bump", "x_mm": 0, "width_mm": 25, "peak_velocity_mm_s": 40 } ], "focus_time_ms": 25 })",
          true, true },
    };
    return files;
}
} // namespace antinode
