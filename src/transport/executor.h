// The executor under the name that the files of sintering snow know.
#pragma once

#include "compute/executor.h"
#include "forcing/regime.h"
#include "transport/step_report.h"
#include "transport/terrain_heights.h"
