#include "models/step_report.h"

namespace erg::models {

StepReport& StepReport::operator+=(const StepReport& other) {
  polls += other.polls;
  lifts += other.lifts;
  travel += other.travel;
  slabs_in += other.slabs_in;
  slabs_out += other.slabs_out;
  if (other.finished) {
    finished = true;
    why_finished = other.why_finished;
  }
  return *this;
}

}  // namespace erg::models
