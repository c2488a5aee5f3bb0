/**
 * Parsers of text records: bytes to lines, lines to poses, without allocating per line.
 *
 * <p>In: bytes in chunks as they arrive. Out: records into a {@link
 * org.selectiverenderer.tracker.pipeline.PoseSink}. Uses {@code tracker.pipeline} and
 * FastDoubleParser.
 */
@NullMarked
package org.selectiverenderer.tracker.text;

import org.jspecify.annotations.NullMarked;
