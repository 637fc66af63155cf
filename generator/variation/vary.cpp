#include "generator/variation/vary.h"
