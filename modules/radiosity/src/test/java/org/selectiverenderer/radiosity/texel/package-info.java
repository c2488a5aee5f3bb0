/** Tests of light at texels. */
@NullMarked
package org.selectiverenderer.radiosity.texel;

import org.jspecify.annotations.NullMarked;
