#include "generator/base/version.h"

namespace pomona {

const char version[] = POMONA_VERSION;

}  // namespace pomona
