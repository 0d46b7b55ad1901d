#pragma once

#include "compute/aligned_vector.h"
