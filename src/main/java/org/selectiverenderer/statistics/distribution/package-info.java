/**
 * Distributions that Commons Math lacks or is not exact enough for: tails of F and t without
 * cancellation, and the noncentral F with its inversion.
 *
 * <p>In and out: numbers. Uses Commons Math only.
 */
@NullMarked
package org.selectiverenderer.statistics.distribution;

import org.jspecify.annotations.NullMarked;
