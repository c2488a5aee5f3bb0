/**
 * The enricher's 3D preview: the document as our own runtime shows it, and small pictures of
 * versions.
 *
 * <p>In: snapshots of a document, the selection, the author's mouse and keys. Out: pictures in a
 * Swing component; the object that was clicked. {@code PreviewPanel} and everything of Swing
 * belongs to the event dispatch thread; the running scene and GL to one thread of {@code
 * PreviewThread}, which is told what to do and answers with {@code Frame}s; files are read by
 * {@code SceneFeed}'s thread. The scene is switched by {@code schema.Activation} or the controller
 * itself, never by code of this package's own.
 *
 * <p>Uses {@code enricher.session}, {@code document}, {@code runtime}, {@code runtime.render}
 * (without JOGL), {@code control}, {@code schema}, {@code app.Walking}.
 */
@NullMarked
package org.selectiverenderer.enricher.preview;

import org.jspecify.annotations.NullMarked;
