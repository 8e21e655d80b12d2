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

namespace {

using Body = std::function<void(size_t, size_t)>;

void runSerially(size_t count, size_t grain, const Body& body) {
  for (size_t begin = 0; begin < count; begin += grain) body(begin, std::min(begin + grain, count));
}

}  // namespace

#if LIMBER_THREADS

namespace {

// One call of parallelFor: ranges are handed out by a counter; errors are kept by range, so that the first
// one in order is thrown whatever the threads' timing.
struct Loop {
  size_t count, grain;
  const Body& body;
  std::atomic<size_t> nextRange = 0;
  std::mutex errorMutex = {};
  size_t errorRange = SIZE_MAX;
  std::exception_ptr error = nullptr;

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

// Threads that wait for loops. They live until the number of threads changes or the program ends.
class Pool {
 public:
  explicit Pool(int helpers) {
    for (int i = 0; i < helpers; ++i) threads_.emplace_back([this] { serve(); });
  }
  ~Pool() {
    {
      const std::lock_guard lock(mutex_);
      stopping_ = true;
    }
    wake_.notify_all();
    for (auto& thread : threads_) thread.join();
  }
  int helperCount() const { return static_cast<int>(threads_.size()); }

  void run(Loop& loop) {
    {
      const std::lock_guard lock(mutex_);
      loop_ = &loop;
      ++generation_;
      busy_ = helperCount();
    }
    wake_.notify_all();
    loop.work();
    std::unique_lock lock(mutex_);
    done_.wait(lock, [this] { return busy_ == 0; });
    loop_ = nullptr;
  }

 private:
  void serve();

  std::vector<std::thread> threads_;
  std::mutex mutex_;
  std::condition_variable wake_, done_;
  Loop* loop_ = nullptr;
  uint64_t generation_ = 0;
  int busy_ = 0;
  bool stopping_ = false;
};

thread_local bool insideLoop = false;

void Pool::serve() {
  insideLoop = true;
  uint64_t seen = 0;
  std::unique_lock lock(mutex_);
  for (;;) {
    wake_.wait(lock, [&] { return stopping_ || generation_ != seen; });
    if (stopping_) return;
    seen = generation_;
    Loop* loop = loop_;
    lock.unlock();
    loop->work();
    lock.lock();
    if (--busy_ == 0) done_.notify_one();
  }
}

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
  if (!pool() || insideLoop || count <= grain) return runSerially(count, grain, body);
  Loop loop{count, grain, body};
  insideLoop = true;
  pool()->run(loop);
  insideLoop = false;
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
  runSerially(count, std::max<size_t>(grain, 1), body);
}

#endif

}  // namespace limber
