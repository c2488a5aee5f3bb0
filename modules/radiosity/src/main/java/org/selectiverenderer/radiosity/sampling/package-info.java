/**
 * Low-discrepancy sample points of the unit square and the hemisphere.
 *
 * <p>In: integers. Out: numbers that are the same on every machine and with any number of threads.
 * Uses nothing else of ours.
 */
@NullMarked
package org.selectiverenderer.radiosity.sampling;

import org.jspecify.annotations.NullMarked;
