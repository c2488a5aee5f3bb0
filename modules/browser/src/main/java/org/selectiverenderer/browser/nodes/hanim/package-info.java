/**
 * Humanoid animation (X3D 4.0, clause 26, and ISO/IEC 19774): skeleton, skinning, displacers that
 * move single points, and recorded motion.
 *
 * <p>In: events to joints and displacers, frames for motion. Out: the points and normals of the
 * skin, written to their nodes without an event, so that drawing, ray casting and collisions use
 * the deformed shape. A humanoid at rest costs nothing per frame. Joints and sites themselves are
 * Transforms of {@code nodes.group}.
 *
 * <p>Uses {@code browser.nodes.group}, {@code browser.nodes.sensor}, {@code browser.scene}, {@code
 * x3d.tessellate}, {@code x3d.catalogue} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.browser.nodes.hanim;

import org.jspecify.annotations.NullMarked;
