#pragma once

#include "BenchFields.h"
#include "Excite.h"

#include <antinode_bench/Measuring.h>
#include <antinode_measurement/RunAnalysis.h>
#include <antinode_measurement/SimulatedBench.h>
#include <antinode_measurement/SurfaceMeasurement.h>

#include <functional>
#include <memory>

namespace antinode
{
inline constexpr TaskText measureText { "measure",
                                        "Measures frequency responses point by point: plays, records and analyses",
                                        "Docs/Theory.md, sections 8.8 to 8.10" };

/** What is measured where, and by which bench. */
struct MeasureRequest
{
    ExcitationRequest excitation;
    Eigen::MatrixX2d points; ///< m
    std::filesystem::path folder;
    bool isSimulated = true;
    std::optional<DeviceDescription> simulatedDevice; ///< None: the same device.
    SimulatedBenchSettings simulation { .delay = 1.234567e-3 };
    BenchWiring wiring;
    double latency = 0; ///< Of the sensors without a sync input, s.
};

/** [any] */
std::vector<Field> fields (MeasureRequest&);

/** A measurement with the excitation that was played. */
struct MeasuredSurface
{
    SurfaceMeasurement measurement;
    ExcitationSheet sheet;
};

/** Opens a bench for a model and the points that are measured, N_p x 2, m. */
using OpenBench = std::function<std::unique_ptr<Bench> (const ModalModel&, const Eigen::MatrixX2d& points)>;

/** Measures all points on a bench, and writes responses.uff and report.html beside what is kept.
    @param open  none: the bench that the request says, real or simulated
    @throws InputError  as excitedModel, measurePoints and openAudioBench
    [worker] Docs/FileFormats.md. */
MeasuredSurface measureOnBench (const MeasureRequest&, const PointGuide&, const OpenBench& open = {});

/** Measures on a simulated bench. @throws InputError  as measureOnBench, and where a real one is asked for [worker] */
MeasuredSurface measure (const MeasureRequest&, const ShowProgress&);
} // namespace antinode
