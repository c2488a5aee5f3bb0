/**
 * The text of the scene: highlighted, editable, one page at a time where it is too big.
 *
 * <p>{@code DocumentPage} keeps the text area and a part of the document alike, both ways; it alone
 * changes the area's text. {@code TypingSteps} says when typing reaches the document and where a
 * step of Undo ends, {@code SourceMarks} paints (tags of the element, the fault's line, hits),
 * {@code FindWork} searches all of the document, whatever part is shown, {@code CompletionList}
 * proposes. What is found, proposed or turned into a comment is worked out by {@code
 * document.hand}; {@code SourcePanel} puts the parts together and follows the selection.
 *
 * <p>In: a session, typing. Out: changes of the document, selections. Uses {@code
 * enricher.session}, {@code enricher.proposal}, {@code enricher.text}, {@code document}, {@code
 * document.hand}, {@code x3d.source}, {@code base.markup} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.enricher.source;

import org.jspecify.annotations.NullMarked;
