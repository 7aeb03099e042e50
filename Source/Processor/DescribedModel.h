#pragma once

#include <atomic>
#include <memory>
#include <utility>

namespace antinode
{
struct ModalModel;

/** The model of which a host knows the texts of the parameters: places are in mm of its surface.

    Hosts read the texts themselves when they have made a plug-in, and are told of others only once they have prepared
    it. Before that JUCE's VST3 may still be adding its parameters on a thread of the host's, to the list that such a
    message would walk (Docs/Design/plugins.md). */
class DescribedModel
{
public:
    /** The host is preparing the plug-in. [any] */
    void prepare() { isPrepared = true; }

    /** Whether the host must be told of the texts of this model, which it then knows. [message thread] */
    bool replace (std::shared_ptr<const ModalModel> model)
    {
        if (! isPrepared || model == known)
            return false;

        known = std::move (model);
        return true;
    }

private:
    std::atomic<bool> isPrepared { false };
    std::shared_ptr<const ModalModel> known;
};
} // namespace antinode
