// Stores phases in node order, as the last ones of the next frame (twin: to_nodes of
// phases/sliced_graph.cpp).

layout(std430, binding = 5) writeonly buffer LastPhases { vec2 last_z[]; };
layout(std430, binding = 7) writeonly buffer PhasesByNode { vec2 z_by_node[]; };

void main() {
  const uint slot = invocation();
  if (slot >= levels[0].slot_count) return;
  const uint node = topology[node_at + slot];
  if (node == kNone) return;
  z_by_node[node] = z[slot];
  last_z[slot] = z[slot];
}
