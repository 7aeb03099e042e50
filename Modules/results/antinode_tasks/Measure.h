#pragma once

#include "BenchFields.h"
#include "Excite.h"

#include <antinode_bench/Measuring.h>
#include <antinode_measurement/RunAnalysis.h>
#include <antinode_measurement/SimulatedBench.h>
#include <antinode_measurement/SurfaceMeasurement.h>

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

/** Measures all points on a real or simulated bench, and writes responses.uff and report.html beside what is kept.
    @throws InputError  as excitedModel, measurePoints and openAudioBench
    [worker] Docs/FileFormats.md. */
MeasuredSurface measureOnBench (const MeasureRequest&, const PointGuide&);

/** Measures on a simulated bench. @throws InputError  as measureOnBench, and where a real one is asked for [worker] */
MeasuredSurface measure (const MeasureRequest&, const ShowProgress&);
} // namespace antinode
