/** Tests of {@code runtime.render.gpu} that need no pictures. */
@NullMarked
package org.selectiverenderer.runtime.render.gpu;

import org.jspecify.annotations.NullMarked;
