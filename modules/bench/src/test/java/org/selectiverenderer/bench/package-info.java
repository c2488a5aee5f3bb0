/**
 * Benchmarks and the generators of their scenes, run by hand, not by the tests; and the plots of
 * measured figures in docs/performance.md.
 */
@NullMarked
package org.selectiverenderer.bench;

import org.jspecify.annotations.NullMarked;
