/**
 * Edits of Switches: wrapping a node in a Switch, adding, removing and reordering its choices, and
 * unwrapping it. The metadata of a choice moves with the choice, and the initially shown choice
 * stays shown.
 *
 * <p>In: a document, a Switch or a node. Out: edits, not yet performed. Uses {@code document},
 * {@code document.enrichment}, {@code document.nodes} and {@code x3d}.
 */
@NullMarked
package org.selectiverenderer.document.switches;

import org.jspecify.annotations.NullMarked;
