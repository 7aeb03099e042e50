#pragma once

#include "FocusBank.h"

#include <antinode_base/RingQueue.h>

#include <atomic>

namespace antinode
{
/** Banks on their way from a worker to the audio thread and back: one atomic exchange each way, no lock, no wait. A
   bank that was given and not yet taken is replaced by the next one. Banks come back when no voice plays them any more,
   and are freed by the worker. One worker thread at a time, one audio thread at a time. */
class BankHandOver
{
public:
    BankHandOver() = default;

    /** Frees everything; nothing may be playing. [worker] */
    ~BankHandOver();
    BankHandOver (const BankHandOver&) = delete;
    BankHandOver& operator= (const BankHandOver&) = delete;

    /** Hands a bank over and frees what came back. [worker] */
    void give (std::unique_ptr<const FocusBank>);

    /** Frees what came back. [worker] */
    void collect();

    /** The newest bank, or none if there was none since the last call. [audio thread] */
    const FocusBank* take() { return next.exchange (nullptr, std::memory_order_acq_rel); }

    /** Whether a bank can be given back at the moment. [audio thread] */
    bool canGiveBack() const;

    /** Gives a bank back to be freed; only where that is possible. [audio thread] */
    void giveBack (const FocusBank*);

private:
    std::atomic<const FocusBank*> next { nullptr };
    RingQueue<const FocusBank*, 64> returned;
};
} // namespace antinode
