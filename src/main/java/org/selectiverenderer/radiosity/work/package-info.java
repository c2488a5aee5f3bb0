/** Parallel computation with progress and cancellation. Uses nothing else of ours. */
@NullMarked
package org.selectiverenderer.radiosity.work;

import org.jspecify.annotations.NullMarked;
