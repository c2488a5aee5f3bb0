/**
 * Files found by the names that users give, and files written whole or not at all.
 *
 * <p>{@link org.selectiverenderer.base.files.FileFinder} finds. For writing there is one policy for
 * everything that is not a log: the content goes to a temporary file beside the target and onto the
 * disk itself, and then takes the name in one step; several files do so all or none, and what they
 * replace is kept until all are in place. Links stay links, permissions stay, pipes and devices are
 * written to and not replaced. What is written once ({@link
 * org.selectiverenderer.base.files.WholeFile#writeOnce}) never replaces anything. Logs (time lines,
 * head logs, journals) are appended to instead, and use {@link
 * org.selectiverenderer.base.files.Disk} alone.
 *
 * <p>In: names, paths and bytes. Out: paths, files, or a {@link
 * org.selectiverenderer.base.files.NotWritten}. Uses the JDK only.
 */
@NullMarked
package org.selectiverenderer.base.files;

import org.jspecify.annotations.NullMarked;
