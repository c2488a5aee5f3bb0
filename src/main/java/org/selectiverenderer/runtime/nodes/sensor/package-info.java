/**
 * Sensors: nodes that each frame updates. A {@link
 * org.selectiverenderer.runtime.nodes.sensor.FrameDrivenNode} receives the {@link
 * org.selectiverenderer.runtime.nodes.sensor.FrameContext} with its time and viewer; a {@link
 * org.selectiverenderer.runtime.nodes.sensor.SleepableNode} only while it has something to do. A
 * {@link org.selectiverenderer.runtime.nodes.sensor.PointingDeviceSensorNode} receives the pointing
 * device's ray and the point that it hits.
 *
 * <p>In: frames. Out: events. Uses {@code runtime.nodes.group}, {@code runtime.scene}, {@code
 * x3d.catalogue} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.runtime.nodes.sensor;

import org.jspecify.annotations.NullMarked;
