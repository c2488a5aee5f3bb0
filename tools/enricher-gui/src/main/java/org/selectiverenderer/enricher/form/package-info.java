/**
 * The form of the selected Switch, ProximitySensor or other element (thesis Figs 44, 46), which
 * turns what the author types into edits of the document.
 *
 * <p>In: a session, pictures of versions. Out: edits of the document. Uses {@code
 * enricher.session}, {@code enricher.task}, {@code enricher.text}, {@code enricher.completion},
 * {@code enricher.help}, {@code enricher.images}, {@code enricher.preview} for the pictures, {@code
 * enricher.versions} for levels of texture and shading, {@code enricher.problems}, {@code
 * authoring}, {@code schema}, {@code x3d} and {@code base}.
 */
@NullMarked
package org.selectiverenderer.enricher.form;

import org.jspecify.annotations.NullMarked;
