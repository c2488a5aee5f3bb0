/** Tests of the recipes of the furniture. */
@NullMarked
package org.selectiverenderer.apartment.furniture;

import org.jspecify.annotations.NullMarked;
