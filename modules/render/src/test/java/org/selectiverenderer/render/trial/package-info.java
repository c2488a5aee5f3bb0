/** Tests of the window, its loop and its input. */
@NullMarked
package org.selectiverenderer.render.trial;

import org.jspecify.annotations.NullMarked;
