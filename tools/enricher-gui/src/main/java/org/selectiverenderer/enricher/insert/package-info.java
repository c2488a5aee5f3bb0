/**
 * Inserting nodes at the selection: templates that draw something, and a dialog with all nodes that
 * may go there, by component.
 *
 * <p>In: a session, where the preview's viewer is. Out: edits of the document, by {@code
 * enricher.menu.StructureCommands}. Uses {@code enricher.component}, {@code enricher.menu}, {@code
 * enricher.session}, {@code enricher.text}, {@code authoring.area}, {@code
 * authoring.structure}, {@code browser.viewer} and {@code x3d}. For the event dispatch thread.
 */
@NullMarked
package org.selectiverenderer.enricher.insert;

import org.jspecify.annotations.NullMarked;
