// What lies on the other side of the ground than the eye is cut off; the ground itself is painted behind everything.
uniform vec2 u_clip;  // x: 1 keeps what is above, -1 what is below, 0 everything; y: ground height, world m

float clipDistance(float y) { return u_clip.x == 0.0 ? 1.0 : u_clip.x * (y - u_clip.y); }
