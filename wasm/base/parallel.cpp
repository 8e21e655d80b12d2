#include "base/parallel.h"

#include <algorithm>
#include <stdexcept>

#if LIMBER_THREADS
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>
#endif

namespace limber {

using Body = std::function<void(size_t begin, size_t end)>;

#if LIMBER_THREADS

namespace {

// One call of parallelFor. A counter hands out the ranges. Errors are stored by range, so that the first one
// in order is thrown regardless of thread timing.
struct Loop {
  size_t count, grain;
  const Body& body;
  std::atomic<size_t> nextRange;
  // Both are guarded by the mutex of the pool.
  int helpers = 0;     // threads working on the loop
  uint64_t order = 0;  // number of loops begun before this one
  std::mutex errorMutex = {};
  size_t errorRange = SIZE_MAX;
  std::exception_ptr error = nullptr;

  bool hasWork() const { return nextRange * grain < count; }

  void work() {
    for (size_t range = nextRange++; range * grain < count; range = nextRange++) {
      try {
        body(range * grain, std::min((range + 1) * grain, count));
      } catch (...) {
        const std::lock_guard lock(errorMutex);
        if (range < errorRange) {
          errorRange = range;
          error = std::current_exception();
        }
      }
    }
  }
};

// Threads that wait for loops and help with the oldest loop that has ranges left: first outer loops, then
// inner ones. A caller that waits for its helpers helps too, but only with loops begun after its own. The
// threads live until their number changes or the program ends.
class Pool {
 public:
  explicit Pool(int helpers) : idle_(helpers) {
    for (int i = 0; i < helpers; ++i) threads_.emplace_back([this] { serve(); });
  }
  ~Pool() {
    {
      const std::lock_guard lock(mutex_);
      stopping_ = true;
    }
    changed_.notify_all();
    for (auto& thread : threads_) thread.join();
  }
  int helperCount() const { return static_cast<int>(threads_.size()); }
  bool hasIdleThreads() const { return idle_ > 0; }

  void run(Loop& loop) {
    {
      const std::lock_guard lock(mutex_);
      loop.order = begun_++;
      open_.push_back(&loop);
    }
    changed_.notify_all();
    loop.work();
    std::unique_lock lock(mutex_);
    std::erase(open_, &loop);
    ++idle_;
    helpUntil(lock, loop.order, [&loop] { return loop.helpers == 0; });
    --idle_;
  }

 private:
  void serve() {
    std::unique_lock lock(mutex_);
    helpUntil(lock, 0, [this] { return stopping_; });
  }

  template <class IsOver>
  void helpUntil(std::unique_lock<std::mutex>& lock, uint64_t since, const IsOver& isOver) {
    while (!isOver()) {
      if (Loop* loop = loopWithWork(since))
        help(lock, *loop);
      else
        changed_.wait(lock);
    }
  }

  void help(std::unique_lock<std::mutex>& lock, Loop& loop) {
    ++loop.helpers;
    --idle_;
    lock.unlock();
    loop.work();
    lock.lock();
    ++idle_;
    if (--loop.helpers == 0) changed_.notify_all();
  }

  Loop* loopWithWork(uint64_t since) const {
    const auto found = std::find_if(open_.begin(), open_.end(),
                                    [&](Loop* loop) { return loop->order >= since && loop->hasWork(); });
    return found != open_.end() ? *found : nullptr;
  }

  std::vector<std::thread> threads_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Loop*> open_;  // loops whose callers still hand out ranges, in the order in which they began
  uint64_t begun_ = 0;
  std::atomic<int> idle_;  // threads that wait for work
  bool stopping_ = false;
};

// Never destroyed: joining threads while a program exits can hang in a browser.
Pool*& pool() {
  static Pool* instance = nullptr;
  return instance;
}

}  // namespace

void setThreadCount(int count) {
  if (count < 1) throw std::invalid_argument("The number of threads must be at least 1.");
  if (count == threadCount()) return;
  delete pool();
  pool() = count > 1 ? new Pool(count - 1) : nullptr;
}

int threadCount() {
  return pool() ? pool()->helperCount() + 1 : 1;
}

void parallelFor(size_t count, size_t grain, const Body& body) {
  if (count == 0) return;
  grain = std::max<size_t>(grain, 1);
  // Works without helpers until a thread is idle.
  size_t begin = 0;
  for (; begin + grain < count && !(pool() && pool()->hasIdleThreads()); begin += grain)
    body(begin, begin + grain);
  if (begin + grain >= count) return body(begin, count);
  Loop loop{count, grain, body, begin / grain};
  pool()->run(loop);
  if (loop.error) std::rethrow_exception(loop.error);
}

#else

void setThreadCount(int count) {
  if (count < 1) throw std::invalid_argument("The number of threads must be at least 1.");
}

int threadCount() {
  return 1;
}

void parallelFor(size_t count, size_t grain, const Body& body) {
  grain = std::max<size_t>(grain, 1);
  for (size_t begin = 0; begin < count; begin += grain) body(begin, std::min(begin + grain, count));
}

#endif

}  // namespace limber
