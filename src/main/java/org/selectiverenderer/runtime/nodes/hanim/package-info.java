/**
 * Humanoid animation (X3D 4.0, clause 26, and ISO/IEC 19774): skeleton, skinning, displacers that
 * move single points, and recorded motion.
 *
 * <p>In: events to joints and displacers, frames for motion. Out: the points and normals of the
 * skin, written to their nodes without an event, so that drawing, ray casting and collisions use
 * the deformed shape. A humanoid at rest costs nothing per frame. Joints and sites themselves are
 * Transforms of {@code nodes.group}.
 *
 * <p>Uses {@code runtime.nodes.group}, {@code runtime.nodes.sensor}, {@code runtime.scene}, {@code
 * geometry.tessellate}, {@code x3d.catalogue} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.runtime.nodes.hanim;

import org.jspecify.annotations.NullMarked;
