/**
 * Particle systems (X3D 4.0, clause 40): emitters, physics models, and the mesh of the particles.
 *
 * <p>In: frames. Out: a new mesh for each frame in which particles live, in local coordinates; it
 * is drawn, culled and lit as any other. The simulation advances in equal time steps with a random
 * seed per node, so that the same times give the same particles, however many frames lie between
 * them. A system that is disabled or has no particles costs next to nothing per frame.
 *
 * <p>Uses {@code browser.nodes.sensor}, {@code browser.scene}, {@code geometry.mesh}, {@code
 * geometry.bvh}, {@code x3d.tessellate}, {@code x3d.catalogue} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.browser.nodes.particle;

import org.jspecify.annotations.NullMarked;
