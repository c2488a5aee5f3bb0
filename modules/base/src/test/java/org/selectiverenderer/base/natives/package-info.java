/** Tests of {@code base.natives}. */
@NullMarked
package org.selectiverenderer.base.natives;

import org.jspecify.annotations.NullMarked;
