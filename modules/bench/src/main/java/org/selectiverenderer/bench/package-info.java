/**
 * Generated scenes for the benchmark, of the thesis's size, with the same bytes every time. Other
 * browsers can be measured with the same files.
 *
 * <p>In: a folder and a size. Out: X3D files and a camera path, and a {@link
 * org.selectiverenderer.bench.BenchScene} that describes the files. Uses {@code geometry}, {@code
 * x3d.write} and {@code base.decimal}.
 */
@NullMarked
package org.selectiverenderer.bench;

import org.jspecify.annotations.NullMarked;
