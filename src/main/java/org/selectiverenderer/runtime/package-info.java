/**
 * The embedded X3D browser: a running scene and its frame step, without a window and without GL.
 *
 * <p>{@link org.selectiverenderer.runtime.World} steps. What other threads have posted is done
 * first, then the viewer moves, sensors send, the cascade runs, and the instance tree applies what
 * has changed. Files that events name (an Inline's new {@code url}) begin to be read in the
 * background, and arrive as posted tasks of a later frame.
 *
 * <p>Sub-packages, each using only those before it:
 *
 * <ul>
 *   <li>{@code scene} nodes, routes and the event cascade
 *   <li>{@code sound} sounds as samples: read, mixed, sent to the device
 *   <li>{@code nodes} the behaviour of each node type, one class each
 *   <li>{@code instance} what is where: world transformations, what is shown, meshes, lights
 *   <li>{@code loading} files to scenes, Inlines in parallel
 *   <li>{@code script} the programs of Scripts, run
 *   <li>{@code viewer} the viewer, and motion along paths and between Viewpoints
 *   <li>{@code collide} rays, and what the viewer bumps into
 *   <li>{@code walk} the viewer's walking
 *   <li>{@code pick} what picking sensors meet
 *   <li>this package: {@code World}, the frame step; the {@code RunningScene} that it shows, and
 *       the layers of that: each {@code SceneLayer} has instances, bound nodes, sensors and a
 *       viewer of its own, and the user's viewer is that of the active one ({@code LayerStack})
 *   <li>{@code sai} the standard's interfaces onto it
 *   <li>{@code view} what is to be seen: cameras and marks, without GL
 *   <li>{@code render} the JOGL renderer, the only place with GL
 * </ul>
 *
 * <p>In: a loaded scene, time, the viewer's motion. Out: events, and the instance tree that a
 * renderer draws. Uses {@code geometry}, {@code x3d} and {@code base}; {@code sai} alone uses
 * {@code org.web3d.x3d.sai}.
 */
@NullMarked
package org.selectiverenderer.runtime;

import org.jspecify.annotations.NullMarked;
