/**
 * What the thesis says of the apartment's objects, as data: polygon counts (Figs 67, 69, 71) and
 * expectancy ratings (Appendix B).
 *
 * <p>In: the CSV files beside this package. Out: records. Uses {@code schema}, {@code formats.csv}
 * and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.apartment.facts;

import org.jspecify.annotations.NullMarked;
