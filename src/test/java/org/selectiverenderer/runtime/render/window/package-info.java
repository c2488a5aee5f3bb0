/** Tests of the window, its loop and its input. */
@NullMarked
package org.selectiverenderer.runtime.render.window;

import org.jspecify.annotations.NullMarked;
