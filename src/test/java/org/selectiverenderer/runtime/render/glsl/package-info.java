/** Tests of programs of authors as texts. */
@NullMarked
package org.selectiverenderer.runtime.render.glsl;

import org.jspecify.annotations.NullMarked;
