#include "render/deliver/provenance.h"

#include "generator/base/version.h"
#include "generator/order/option_table.h"

namespace pomona {

Provenance provenance_of(const FruitOrder& fruit) {
  if (!fruit.seeds.empty()) return {fruit.seeds};
  return {{fruit.seed.value_or(0)}};
}

std::string made_by(const Provenance& provenance) {
  Order seeds;
  seeds.fruit.seeds = provenance.seeds;
  return std::string("pomona ") + version + (provenance.seeds.size() == 1 ? ", seed " : ", seeds ") +
         text_of_option(order_option("seeds"), seeds);
}

}  // namespace pomona
