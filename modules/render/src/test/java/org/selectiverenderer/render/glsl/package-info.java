/** Tests of programs of authors as texts. */
@NullMarked
package org.selectiverenderer.render.glsl;

import org.jspecify.annotations.NullMarked;
