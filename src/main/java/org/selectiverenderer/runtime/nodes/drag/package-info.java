/**
 * Drag sensors: what the pointing device does while its button is held, as a movement along a
 * plane, a sphere or a cylinder (X3D 4.0, 20.4.1 to 20.4.3).
 *
 * <p>{@link org.selectiverenderer.runtime.nodes.drag.DragSensorNode} is the life of a drag: where
 * it begins, what is sent while it goes on, what is kept when it ends. Its types differ in the
 * {@link org.selectiverenderer.runtime.nodes.drag.DragSurface} along which the pointer is followed,
 * and in how a way along it becomes a value. {@link
 * org.selectiverenderer.runtime.nodes.drag.DragRay} is the pointer in the sensor's coordinates.
 *
 * <p>In: bearings of the pointing device. Out: {@code trackPoint_changed} and the value that is
 * dragged. Uses {@code nodes.sensor}, {@code runtime.scene}, {@code x3d.catalogue} and {@code
 * base.problem}.
 */
@NullMarked
package org.selectiverenderer.runtime.nodes.drag;

import org.jspecify.annotations.NullMarked;
