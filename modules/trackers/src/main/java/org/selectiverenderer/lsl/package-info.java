/**
 * The Lab Streaming Layer: data sent to, and received from, other programs of a lab's network, all
 * stamped by clocks whose offsets are known (Kothe and others 2025, "The lab streaming layer for
 * synchronized multimodal recording").
 *
 * <p>This package is the only one that calls liblsl, a library that the user installs: {@code
 * lsl.dll}, {@code liblsl.so} or {@code liblsl.dylib} is loaded on first use. Its C functions are
 * called through the libffi that LWJGL contains, which {@code polygon} needs anyway, so that no
 * further library is shipped.
 *
 * <p>In: a {@link org.selectiverenderer.lsl.StreamInfo} and samples for an {@link
 * org.selectiverenderer.lsl.LslOutlet}; or a predicate on streams for an {@link
 * org.selectiverenderer.lsl.LslResolver}, which finds them, each to be read by an {@link
 * org.selectiverenderer.lsl.LslInlet}. Times are seconds of the library's clock on this machine
 * ({@link org.selectiverenderer.lsl.LslLibrary#clock}). Depends on no other package of the program;
 * each object belongs to one thread at a time.
 */
@NullMarked
package org.selectiverenderer.lsl;

import org.jspecify.annotations.NullMarked;
