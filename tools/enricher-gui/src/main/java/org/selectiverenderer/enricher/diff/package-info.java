/**
 * Shows line by line what saving will change in the file, and merges with changes of other
 * programs.
 *
 * <p>In: a document and its file. Out: the author's yes or no. Uses {@code enricher.session},
 * {@code enricher.task}, {@code authoring} and {@code authoring.file}.
 */
@NullMarked
package org.selectiverenderer.enricher.diff;

import org.jspecify.annotations.NullMarked;
