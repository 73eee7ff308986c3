// Which frames a process draws where several share a sequence: ranks under MPI, tasks of a Slurm
// array job. Each draws its own and knows nothing of the others' progress; the frames themselves
// say what is done.
#pragma once

#include <array>

namespace scanlit::studio {

/// Of the frames first..last every `count`-th, beginning with number `index` of them.
struct Share {
  int first = 0, last = 0;
  int index = 0, count = 1;

  bool has(int frame) const {
    return frame >= first && frame <= last && (frame - first) % count == index;
  }
};

/// The processes that one mpirun started; one rank of one where none did. Without MPI in the build
/// more than one rank is refused with an Error: each would draw everything.
class Ranks {
 public:
  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  int rank() const { return rank_; }
  int count() const { return count_; }

  /// What rank 0 says, to every rank: all wait for it.
  bool agreed(bool of_rank_0) const;

  /// Sums over the ranks, for each of them: all wait for the last.
  std::array<long, 3> summed(std::array<long, 3> counts) const;

 private:
  int rank_ = 0, count_ = 1;
  bool mpi_ = false;
};

/// The task's number among those of its array job, and how many they are, from the environment that
/// Slurm sets. Throws Error where there is none, or the array has gaps.
Share slurm_share(Share share);

}  // namespace scanlit::studio
