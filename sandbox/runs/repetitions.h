// The order in which several methods are drawn again and again: A B C, C B A, A B C, … Over an even number of
// repetitions all stand at the same place on average, so that a machine that gets slower or faster evenly
// does so for all of them alike, and each follows and precedes the same neighbours. That it does is told from
// the repetitions themselves, on any device: a clock that sinks as the device warms looks like this.
#ifndef PLUME_RUNS_REPETITIONS_H
#define PLUME_RUNS_REPETITIONS_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace plume {

/// Which of `count` has turn number `turn`, from 0, of a repetition, counted from 0.
constexpr size_t whose_turn(size_t turn, size_t count, uint32_t repetition) {
  return repetition % 2 == 0 ? turn : count - 1 - turn;
}

/// Of the times of one repetition after the other, each of all methods: the later half's median over the
/// earlier half's, where the two are told apart (see statistics.h) and differ by more than 5 %.
std::optional<double> drift(std::span<const double> repetitions_ms);

}  // namespace plume
#endif
