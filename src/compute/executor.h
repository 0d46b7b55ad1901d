// The executor: what carries out the time steps of models, and shares out their other work over threads. People choose
// it by name: `serial` is the reference (one slab at a time), `cpu` all threads of the processor, `cuda` a graphics
// card.
//
// A family of models brings a step as data and solvers that carry it out on a machine (models/slab/slab_step.h is one).
// The executor keeps one solver, with the terrain in a form of its own, between steps. Then the terrain's layers are
// stale until sync_to_host writes them back; whoever owns both calls it before anyone reads. Editing the terrain (its
// stamp changes) makes the solver load it again at the next step.
//
// Where a device is missing, full or fails, the processor goes on from the same state, and take_notice says so. For
// that the executor logs the steps since the terrain was last brought back: the processor does them once more, which
// gives the same bits.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "compute/cpu_backend.h"
#include "compute/instruction_set.h"
#include "core/errors.h"
#include "core/terrain.h"

namespace erg::compute {

/// Which executor, and how it works.
struct ExecutorOptions {
  std::string name = "auto";  ///< one of executor_names() (sim/make_executor.h); "auto" takes the fastest that works
  int threads = 0;            ///< 0: one for each processor
  int sweeps = 16;            ///< K, sub-sweeps a step (cpu, cuda): a power of two, 2 to 64
  InstructionSet instructions = wanted_instruction_set();
  /// Lines along the wind that are worth a thread of their own in sub-sweeps: with fewer, what a row costs however
  /// short it is outweighs the help. The same bits with any number.
  int lines_a_thread = 256;

  bool operator==(const ExecutorOptions&) const = default;
};

/// Carries out a family's steps on one machine, and holds a terrain there between them.
class Solver {
 public:
  virtual ~Solver() = default;
  /// Whether it also holds fields of the terrain: then it loads anew when they have been edited.
  virtual bool holds_fields() const { return false; }
  /// Writes back what steps have changed since the terrain was loaded or last brought back; nothing where that fails.
  /// The terrain is the one that was loaded.
  virtual void sync_to_host(Terrain& terrain) = 0;
};

class Executor {
 public:
  /// `device`: what does the work; null: the processor, with a `notice` of why. Options: threads and sweeps as above,
  /// threads positive. Throws InputError for other sweeps, and when the system gives fewer threads.
  explicit Executor(const ExecutorOptions& options, std::unique_ptr<Backend> device = nullptr, std::string notice = {});
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;

  /// What does the work now: "serial", "cpu", "cuda".
  std::string name() const;
  const ExecutorOptions& options() const { return options_; }
  /// Threads of the processor that it works on.
  int threads() const { return processor_.threads(); }
  /// Sub-sweeps that a step is cut into; 0: one slab at a time.
  int sub_sweeps() const { return options_.name == "serial" ? 0 : options_.sweeps; }
  CpuBackend& processor() { return processor_; }
  /// Null where the processor does the work.
  Backend* device() { return device_.get(); }
  /// What does the work.
  Backend& backend() { return device_ ? *device_ : processor_; }

  /// Runs `work` over chunks of [0, items) on the processor's threads: for what a model does between steps
  /// (CpuBackend::parallel_for).
  void parallel_for(std::int64_t items, const std::function<void(std::int64_t begin, std::int64_t end)>& work) {
    processor_.parallel_for(items, work);
  }

  /// One step of a family's. A Step is a value with
  ///
  ///     using Solver = ...;                                         // a class derived from erg::Solver
  ///     using Report = ...;                                         // what the step tells
  ///     std::unique_ptr<Solver> make_solver(Executor&) const;       // for executor.backend()
  ///     void load(Solver&, const Terrain&) const;
  ///     Report run(Solver&, Terrain&, Executor&) const;             // books in- and outflow in the terrain's ledger
  ///     Step kept(Solver&) const;                                   // that outlives all that this one points to
  ///
  /// `run` throws InputError before it has changed anything, or not at all. Where it throws anything else, the executor
  /// holds nothing any more, and the terrain is no moment of the run: its owner goes back to one that was.
  template <typename Step>
  typename Step::Report carry_out(Terrain& terrain, const Step& step);
  /// Brings the terrain's layers up to date, and its fields where steps change them.
  void sync_to_host(Terrain& terrain);
  /// Runs work(backend) where steps are done, for kernels of a model's own between them. It sends what it reads and
  /// fetches what it makes: where the device fails it is done once more, on the processor.
  template <typename Work>
  void on_backend(Terrain& terrain, const Work& work);

  /// Adds, from the next step on, the slabs that the polls of a step lift from each cell to `counts`, whose extent is
  /// the terrain's and which must stay; null: no longer. Costs some time, and changes nothing else. In all cells
  /// together a step adds its `lifts`.
  void count_lifts(Grid<std::int32_t>* counts) { lift_counts_ = counts; }
  /// Where lifts are counted; null: nowhere.
  Grid<std::int32_t>* lift_counts() const { return lift_counts_; }
  /// What the user should know that happened since this was last asked (a device was lost), in one line; mostly empty.
  std::string take_notice() { return std::exchange(notice_, {}); }

 private:
  /// The stamps of the terrain that the solver holds; 0: of none.
  struct Held {
    std::uint64_t ground = 0;
    std::uint64_t fields = 0;
  };
  using LoggedStep = std::function<void(Terrain& terrain)>;

  template <typename Step>
  typename Step::Report run(Terrain& terrain, const Step& step);
  template <typename Step>
  typename Step::Solver& solver(Terrain& terrain, const Step& step);
  bool holds(const Terrain& terrain) const;
  void adopt(const Terrain& terrain) { held_ = {terrain.stamp(), terrain.fields_stamp()}; }
  void bring_back(Terrain& terrain);
  void clear();
  void fall_back_to_cpu(Terrain& terrain, const std::string& why);

  /// Steps after which the terrain comes back unasked, so that a device that fails never costs more than these.
  static constexpr std::size_t most_logged = 256;

  ExecutorOptions options_;
  CpuBackend processor_;
  std::unique_ptr<Backend> device_;
  std::unique_ptr<Solver> solver_;  // freed before the device
  Held held_;
  bool stepped_ = false;         // since the terrain's layers were up to date
  std::vector<LoggedStep> log_;  // of the device's steps since then
  Grid<std::int32_t>* lift_counts_ = nullptr;
  std::string notice_;
};

// --- how a step is carried out ---

/// The solver for this step, with the terrain in it. Another family's gives its terrain back and its memory free first.
template <typename Step>
typename Step::Solver& Executor::solver(Terrain& terrain, const Step& step) {
  auto* kept = dynamic_cast<typename Step::Solver*>(solver_.get());
  if (kept != nullptr && holds(terrain)) return *kept;
  bring_back(terrain);
  clear();
  if (kept == nullptr) {
    solver_.reset();
    auto made = step.make_solver(*this);
    kept = made.get();
    solver_ = std::move(made);
  }
  step.load(*kept, terrain);
  adopt(terrain);
  return *kept;
}

template <typename Step>
typename Step::Report Executor::run(Terrain& terrain, const Step& step) {
  auto& solver = this->solver(terrain, step);
  const Held held = std::exchange(held_, {});  // half way it is nobody's terrain
  try {
    typename Step::Report report = step.run(solver, terrain, *this);
    if (device_) {
      log_.push_back([this, kept = step.kept(solver)](Terrain& again) { run(again, kept); });
    }
    stepped_ = true;
    adopt(terrain);
    return report;
  } catch (const InputError&) {
    held_ = held;
    throw;
  } catch (const DeviceError&) {
    held_ = held;
    throw;
  }
}

template <typename Step>
typename Step::Report Executor::carry_out(Terrain& terrain, const Step& step) {
  if (device_) {
    try {
      typename Step::Report report = run(terrain, step);
      if (log_.size() >= most_logged) sync_to_host(terrain);
      return report;
    } catch (const DeviceError& error) {
      fall_back_to_cpu(terrain, error.what());
    }
  }
  return run(terrain, step);
}

template <typename Work>
void Executor::on_backend(Terrain& terrain, const Work& work) {
  if (device_) {
    try {
      return work(*device_);
    } catch (const DeviceError& error) {
      fall_back_to_cpu(terrain, error.what());
    }
  }
  work(processor_);
}

}  // namespace erg::compute
