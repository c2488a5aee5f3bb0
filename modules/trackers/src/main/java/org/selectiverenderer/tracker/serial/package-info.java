/**
 * Sources of trackers on a serial port: InterTrax2, and devices with the protocol of the Polhemus
 * Fastrak.
 *
 * <p>In: the name of a port. Out: {@link org.selectiverenderer.tracker.pipeline.PoseSource}s.
 * Serial ports are accessed through jSerialComm, which contains native libraries for all platforms;
 * {@link org.selectiverenderer.tracker.serial.SerialLine} opens and reads a port, {@code
 * SerialPortErrors} explains why one cannot be opened. Uses {@code tracker}, {@code
 * tracker.pipeline} and {@code tracker.text}.
 */
@NullMarked
package org.selectiverenderer.tracker.serial;

import org.jspecify.annotations.NullMarked;
