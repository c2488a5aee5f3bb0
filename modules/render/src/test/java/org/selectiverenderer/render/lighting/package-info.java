/** Tests of where the light of a shape is computed. */
@NullMarked
package org.selectiverenderer.render.lighting;

import org.jspecify.annotations.NullMarked;
