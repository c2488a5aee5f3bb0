/**
 * The conformance suite: small scenes, one for each node and behaviour, that contain their own
 * expectations. The {@code meta} elements of their heads name the clause of the standard, the
 * frames to step, and the events, values, pixels and messages that are expected.
 *
 * <ul>
 *   <li>{@code clause}: the clause that is checked, and what of it; required
 *   <li>{@code at}: {@code TIME [ACTION]}: a frame at that time in seconds, before which is done:
 *       {@code viewer X Y Z [YAW PITCH]} (metres, degrees), {@code pointer X Y [down|up]} (0..1 of
 *       the picture, from left and top), {@code key NAME down|up} (a character or {@code SPACE},
 *       {@code ENTER}, {@code BACKSPACE}, {@code UP}, {@code F1}, {@code SHIFT} ...), {@code set
 *       NODE.field VALUE} (as in an attribute; a node by its name). Those of one time are done in
 *       one frame, in order. Without any there is one frame, at 0.
 *   <li>{@code event}: {@code TIME NODE.field VALUE}: all events of every field that is so named,
 *       in order
 *   <li>{@code silent}: {@code NODE.field}: it sends none
 *   <li>{@code value}: {@code NODE.field VALUE}, after the last frame
 *   <li>{@code pixel}: {@code X Y R G B [TOLERANCE]}: the picture of the last frame, 256 pixels
 *       wide and high; X and Y in 0..1 from left and top, colours in 0..255, the tolerance 8
 *   <li>{@code says}: words of a problem, in order; no other may be told
 * </ul>
 *
 * <p>Numbers agree to 1e-4. The scenes lie in {@code
 * modules/render/src/test/resources/conformance}, in a folder for each component of the standard.
 */
@NullMarked
package org.selectiverenderer.render.conformance;

import org.jspecify.annotations.NullMarked;
