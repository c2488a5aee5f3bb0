/** Tests of the recipes of the kitchen. */
@NullMarked
package org.selectiverenderer.apartment.kitchen;

import org.jspecify.annotations.NullMarked;
