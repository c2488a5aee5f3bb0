/** Tests of {@code runtime.render.draw} that need no pictures. */
@NullMarked
package org.selectiverenderer.runtime.render.draw;

import org.jspecify.annotations.NullMarked;
