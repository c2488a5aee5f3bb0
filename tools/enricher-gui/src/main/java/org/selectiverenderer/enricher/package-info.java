/**
 * The enricher's window (thesis Fig 44), in which an author edits a {@code authoring}. These
 * packages hold the widgets; the edits themselves are made by package {@code authoring}, which has
 * no window.
 *
 * <p>This package assembles the window from its parts: {@code session} (one open document and its
 * selection), {@code task} (work in the background), {@code tree}, {@code source}, {@code form},
 * {@code preview}, {@code compare}, {@code cost}, {@code run}, {@code problems}, {@code help}, and
 * the dialogs {@code overview}, {@code ratings}, {@code versions}, {@code diff}, {@code newscene},
 * {@code importing} and {@code access}; {@code settings} stores the author's preferences, {@code
 * table} and {@code parts} are shared.
 *
 * <p>In: a scene's file, the author's mouse and keyboard. Out: edits of the document. Swing with
 * FlatLaf, MigLayout and, for the source, RSyntaxTextArea. Uses these, {@code authoring}, {@code
 * validation}, {@code polygon}, {@code x3d} and {@code base.markup}; of our own packages only
 * {@code cli} uses it.
 */
@NullMarked
package org.selectiverenderer.enricher;

import org.jspecify.annotations.NullMarked;
