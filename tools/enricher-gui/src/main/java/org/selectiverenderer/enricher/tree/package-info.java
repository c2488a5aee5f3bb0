/**
 * The scene as a tree, whole or its Switches and ProximitySensors only; virtual, for big scenes.
 * While the text is not well formed it shows the last elements that there were, greyed.
 *
 * <p>In: a session. Out: selections. Uses {@code enricher.session}, {@code enricher.text}, {@code
 * document}, {@code document.enrichment} and {@code x3d.source}.
 */
@NullMarked
package org.selectiverenderer.enricher.tree;

import org.jspecify.annotations.NullMarked;
