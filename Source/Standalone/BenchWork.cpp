#include "BenchWork.h"

#include <Editor/MotionView.h>
#include <antinode_audio/IdentifyTone.h>
#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_base/Watch.h>
#include <antinode_base/WholeFile.h>
#include <antinode_bench/AudioBench.h>
#include <antinode_documents/MeasuredDevice.h>
#include <antinode_focus/Detuning.h>
#include <antinode_learning/ChooseSensors.h>
#include <antinode_text/JsonText.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
using namespace std::chrono_literals;

std::shared_ptr<const SurfacePicture> pictureOf (const ModalModel& model)
{
    auto picture = std::make_shared<SurfacePicture>();
    picture->model = std::make_shared<const ModalModel> (model);
    picture->frames = std::make_shared<const FieldFrames> (stillFrames (model));
    picture->field = std::make_shared<const Chart> (motionChart (model, *picture->frames));
    return picture;
}

/** What ceramics play: a share of the limits. */
std::vector<double> levelsFor (const ModalModel& model, const BenchQuestion& question)
{
    std::vector<double> levels;

    for (std::size_t k = 0; k < model.ceramics.size(); ++k)
    {
        const auto limit = voltageLimit (model, k);
        levels.push_back (question.levelShare
                          * (k < question.limits.size() ? std::min (limit, question.limits[k]) : limit));
    }

    return levels;
}

std::string asFileName (std::string name)
{
    for (auto& letter : name)
        if (letter == '/' || letter == '\\' || letter == ':' || static_cast<unsigned char> (letter) < ' ')
            letter = '-';

    return name.empty() || name.front() == '.' ? "device" + name : name;
}

/** The first folder that is free, or holds the same measurement under the same conditions, not finished. */
std::filesystem::path folderFor (const BenchQuestion& question, const ExcitationSheet& sheet,
                                 const Eigen::MatrixX2d& points)
{
    const auto name = asFileName (sheet.device);

    for (int i = 1;; ++i)
    {
        auto folder = question.folder / (i == 1 ? name : name + " " + std::to_string (i));
        std::error_code ignored;

        const auto conditions = folder / "bench.json";

        if (std::filesystem::exists (folder / "responses.uff", ignored)
            || (std::filesystem::exists (folder, ignored)
                && (! std::filesystem::exists (conditions, ignored)
                    || readWholeFile (conditions, {}) != question.conditions)))
            continue;

        try
        {
            const MeasurementFolder made (folder, sheet, points);
            writeWholeFile (conditions, question.conditions);
            return folder;
        }
        catch (const InputError&)
        {
            if (! std::filesystem::exists (folder, ignored))
                throw; // It cannot be made.
        }
    }
}

/** N_b: RMS over all that is measured, (m/s)/V. */
Eigen::VectorXd answersOf (const FrequencyResponses& responses)
{
    Eigen::VectorXd answers (std::ssize (responses.values));

    for (Eigen::Index k = 0; k < answers.size(); ++k)
    {
        const auto& values = responses.values[static_cast<std::size_t> (k)];
        double sum = 0, count = 0;

        for (const auto& value : values.reshaped())
            if (std::isfinite (std::abs (value)))
            {
                sum += std::norm (value);
                ++count;
            }

        answers[k] = count > 0 ? std::sqrt (sum / count) : 0;
    }

    return answers;
}

double meanLatency (const SurfaceMeasurement& measurement, double sampleRate)
{
    const auto known = measurement.latencies.array().isFinite();
    const auto count = static_cast<double> (known.count());
    return count > 0 ? known.select (measurement.latencies.array(), 0.0).sum() / count / sampleRate : 0;
}

/** |H| of a model at a measured point, N_f. */
Eigen::VectorXd magnitudes (const ModalModel& model, const FrequencyResponses& responses, Eigen::Index point,
                            Eigen::Index ceramic)
{
    const Eigen::RowVectorXd shapes = shapesAt (model, responses.points (point, 0), responses.points (point, 1));
    return responses.frequencies.unaryExpr ([&] (double frequency)
                                            { return expectedResponse (model, shapes, ceramic, frequency); });
}

/** By how much a model misses the magnitudes of all measured responses, RMS over RMS. */
double missOf (const ModalModel& model, const FrequencyResponses& responses)
{
    double missed = 0, all = 0;

    for (Eigen::Index k = 0; k < std::ssize (responses.values); ++k)
        for (Eigen::Index p = 0; p < responses.points.rows(); ++p)
        {
            checkWatch();
            const Eigen::VectorXd measured = responses.values[static_cast<std::size_t> (k)].col (p).cwiseAbs();

            if (! measured.allFinite())
                continue;

            missed += (measured - magnitudes (model, responses, p, k)).squaredNorm();
            all += measured.squaredNorm();
        }

    return all > 0 ? std::sqrt (missed / all) : 0;
}

/** The strongest response as it is measured, drawn and retuned. */
Chart responseComparison (const RetunedDevice& retuned, const FrequencyResponses& responses)
{
    Eigen::Index point = 0, ceramic = 0;
    double most = 0;

    for (Eigen::Index k = 0; k < std::ssize (responses.values); ++k)
        for (Eigen::Index p = 0; p < responses.points.rows(); ++p)
            if (const auto norm = responses.values[static_cast<std::size_t> (k)].col (p).norm();
                std::isfinite (norm) && norm > most)
            {
                most = norm;
                point = p;
                ceramic = k;
            }

    LineChart chart;
    chart.title = "Ceramic " + std::to_string (ceramic + 1) + " at point " + std::to_string (point + 1);
    chart.xLabel = "frequency (Hz)";
    chart.yLabel = "(mm/s)/V";
    chart.logarithmicY = true;
    chart.series = { { "measured", responses.frequencies,
                       milli * responses.values[static_cast<std::size_t> (ceramic)].col (point).cwiseAbs() },
                     { "drawn", responses.frequencies, milli * magnitudes (retuned.before, responses, point, ceramic),
                       LineStyle::dotted },
                     { "retuned", responses.frequencies,
                       milli * magnitudes (retuned.now.model, responses, point, ceramic), LineStyle::dashed } };
    return chart;
}
} // namespace

void BenchWork::leave()
{
    const std::lock_guard lock (mutex); // Else who is about to wait would not hear of it.
    questions.leave();
    answered.notify_all();
}

void BenchWork::ask (BenchQuestion question)
{
    const std::lock_guard lock (mutex);
    known = {};
    known.step = BenchStep::preparing;
    known.device = question.device;
    chosen.reset();
    questions.ask (std::move (question));
    answered.notify_all();
}

void BenchWork::answer (PointAnswer answer, BenchStep step, Eigen::Index point)
{
    const std::lock_guard lock (mutex);

    if ((step != BenchStep::aiming && step != BenchStep::wires) || known.step != step || known.point != point)
        return;

    chosen = answer;
    known.step = BenchStep::playing; // A second click answers nothing.
    answered.notify_all();
}

void BenchWork::stop()
{
    const std::lock_guard lock (mutex);
    questions.giveUp();
    known.step = BenchStep::none;
    known.ceramic = -1;
    answered.notify_all();
}

BenchState BenchWork::state() const
{
    const std::lock_guard lock (mutex);
    return known;
}

/** Of a measurement that was not given up. */
void BenchWork::set (const std::function<void (BenchState&)>& change)
{
    const std::lock_guard lock (mutex);

    if (! questions.isOutdated())
        change (known);
}

void BenchWork::run()
{
    const WatchScope scope ([this] { return ! questions.isOutdated(); });

    while (const auto question = questions.take())
    {
        try
        {
            measure (*question);
        }
        catch (const Cancelled&)
        {
            // Nobody wants it any more; what is measured is kept.
        }
        catch (const std::exception& failure)
        {
            set (
                [&] (BenchState& now)
                {
                    now.step = BenchStep::failed;
                    now.ceramic = -1;
                    now.error = failure.what();
                });
        }
    }
}

PointAnswer BenchWork::waitForAnswer()
{
    std::unique_lock lock (mutex);
    answered.wait (lock, [this] { return chosen || questions.isOutdated(); });

    if (questions.isOutdated())
        throw Cancelled();

    return *std::exchange (chosen, std::nullopt);
}

PointGuide BenchWork::guide (const MeasurementFolder& folder, const std::function<void()>& rest)
{
    PointGuide guide;
    guide.ask = [this, &folder, rest] (const Eigen::MatrixX2d&, Eigen::Index first, Eigen::Index)
    {
        if (rest)
            rest();

        set (
            [&folder, first] (BenchState& now)
            {
                for (std::size_t p = 0; p < now.measured.size(); ++p)
                    now.measured[p] = folder.has (static_cast<Eigen::Index> (p));

                now.step = BenchStep::aiming;
                now.point = first;
                now.ceramic = -1;
            });
        return waitForAnswer();
    };
    guide.plays = [this] (Eigen::Index ceramic)
    {
        set (
            [ceramic] (BenchState& now)
            {
                now.step = BenchStep::playing;
                now.ceramic = ceramic;
            });
    };
    guide.tell = [this] (const std::string& sentence)
    { set ([&] (BenchState& now) { now.sentences.push_back (sentence); }); };
    guide.wires = [this, rest, isFirst = true] (const SurfaceMeasurement& measurement,
                                                const std::vector<WireFinding>& findings) mutable
    {
        const auto decides = std::exchange (isFirst, false) && ! findings.empty();
        set (
            [&] (BenchState& now)
            {
                now.findings = findings;
                now.answers = answersOf (measurement.responses);
                now.step = decides ? BenchStep::wires : now.step;
            });

        if (decides && rest)
            rest();

        if (decides)
            waitForAnswer();
    };
    return guide;
}

void BenchWork::measure (const BenchQuestion& question)
{
    MeasureRequest request;
    request.excitation.device = question.device->description;
    request.excitation.sampleRate = question.sampleRate;
    request.latency = question.latency;
    const auto model = excitedModel (request.excitation.device, true);

    if (model.actuators() > OutputRouting::maximumCeramics)
        throw InputError ("device", "has " + std::to_string (model.actuators())
                                        + " ceramics; allowed: " + std::to_string (OutputRouting::maximumCeramics));

    request.points = placesToMeasure (model, question.points);
    request.excitation.levels = levelsFor (model, question);
    const auto sheet = excitationFor (model, request.excitation);
    request.folder = folderFor (question, sheet, request.points);
    const BenchChannels channels { { question.sensor.input },
                                   question.syncOutput,
                                   question.hasSync ? question.sensor.syncInput : -1,
                                   question.outputs };
    auto checklist = benchChecklist (model, sheet, request.points, channels, question.sensor.scale);
    writeWholeFile (request.folder / "checklist.txt", checklist);
    const auto picture = pictureOf (model);
    std::vector<double> tones;

    for (std::size_t k = 0; k < model.ceramics.size(); ++k)
        tones.push_back (
            IdentifyTone::amplitude (k < question.limits.size() ? question.limits[k] : voltageLimit (model, k)));

    set (
        [&] (BenchState& now)
        {
            now.picture = picture;
            now.points = request.points;
            now.measured.assign (static_cast<std::size_t> (request.points.rows()), false);
            now.checklist = std::move (checklist);
            now.toneVolts = std::move (tones);
            now.folder = request.folder;
        });
    const MeasurementFolder folder (request.folder, sheet, request.points);
    const auto measured = measureOnBench (request, guide (folder, question.rest), question.open);
    set ([] (BenchState& now) { now.step = BenchStep::retuning; });
    retune (question, measured);
}

void BenchWork::retune (const BenchQuestion& question, const MeasuredSurface& measured)
{
    RetuneRequest request;
    request.device = question.device->description;
    request.files = { state().folder / "responses.uff" };
    const auto retuned = std::make_shared<const RetunedDevice> (antinode::retune (request, {}));
    const auto& responses = measured.measurement.responses;
    const auto before = missOf (retuned->before, responses), after = missOf (retuned->now.model, responses);
    const auto chart = std::make_shared<const Chart> (responseComparison (*retuned, responses));
    set (
        [&] (BenchState& now)
        {
            now.step = BenchStep::done;
            now.latency = meanLatency (measured.measurement, question.sampleRate);
            now.retuned = retuned;
            now.missBefore = before;
            now.missAfter = after;
            now.chart = chart;
        });
}

std::string namedDeviceText (const RetunedDevice& retuned, const std::string& name)
{
    auto json = nlohmann::ordered_json::parse (retunedDeviceText (retuned));
    json["name"] = name;
    return deviceText (json);
}

namespace
{
/** With one sensor, which is moved. */
struct TourBench final : SimulatedBenchPlayer
{
    using SimulatedBenchPlayer::SimulatedBenchPlayer;

    Eigen::Index sensors() const override { return 1; }
};
} // namespace

OpenBench simulatedTour (const OutputRouting& routing)
{
    return [routing] (const ModalModel& drawn, const Eigen::MatrixX2d& points) -> std::unique_ptr<Bench>
    {
        constexpr DetuningSpread ofDrawings { 0.01, 0.1, 0.05, 0.03 };
        auto real = detuned (drawn, ofDrawings, 1);
        const auto ceramics = real.actuators();
        std::vector<Eigen::Index> behind (static_cast<std::size_t> (ceramics)); // each output
        Eigen::VectorXd signs = Eigen::VectorXd::Ones (ceramics);

        for (Eigen::Index k = 0; k < ceramics; ++k)
            behind[static_cast<std::size_t> (k)] = k;

        if (ceramics > 2)
        {
            std::swap (behind[0], behind[1]);
            signs[ceramics - 1] = -1;
        }

        auto driven = real.participation;

        for (Eigen::Index k = 0; k < ceramics; ++k)
        {
            const auto output = routing.outputs[static_cast<std::size_t> (k)];
            const auto isThere = output >= 0 && output < ceramics;
            driven.col (k) =
                isThere ? Eigen::VectorXd (real.participation.col (behind[static_cast<std::size_t> (output)])
                                           * signs[output] * routing.chains[static_cast<std::size_t> (output)].polarity)
                        : Eigen::VectorXd::Zero (real.modes());
        }

        real.participation = driven;
        return std::make_unique<TourBench> (real, points, SimulatedBenchSettings {});
    };
}
} // namespace antinode
