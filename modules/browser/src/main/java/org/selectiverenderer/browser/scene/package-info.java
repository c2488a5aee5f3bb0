/**
 * The nodes of a running scene, their routes and the event cascade (X3D 4.0, 4.4.8).
 *
 * <p>A file that is inlined many times has a {@link Scene} for each Inline, whose nodes are its
 * own. Until one changes, they share the values of the file's node and its {@link NodeTemplate},
 * and the scenes share what stands in the file's head and the list of its DEF names. The nodes in a
 * Shape of the second and further scenes are made by the template when somebody asks for them.
 *
 * <p>In: events. Out: field values, and calls to observers and listeners. Uses {@code
 * x3d.catalogue}, {@code x3d.read}, {@code geometry.mesh} and {@code base.problem}. All of it belongs to one thread,
 * the one that steps the world.
 */
@NullMarked
package org.selectiverenderer.browser.scene;

import org.jspecify.annotations.NullMarked;
