/**
 * Finds files by the names and patterns that users give, and writes files atomically.
 *
 * <p>{@link org.selectiverenderer.base.files.FileFinder} finds files. All files but logs are
 * written in one way: the content is written to a temporary file beside the target, forced to the
 * disk, and then renamed in one atomic step; several files are replaced all or none, and the
 * replaced files are kept until all are in place. Links stay links, permissions are kept, and pipes
 * and devices are written to, not replaced. A file written once ({@link
 * org.selectiverenderer.base.files.AtomicFileWriter#writeOnce}) never replaces another. Logs (time
 * lines, head logs, journals) are appended to instead, and use only {@link
 * org.selectiverenderer.base.files.DiskSync}. What is known about participants is created by {@link
 * org.selectiverenderer.base.files.PrivateFiles}, so that only the owner reads it.
 *
 * <p>In: names, paths and bytes. Out: paths, files, or a {@link
 * org.selectiverenderer.base.files.FileWriteException}. Uses the JDK only.
 */
@NullMarked
package org.selectiverenderer.base.files;

import org.jspecify.annotations.NullMarked;
