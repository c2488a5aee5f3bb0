/**
 * An emulator of the InterTrax2, for tests without the device: the device's side of the protocol on
 * a pseudo-terminal, which any program opens like a serial port.
 *
 * <p>In: the motion of the head and the rate of the records. Out: a link to a terminal. Java cannot
 * create a pseudo-terminal, and native code for an emulator alone would be too much: socat creates
 * it if it is installed, else util-linux's script, which every Linux distribution has. Uses {@code
 * tracker}.
 */
@NullMarked
package org.selectiverenderer.tracker.emulator;

import org.jspecify.annotations.NullMarked;
