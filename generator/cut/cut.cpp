#include "generator/cut/cut.h"
