/**
 * The dialogs by which models become part of a scene, and by which a scene leaves with its files.
 *
 * <p>In: a file, and whether the scene may name it. Out: what the author wants. Uses {@code
 * enricher.component}, {@code enricher.text} and {@code swing}.
 */
@NullMarked
package org.selectiverenderer.enricher.importing;

import org.jspecify.annotations.NullMarked;
