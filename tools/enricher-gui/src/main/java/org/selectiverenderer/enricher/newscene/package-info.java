/**
 * The dialog of a new scene: its kind, its size and its file.
 *
 * <p>In: a proposed file. Out: the text of a scene and the file to write it to. Uses {@code
 * authoring.creation}, {@code enricher.component}, {@code enricher.text} and {@code swing}.
 */
@NullMarked
package org.selectiverenderer.enricher.newscene;

import org.jspecify.annotations.NullMarked;
