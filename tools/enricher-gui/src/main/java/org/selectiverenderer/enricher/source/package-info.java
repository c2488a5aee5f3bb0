/**
 * The source view: an editor of the scene's text with syntax highlighting, which shows large texts
 * a page at a time.
 *
 * <p>{@code SourceAreaBinding} synchronizes the text area with a part of the document in both
 * directions; it alone changes the area's text. {@code TypingUndoGrouper} groups typing into undo
 * steps, {@code SourceHighlighter} highlights (tags of the element, the fault's line, hits), {@code
 * FindReplaceController} searches the whole document, whatever part is shown, {@code
 * SourceCompletion} proposes completions. {@code authoring.editing} computes hits, proposals and
 * comments; {@code LongLineTokenMaker} colours lines of any length, {@code SourceAreaSetup} sets
 * the area up, {@code FaultBar} and {@code PageBar} are the bars below it; {@code SourcePanel}
 * assembles the parts and follows the selection.
 *
 * <p>In: a session, typing. Out: changes of the document, selections. Uses {@code
 * enricher.session}, {@code enricher.component}, {@code enricher.completion}, {@code
 * enricher.text}, {@code authoring}, {@code authoring.editing}, {@code x3d.source}, {@code
 * base.markup} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.enricher.source;

import org.jspecify.annotations.NullMarked;
