/**
 * What the command {@code track} shows and writes: every record, how well they come, and figures of
 * the whole at the end.
 *
 * <p>In: an open tracker and its records. Out: text, JSON lines or CSV. Uses {@code tracker},
 * {@code tracker.open}, {@code base.csv}, {@code base.decimal} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.tracker.report;

import org.jspecify.annotations.NullMarked;
