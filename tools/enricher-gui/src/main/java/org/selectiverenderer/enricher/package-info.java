/**
 * The enricher's window (thesis Fig 44): an author's view of a {@code document}. Widgets only; what
 * they do is done by package {@code document}, which has no window.
 *
 * <p>This package puts the window together of its parts: {@code session} (one open document and its
 * selection), {@code task} (work in the background), {@code tree}, {@code source}, {@code form},
 * {@code preview}, {@code compare}, {@code cost}, {@code run}, {@code problems}, {@code help}, and
 * the dialogs {@code overview}, {@code ratings}, {@code versions} and {@code diff}; {@code
 * settings} remembers, {@code table} and {@code parts} are shared.
 *
 * <p>In: a scene's file, the author's hands. Out: edits of the document. Swing with FlatLaf,
 * MigLayout and, for the source, RSyntaxTextArea. Uses these, {@code document}, {@code validation},
 * {@code polygon.count}, {@code x3d} and {@code base.markup}; no other package of ours uses it but
 * {@code cli}.
 */
@NullMarked
package org.selectiverenderer.enricher;

import org.jspecify.annotations.NullMarked;
