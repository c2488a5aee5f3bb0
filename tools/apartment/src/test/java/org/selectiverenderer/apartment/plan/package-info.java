/** Tests of the floor plan. */
@NullMarked
package org.selectiverenderer.apartment.plan;

import org.jspecify.annotations.NullMarked;
