// Stands in for cuda_api.cu where there is no nvcc.
#include "cuda/cuda_api.h"

namespace erg::cuda {

std::unique_ptr<CudaApi> cuda_api() { return nullptr; }

}  // namespace erg::cuda
