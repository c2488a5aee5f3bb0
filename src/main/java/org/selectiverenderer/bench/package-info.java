/**
 * Scenes for the benchmark: generated, the same bytes every time, of the thesis's size. A peer
 * browser can be measured with the same files.
 *
 * <p>In: a folder and a size. Out: X3D files and a camera path, and a {@link
 * org.selectiverenderer.bench.BenchScene} that says what was written. Uses {@code geometry}, {@code
 * x3d.write} and {@code base.decimal}.
 */
@NullMarked
package org.selectiverenderer.bench;

import org.jspecify.annotations.NullMarked;
