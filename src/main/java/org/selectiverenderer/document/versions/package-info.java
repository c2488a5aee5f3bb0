/**
 * The polygon count process (thesis 4.2.1) on a document: a Switch of versions in an object's
 * place, as an edit that can be undone.
 *
 * <p>In: a document, an object's DEF name, goals. Out: files of versions, an edit. Uses {@code
 * document} and {@code polygon}.
 */
@NullMarked
package org.selectiverenderer.document.versions;

import org.jspecify.annotations.NullMarked;
