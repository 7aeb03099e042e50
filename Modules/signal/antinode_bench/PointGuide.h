#pragma once

#include <Eigen/Core>

#include <functional>
#include <string>
#include <utility>

namespace antinode
{
/** The user's choice at a point. */
enum class PointAnswer
{
    measure,
    skip,
    again, ///< The previous point.
    end
};

/** Leads a user with a scanning sensor from point to point, by lines on the terminal. */
class PointGuide
{
public:
    /** @param asksNoQuestions  everything is measured as it comes */
    explicit PointGuide (bool asksNoQuestions) : silent (asksNoQuestions) {}

    /** Asks no questions, and hands on what it tells in place of writing it on the terminal. */
    explicit PointGuide (std::function<void (const std::string& sentence)> listenerToUse)
        : silent (true), listener (std::move (listenerToUse))
    {
    }

    /** Asks for the sensors to be put at consecutive points, and waits for an answer that it understands; the end of
       the input means the end.
        @param places     N_p x 2, m
        [worker] */
    PointAnswer ask (const Eigen::MatrixX2d& places, Eigen::Index first, Eigen::Index count) const;

    /** Whether the user is not asked. */
    bool isSilent() const { return silent; }

    /** Says how a measurement went, in a line. */
    void tell (const std::string& sentence) const;

private:
    bool silent;
    std::function<void (const std::string&)> listener; ///< None: the terminal.
};
} // namespace antinode
