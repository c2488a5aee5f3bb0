/**
 * Reads models of other programs in a child process, since Assimp, a native library, can be crashed
 * or made to take all memory by a damaged file.
 *
 * <p>The child process is given bytes, never paths: it asks this one by url for each file that it
 * needs ({@link org.selectiverenderer.models.importer.ModelFileSource}), and answers with what the
 * file holds ({@link org.selectiverenderer.models.importer.ImportedModel}), which is checked here
 * as untrusted input. {@link org.selectiverenderer.models.importer.ModelImportProcess} starts the
 * child, limits its time and memory, and reads several models with it; {@link
 * org.selectiverenderer.models.importer.ModelImportMain} is the child's main class. Both write and
 * read messages in the order that {@link org.selectiverenderer.models.importer.ImportProtocol}
 * lists.
 *
 * <p>Uses {@code base.platform}, {@code base.natives} and LWJGL's Assimp.
 */
@NullMarked
package org.selectiverenderer.models.importer;

import org.jspecify.annotations.NullMarked;
