/** Benchmarks and the generators of their scenes; run by hand, not by the tests. */
@NullMarked
package org.selectiverenderer.bench;

import org.jspecify.annotations.NullMarked;
