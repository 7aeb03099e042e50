#pragma once

#include "FeltOutcome.h"
#include "PowerFlow.h"

#include <antinode_engine/LagFilters.h>
#include <antinode_engine/OfflineRender.h>
#include <antinode_fingers/OneSidedContact.h>
#include <antinode_focus/FocusDesign.h>
#include <antinode_focus/FocusScore.h>
#include <antinode_focus/SpillOver.h>
#include <antinode_model/ModalModel.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace antinode
{
/** The settings of a render. */
struct RenderOptions
{
    Playback playback { Reconstruction::bandLimited, 192000 };
    std::optional<double> duration; ///< s from the trigger; none: twice the last focus time, at least 25 ms after it or
                                    ///< until 2 ms after the brake.
    std::vector<std::pair<double, double>> probes; ///< x, y in m; none: the focus's, or its targets.
    int blockSize = 512;
    std::optional<double> repetitions = {}; ///< Per second, at which the electrical power is wanted; none: without it.
    std::optional<SkinThreshold> threshold = {}; ///< By which it is wanted what skin feels; none: without it.
    bool mayLiftOff = true; ///< False: fingers stay on the surface, which is played as they load it.
};

/** The result of the plate model at the time of one focus. */
struct ReachedMoment
{
    std::int64_t sample = 0;
    Eigen::VectorXd modalVelocities; ///< N_c, m/s kg^1/2
    Eigen::VectorXd field;           ///< N_p, m/s
    FieldPeak peak;                  ///< The largest velocity anywhere on the surface.
    FocusScore score;                ///< Against the wanted field.
    FocusScore truncatedScore;       ///< Against the truncated field.
    double spillOver = 0;            ///< RMS of the field in modes beyond the device's own / RMS of the whole field.
};

/** The residual motion after the last focus if a brake is requested. */
struct ResidualMotion
{
    double time = 0; ///< s after the last focus.
    double ratio =
        0; ///< The largest velocity anywhere on the surface from then on for 2 ms, of the peak of the last field.
};

/** A designed focus and what the plate model did with its sampled voltages. */
struct RenderedFocus
{
    ModalModel model;     ///< That was played: with modes beyond the device's own, where there are any.
    ModalModel known;     ///< With the device's own modes, loaded by the fingers that the design knows.
    std::string obstacle; ///< Why it was not played with modes far enough beyond; empty where it was.
    FocusDesign design;
    Render render;
    std::optional<UndoneLags> undone; ///< What is asked for so that ceramics get the voltages of the render, where they
                                      ///< lag.
    std::vector<std::pair<double, double>> probes; ///< x, y, m
    Eigen::VectorXd reachedField;                  ///< N_p: the velocity at the focus sample, m/s.
    FocusScore score;                              ///< Against the wanted field.
    FocusScore truncatedScore;                     ///< Against the truncated field.
    double contrast = 0;
    std::vector<ReachedMoment> moments; ///< One each of the design's; the first is what the fields above speak of.
    std::optional<ResidualMotion> residual;
    std::optional<FocusPower> power;      ///< Where it is wanted.
    std::optional<FeltOutcome> felt;      ///< Where it is wanted.
    std::vector<ContactHistory> contacts; ///< Of each finger, where one of them may lift off.
};

/** Plays a design through synthesiser, limiter and plate model, and scores what the plate did.
    @throws InputError  when a probe lies outside the surface or the options are not usable; Cancelled as checkWatch()
    [worker] */
RenderedFocus renderFocus (WideModel, FocusDesign, const RenderOptions&,
                           const std::function<void (double)>& progress = {});

/** The same with the modes of a model alone: those that the design knows. */
RenderedFocus renderFocus (ModalModel, FocusDesign, const RenderOptions&,
                           const std::function<void (double)>& progress = {});

/** What files and outputs get, N_b x N_s, V: the voltages of the render, or what is asked for so that ceramics get
   them. [any] */
const Eigen::MatrixXd& outputVoltages (const RenderedFocus&);

/** The largest spill-over of all foci, 0 where there are no modes beyond. [any] */
double spillOverShare (const RenderedFocus&);

/** How much of the field is in modes beyond the device's own, and how far they go; or why that is not known. [any] */
std::string spillOverInWords (const RenderedFocus&);

/** The same as a line of the scores. [any] */
std::string spillOverToText (const RenderedFocus&);
} // namespace antinode
