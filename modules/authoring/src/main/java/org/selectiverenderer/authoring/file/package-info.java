/**
 * Documents and the file system: opening, saving with backups, detecting changes by other programs,
 * recovery of unsaved work after a crash, comparing and merging texts.
 *
 * <p>In: paths, documents. Out: files, differences as text. Uses {@code authoring}, {@code
 * x3d.source} and {@code base.files}.
 */
@NullMarked
package org.selectiverenderer.authoring.file;

import org.jspecify.annotations.NullMarked;
