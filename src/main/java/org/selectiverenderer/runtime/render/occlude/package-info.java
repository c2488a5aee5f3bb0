/** What walls and other large flat things hide is not drawn. Without GL, on the processor. */
@NullMarked
package org.selectiverenderer.runtime.render.occlude;

import org.jspecify.annotations.NullMarked;
