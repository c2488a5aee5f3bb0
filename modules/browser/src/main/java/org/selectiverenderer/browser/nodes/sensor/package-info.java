/**
 * Sensors: nodes that each frame updates. A {@link
 * org.selectiverenderer.browser.nodes.sensor.FrameDrivenNode} receives the {@link
 * org.selectiverenderer.browser.nodes.sensor.FrameContext} with its time and viewer; a {@link
 * org.selectiverenderer.browser.nodes.sensor.SleepableNode} only while it has something to do. A
 * {@link org.selectiverenderer.browser.nodes.sensor.PointingDeviceSensorNode} receives the pointing
 * device's ray and the point that it hits.
 *
 * <p>In: frames. Out: events. Uses {@code browser.nodes.group}, {@code browser.scene}, {@code
 * x3d.catalogue} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.browser.nodes.sensor;

import org.jspecify.annotations.NullMarked;
