/** Tests of {@code render.gpu} that need no pictures. */
@NullMarked
package org.selectiverenderer.render.gpu;

import org.jspecify.annotations.NullMarked;
