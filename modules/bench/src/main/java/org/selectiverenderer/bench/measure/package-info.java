/**
 * Measurements of this machine: reading, loading, frame rates, activation, memory. Scenes run in
 * child processes, so that each starts cold and has its own peak memory.
 *
 * <p>In: the scenes that {@code bench} and {@code apartment} generate. Out: one JSON object, and a
 * text that compares it with other browsers. May use every package but {@code enricher} and {@code
 * cli}.
 */
@NullMarked
package org.selectiverenderer.bench.measure;

import org.jspecify.annotations.NullMarked;
