// Named templates for the tests of variation, made in code.
#pragma once

#include "generator/template/template.h"

namespace pomona::fruits {

/// Cylindrical: nested wavy layers of different shapes that do not cross as drawn.
Template onion(int layers = 7);

/// Cylindrical: one loop that some rays from the axis meet more than once.
Template curly();

/// N-fold with uneven folds: lobed skin, inner wall and core around the axis, a chamber in each fold.
Template tomato(int folds = 5);

/// The largest radius of a loop less its smallest, over the mean of the two.
double waviness(const Curve& loop);

}  // namespace pomona::fruits
