/**
 * What the command {@code track} shows and writes: every record, how well they come, and figures of
 * the whole at the end.
 *
 * <p>In: an open tracker and its records. Out: text, JSON lines or CSV. Uses the interface types of
 * {@code tracker} only.
 */
@NullMarked
package org.selectiverenderer.tracker.report;

import org.jspecify.annotations.NullMarked;
