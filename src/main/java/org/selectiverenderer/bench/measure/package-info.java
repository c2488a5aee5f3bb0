/**
 * What this machine reaches: reading, loading, frames, activation, memory. Scenes are run in
 * processes of their own, so that each starts cold and has its own peak of memory.
 *
 * <p>In: the scenes that {@code bench} and {@code apartment} generate. Out: one JSON object, and a
 * text that sets it beside the peers' figures. May use every package but {@code enricher} and
 * {@code cli}.
 */
@NullMarked
package org.selectiverenderer.bench.measure;

import org.jspecify.annotations.NullMarked;
