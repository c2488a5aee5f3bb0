/**
 * The Lab Streaming Layer: data sent to, and received from, other programs of a lab's network, all
 * stamped by clocks whose offsets are known (Kothe and others 2025, "The lab streaming layer for
 * synchronized multimodal recording").
 *
 * <p>The door to its library, liblsl, which is the user's: {@code lsl.dll}, {@code liblsl.so} or
 * {@code liblsl.dylib} is looked for when somebody asks for it, and only then. Its C functions are
 * called by the libffi that LWJGL carries for {@code polygon}, so that there is no further library
 * to ship.
 *
 * <p>In: a {@link org.selectiverenderer.lsl.StreamDescription} and samples for an {@link
 * org.selectiverenderer.lsl.LslOutlet}; or a condition on streams for an {@link
 * org.selectiverenderer.lsl.LslResolver}, which finds them, each to be read by an {@link
 * org.selectiverenderer.lsl.LslInlet}. Times are seconds of the library's clock on this machine
 * ({@link org.selectiverenderer.lsl.LslLibrary#clock}). Uses nothing of the program of errors; each
 * object belongs to one thread at a time.
 */
@NullMarked
package org.selectiverenderer.lsl;

import org.jspecify.annotations.NullMarked;
