#include "ui/view/skeleton_shaders.h"

#include "ui/view/clip_shader.h"
#include "ui/view/focus_shader.h"

namespace espalier::shaders {

/// What the shaders of edges and nodes share.
#define ESPALIER_GLYPH_HEAD                                                                        \
  "#version 330 core\n"                                                                            \
  "uniform mat4 toView;\n"                                                                         \
  "uniform mat4 toClip;\n"                                                                         \
  "uniform vec2 halfScreen;\n" /* [device pixels] */                                               \
  "uniform float pixelRatio;\n"                                                                    \
  "uniform float pixelSize;\n" /* [L], in perspective at depth 1 */                                \
  "uniform int perspective;\n"                                                                     \
  "uniform vec3 successorColor;\n"                                                                 \
  "uniform vec3 branchingColor;\n"                                                                 \
  "uniform vec3 selectedColor;\n"                                                                  \
  "uniform vec3 hoveredColor;\n"                                                                   \
  "uniform vec3 backgroundColor;\n"                                                                \
  "uniform int isReference;\n" /* that the skeleton is compared with */                            \
  "uniform float depthFade;\n"                                                                     \
  "uniform vec2 depths;\n"     /* nearest and farthest of the skeleton [L] */                      \
  "uniform float roominess;\n" /* 0: nodes crowd on the screen; 1: there is room for them */       \
  "vec3 faded(vec3 color, float z) {\n" /* the far side steps back */                              \
  "  float part = clamp((-z - depths.x) / (depths.y - depths.x), 0.0, 1.0);\n"                     \
  "  return mix(color, backgroundColor, mix(0.5 * part * part, 0.92 * part, depthFade));\n"        \
  "}\n" ESPALIER_FOCUS                                                                             \
  "float outside(float fading, float depth) {\n" /* of the focus; what is whole is not */          \
  "  return fading > 1.5 ? 0.0 : outOfFocus(depth);\n"                                             \
  "}\n"                                                                                            \
  "vec4 sunk(vec4 clip, float fading, float depth) {\n"                                            \
  "  return fading > 1.5 ? clip : behindFocus(clip, depth);\n"                                     \
  "}\n"                                                                                            \
  "vec3 dressed(vec3 usual, vec4 own, float fading, float z) {\n"                                  \
  "  vec3 color = faded(own.a > 0.5 ? own.rgb / 255.0 : usual, z);\n"                              \
  "  color = mix(color, backgroundColor, 0.92 * outside(fading, -z));\n"                           \
  "  float paleness = own.a > 0.5 ? 0.4 : 0.82;\n" /* a color that has a meaning is still read */  \
  "  return fading == 1.0 ? mix(color, backgroundColor, paleness) : color;\n"                      \
  "}\n"

/// An edge is cut where it leaves the clip, by the distance of each end to its sides.
#define ESPALIER_EDGE_CLIP                                                                         \
  "out float gl_ClipDistance[8];\n"                                                                \
  "void clipAt(vec3 place, float depth) {\n"                                                       \
  "  if (clipped == 0) return;\n"                                                                  \
  "  vec3 low = place - clipLow;\n"                                                                \
  "  vec3 high = clipHigh - place;\n"                                                              \
  "  for (int i = 0; i < 3; ++i) {\n"                                                              \
  "    gl_ClipDistance[i] = low[i];\n"                                                             \
  "    gl_ClipDistance[3 + i] = high[i];\n"                                                        \
  "  }\n"                                                                                          \
  "  gl_ClipDistance[6] = depth - clipDepths.x;\n"                                                 \
  "  gl_ClipDistance[7] = clipDepths.y - depth;\n"                                                 \
  "}\n"

const char* const lineVertex = ESPALIER_GLYPH_HEAD ESPALIER_CLIP ESPALIER_EDGE_CLIP R"(
layout(location = 0) in vec4 parent;
layout(location = 1) in vec4 child;
layout(location = 2) in vec4 look;      // shape, mark, whether faded
layout(location = 3) in vec4 own;       // color, if its alpha is not 0
noperspective out float across;         // from the axis, in device pixels
noperspective out float along;          // from the parent, in device pixels
flat out float total;                   // length on the screen, in device pixels
flat out vec2 halfWidth;                // at the parent and at the child
flat out vec3 color;
flat out float isDashed;

vec4 before(vec4 a, vec4 b) { // the part of a in front of the eye
  float nearest = toClip[3][2] / (1.0 - toClip[2][2]); // view z of the near plane
  if (perspective == 0 || a.z <= nearest) return a;
  return mix(b, a, (nearest - b.z) / (a.z - b.z));
}

void main() {
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // outside: not drawn
  if (look.x < 0.5 || isInHole(child.xyz)) return;
  vec4 a = toView * vec4(parent.xyz, 1.0);
  vec4 b = toView * vec4(child.xyz, 1.0);
  float nearest = toClip[3][2] / (1.0 - toClip[2][2]);
  if (perspective != 0 && a.z > nearest && b.z > nearest) return;
  vec4 clipA = toClip * before(a, b);
  vec4 clipB = toClip * before(b, a);
  vec2 screenA = clipA.xy / clipA.w * halfScreen;
  vec2 screenB = clipB.xy / clipB.w * halfScreen;
  vec2 span = screenB - screenA;
  total = length(span);
  vec2 direction = total > 1e-6 ? span / total : vec2(1.0, 0.0);
  bool hovered = look.y > 1.5;
  halfWidth = pixelRatio * (hovered ? vec2(2.6, 0.9) : vec2(mix(0.7, 1.0, roominess)));
  float reach = max(halfWidth.x, halfWidth.y) + 1.5 * pixelRatio;
  float side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  bool atChild = (gl_VertexID & 2) != 0;
  across = side * reach;
  along = atChild ? total : 0.0;
  color = hovered ? hoveredColor
                  : dressed(look.x > 1.5 ? branchingColor : successorColor, own, look.z,
                            0.5 * (a.z + b.z));
  bool isLong = total > (isReference == 1 ? 6.0 : 24.0) * pixelRatio;
  isDashed = (isReference == 1 || look.x > 1.5) && isLong ? 1.0 : 0.0;
  vec4 clip = atChild ? clipB : clipA;
  vec2 screen = (atChild ? screenB : screenA) + vec2(-direction.y, direction.x) * across;
  // A part before the eye was cut off both: the place is found again from what is left.
  vec4 kept = atChild ? before(b, a) : before(a, b);
  float part = distance(a, b) > 0.0 ? distance(a.xyz, kept.xyz) / distance(a.xyz, b.xyz) : 0.0;
  clipAt(mix(parent.xyz, child.xyz, part), -kept.z);
  gl_Position = sunk(vec4(screen / halfScreen * clip.w, clip.z, clip.w), look.z, -kept.z);
})";

const char* const lineFragment = R"(#version 330 core
uniform vec3 outlineColor;
uniform float pixelRatio;
uniform int isReference;
noperspective in float across;
noperspective in float along;
flat in float total;
flat in vec2 halfWidth;
flat in vec3 color;
flat in float isDashed;
out vec4 fragment;
void main() {
  float width = mix(halfWidth.x, halfWidth.y, total > 0.0 ? along / total : 0.0);
  float beyond = abs(across) - width; // outside the line, in pixels
  float line = clamp(0.5 - beyond, 0.0, 1.0);
  // Whole dashes only, so that both ends of the edge are drawn.
  float period = total / (floor(total / ((isReference == 1 ? 5.0 : 9.0) * pixelRatio)) + 0.6);
  if (isDashed > 0.5 && fract(along / period) > 0.6) line = 0.0;
  float outline = 0.6 * clamp(0.5 - (beyond - pixelRatio), 0.0, 1.0);
  float alpha = max(line, outline);
  if (alpha < 0.05) discard;
  fragment = vec4(mix(outlineColor, color, line), alpha);
})";

const char* const frustumVertex = ESPALIER_GLYPH_HEAD ESPALIER_CLIP ESPALIER_EDGE_CLIP R"(
layout(location = 0) in vec4 parent;
layout(location = 1) in vec4 child;
layout(location = 2) in vec4 look;
layout(location = 3) in vec4 own;
out vec3 place;                         // view coordinates, on the axis plane
out float radius;
noperspective out float across;         // -1 to 1
flat out float tilt;                    // sine of the angle between axis and line of sight
out float toNearEnd;                    // along the axis, to its end nearer to the eye [L]
flat out vec3 color;
flat out float back;                    // how far it is drawn behind all, in [0, 1]

void main() {
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  if (look.x < 0.5 || isInHole(child.xyz)) return;
  vec3 a = (toView * vec4(parent.xyz, 1.0)).xyz;
  vec3 b = (toView * vec4(child.xyz, 1.0)).xyz;
  bool atChild = (gl_VertexID & 2) != 0;
  vec3 axis = b - a;
  place = atChild ? b : a;
  vec3 toEye = perspective != 0 ? -place : vec3(0.0, 0.0, 1.0);
  vec3 sideways = cross(axis, toEye);
  float size = length(sideways);
  if (size < 1e-12) return; // seen end on: the spheres of its nodes cover it
  tilt = max(size / (length(axis) * length(toEye)), 0.1);
  bool isNearEnd = (dot(axis, toEye) > 0.0) == atChild;
  toNearEnd = isNearEnd ? 0.0 : length(axis);
  float pixel = pixelSize * (perspective != 0 ? max(-place.z, 0.0) : 1.0);
  radius = max(atChild ? child.w : parent.w, pixelRatio * pixel);
  across = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  color = look.y > 1.5 ? hoveredColor
                       : dressed(look.x > 1.5 ? branchingColor : successorColor, own, look.z,
                            0.5 * (a.z + b.z));
  float depth = -0.5 * (a.z + b.z);
  back = look.z < 1.5 && isPassed(depth) ? 1.0 : 0.0;
  clipAt(atChild ? child.xyz : parent.xyz, -place.z);
  gl_Position = toClip * vec4(place + sideways / size * across * radius, 1.0);
})";

const char* const frustumFragment = R"(#version 330 core
uniform mat4 toClip;
in vec3 place;
in float radius;
noperspective in float across;
flat in float tilt;
in float toNearEnd;
flat in vec3 color;
flat in float back;
out vec4 fragment;
void main() {
  float facing = sqrt(max(0.0, 1.0 - across * across));
  // The front of a tilted cone belongs to a place farther along its axis, perhaps past its end.
  if (radius * facing * sqrt(1.0 - tilt * tilt) > toNearEnd * tilt) discard;
  vec4 front = toClip * vec4(place.xy, place.z + radius * facing / tilt, 1.0);
  gl_FragDepth = mix(clamp(0.5 * front.z / front.w + 0.5, 0.0, 1.0), 0.9998, back);
  fragment = vec4(color * (0.4 + 0.6 * facing * tilt), 1.0);
})";

const char* const nodeVertex = ESPALIER_GLYPH_HEAD ESPALIER_CLIP R"(
layout(location = 0) in vec4 center;    // and radius
layout(location = 1) in vec4 look;      // shape, mark, unit start, whether faded
layout(location = 2) in vec4 own;       // color, if its alpha is not 0
uniform int spheres;
uniform float pushed;                   // discs toward the eye, in radii of the node
out vec3 place;
flat out float radius;                  // [L]
noperspective out vec2 offset;          // from the center, in device pixels
flat out float halfWidth;               // in device pixels
flat out vec3 color;
flat out vec3 rim;                      // color of its edge
flat out int shape;
flat out int isUnitStart;
flat out float back;

float halfWidthOf(int kind, int mark) {
  float width = kind == 2 ? 4.5 : kind == 4 ? 3.6 : kind == 3 ? 3.2 : 2.5;
  if (kind != 2) width *= roominess;
  if (mark == 1) width = max(1.35 * width, 3.5);
  if (mark >= 2) width = max(1.5 * width, mark == 3 ? 5.0 : 4.0);
  return width * pixelRatio;
}

void main() {
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  shape = int(look.x + 0.5);
  int mark = int(look.y + 0.5);
  isUnitStart = int(look.z + 0.5);
  if (shape == 0) return;
  if (isReference == 1 && mark == 0) return;
  if (spheres == 0 && roominess < 0.5 && shape != 2 && mark == 0 && isUnitStart == 0)
    return; // edges show enough
  place = (toView * vec4(center.xyz, 1.0)).xyz;
  if (isClipped(center.xyz, -place.z)) return;
  float pixel = pixelSize * (perspective != 0 ? -place.z : 1.0);
  if (pixel <= 0.0) return; // behind the eye
  vec2 corner = vec2((gl_VertexID & 1) == 0 ? -1.0 : 1.0, (gl_VertexID & 2) == 0 ? -1.0 : 1.0);
  radius = max(center.w, pixelRatio * pixel);
  color = mark == 2                ? hoveredColor
          : mark == 1 || mark == 3 ? selectedColor
                                   : dressed(successorColor, own, look.w, place.z);
  rim = mark == 3 ? hoveredColor : isUnitStart == 1 ? branchingColor : color;
  halfWidth = spheres != 0 ? radius / pixel : halfWidthOf(shape, mark);
  if (spheres == 0 && isUnitStart == 1) halfWidth = max(1.6 * halfWidth, 6.0 * pixelRatio);
  offset = corner * (halfWidth + 1.5 * pixelRatio);
  vec4 clip = toClip * vec4(place, 1.0);
  // Nodes before their edges, marked nodes before all others.
  float nearer = spheres != 0 ? 0.0 : pushed * center.w + pixel * (4.0 + 8.0 * float(mark));
  vec4 moved = toClip * vec4(place.xy, place.z + nearer, 1.0);
  float depth = moved.w > 0.0 ? moved.z / moved.w : -1.0;
  back = look.w < 1.5 && mark == 0 && isPassed(-place.z) ? 1.0 : 0.0;
  gl_Position = vec4(clip.xy + offset / halfScreen * clip.w,
                     mix(max(depth, -1.0), 0.9995, back) * clip.w, clip.w);
})";

const char* const discFragment = R"(#version 330 core
uniform vec3 outlineColor;
uniform float pixelRatio;
noperspective in vec2 offset;
flat in float halfWidth;
flat in vec3 color;
flat in vec3 rim;
flat in int shape;
flat in int isUnitStart;
out vec4 fragment;
void main() {
  float away = isUnitStart == 1 ? abs(offset.x) + abs(offset.y) // a diamond
               : shape == 2     ? max(abs(offset.x), abs(offset.y)) : length(offset);
  float beyond = away - halfWidth;
  float disc = clamp(0.5 - beyond, 0.0, 1.0);
  float outline = 0.85 * clamp(0.5 - (beyond - pixelRatio), 0.0, 1.0);
  float alpha = max(disc, outline);
  if (alpha < 0.05) discard;
  float hole = shape == 3 ? clamp(0.5 + 0.5 * halfWidth - away, 0.0, 1.0) : 0.0; // apex: a ring
  vec3 fill = mix(color, rim, clamp(0.5 + beyond + 2.0 * pixelRatio, 0.0, 1.0));
  fragment = vec4(mix(outlineColor, fill, disc * (1.0 - hole)), alpha);
})";

const char* const sphereFragment = R"(#version 330 core
uniform mat4 toClip;
in vec3 place;
flat in float radius;
noperspective in vec2 offset;
flat in float halfWidth;
flat in vec3 color;
flat in vec3 rim;
flat in float back;
out vec4 fragment;
void main() {
  float part = length(offset) / halfWidth;
  if (part > 1.0) discard;
  float facing = sqrt(1.0 - part * part);
  vec3 fill = part > 0.7 ? rim : color;
  vec4 front = toClip * vec4(place.xy, place.z + radius * facing, 1.0);
  gl_FragDepth = mix(clamp(0.5 * front.z / front.w + 0.5, 0.0, 1.0), 0.9998, back);
  fragment = vec4(fill * (0.4 + 0.6 * facing), 1.0);
})";

#undef ESPALIER_EDGE_CLIP
#undef ESPALIER_GLYPH_HEAD

} // namespace espalier::shaders
