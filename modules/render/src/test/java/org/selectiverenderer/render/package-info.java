/** Tests of the renderer: pictures of small scenes, pixel by pixel. */
@NullMarked
package org.selectiverenderer.render;

import org.jspecify.annotations.NullMarked;
