/**
 * Drag sensors: convert motion of the pointing device with its button held to a movement along a
 * plane, a sphere or a cylinder (X3D 4.0, 20.4.1 to 20.4.3).
 *
 * <p>{@link org.selectiverenderer.browser.nodes.drag.DragSensorNode} handles the course of a drag:
 * its start, the events sent during it, and the offset kept at its end. The node types differ in
 * the {@link org.selectiverenderer.browser.nodes.drag.DragSurface} along which the pointer is
 * followed, and in how a motion along it is converted to a value. {@link
 * org.selectiverenderer.browser.nodes.drag.DragRay} is the pointer's ray in the sensor's
 * coordinates.
 *
 * <p>In: rays of the pointing device. Out: {@code trackPoint_changed} and the dragged value. Uses
 * {@code nodes.sensor}, {@code browser.scene}, {@code x3d.catalogue} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.browser.nodes.drag;

import org.jspecify.annotations.NullMarked;
