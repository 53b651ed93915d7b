// The paper's Eq. 2 and 7, literally (twin: common_source_distance of waves/phase_shift.cpp).

struct Distance {
  double len;
  bool reflecting;
};

Distance parallel_distance(Wave j, Wave i) {
  const float cosine = dot(i.direction, j.direction);
  const vec3 sum = j.direction + (cosine < 0.0 ? -1.0 : 1.0) * i.direction;
  return Distance(double(dot(i.position - j.position, sum) / (1.0 + abs(cosine))), cosine < 0.0);
}

Distance common_source_distance(Wave j, Wave i) {
  const dvec3 e = dvec3(i.position - j.position);
  const dvec3 d_i = dvec3(i.direction), d_j = dvec3(j.direction);
  const double cosine = dot(d_i, d_j);
  const double edge = sqrt(dot(e, e));
  if (!(edge > 0.0lf)) return parallel_distance(j, i);

  const dvec3 x = e / edge;
  const dvec3 to_p = 0.5lf * (e + (cosine < 0.0lf ? -1.0lf : 1.0lf) * d_i + d_j);
  const dvec3 off_edge = to_p - dot(to_p, x) * x;
  const double off_edge_length = sqrt(dot(off_edge, off_edge));
  if (off_edge_length < 1e-9lf * sqrt(dot(to_p, to_p)) || to_p == dvec3(0)) {
    return parallel_distance(j, i);
  }
  const dvec3 y = off_edge / off_edge_length;

  // In the plane's axes (x, y) with v_j at the origin: C = a d_j = e + b d_i.
  const dvec2 p_j = dvec2(dot(d_j, x), dot(d_j, y)), p_i = dvec2(dot(d_i, x), dot(d_i, y));
  const double across = p_j.x * p_i.y - p_j.y * p_i.x;
  if (abs(across) < 1e-9lf * sqrt(dot(p_j, p_j) * dot(p_i, p_i)) || across == 0.0lf) {
    return parallel_distance(j, i);
  }
  const double a = edge * p_i.y / across;
  const dvec2 from_j = a * p_j, from_i = from_j - dvec2(edge, 0);
  const double sign_j = dot(from_j, p_j) < 0.0lf ? -1.0lf : 1.0lf;
  return Distance((sqrt(dot(from_j, from_j)) - sqrt(dot(from_i, from_i))) * sign_j,
                  cosine * dot(from_i, from_j) < 0.0lf);
}

EdgeShift edge_shift(Wave j, Wave i) {
  const Distance d = common_source_distance(j, i);
  return EdgeShift(dot(i.direction, j.direction), d.reflecting,
                   i.root_frequency * j.root_frequency * float(d.len));
}
