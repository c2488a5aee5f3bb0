/** Tests of what is hidden behind what. */
@NullMarked
package org.selectiverenderer.runtime.render.occlude;

import org.jspecify.annotations.NullMarked;
