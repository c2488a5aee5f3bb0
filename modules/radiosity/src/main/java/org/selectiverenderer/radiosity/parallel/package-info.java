/** Parallel computation with progress and cancellation. Uses nothing else of ours. */
@NullMarked
package org.selectiverenderer.radiosity.parallel;

import org.jspecify.annotations.NullMarked;
