/**
 * The embedded X3D browser: a running scene and its frame step, without a window and without GL.
 *
 * <p>{@link org.selectiverenderer.browser.World} runs the frame step: it runs the tasks that other
 * threads have posted, moves the viewer, updates the sensors, runs the event cascade, and applies
 * all changes to the instance tree. Files that events name (an Inline's new {@code url}) are read
 * in the background and arrive as posted tasks in a later frame.
 *
 * <h2>A frame</h2>
 *
 * <p>A frame is one call of {@link org.selectiverenderer.browser.World#step}. Where there is a
 * picture, {@code SceneRenderer} of the module {@code render} then draws it once for each eye. The
 * step has these parts:
 *
 * <ol>
 *   <li>The world runs the tasks that other threads have posted (files that have arrived, with at
 *       most 20,000 triangles of them), and listeners receive the events sent since the last frame.
 *   <li>The viewer follows the bound Viewpoint, then the motion: mouse, tracker or recorded path.
 *   <li>LOD and Billboard nodes adapt to the viewer, and the pointing device is moved to what it
 *       touches.
 *   <li>{@code prepareEvents} of scripts is called, and sensors and clocks send their events. The
 *       cascade carries these along the routes and through scripts until none is left (X3D 4.0,
 *       4.4.8.3). Then listeners are called, and their own events cascade in turn, all at one time
 *       stamp. The controller is such a listener: an area that is entered in a frame switches its
 *       objects in that frame.
 *   <li>The instance tree applies the changes: a Switch shows its other child.
 *   <li>Decisions that need the frame's viewer and all its events are made, such as which versions
 *       a budget affords, and applied in the same way.
 * </ol>
 *
 * <p>A scene with a LayerSet is several layers, each with instances, bound nodes, sensors and a
 * viewer of its own ({@link org.selectiverenderer.browser.LayerStack}). Parts 2 to 5 go through all
 * of them, and the user's motion moves the viewer of the active layer.
 *
 * <p>A picture leaves out what no eye can see: surfaces outside of the frustum, facing away, or
 * behind walls and other large flat things ({@code render.occlusion}, on the processor; no pixel
 * changes). It is found by a hierarchy over the boxes of all shapes ({@code instance.ShapeTree}),
 * and what has changed by a log ({@code instance.ShapeChanges}), so that a frame costs what is in
 * view and what changes, not what there is. Small shapes of one look that stand still share buffers
 * and are drawn by one call. Shapes that are new and hidden are made ready over the next frames,
 * shapes that are shown in their own frame; those of a large scene when they are seen or near.
 * Light is computed at pixels on a graphics card and at vertices on a processor, by one text
 * ({@code light.glsl}); {@code render.lighting} decides for each shape and divides surfaces that
 * are too coarse for it.
 *
 * <p>In a headset the OpenXR runtime says when a frame is due, and where head and eyes will be when
 * it is seen; part 2 reads that pose. The thread {@code headset} steps and draws; the mirror on the
 * desk is another thread's, and neither waits for the other ({@code render.headset}). A controller
 * of a run that asks the user something inside the headset returns {@link
 * org.selectiverenderer.browser.camera.WorldSpacePanel}s from {@code RunController.panels}, learns
 * where a hand points by {@code RunController.pointed} and of buttons by {@code
 * RunController.answered}, and lets the controllers move nobody ({@code
 * app.session.HeadsetQuestionController}).
 *
 * <h2>Packages</h2>
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
 *   <li>{@code collision} ray casting, and collisions of the viewer
 *   <li>{@code navigation} navigation: how input moves the viewer
 *   <li>{@code picking} intersections that pick sensors report
 *   <li>this package: {@link World}, the frame step; {@link RunningScene}, the scene that it shows,
 *       and its layers: each {@link SceneLayer} of the {@link LayerStack} has instances, bound
 *       nodes, sensors and a viewer of its own, and the user's viewer is that of the active layer
 *   <li>{@code sai} the standard's interfaces onto it
 *   <li>{@code movie} movies of MovieTextures
 *   <li>{@code camera} cameras and two-dimensional primitives, without GL
 * </ul>
 *
 * <p>In: a loaded scene, time, the viewer's motion. Out: events, and the instance tree that a
 * renderer draws. Uses {@code geometry}, {@code x3d} and {@code base}; {@code sai} alone uses
 * {@code org.web3d.x3d.sai}.
 */
@NullMarked
package org.selectiverenderer.browser;

import org.jspecify.annotations.NullMarked;
