/**
 * Expectancy ratings of objects (thesis 5.1, Appendix A) turned into schema metadata, in steps that
 * can be reviewed and corrected: ratings, their means, the matching of objects and Switches, the
 * bands of 5.1, and one edit. What participants looked at proposes such metadata, too; accepted
 * proposals take the place of ratings.
 *
 * <p>In: RATINGS.csv, proposals from head logs, a document. Out: an edit, problems. Uses {@code
 * authoring}, {@code authoring.enrichment}, {@code schema}, {@code x3d.source}, {@code formats.csv}
 * and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.authoring.ratings;

import org.jspecify.annotations.NullMarked;
