/** The start window, driven by a robot. */
@NullMarked
package org.selectiverenderer.app.start.window;

import org.jspecify.annotations.NullMarked;
