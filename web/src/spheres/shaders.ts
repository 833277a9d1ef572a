// Programs of the graphics card. A sphere or a spherocylinder (a force, an edge of the box, an arm of a cluster) is a flat
// quadrilateral towards the eye; each of its pixels finds where its ray meets the true surface, so that both are round at
// any size. Units of a scene; screen axes.

const COMMON = `#version 300 es
precision highp float;
uniform mat3 turn;
uniform float eye, front, reach, least;
uniform vec2 scale;
uniform vec3 ramp[7];
const vec3 GROUND = vec3(1.);

vec4 project(vec3 p) {
  float w = eye - p.z, near = eye - 1.6 * reach, far = eye + 1.6 * reach;
  return vec4(scale * p.xy, ((far + near) * w - 2. * far * near) / (far - near), w);
}
vec3 heat(float force) {
  float t = clamp(force / 4., 0., 1.) * 6.;
  int k = min(int(t), 5);
  return mix(ramp[k], ramp[k + 1], t - float(k));
}
`;

const LIGHT = `
vec3 lit(vec3 colour, vec3 normal, vec3 at, float contour) {
  vec3 to_eye = normalize(vec3(0., 0., eye) - at);
  vec3 lamp = normalize(vec3(-.45, .7, .8));
  float day = max(dot(normal, lamp), 0.);
  float sky = .5 + .5 * normal.y;
  vec3 shade = colour * (.52 + .16 * sky + .42 * day);
  shade += .16 * pow(max(dot(reflect(-lamp, normal), to_eye), 0.), 24.);
  shade *= mix(1., .62, contour * smoothstep(.5, .05, dot(normal, to_eye)));
  float far = clamp((reach - at.z) / (2. * reach), 0., 1.);
  return mix(shade, GROUND, .42 * far * far);
}
void depth_of(vec3 at) {
  vec4 p = project(at);
  gl_FragDepth = .5 + .5 * p.z / p.w;
}
out vec4 pixel;
`;

export const SPHERE_VERTEX = `${COMMON}
uniform float shrink;
in vec2 corner;
in vec4 grain;
in float strongest;
flat out vec4 ball;
flat out float force;
out vec3 at;
void main() {
  vec3 centre = turn * grain.xyz;
  ball = vec4(centre, grain.w * shrink);
  force = strongest;
  at = centre + vec3(corner * ball.w * 1.15, 0.);
  gl_Position = centre.z > front ? vec4(2., 2., 2., 1.) : project(at);
}`;

export const SPHERE_FRAGMENT = `${COMMON}${LIGHT}
uniform float plain;
flat in vec4 ball;
flat in float force;
in vec3 at;
void main() {
  vec3 from = vec3(0., 0., eye), way = normalize(at - from);
  vec3 nearest = from + way * dot(ball.xyz - from, way);
  vec3 off = nearest - ball.xyz;
  float room = ball.w * ball.w - dot(off, off);
  if (room < 0.) discard;
  vec3 hit = nearest - way * sqrt(room);
  depth_of(hit);
  vec3 colour = force < 0. ? vec3(.93, .945, .96) : plain > .5 ? vec3(.80, .835, .875) : heat(force);
  pixel = vec4(lit(colour, (hit - ball.xyz) / ball.w, hit, 1.), 1.);
}`;

export const ROD_VERTEX = `${COMMON}
in vec2 corner;
in vec3 start, end;
in float strength;
in float thick;
uniform float shrink, unit, fine;
flat out vec3 a, b;
flat out float force, radius;
out vec3 at;
void main() {
  a = turn * start;
  b = turn * end;
  force = strength;
  radius = thick > 0. ? thick * shrink : strength < 0. ? fine : unit * (.012 + .034 * min(strength, 5.));
  vec3 here = corner.y < 0. ? a : b;
  vec3 to_eye = normalize(vec3(0., 0., eye) - here);
  vec3 along = b - a - to_eye * dot(b - a, to_eye);
  along = dot(along, along) > 1e-10 ? normalize(along) : normalize(cross(to_eye, vec3(.3, .8, .5)));
  vec3 side = cross(along, to_eye);
  at = here + 1.15 * radius * (corner.x * side + corner.y * along);
  bool away = strength >= 0. && ((thick <= 0. && strength < least) || .5 * (a.z + b.z) > front);
  gl_Position = away ? vec4(2., 2., 2., 1.) : project(at);
}`;

/** The ray's origin is moved near the rod first: far away, squares of distances would eat the digits. */
export const ROD_FRAGMENT = `${COMMON}${LIGHT}
uniform float body, plain;
flat in vec3 a, b;
flat in float force, radius;
in vec3 at;
float ball_hit(vec3 from, vec3 way) {
  float half_way = dot(way, from), room = half_way * half_way - dot(from, from) + radius * radius;
  return room < 0. ? 1e9 : -half_way - sqrt(room);
}
void main() {
  vec3 lens = vec3(0., 0., eye), way = normalize(at - lens);
  vec3 from = lens + way * dot(.5 * (a + b) - lens, way);
  vec3 axis = b - a, off = from - a;
  float aa = dot(axis, axis), aw = dot(axis, way), ao = dot(axis, off);
  float p = aa - aw * aw, q = aa * dot(way, off) - ao * aw, s = aa * (dot(off, off) - radius * radius) - ao * ao;
  float room = q * q - p * s;
  if (room < 0.) discard;
  float t = p > 1e-9 ? (-q - sqrt(room)) / p : 1e9, along = ao + t * aw;
  if (p <= 1e-9 || along < 0. || along > aa) {
    bool first = p <= 1e-9 ? aw > 0. : along < 0.;
    t = ball_hit(first ? off : from - b, way);
    if (t > 1e8) discard;
  }
  vec3 hit = from + t * way;
  vec3 foot = a + axis * clamp(dot(hit - a, axis) / max(aa, 1e-12), 0., 1.);
  depth_of(hit);
  vec3 colour = force < -1.5 ? vec3(.74, .77, .81) : force < 0. ? vec3(.52, .56, .62) : heat(force);
  if (body > .5) colour = plain > .5 ? vec3(.80, .835, .875) : force <= 0. ? vec3(.93, .945, .96) : heat(force);
  pixel = vec4(lit(colour, (hit - foot) / radius, hit, body > .5 ? 1. : force < 0. ? 0. : .6), 1.);
}`;
