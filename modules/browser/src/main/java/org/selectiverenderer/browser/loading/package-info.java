/**
 * Loads files into running scenes: reads the scene's file and all Inlines and images that it names
 * and tessellates their geometry, in parallel and with all versions up front. {@code x3d.url}
 * decides which files may be read.
 *
 * <p>Files that a running scene names later are read in the background; {@link
 * org.selectiverenderer.browser.loading.FrameBudgetQueue} puts them into the scene, a limited
 * amount per frame.
 *
 * <p>The nodes of each Inline are its own. But of a file that is inlined again, the nodes in its
 * Shapes are only made when somebody asks for one ({@code DeferredParts}), as a street of copies
 * would else have millions that nobody looks at.
 *
 * <p><b>Own decoders.</b> The readers of TwelveMonkeys ImageIO 3.12.0 (640 kB for TGA, DDS and
 * JPEG) were compared with this package's on the images of its tests, and not taken. Its DDS reader
 * gives one face of a cube map and one slice of a volume, reads the alpha of a DXT3 block
 * differently, and fails on a hostile size with a NegativeArraySizeException. Its TGA reader
 * refuses images stored from the right and files shorter than 26 bytes, and drops the alpha of
 * 32-bit images whose descriptor counts no alpha bits, as many programs write it. Its JPEG reader
 * takes the inks of a JPEG without an Adobe segment for colours with alpha, needs the global
 * registry of ImageIO to find the JDK's reader, and once on the class path comes before that reader
 * for every JPEG.
 *
 * <p>KTX2 and Radiance pictures have no reader in ImageIO; no library in Java reads them that has a
 * release of the last years and takes no native code. Levels compressed by zlib are inflated by
 * {@code java.util.zip} up to the size that the header announces.
 *
 * <p>{@link org.selectiverenderer.browser.loading.ImageTranscoder} converts what these decoders
 * read into PNG, for files that can hold nothing else.
 *
 * <p>In: a path. Out: a {@link org.selectiverenderer.browser.loading.LoadedScene} and problems.
 * Uses {@code browser.scene}, {@code browser.nodes}, the asset interface of {@code
 * browser.instance}, {@code browser.sound}, {@code browser.movie}, {@code geometry}, {@code x3d}
 * and {@code base.problem}; ImageIO decodes the images that this package's own decoders do not.
 */
@NullMarked
package org.selectiverenderer.browser.loading;

import org.jspecify.annotations.NullMarked;
