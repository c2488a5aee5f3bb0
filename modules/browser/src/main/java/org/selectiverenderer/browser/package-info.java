/**
 * The embedded X3D browser: a running scene and its frame step, without a window and without GL.
 *
 * <p>{@link org.selectiverenderer.browser.World} runs the frame step: it runs the tasks that other
 * threads have posted, moves the viewer, updates the sensors, runs the event cascade, and applies
 * all changes to the instance tree. Files that events name (an Inline's new {@code url}) are read
 * in the background and arrive as posted tasks in a later frame.
 *
 * <p>Sub-packages, each using only those before it:
 *
 * <ul>
 *   <li>{@code scene} nodes, routes and the event cascade
 *   <li>{@code sound} sounds as samples: read, mixed, sent to the device
 *   <li>{@code nodes} the behaviour of each node type, one class each
 *   <li>{@code instance} the instance tree: world transformations, visibility, meshes, lights
 *   <li>{@code loading} reads files into scenes, Inlines in parallel
 *   <li>{@code script} runs the programs of Scripts
 *   <li>{@code viewer} the viewer, and motion along paths and between Viewpoints
 *   <li>{@code collide} ray casting, and collisions of the viewer
 *   <li>{@code walk} navigation: how input moves the viewer
 *   <li>{@code pick} intersections that pick sensors report
 *   <li>this package: {@link World}, the frame step; {@link RunningScene}, the scene that it shows,
 *       and its layers: each {@link SceneLayer} of the {@link LayerStack} has instances, bound
 *       nodes, sensors and a viewer of its own, and the user's viewer is that of the active layer
 *   <li>{@code sai} the standard's interfaces onto it
 *   <li>{@code camera} cameras and two-dimensional primitives, without GL
 *   <li>{@code render} the JOGL renderer, the only place with GL
 * </ul>
 *
 * <p>In: a loaded scene, time, the viewer's motion. Out: events, and the instance tree that a
 * renderer draws. Uses {@code geometry}, {@code x3d} and {@code base}; {@code sai} alone uses
 * {@code org.web3d.x3d.sai}.
 */
@NullMarked
package org.selectiverenderer.browser;

import org.jspecify.annotations.NullMarked;
