/**
 * The text of the scene: highlighted, editable, one page at a time where it is too big.
 *
 * <p>In: a session, typing. Out: changes of the document, selections. Uses {@code
 * enricher.session}, {@code document}, {@code x3d.source}, {@code base.markup} and {@code
 * base.problem}.
 */
@NullMarked
package org.selectiverenderer.enricher.source;

import org.jspecify.annotations.NullMarked;
