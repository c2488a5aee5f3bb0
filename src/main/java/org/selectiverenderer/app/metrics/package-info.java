/**
 * The performance measurements of a run: frame times, polygons, memory.
 *
 * <p>In: each frame as it is drawn. Out: {@link org.selectiverenderer.app.metrics.RunMetrics}, and
 * their JSON. Uses {@code render} for what was drawn, {@code tracker} for the latency of its
 * samples, and {@code base}.
 */
@NullMarked
package org.selectiverenderer.app.metrics;

import org.jspecify.annotations.NullMarked;
