/** Tests of what is hidden behind what. */
@NullMarked
package org.selectiverenderer.runtime.render.occlusion;

import org.jspecify.annotations.NullMarked;
