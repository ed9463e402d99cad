#pragma once

/// The shaders of SkeletonPass. Each edge and node has four corners, vertices in a row of the same
/// attributes; a node faces the screen, an edge turns about its axis to face the eye.
namespace espalier::shaders {

// Lines of constant width, with an outline; a hovered one narrows toward the child.
extern const char* const lineVertex;
extern const char* const lineFragment;

// Cones from radius to radius, lit from the eye, at the depth of their front.
extern const char* const frustumVertex;
extern const char* const frustumFragment;

// Discs of constant size, by the shape of the node; or spheres of its radius.
extern const char* const nodeVertex;
extern const char* const discFragment;
extern const char* const sphereFragment;

} // namespace espalier::shaders
