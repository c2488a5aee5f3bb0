/**
 * Switches made of what is in a scene: a node wrapped in one, its choices added, taken out, put in
 * another order, and the Switch taken away again. What the metadata says of a choice goes with the
 * choice, and the choice that shows at the start goes on showing.
 *
 * <p>In: a document, a Switch or a node. Out: edits, not yet made. Uses {@code document}, {@code
 * document.enrichment}, {@code document.nodes} and {@code x3d}.
 */
@NullMarked
package org.selectiverenderer.document.switches;

import org.jspecify.annotations.NullMarked;
