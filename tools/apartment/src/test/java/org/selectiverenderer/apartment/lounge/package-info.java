/** Tests of the recipes of the lounge. */
@NullMarked
package org.selectiverenderer.apartment.lounge;

import org.jspecify.annotations.NullMarked;
