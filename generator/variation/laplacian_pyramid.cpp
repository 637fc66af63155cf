#include "generator/variation/laplacian_pyramid.h"

namespace pomona {

namespace {

double at(const CyclicSignal& signal, std::size_t index, int offset) {
  const std::size_t n = signal.size();
  return signal[(index + n + static_cast<std::size_t>(static_cast<long long>(n) + offset)) % n];
}

CyclicSignal reduced(const CyclicSignal& fine) {
  CyclicSignal coarse(fine.size() / 2);
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    const double far = at(fine, 2 * i, -2) + at(fine, 2 * i, 2);
    const double near = at(fine, 2 * i, -1) + at(fine, 2 * i, 1);
    coarse[i] = (far + 4 * near + 6 * fine[2 * i]) / 16;
  }
  return coarse;
}

CyclicSignal expanded(const CyclicSignal& coarse) {
  CyclicSignal fine(2 * coarse.size());
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    fine[2 * i] = (at(coarse, i, -1) + 6 * coarse[i] + at(coarse, i, 1)) / 8;
    fine[2 * i + 1] = (coarse[i] + at(coarse, i, 1)) / 2;
  }
  return fine;
}

}  // namespace

LaplacianPyramid decompose(CyclicSignal signal, std::size_t coarsest) {
  LaplacianPyramid pyramid;
  while (signal.size() > coarsest) {
    CyclicSignal coarse = reduced(signal);
    const CyclicSignal smooth = expanded(coarse);
    for (std::size_t i = 0; i < signal.size(); ++i) signal[i] -= smooth[i];
    pyramid.push_back(std::move(signal));
    signal = std::move(coarse);
  }
  pyramid.push_back(std::move(signal));
  return pyramid;
}

CyclicSignal compose(const LaplacianPyramid& pyramid) {
  CyclicSignal signal = pyramid.back();
  for (std::size_t level = pyramid.size() - 1; level-- > 0;) {
    signal = expanded(signal);
    for (std::size_t i = 0; i < signal.size(); ++i) signal[i] += pyramid[level][i];
  }
  return signal;
}

}  // namespace pomona
