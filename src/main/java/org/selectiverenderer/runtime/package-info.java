/**
 * The embedded X3D browser: a running scene and its frame step, without a window and without GL.
 *
 * <p>In: a loaded scene, time, the viewer's motion. Out: events, and the instance tree that a
 * renderer draws. Sub-packages, each using only those before it:
 *
 * <ul>
 *   <li>{@code scene} nodes, routes and the event cascade
 *   <li>{@code nodes} the behaviour of each node type, one class each
 *   <li>{@code instance} what is where: world transformations, what is shown, meshes, lights
 *   <li>{@code loading} files to scenes, Inlines in parallel
 *   <li>{@code navigation} the viewer's walking, collisions, rays
 *   <li>this package: {@code World}, the frame step
 *   <li>{@code sai} the standard's interfaces onto it
 *   <li>{@code render} the JOGL renderer, the only place with GL
 * </ul>
 */
@NullMarked
package org.selectiverenderer.runtime;

import org.jspecify.annotations.NullMarked;
