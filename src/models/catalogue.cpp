// Every model, one line each. Adding a model: its two files and its line here.
#include "models/bishop.h"
#include "models/grains.h"
#include "models/model.h"
#include "models/momiji.h"
#include "models/nield_baas.h"
#include "models/snow_packing.h"
#include "models/snow_sintering.h"
#include "models/werner.h"

namespace erg {

const std::vector<ModelType>& catalogue() {
  static const std::vector<ModelType> models{
      werner(), momiji(), bishop(), nield_baas(), snow_packing(), snow_sintering(), grains(),
  };
  return models;
}

const ModelType& find_model(const std::string& key) {
  std::vector<std::string> keys;
  for (const ModelType& model : catalogue()) {
    if (model.info.key == key) return model;
    keys.push_back(model.info.key);
  }
  throw InputError("model", "unknown model \"" + key + "\"", suggestion(key, keys));
}

}  // namespace erg
