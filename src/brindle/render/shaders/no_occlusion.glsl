// All light reaches every point.
float open_share(SurfacePoint p) { return 1.0; }
