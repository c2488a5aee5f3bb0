/**
 * Distributions that Commons Math lacks or is not exact enough for: tails of F and t without
 * cancellation, the noncentral F and t with their inversions, Tukey's studentized range.
 *
 * <p>In and out: numbers. Uses only Commons Math.
 */
@NullMarked
package org.selectiverenderer.statistics.distribution;

import org.jspecify.annotations.NullMarked;
