/**
 * Trackers on a serial port: InterTrax2, and those that speak as the Polhemus Fastrak does.
 *
 * <p>In: the name of a port. Out: {@link org.selectiverenderer.tracker.live.PoseSource}s.
 * jSerialComm opens serial ports, since it brings its native parts for all platforms; {@link
 * org.selectiverenderer.tracker.serial.SerialLine} opens and reads them, {@code SerialTrouble} says
 * why one cannot be opened. Uses {@code tracker}, {@code tracker.live} and {@code tracker.text}.
 */
@NullMarked
package org.selectiverenderer.tracker.serial;

import org.jspecify.annotations.NullMarked;
