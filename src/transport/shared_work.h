// WorkQueue under the name that the files of sintering snow know.
#pragma once

#include "compute/work_queue.h"

namespace erg {

class SharedWork : public WorkQueue {
 public:
  using WorkQueue::WorkQueue;
  template <typename Work>
  void take_pieces(int member, const Work& work) {
    take_chunks(member, work);
  }
};

}  // namespace erg
