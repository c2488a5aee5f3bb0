/**
 * What the enricher remembers of its author: files, layout, theme, size of letters, language,
 * unsaved work.
 *
 * <p>In and out: files in the folder of the user's settings. Uses {@code enricher.session}, {@code
 * enricher.task}, {@code document}, {@code document.file}, {@code x3d.files} and {@code
 * base.files}.
 */
@NullMarked
package org.selectiverenderer.enricher.settings;

import org.jspecify.annotations.NullMarked;
