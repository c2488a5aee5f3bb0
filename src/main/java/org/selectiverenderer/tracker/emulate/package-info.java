/**
 * An InterTrax2 for those who have none: the device's side of the protocol, on a pseudo-terminal
 * that any program opens like a serial port.
 *
 * <p>In: how the head moves and how often the device says so. Out: a link to a terminal. Java
 * cannot make a pseudo-terminal, and native code for an emulator alone would be too much: socat
 * makes it when it is installed, else util-linux's script, which every Linux distribution has. Uses
 * {@code tracker}.
 */
@NullMarked
package org.selectiverenderer.tracker.emulate;

import org.jspecify.annotations.NullMarked;
