/** Tests of {@code render.draw} that need no pictures. */
@NullMarked
package org.selectiverenderer.render.draw;

import org.jspecify.annotations.NullMarked;
