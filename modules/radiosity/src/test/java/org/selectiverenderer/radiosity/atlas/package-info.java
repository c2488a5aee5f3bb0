/** Tests of the places for light in pictures. */
@NullMarked
package org.selectiverenderer.radiosity.atlas;

import org.jspecify.annotations.NullMarked;
