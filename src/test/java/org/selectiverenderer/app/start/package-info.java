/** The start window's knowledge, without a window. */
@NullMarked
package org.selectiverenderer.app.start;

import org.jspecify.annotations.NullMarked;
