/**
 * Documents and the file system: opening, saving without ever losing what was there, noticing what
 * others do to the file, keeping unsaved work for the next start, telling two texts apart.
 *
 * <p>In: paths, documents. Out: files, differences as text. Uses {@code document}, {@code
 * x3d.source} and {@code base.files}.
 */
@NullMarked
package org.selectiverenderer.document.file;

import org.jspecify.annotations.NullMarked;
