/**
 * The settings that the enricher stores: recent files, layout, theme, text size and language; and
 * the recovery copies of unsaved changes.
 *
 * <p>In and out: files in the folder of the user's settings. Uses {@code enricher.session}, {@code
 * enricher.task}, {@code enricher.text}, {@code authoring}, {@code authoring.file}, {@code x3d.url}
 * and {@code base.files}.
 */
@NullMarked
package org.selectiverenderer.enricher.settings;

import org.jspecify.annotations.NullMarked;
