#include "generator/scene/solid.h"
