/** Tests of where the light of a shape is computed. */
@NullMarked
package org.selectiverenderer.runtime.render.lighting;

import org.jspecify.annotations.NullMarked;
