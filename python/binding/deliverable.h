// What can be written to files and drawn: fruit, pieces, sections, scenes.
#pragma once

#include <vector>

#include "generator/order/option_table.h"
#include "render/deliver/deliver_options.h"

namespace pomona {

class Deliverable {
 public:
  Deliverable(Order order, OrderTaker taker) : order_(std::move(order)), taker_(taker) {}
  virtual ~Deliverable() = default;
  Deliverable(const Deliverable&) = delete;
  Deliverable& operator=(const Deliverable&) = delete;

  /// The bytes of all outputs of an order that begins as order() does.
  virtual Delivered deliver(const Order& order, const DeliverOptions& how) const = 0;

  virtual const std::vector<Format>& formats() const = 0;

  /// The first step of the road that is still to come.
  virtual OrderStep next_step() const { return OrderStep::write; }

  /// The size of pictures where the order says none.
  virtual PictureSize usual_size() const { return DeliverOptions().usual_size; }

  /// Whether cut faces can be coloured for textures: they keep what coloured them only where that was ordered.
  virtual bool can_have_textures() const { return true; }

  const Order& order() const { return order_; }
  OrderTaker taker() const { return taker_; }

 private:
  Order order_;
  OrderTaker taker_;
};

/// The style that the order names, as found.
Style ordered_style(const Order& order);

/// What files of it are made by: the style, and what made them.
DeliverOptions deliver_options(const Deliverable& what, const Order& order, const DeliveryProgress& progress = {});

}  // namespace pomona
