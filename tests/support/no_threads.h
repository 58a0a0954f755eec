#pragma once

#include <pthread.h>

#include <cstddef>

namespace npsee::test {

/// As long as it lives the system gives this process no thread: each would have a stack larger than all addresses.
class NoThreads {
 public:
  NoThreads() {
    pthread_getattr_default_np(&before_);
    pthread_attr_t larger;
    pthread_attr_init(&larger);
    pthread_attr_setstacksize(&larger, std::size_t{1} << 50);
    pthread_setattr_default_np(&larger);
    pthread_attr_destroy(&larger);
  }
  ~NoThreads() {
    pthread_setattr_default_np(&before_);
    pthread_attr_destroy(&before_);
  }
  NoThreads(const NoThreads&) = delete;
  NoThreads& operator=(const NoThreads&) = delete;

 private:
  pthread_attr_t before_;
};

}  // namespace npsee::test
