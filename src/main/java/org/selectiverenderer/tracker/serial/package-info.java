/**
 * Trackers on a serial port, by jSerialComm: InterTrax2, and those that speak as the Polhemus
 * Fastrak does.
 *
 * <p>In: the name of a port. Out: {@link org.selectiverenderer.tracker.pose.PoseSource}s. {@link
 * org.selectiverenderer.tracker.serial.SerialLine} is the only class that knows jSerialComm. Uses
 * {@code tracker.pose} and {@code tracker.text}.
 */
@NullMarked
package org.selectiverenderer.tracker.serial;

import org.jspecify.annotations.NullMarked;
