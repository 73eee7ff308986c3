#include "lessons/studio/frames/ranks.h"

#ifdef SCANLIT_MPI
#include <mpi.h>
#endif

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string>

#include "lessons/studio/text.h"
#include "rasterizer/error.h"

namespace scanlit::studio {
namespace {

std::optional<int> environment(const char* name) {
  const char* text = std::getenv(name);
  if (!text) return std::nullopt;
  return parse_integer(name, text, {0, 1e9});
}

/// How many processes a launcher says it started: Open MPI's mpirun, others by PMI, Slurm's srun.
int launched() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "SLURM_STEP_NUM_TASKS"})
    if (const auto count = environment(name)) return *count;
  return 1;
}

}  // namespace

#ifdef SCANLIT_MPI

Ranks::Ranks() {
  // Alone, MPI would start a helper process and take its time for it.
  if (launched() <= 1) return;
  mpi_ = true;
  MPI_Init(nullptr, nullptr);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &count_);
}

Ranks::~Ranks() {
  if (mpi_) MPI_Finalize();
}

bool Ranks::agreed(bool of_rank_0) const {
  int value = of_rank_0;
  if (mpi_) MPI_Bcast(&value, 1, MPI_INT, 0, MPI_COMM_WORLD);
  return value != 0;
}

std::array<long, 3> Ranks::summed(std::array<long, 3> counts) const {
  if (mpi_) MPI_Allreduce(MPI_IN_PLACE, counts.data(), 3, MPI_LONG, MPI_SUM, MPI_COMM_WORLD);
  return counts;
}

#else

Ranks::Ranks() {
  if (launched() > 1)
    throw Error("this scanlit was built without MPI, so that each of " +
                std::to_string(launched()) +
                " ranks would draw every frame; install libopenmpi-dev and build again, or give "
                "each process its --range");
}
Ranks::~Ranks() = default;
bool Ranks::agreed(bool of_rank_0) const { return of_rank_0; }
std::array<long, 3> Ranks::summed(std::array<long, 3> counts) const { return counts; }

#endif

Share slurm_share(Share share) {
  const auto id = environment("SLURM_ARRAY_TASK_ID"), count = environment("SLURM_ARRAY_TASK_COUNT");
  if (!id || !count || *count == 0)
    throw Error("--slurm",
                "SLURM_ARRAY_TASK_ID and _COUNT are not set: this is no task of an "
                "array job (sbatch --array=0-9)");
  const int min = environment("SLURM_ARRAY_TASK_MIN").value_or(0);
  const int step = std::max(environment("SLURM_ARRAY_TASK_STEP").value_or(1), 1);
  share.index = (*id - min) / step;
  share.count = *count;
  if (*id < min || (*id - min) % step != 0 || share.index >= share.count)
    throw Error("--slurm", "task " + std::to_string(*id) + " of " + std::to_string(*count) +
                               " from " + std::to_string(min) +
                               " on: the array has gaps; number its tasks without");
  return share;
}

}  // namespace scanlit::studio
