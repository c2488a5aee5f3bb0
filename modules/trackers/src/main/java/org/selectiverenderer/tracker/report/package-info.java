/**
 * The outputs of the command {@code track}: every record, status lines, and statistics at the end.
 *
 * <p>In: an open tracker and its records. Out: text, JSON lines or CSV. Uses {@code tracker},
 * {@code tracker.factory}, {@code formats.csv}, {@code base.decimal} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.tracker.report;

import org.jspecify.annotations.NullMarked;
