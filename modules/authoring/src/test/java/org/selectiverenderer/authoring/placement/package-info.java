/** Tests of the package of that name. */
@NullMarked
package org.selectiverenderer.authoring.placement;

import org.jspecify.annotations.NullMarked;
