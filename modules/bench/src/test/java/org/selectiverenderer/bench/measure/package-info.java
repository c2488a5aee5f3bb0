/** What the measurements of the benchmark make of their figures; nothing is timed here. */
@NullMarked
package org.selectiverenderer.bench.measure;

import org.jspecify.annotations.NullMarked;
