/**
 * Documents and the file system: opening, saving with backups, detecting changes by other programs,
 * recovery of unsaved work after a crash, comparing and merging texts.
 *
 * <p><b>Own line diff.</b> java-diff-utils 4.16 finds the same number of equal lines in the scenes
 * of this project, but its algorithm, by Myers, takes time and memory that grow with the number of
 * differences: 10.6 s for 20,000 lines that were all indented anew, 3.8 s in linear space, where
 * {@link org.selectiverenderer.authoring.file.PatienceDiff} takes 17 ms. It also has no three-way
 * merge, and its unified format does not tell a missing line end at the end of a file, without
 * which {@code patch} gives other bytes.
 *
 * <p>In: paths, documents. Out: files, differences as text. Uses {@code authoring}, {@code
 * x3d.source} and {@code base.files}.
 */
@NullMarked
package org.selectiverenderer.authoring.file;

import org.jspecify.annotations.NullMarked;
