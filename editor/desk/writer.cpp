#include "editor/desk/writer.h"

#include "sim/core/files.h"

#include <system_error>
#include <utility>

namespace npsee::editor {

namespace fs = std::filesystem;

Writer::Writer() : thread_([this](const std::stop_token& stop) { work(stop); }) {}

Writer::~Writer() { wait(); }

std::uint64_t Writer::write(fs::path file, std::string text) { return add({std::move(file), std::move(text)}); }
void Writer::remove(fs::path file) { add({std::move(file), std::nullopt}); }

Writer::Fate Writer::fateOf(std::uint64_t number) const {
  const std::lock_guard lock(mutex_);
  if (number > ended_) return Fate::waiting;
  return failed_.contains(number) ? Fate::failed : Fate::written;
}

std::uint64_t Writer::add(Task task) {
  std::uint64_t number = 0;
  {
    const std::lock_guard lock(mutex_);
    number = task.number = ++asked_;
    // Only the newest of what waits is worth a write; the order among different files stays.
    if (!tasks_.empty() && tasks_.back().file == task.file) tasks_.back() = std::move(task);
    else tasks_.push_back(std::move(task));
  }
  changed_.notify_all();
  return number;
}

void Writer::wait() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return tasks_.empty() && !working_; });
}

std::optional<std::string> Writer::takeError() {
  const std::lock_guard lock(mutex_);
  return std::exchange(error_, std::nullopt);
}

void Writer::work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (changed_.wait(lock, stop, [this] { return !tasks_.empty(); })) {
    const Task task = std::move(tasks_.front());
    tasks_.pop_front();
    working_ = true;
    lock.unlock();
    std::error_code ignored;
    Expected<void> done;
    if (task.text) {
      fs::create_directories(task.file.parent_path(), ignored);
      done = writeFileAtomically(task.file, *task.text);
    } else {
      fs::remove(task.file, ignored);
    }
    lock.lock();
    working_ = false;
    ended_ = task.number;
    if (!done) {
      error_ = done.error().text();
      failed_.insert(task.number);
    }
    changed_.notify_all();
  }
}

}  // namespace npsee::editor
