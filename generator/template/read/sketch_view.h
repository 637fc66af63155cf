// The two views in which a sketch shows a fruit (paper, section 4.1).
#pragma once

namespace pomona {

enum class SketchView {
  side,  ///< vertical curves: x = distance from the axis
  top,   ///< horizontal curves: the axis is a point
};

inline const char* name_of(SketchView view) { return view == SketchView::side ? "side view" : "top view"; }

}  // namespace pomona
