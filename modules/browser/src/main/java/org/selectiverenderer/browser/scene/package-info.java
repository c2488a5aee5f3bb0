/**
 * The nodes of a running scene, their routes and the event cascade (X3D 4.0, 4.4.8).
 *
 * <p>In: events. Out: field values, and calls to observers and listeners. Uses {@code
 * x3d.catalogue}, {@code geometry.mesh} and {@code base.problem}. All of it belongs to one thread,
 * the one that steps the world.
 */
@NullMarked
package org.selectiverenderer.browser.scene;

import org.jspecify.annotations.NullMarked;
