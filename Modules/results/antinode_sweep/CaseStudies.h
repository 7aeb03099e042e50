#pragma once

#include "CaseEvaluator.h"
#include "SweepInputs.h"

#include <antinode_documents/Library.h>
#include <antinode_focus/FocusScore.h>
#include <antinode_tracks/TrackDesign.h>

#include <algorithm>
#include <functional>
#include <future>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

namespace antinode
{
/** Values that several threads need: each is made once, by the first that asks, while others wait. The latest are kept.
    An exception of the one who makes it reaches all who ask. */
template <typename Value>
class SharedValues
{
public:
    /** @param mostToKeep  at least 1 */
    explicit SharedValues (std::size_t mostToKeep) : most (mostToKeep) {}

    /** @param make  gives the value of a key @throws  what it throws [worker] */
    std::shared_ptr<const Value> get (const std::string& key, const std::function<Value()>& make)
    {
        std::promise<std::shared_ptr<const Value>> promise;
        auto [future, isFirst] = find (key, promise);

        if (isFirst)
        {
            try
            {
                promise.set_value (std::make_shared<const Value> (make()));
            }
            catch (...)
            {
                promise.set_exception (std::current_exception());
            }
        }

        return future.get();
    }

private:
    using Future = std::shared_future<std::shared_ptr<const Value>>;

    std::pair<Future, bool> find (const std::string& key, std::promise<std::shared_ptr<const Value>>& promise)
    {
        const std::lock_guard lock (mutex);
        const auto found =
            std::find_if (latest.begin(), latest.end(), [&] (const auto& each) { return each.first == key; });

        if (found != latest.end())
        {
            latest.splice (latest.begin(), latest, found);
            return { found->second, false };
        }

        latest.emplace_front (key, promise.get_future().share());

        if (latest.size() > most)
            latest.pop_back();

        return { latest.front().second, true };
    }

    const std::size_t most;
    std::mutex mutex;
    std::list<std::pair<std::string, Future>> latest;
};

/** A focus on a device: by a render, or by formula. A device that several cases share is solved once, and a focus that
    they share is designed once. */
class FocusStudy : public CaseStudy
{
public:
    /** @param inputs  live as long as the study @param usesCache  of solved devices */
    FocusStudy (const SweepInputs&, bool usesCache);

    void check (const CaseKeys&) const override;
    nlohmann::ordered_json summary (const CaseKeys&, const Deviation&, std::uint64_t seed) const override;

private:
    struct MadeDesign
    {
        WideDesign made;
        ModalModel modes; ///< Of the played model, without shapes.
        FieldPeak wantedPeak, truncatedPeak;
    };

    std::shared_ptr<const Setup> deviceOf (const CaseKeys&) const;
    std::shared_ptr<const MadeDesign> designOf (const CaseKeys&) const;
    nlohmann::ordered_json closedForm (const MadeDesign&, const Deviation&, std::uint64_t seed) const;
    nlohmann::ordered_json rendered (const MadeDesign&, const Deviation&, std::uint64_t seed) const;

    const SweepInputs& given;
    Playback playback;
    DesignExtent extent;
    bool usesCache;
    mutable SharedValues<Setup> devices;
    mutable SharedValues<MadeDesign> designs;
};

/** Waveforms at fingers on a device, as `antinode perform` plays them. A device that several cases share is solved
   once, and waveforms that they share are designed once; what deviates is the surface that plays. */
class WaveformsStudy : public CaseStudy
{
public:
    /** @param inputs  live as long as the study @param usesCache  of solved devices */
    WaveformsStudy (const SweepInputs&, bool usesCache);

    void check (const CaseKeys&) const override;
    nlohmann::ordered_json summary (const CaseKeys&, const Deviation&, std::uint64_t seed) const override;

private:
    WaveformsDescription waveformsOf (const CaseKeys&, const std::string& source) const;

    const SweepInputs& given;
    TrackSettings settings;
    bool usesCache;
    mutable SharedValues<TrackModels> devices;
    mutable SharedValues<TrackDesign> designs;
};
} // namespace antinode
