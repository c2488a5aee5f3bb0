/**
 * Shows line by line what saving will change in the file, and merges with changes of other
 * programs. Of a long line it shows what is around its difference ({@code LineExcerpt}).
 *
 * <p>In: a document and its file. Out: the author's yes or no. Uses {@code enricher.session},
 * {@code enricher.task}, {@code authoring}, {@code authoring.file} and {@code base.markup}.
 */
@NullMarked
package org.selectiverenderer.enricher.diff;

import org.jspecify.annotations.NullMarked;
