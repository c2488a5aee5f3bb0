/** Tests of the preview pictures of an editor. */
@NullMarked
package org.selectiverenderer.render.preview;

import org.jspecify.annotations.NullMarked;
