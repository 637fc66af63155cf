// What guides texture detail, beside the surfaces that are nearest.
in vec4 way_layer;
in vec4 share;

layout(location = 0) out vec4 way_layer_out;
layout(location = 1) out vec4 share_out;

void main() {
  way_layer_out = way_layer;
  share_out = share;
}
