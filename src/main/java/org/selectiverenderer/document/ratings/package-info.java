/**
 * Expectancy ratings of objects (thesis 5.1, Appendix A) turned into schema metadata, step by step
 * so that each can be looked at and corrected: ratings, their means, which Switch each object is,
 * what the bands of 5.1 imply, and one edit.
 *
 * <p>In: RATINGS.csv, a document. Out: an edit, problems. Uses {@code document}, {@code
 * document.enrichment}, {@code schema}, {@code x3d.source}, {@code base.csv} and {@code
 * base.problem}.
 */
@NullMarked
package org.selectiverenderer.document.ratings;

import org.jspecify.annotations.NullMarked;
