/** Tests of what is hidden behind what. */
@NullMarked
package org.selectiverenderer.render.occlusion;

import org.jspecify.annotations.NullMarked;
