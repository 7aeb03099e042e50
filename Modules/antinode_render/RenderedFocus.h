#pragma once

#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/FocusDesign.h>
#include <antinode_focus/FocusScore.h>
#include <antinode_model/ModalModel.h>

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace antinode
{
/** How an event is rendered. */
struct RenderOptions
{
    Playback playback { Reconstruction::bandLimited, 192000 };
    std::optional<double>
        duration; ///< s from the trigger; none: twice the focus time, at least 25 ms after it or until the brake ends.
    std::vector<std::pair<double, double>> probes; ///< x, y in m; none: the focus's, or its targets.
    int blockSize = 512;
};

/** A designed focus and what the plate model did with its sampled voltages. */
struct RenderedFocus
{
    ModalModel model;
    FocusDesign design;
    Render render;
    std::vector<std::pair<double, double>> probes; ///< x, y, m
    Eigen::VectorXd reachedField;                  ///< N_p: the velocity at the focus sample, m/s.
    FocusScore score;                              ///< Against the wanted field.
    FocusScore truncatedScore;                     ///< Against the truncated field.
    double contrast = 0;
};

/** Plays a design through synthesiser, limiter and plate model, and scores what the plate did.
    @throws InputError  when a probe lies beside the surface or the options are not usable
    [worker] */
RenderedFocus renderFocus (ModalModel, FocusDesign, const RenderOptions&,
                           const std::function<void (double)>& progress = {});

/** The keys of summary.json. [any] */
nlohmann::ordered_json summaryOf (const RenderedFocus&);
} // namespace antinode
