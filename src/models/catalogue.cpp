// Every model, one line each. Adding a model: its two files and its line here.
#include <utility>

#include "models/grains/grains.h"
#include "models/model.h"
#include "models/slab/bishop.h"
#include "models/slab/momiji.h"
#include "models/slab/nield_baas.h"
#include "models/slab/snow_packing.h"
#include "models/slab/werner.h"
#include "models/snow/snow_sintering.h"

namespace erg::models {

namespace {

// A deque: runs hold pointers to their model's entry, which stay good when one is added.
std::deque<ModelType>& all_models() {
  static std::deque<ModelType> models{
      werner(), momiji(), bishop(), nield_baas(), snow_packing(), snow_sintering(), grains(),
  };
  return models;
}

}  // namespace

const std::deque<ModelType>& catalogue() { return all_models(); }

void add_model(ModelType model) {
  for (const ModelType& other : catalogue()) {
    if (other.info.key != model.info.key) continue;
    throw InputError("model", "there is a model \"" + model.info.key + "\" already", "give yours a key of its own");
  }
  all_models().push_back(std::move(model));
}

const ModelType& find_model(const std::string& key) {
  std::vector<std::string> keys;
  for (const ModelType& model : catalogue()) {
    if (model.info.key == key) return model;
    keys.push_back(model.info.key);
  }
  throw InputError("model", "unknown model \"" + key + "\"", suggestion(key, keys));
}

}  // namespace erg::models
