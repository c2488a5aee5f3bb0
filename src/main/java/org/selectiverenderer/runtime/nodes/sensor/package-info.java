/**
 * Sensors: nodes that a frame drives. {@link org.selectiverenderer.runtime.nodes.sensor.FrameNode}s
 * look at the {@link org.selectiverenderer.runtime.nodes.sensor.Frame}, its time and viewer; a
 * {@link org.selectiverenderer.runtime.nodes.sensor.Sleeper} only while something goes on in it. A
 * {@link org.selectiverenderer.runtime.nodes.sensor.PointingSensorNode} is told what the pointing
 * device touches and where it points.
 *
 * <p>In: frames. Out: events. Uses {@code runtime.nodes.group}, {@code runtime.scene}, {@code
 * x3d.catalogue} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.runtime.nodes.sensor;

import org.jspecify.annotations.NullMarked;
