/** Tests of {@code x3d.source}. */
@NullMarked
package org.selectiverenderer.x3d.source;

import org.jspecify.annotations.NullMarked;
